// SPDX-License-Identifier: MIT
#include "freshet/run.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "io/run_folder.h"
#include "io/video.h"
#include "render/dots.h"
#include "render/png.h"
#include "scene/keys.h"
#include "scene/schedule.h"

namespace freshet {
namespace {

std::string frame_name(std::int64_t k) { return fmt::format("frames/frame_{:04}.png", k); }

std::vector<std::string> planned_files(const Schedule& schedule) {
  std::vector<std::string> files{"result.png", "observables.csv", "scene.toml", "report.json"};
  for (std::int64_t k = 0; k < schedule.frames(); ++k) files.push_back(frame_name(k));
  return files;
}

constexpr const char* axis_names[] = {"x", "y", "z"};

std::string observables_header(const Scene& s) {
  const bool flat = s.dimension() == 2;
  const char *density = flat ? "kg/m^2" : "kg/m^3", *force = flat ? "N/m" : "N";
  std::string line = "step,time [s],time step [s],kinetic energy [J],potential energy [J]";
  for (int d = 0; d < s.dimension(); ++d)
    line += fmt::format(",momentum {} [kg m/s]", axis_names[d]);
  line += fmt::format(",density mean [{0}],density max [{0}],speed mean [m/s],speed max [m/s]",
                      density);
  for (const std::string& name : s.wall_names())
    for (int d = 0; d < s.dimension(); ++d)
      line += fmt::format(",force on {} {} [{}]", name, axis_names[d], force);
  return line + "\n";
}

std::string observables_line(const Simulation& s, const std::vector<Vector>& wall_forces) {
  const Statistics t = s.statistics();
  std::string line = fmt::format("{},{:.9g},{:.9g},{:.9g},{:.9g}", s.steps_done(), s.time(),
                                 s.time_steps().last, t.kinetic_energy, t.potential_energy);
  for (const double p : t.momentum) line += fmt::format(",{:.9g}", p);
  line += fmt::format(",{:.9g},{:.9g},{:.9g},{:.9g}", t.density_mean, t.density_max, t.speed_mean,
                      t.speed_max);
  for (const Vector& force : wall_forces)
    for (const double f : force) line += fmt::format(",{:.9g}", f);
  return line + "\n";
}

CheckResult compare(std::string name, double value, std::string relation, double bound) {
  const bool passed = relation == ">"   ? value > bound
                      : relation == "<" ? value < bound
                                        : value <= bound;
  return {std::move(name), std::move(relation), value, bound, passed};
}

std::vector<CheckResult> evaluate(const Scene::Checks& c, const Report& r) {
  std::vector<CheckResult> all;
  const Statistics& s = r.statistics;
  if (c.out_of_bounds_max)
    all.push_back(
        compare("out of bounds", double(s.out_of_bounds), "<=", double(*c.out_of_bounds_max)));
  if (c.density_mean_min)
    all.push_back(compare("density mean", s.density_mean, ">", *c.density_mean_min));
  if (c.speed_mean_max) all.push_back(compare("speed mean", s.speed_mean, "<", *c.speed_mean_max));
  if (c.bright_fraction_min)
    all.push_back(
        compare("bright fraction", r.picture.bright_fraction(), ">", *c.bright_fraction_min));
  if (c.height_mean_max)
    all.push_back(compare("height mean", s.height_mean, "<", *c.height_mean_max));
  return all;
}

Provenance provenance(const Scene& scene, const RunOptions& options) {
  const bool cpu = scene.solver.backend == BackendName::cpu;
  return {options.command, backend_words[int(scene.solver.backend)],
          cpu ? instruction_set(options.execution.isa) : "plain",
          cpu ? thread_count(options.execution.threads) : 1};
}

/// The run's pictures and tables, written as the run goes.
class Observer {
 public:
  Observer(Simulation& sim, const RunOptions& options)
      : sim_(sim),
        schedule_(sim.scene()),
        video_(options.video),
        folder_(options.output, options.overwrite, planned_files(schedule_),
                provenance(sim.scene(), options)) {
    folder_.write("scene.toml", sim.scene().source);
    const auto& picture = sim.scene().picture;
    if (video_) film_.emplace(video_->file, int(picture.width), int(picture.height), video_->fps);
  }

