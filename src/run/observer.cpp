// SPDX-License-Identifier: MIT
#include "run/observer.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <memory>

#include "io/frame_data.h"
#include "render/dots.h"
#include "render/draw.h"
#include "render/png.h"
#include "run/body_table.h"
#include "run/checks.h"
#include "run/observables.h"
#include "scene/keys/keys.h"
#include "scene/model/body_mesh.h"
#include "scene/model/body_shape.h"

namespace freshet {
namespace {

constexpr double seconds_between_checkpoints = 300;
constexpr std::size_t checkpoints_that_stay = 2;
constexpr const char* failure_picture = "failure.png";

std::string frame_name(std::int64_t k) { return fmt::format("frames/frame_{:04}.png", k); }
std::string checkpoint_name(std::int64_t step) {
  return fmt::format("checkpoints/step_{:09}.h5", step);
}

std::string body_file(std::size_t k) { return fmt::format("bodies/body_{:03}.obj", k); }

std::vector<std::string> planned_files(const Schedule& schedule, const Inputs& inputs,
                                       const Scene& scene) {
  std::vector<std::string> files{"result.png", "observables.csv", "scene.toml", "report.json"};
  for (std::int64_t k = 0; k < schedule.frames(); ++k) files.push_back(frame_name(k));
  for (const auto& [name, bytes] : inputs.files) files.push_back(name);
  for (std::size_t k = 0; k < scene.probe.size(); ++k) files.push_back(probe_file(scene, k));
  for (std::string& name : data_files(scene.output, schedule.data_frames())) files.push_back(name);
  if (!scene.body.empty()) files.push_back("bodies.csv");
  for (std::size_t k = 0; k < scene.body.size() && scene.dimension() == 3; ++k)
    files.push_back(body_file(k));
  return files;
}

Provenance provenance(const Scene& scene, const Execution& execution,
                      const std::vector<std::string>& command) {
  const bool cpu = scene.solver.backend == BackendName::cpu;
  return {command, backend_words[int(scene.solver.backend)],
          cpu ? instruction_set(execution.isa) : "plain",
          cpu ? thread_count(execution.threads) : 1};
}

}  // namespace

Observer::Observer(Simulation& sim, const RunOptions& options)
    : sim_(sim),
      schedule_(sim.scene()),
      probes_(sim.scene()),
      inputs_(inputs_of(sim.scene())),
      folder_(options.output,
              options.overwrite ? RunFolder::Take::overwrite : RunFolder::Take::empty,
              planned_files(schedule_, inputs_, sim.scene()),
              provenance(sim.scene(), options.execution, options.command)),
      video_(options.video) {
  record_.scene_name = options.scene_name;
  record_.observables = observables_header(sim.scene());
  for (std::size_t k = 0; k < probes_.size(); ++k) record_.probes.push_back(probes_.header(k));
  record_.bodies = body_header(sim.scene());
  const Scene& scene = sim.scene();
  for (std::size_t k = 0; k < scene.body.size() && scene.dimension() == 3; ++k)
    folder_.write(body_file(k), encode_obj(body_mesh(scene.body[k]),
                                           body_shape(scene.body[k]).center, scene.body_name(k)));
  for (const auto& [name, bytes] : inputs_.files) folder_.write(name, bytes);
  folder_.write("scene.toml", inputs_.source);
  const auto& picture = sim.scene().picture;
  if (video_) film_.emplace(video_->file, int(picture.width), int(picture.height), video_->fps);
}

Observer::Observer(Simulation& sim, const ResumeOptions& options, FolderLock lock, RunRecord record)
    : sim_(sim),
      schedule_(sim.scene()),
      record_(std::move(record)),
      probes_(sim.scene()),
      inputs_{sim.scene().source, {}},  // they lie in the folder
      folder_(std::move(lock), RunFolder::Take::resume,
              planned_files(schedule_, inputs_, sim.scene()),
              provenance(sim.scene(), options.execution, options.command)),
      before_(sim.time()),
      saved_(sim.steps_done()) {
  for (const auto& file : checkpoints_of(options.folder))
    checkpoints_.push_front("checkpoints/" + file.filename().string());
  folder_.write("scene.toml", inputs_.source);
  folder_.remove("report.json");
  if (sim.finished()) return;
  record_.frames = record_.scheduled_frames;
  record_.data_times.resize(record_.scheduled_data);
  record_.observables.resize(record_.scheduled_observables);
  for (std::size_t k = 0; k < probes_.size(); ++k)
    record_.probes[k].resize(record_.scheduled_probes[k]);
  record_.bodies.resize(record_.scheduled_bodies);
}

void Observer::after_step(double seconds) {
  record_.seconds = seconds;
  const StepTaken step{sim_.steps_done() - 1, before_, sim_.time(), false};
  before_ = sim_.time();
  if (schedule_.observe_after(step)) observe();
  probe(step);
  if (schedule_.frame_after(step)) draw_frame();
  if (schedule_.data_after(step)) write_data();
  film();
  remember_scheduled();
  if (sim_.finished()) return after_last_step();
  const bool by_clock =
      schedule_.checkpoints_by_clock() &&
      Clock::now() - saved_at_ > std::chrono::duration<double>(seconds_between_checkpoints);
  if (by_clock || schedule_.checkpoint_after(step)) save();
}

void Observer::remember_scheduled() {
  record_.scheduled_frames = record_.frames;
  record_.scheduled_data = record_.data_times.size();
  record_.scheduled_observables = record_.observables.size();
  record_.scheduled_bodies = record_.bodies.size();
  record_.scheduled_probes.clear();
  for (const std::string& table : record_.probes) record_.scheduled_probes.push_back(table.size());
}

/// What the end asks for and the schedule did not.
void Observer::after_last_step() {
  if (record_.observed_step != sim_.steps_done()) observe();
  if (record_.frame_step != sim_.steps_done()) draw_frame();
  if (record_.data_step != sim_.steps_done()) write_data();
  save();
}

void Observer::observe() {
  record_.observed_step = sim_.steps_done();
  record_.wall_forces = sim_.wall_forces();
  record_.flows = sim_.flows();
  record_.observables += observables_line(sim_, record_.wall_forces, record_.flows);
  note_bodies();
}

void Observer::note_bodies() {
  if (record_.bodies_step == sim_.steps_done()) return;
  record_.bodies_step = sim_.steps_done();
  record_.bodies += body_lines(sim_);
}

void Observer::probe(const StepTaken& step) {
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < probes_.size(); ++k) {
    if (!schedule_.probe_after(k, step)) continue;
    if (lines.empty()) lines = probes_.look(sim_);
    record_.probes[k] += lines[k];
  }
}

