// SPDX-License-Identifier: MIT
#include "freshet/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <new>

#include "io/video.h"
#include "run/observer.h"
#include "scene/keys/keys.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

/// Steps to the end, or until after_step says no, which is told.
bool steps(Simulation& sim, Observer& observer, const AfterStep& after_step) {
  using Clock = std::chrono::steady_clock;
  double seconds = observer.record().seconds;
  while (!sim.finished()) {
    const auto start = Clock::now();
    sim.step();
    seconds += std::chrono::duration<double>(Clock::now() - start).count();
    observer.after_step(seconds);
    if (after_step && !after_step(sim, seconds) && !sim.finished()) return false;
  }
  return true;
}

Report report_of(const Simulation& sim, const RunRecord& record) {
  Report r;
  r.scene = record.scene_name;
  r.title = sim.scene().title;
  r.backend = backend_words[int(sim.scene().solver.backend)];
  r.solver = sim.scene().method().name;
  r.steps = sim.steps_done();
  r.time = sim.time();
  r.seconds = record.seconds;
  r.time_steps = sim.time_steps();
  r.solves = sim.solves();
  r.statistics = sim.statistics();
  const std::vector<BodyState> bodies = sim.bodies();
  for (std::size_t k = 0; k < bodies.size(); ++k)
    r.bodies.emplace_back(sim.scene().body_name(k), bodies[k]);
  r.warnings = sim.warnings();
  r.verbs = sim.timings();
  r.state_sha256 = sim.state_sha256();
  r.kept_sha256 = sim.kept_sha256();
  return r;
}

/// The error with what is left of the run.
[[noreturn]] void rethrow(const Error& error, const std::string& words) {
  auto diagnostics = error.diagnostics();
  diagnostics.back().message += words;
  throw Error(error.kind(), std::move(diagnostics));
}

Report run_observed(Simulation& sim, Observer& observer, const AfterStep& after_step) {
  try {
    const bool ended = steps(sim, observer, after_step);
    if (!ended) observer.save();
    Report report = report_of(sim, observer.record());
    if (!ended) report.state = Report::State::interrupted;
    observer.finish(report);
    return report;
  } catch (const Error& error) {
    rethrow(error, observer.fail());
  } catch (const std::bad_alloc&) {
    const std::string left = observer.fail();
    throw Error(Error::Kind::run, "",
                fmt::format("out of memory at step {}, {:.6g} s; make particles.spacing larger, or "
                            "free memory for the run{}",
                            sim.steps_done(), sim.time(), left));
  } catch (...) {  // an exception of after_step, for example
    observer.fail();
    throw;
  }
}

/// Keys that no step depends on.
bool may_change(const std::string& key) {
  static constexpr const char* free[] = {"time.end", "title", "description"};
  static constexpr const char* free_tables[] = {"output.", "picture.", "camera", "checks."};
  return std::any_of(std::begin(free), std::end(free), [&](auto name) { return key == name; }) ||
         std::any_of(std::begin(free_tables), std::end(free_tables),
                     [&](auto table) { return key.starts_with(table); });
}

/// The newest checkpoint that is whole; what is wrong with newer ones is told.
RunCheckpoint newest_checkpoint(const ResumeOptions& options) {
  std::vector<Diagnostic> wrong;
  for (const fs::path& file : checkpoints_of(options.folder)) {
    try {
      RunCheckpoint c = read_checkpoint(file);
      for (Diagnostic& d : wrong) {
        d.severity = Diagnostic::Severity::warning;
        d.message += fmt::format("; going on from step {}", c.steps);
      }
      if (options.warn) options.warn(wrong);
      return c;
    } catch (const Error& error) {
      wrong.push_back(error.diagnostics().front());
    }
  }
  if (!wrong.empty()) throw Error(Error::Kind::run, std::move(wrong));
  const bool is_run = fs::exists(options.folder / "manifest.json");
  throw Error(Error::Kind::scene, options.folder.string(),
              is_run ? "this run has left no checkpoint to go on from; run its scene.toml again, "
                       "and see output.checkpoint_every"
                     : "this folder holds no run; name the folder of one");
}

}  // namespace

Report run(const Scene& scene, const RunOptions& options) {
  Simulation sim(scene, options.execution);
  if (options.video) Video::check(options.video->file, options.overwrite);
  Observer observer(sim, options);
  return run_observed(sim, observer, options.after_step);
}

Report resume(const ResumeOptions& options) {
  for (const auto& [key, value] : options.overrides)
    if (!may_change(key))
      throw Error(Error::Kind::scene, "override " + key,
                  "this changes what has been simulated; a run that goes on takes time.end and "
                  "the keys of output, picture, camera and checks; for another simulation, run "
                  "its scene.toml");
  std::error_code ec;
  if (!fs::is_directory(options.folder, ec))
    throw Error(Error::Kind::scene, options.folder.string(),
                fs::exists(options.folder, ec)
                    ? "this is not a folder; name the folder of a run"
                    : "there is no such folder, and no run to resume; name the folder of a run");
  FolderLock lock(options.folder);
  RunCheckpoint checkpoint = newest_checkpoint(options);
  const Scene scene =
      parse_scene(checkpoint.scene, (options.folder / "scene.toml").string(), options.overrides);
  Simulation sim(scene, options.execution);
  sim.restore(checkpoint);
  if (sim.finished() && fs::exists(options.folder / "report.json"))
    throw Error(
        Error::Kind::scene, options.folder.string(),
        fmt::format("this run has reached its end, {:g} s; `time.end` prolongs it", scene.time.end),
        {"time.end"});
  Observer observer(sim, options, std::move(lock), std::move(checkpoint.run));
  return run_observed(sim, observer, options.after_step);
}

}  // namespace freshet