  void after_step() {
    const StepTaken step{sim_.steps_done() - 1, before_, sim_.time(), sim_.finished()};
    before_ = sim_.time();
    if (schedule_.observe_after(step)) {
      wall_forces_ = sim_.wall_forces();
      observables_ += observables_line(sim_, wall_forces_);
    }
    if (schedule_.frame_after(step)) {
      folder_.write(frame_name(frames_++), encode_png(draw()));
      folder_.write("observables.csv", observables_);
    }
    while (film_ && double(filmed_) / video_->fps <= sim_.time() + 1e-12) {
      film_->add(draw());
      ++filmed_;
    }
  }

  void finish(Report& report) {
    const Image result = draw();
    report.picture = picture_statistics(result);
    const auto names = sim_.scene().wall_names();
    for (std::size_t w = 0; w < wall_forces_.size(); ++w)
      report.wall_forces.emplace_back(names[w], wall_forces_[w]);
    report.checks = evaluate(sim_.scene().checks, report);
    for (const CheckResult& check : report.checks)
      if (!check.passed && report.state == Report::State::done)
        report.state = Report::State::check_failed;
    if (film_) film_->finish();
    folder_.write("result.png", encode_png(result));
    folder_.write("observables.csv", observables_);
    folder_.write("report.json", to_json(report));
    folder_.finish(report.state == Report::State::interrupted ? "interrupted" : "done");
  }

  void fail() { folder_.finish("failed"); }

 private:
  Image draw() const { return freshet::draw(sim_.scene(), sim_.frame()); }

  Simulation& sim_;
  Schedule schedule_;
  double before_ = 0;                // the last step
  std::vector<Vector> wall_forces_;  // as last observed
  std::optional<VideoOptions> video_;
  RunFolder folder_;
  std::optional<Video> film_;
  std::int64_t frames_ = 0, filmed_ = 0;
  std::string observables_ = observables_header(sim_.scene());
};

/// Steps to the end, or until after_step says no. Returns the seconds that the steps took.
double steps(Simulation& sim, Observer& observer, const RunOptions& options, bool& interrupted) {
  using Clock = std::chrono::steady_clock;
  double seconds = 0;
  while (!sim.finished() && !interrupted) {
    const auto start = Clock::now();
    sim.step();
    seconds += std::chrono::duration<double>(Clock::now() - start).count();
    observer.after_step();
    interrupted = options.after_step && !options.after_step(sim, seconds);
  }
  return seconds;
}

Report report_of(const Simulation& sim, const RunOptions& options) {
  Report r;
  r.scene = options.scene_name;
  r.title = sim.scene().title;
  r.backend = backend_words[int(sim.scene().solver.backend)];
  r.solver = solver_words[int(sim.scene().solver.name)];
  r.steps = sim.steps_done();
  r.time = sim.time();
  r.time_steps = sim.time_steps();
  r.statistics = sim.statistics();
  r.verbs = sim.timings();
  r.state_sha256 = sim.state_sha256();
  r.kept_sha256 = sim.kept_sha256();
  return r;
}

}  // namespace

Report run(const Scene& scene, const RunOptions& options) {
  Simulation sim(scene, options.execution);
  if (options.video) Video::check(options.video->file, options.overwrite);
  Observer observer(sim, options);
  try {
    bool interrupted = false;
    const double seconds = steps(sim, observer, options, interrupted);
    Report report = report_of(sim, options);
    report.seconds = seconds;
    if (interrupted && !sim.finished()) report.state = Report::State::interrupted;
    observer.finish(report);
    return report;
  } catch (...) {
    try {
      observer.fail();
    } catch (const Error&) {  // the disk may be full: the first error is the one to tell
    }
    throw;
  }
}

}  // namespace freshet