void Observer::draw_frame() {
  record_.frame_step = sim_.steps_done();
  background_.add([this, k = record_.frames++, frame = std::make_shared<Frame>(sim_.frame())] {
    folder_.write(frame_name(k), encode_png(draw(sim_.scene(), *frame)));
  });
  write_observables();
}

void Observer::write_data() {
  const Scene::Output& output = sim_.scene().output;
  if (output.data.empty()) return;
  record_.data_step = sim_.steps_done();
  record_.data_times.push_back(sim_.time());
  note_bodies();  // so that the frame can be drawn again
  background_.add([this, &output, times = record_.data_times,
                   frame = std::make_shared<Frame>(sim_.frame())] {
    const auto k = std::int64_t(times.size()) - 1;
    for (const DataFormat format : output.data)
      folder_.write_more(data_file(format, k), encode_frame(format, *frame, DataFields(output)));
    if (std::find(output.data.begin(), output.data.end(), DataFormat::vtp) == output.data.end())
      return;
    std::vector<std::string> names;
    for (std::int64_t n = 0; n <= k; ++n) names.push_back(data_file(DataFormat::vtp, n));
    folder_.write(pvd_file, encode_pvd(times, names));
  });
}

void Observer::write_observables() {
  background_.add([this, table = record_.observables, probes = record_.probes] {
    folder_.write("observables.csv", table);
    for (std::size_t k = 0; k < probes.size(); ++k)
      folder_.write(probe_file(sim_.scene(), k), probes[k]);
  });
  if (!record_.bodies.empty())
    background_.add([this, table = record_.bodies] { folder_.write("bodies.csv", table); });
}

