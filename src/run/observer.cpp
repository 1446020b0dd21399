// SPDX-License-Identifier: MIT
#include "run/observer.h"

#include <fmt/format.h>

#include <exception>
#include <memory>

#include "render/dots.h"
#include "render/draw.h"
#include "render/png.h"
#include "run/checks.h"
#include "scene/keys/keys.h"

namespace freshet {
namespace {

constexpr double seconds_between_checkpoints = 300;
constexpr std::size_t checkpoints_that_stay = 2;
constexpr const char* failure_picture = "failure.png";

std::string checkpoint_name(std::int64_t step) {
  return fmt::format("{}/step_{:09}.h5", checkpoint_folder, step);
}

Provenance provenance(const Scene& scene, const Execution& execution,
                      const std::vector<std::string>& command) {
  const bool cpu = scene.solver.backend == BackendName::cpu;
  return {command, backend_words[int(scene.solver.backend)],
          cpu ? instruction_set(execution.isa) : "plain",
          cpu ? thread_count(execution.threads) : 1};
}

RunRecord record_of(const RunOptions& options) {
  RunRecord record;
  record.scene_name = options.scene_name;
  record.video = options.video;
  if (record.video) record.video->file = std::filesystem::absolute(record.video->file);
  return record;
}

}  // namespace

Observer::Observer(Simulation& sim, FolderLock lock, RunRecord record, Inputs inputs)
    : sim_(sim),
      schedule_(sim.scene()),
      record_(std::move(record)),
      inputs_(std::move(inputs)),
      folder_(std::move(lock)),
      tables_(record_, folder_, background_),
      outputs_(outputs_of({sim_, schedule_, record_, folder_, background_, tables_, ranges_})) {
  prepare_checkpoints();
}

Observer::Observer(Simulation& sim, const RunOptions& options)
    : Observer(sim, FolderLock::of_new(options.output), record_of(options),
               inputs_of(sim.scene())) {
  begin_or_fail([&] { begin(options); });
}

Observer::Observer(Simulation& sim, const ResumeOptions& options, FolderLock lock, RunRecord record)
    : Observer(sim, std::move(lock), std::move(record),
               {sim.scene().source, {}}) {  // the input files lie in the folder
  begin_or_fail([&] { begin(options); });
}

/// An error while a run begins closes the manifest, if it is the run's by then.
template <class Begin> void Observer::begin_or_fail(const Begin& begin) {
  try {
    begin();
  } catch (...) {
    come_to_rest();
    folder_.fail();
    throw;
  }
}

void Observer::begin(const RunOptions& options) {
  folder_.take(options.overwrite ? RunFolder::Take::overwrite : RunFolder::Take::empty, plan(),
               provenance(sim_.scene(), options.execution, options.command));
  for (const auto& [name, bytes] : inputs_.files) folder_.write(name, bytes);
  folder_.write("scene.toml", inputs_.source);
  for (const auto& output : outputs_) output->start();
}

void Observer::begin(const ResumeOptions& options) {
  folder_.take(RunFolder::Take::resume, plan(),
               provenance(sim_.scene(), options.execution, options.command));
  before_ = sim_.time();
  saved_ = sim_.steps_done();
  for (const auto& file : checkpoints_of(options.folder))
    checkpoints_.push_front(fmt::format("{}/{}", checkpoint_folder, file.filename().string()));
  folder_.write("scene.toml", inputs_.source);
  folder_.remove("report.json");
  const bool prolonged = !sim_.finished();
  if (prolonged)
    for (auto& [name, series] : record_.series) series.times.resize(series.scheduled);
  std::vector<Diagnostic> missing = tables_.resume(prolonged);
  for (const auto& output : outputs_)
    for (Diagnostic& d : output->resume()) missing.push_back(std::move(d));
  if (options.warn && !missing.empty()) options.warn(missing);
}

/// Checkpoints get their names later. Those in the folder are planned: a run may replace and rotate
/// its own, and those of others must not be there.
RunPlan Observer::plan() const {
  RunPlan plan{{"result.png", "scene.toml", "report.json", failure_picture}, {checkpoint_folder}};
  for (const auto& [name, bytes] : inputs_.files) plan.files.push_back(name);
  for (const auto& output : outputs_)
    for (std::string& file : output->files()) plan.files.push_back(std::move(file));
  for (const std::string& name : checkpoint_names(folder_.path()))
    plan.files.push_back(fmt::format("{}/{}", checkpoint_folder, name));
  return plan;
}

void Observer::write(Output& output, const StepTaken& step) {
  record_.written[output.name()] = sim_.steps_done();
  output.write(step);
}

void Observer::after_step(double seconds) {
  record_.seconds = seconds;
  const StepTaken step{sim_.steps_done() - 1, before_, sim_.time(), false};
  before_ = sim_.time();
  for (const auto& output : outputs_)
    if (output->due(step)) write(*output, step);
  remember_scheduled();
  if (sim_.finished()) {
    for (const auto& output : outputs_)
      if (output->writes_the_end() && record_.written[output->name()] != sim_.steps_done())
        write(*output, step);
    return save();
  }
  const bool by_clock =
      schedule_.checkpoints_by_clock() &&
      Clock::now() - saved_at_ > std::chrono::duration<double>(seconds_between_checkpoints);
  if (by_clock || schedule_.checkpoint_after(step)) save();
}

void Observer::remember_scheduled() {
  for (auto& [name, series] : record_.series) series.scheduled = series.times.size();
  for (auto& [file, table] : record_.tables) table.scheduled = table.bytes;
}

void Observer::save() {
  if (saved_ == sim_.steps_done()) return;
  tables_.flush();
  auto checkpoint = std::make_shared<RunCheckpoint>(sim_.checkpoint());
  checkpoint->scene = inputs_.source;
  checkpoint->run = record_;
  saved_ = sim_.steps_done();
  saved_at_ = Clock::now();
  background_.add([this, checkpoint] {
    for (auto& [file, table] : checkpoint->run.tables) {
      table.sha256 = folder_.appended_sha256(file, table.bytes);
      table.scheduled_sha256 = folder_.appended_sha256(file, table.scheduled);
    }
    const std::string name = checkpoint_name(checkpoint->steps);
    folder_.write_more(name, encode_checkpoint(*checkpoint));
    std::erase(checkpoints_, name);
    checkpoints_.push_back(name);
    for (; checkpoints_.size() > checkpoints_that_stay; checkpoints_.pop_front())
      folder_.remove(checkpoints_.front());
  });
}

void Observer::finish(Report& report) {
  tables_.flush();
  background_.wait();
  const Image result = draw(sim_.scene(), sim_.frame(), ranges_);
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
  for (const auto& output : outputs_) output->finish();
  folder_.write("result.png", encode_png(result));
  folder_.write("report.json", to_json(report));
  folder_.finish(report.state == Report::State::interrupted       ? "interrupted"
                 : report.state == Report::State::cannot_be_right ? "failed"
                                                                  : "done");
}

std::string Observer::fail() {
  const bool whole = come_to_rest();
  folder_.mark_failed();  // first: what follows needs memory and room on the disk
  std::string message;
  try {
    if (whole) {
      folder_.write_more(failure_picture, encode_png(draw(sim_.scene(), sim_.frame(), ranges_)));
      tables_.flush_now();
      message = fmt::format("; {} shows the moment", (folder_.path() / failure_picture).string());
    }
  } catch (const std::exception&) {  // a full disk, say: the first error is the one to report
  }
  folder_.fail();
  if (!checkpoints_.empty())
    message += fmt::format("; the last good checkpoint is {}",
                           (folder_.path() / checkpoints_.back()).string());
  return message;
}

bool Observer::come_to_rest() noexcept {
  try {
    background_.wait();
  } catch (...) {  // a job failed, and none is done after it
    return false;
  }
  return true;
}

}  // namespace freshet
