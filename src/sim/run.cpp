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

std::string observables_line(const Simulation& s) {
  const Statistics t = s.statistics();
  return fmt::format("{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n",
                     s.steps_done(), s.time(), t.kinetic_energy, t.potential_energy, t.momentum_x,
                     t.momentum_y, t.density_mean, t.density_max, t.speed_mean, t.speed_max);
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
  Observer(const Simulation& sim, const RunOptions& options)
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
    const std::int64_t step = sim_.steps_done() - 1;  // counted from 0
    if (schedule_.observe_after(step)) observables_ += observables_line(sim_);
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
  Image draw() const { return draw_dots(sim_.scene(), sim_.fluid()); }

  const Simulation& sim_;
  Schedule schedule_;
  std::optional<VideoOptions> video_;
  RunFolder folder_;
  std::optional<Video> film_;
  std::int64_t frames_ = 0, filmed_ = 0;
  std::string observables_ =
      "step,time [s],kinetic energy [J],potential energy [J],momentum x [kg m/s],"
      "momentum y [kg m/s],density mean [kg/m^2],density max [kg/m^2],speed mean [m/s],"
      "speed max [m/s]\n";
};

/// Steps to the end, or until after_step says no. Returns the seconds that the steps took.
double steps(Simulation& sim, Observer& observer, const RunOptions& options, bool& interrupted) {
  using Clock = std::chrono::steady_clock;
  double seconds = 0;
  while (sim.steps_done() < sim.scene().steps() && !interrupted) {
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
    if (interrupted && sim.steps_done() < scene.steps()) report.state = Report::State::interrupted;
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