void Observer::film() {
  const auto due = [this] { return double(filmed_) / video_->fps <= sim_.time() + 1e-12; };
  if (!film_ || !due()) return;
  int times = 0;
  for (; due(); ++filmed_) ++times;
  background_.add([this, times, frame = std::make_shared<Frame>(sim_.frame())] {
    const Image image = draw(sim_.scene(), *frame);
    for (int k = 0; k < times; ++k) film_->add(image);
  });
}

void Observer::save() {
  if (saved_ == sim_.steps_done()) return;
  auto checkpoint = std::make_shared<RunCheckpoint>(sim_.checkpoint());
  checkpoint->scene = inputs_.source;
  checkpoint->run = record_;
  saved_ = sim_.steps_done();
  saved_at_ = Clock::now();
  background_.add([this, checkpoint] {
    const std::string name = checkpoint_name(checkpoint->steps);
    folder_.write_more(name, encode_checkpoint(*checkpoint));
    std::erase(checkpoints_, name);
    checkpoints_.push_back(name);
    for (; checkpoints_.size() > checkpoints_that_stay; checkpoints_.pop_front())
      folder_.remove(checkpoints_.front());
  });
}

void Observer::finish(Report& report) {
  background_.wait();
  const Image result = draw(sim_.scene(), sim_.frame());
  report.picture = picture_statistics(result);
  const auto names = sim_.scene().wall_names();
  for (std::size_t w = 0; w < record_.wall_forces.size(); ++w)
    report.wall_forces.emplace_back(names[w], record_.wall_forces[w]);
  report.flows = record_.flows;
  report.checks = evaluate(sim_.scene().checks, report);
  for (const CheckResult& check : report.checks)
    if (!check.passed && report.state == Report::State::done)
      report.state = Report::State::check_failed;
  for (const Warning& warning : report.warnings)
    if (warning.cannot_be_right && report.state != Report::State::interrupted)
      report.state = Report::State::cannot_be_right;
  if (film_) film_->finish();
  folder_.write("result.png", encode_png(result));
  folder_.write("observables.csv", record_.observables);
  for (std::size_t k = 0; k < probes_.size(); ++k)
    folder_.write(probe_file(sim_.scene(), k), record_.probes[k]);
  if (!record_.bodies.empty()) folder_.write("bodies.csv", record_.bodies);
  folder_.write("report.json", to_json(report));
  folder_.finish(report.state == Report::State::interrupted       ? "interrupted"
                 : report.state == Report::State::cannot_be_right ? "failed"
                                                                  : "done");
}

std::string Observer::fail() {
  std::string words;
  try {
    background_.wait();
    folder_.write_more(failure_picture, encode_png(draw(sim_.scene(), sim_.frame())));
    folder_.write("observables.csv", record_.observables);
    if (!record_.bodies.empty()) folder_.write("bodies.csv", record_.bodies);
    words = fmt::format("; {} shows the moment", (folder_.path() / failure_picture).string());
  } catch (const std::exception&) {  // the disk may be full: the first error is the one to tell
  }
  if (!checkpoints_.empty())
    words += fmt::format("; the last good checkpoint is {}",
                         (folder_.path() / checkpoints_.back()).string());
  try {
    folder_.finish("failed");
  } catch (const std::exception&) {
  }
  return words;
}

}  // namespace freshet
