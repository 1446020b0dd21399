// SPDX-License-Identifier: MIT
#include "freshet/run.h"

#include <fmt/format.h>

#include <chrono>
#include <new>

#include "core/input_file.h"
#include "run/observer.h"
#include "run/record_of_scene.h"
#include "run/video_output.h"
#include "scene/keys/keys.h"
#include "scene/keys/override_place.h"
#include "scene/keys/same_steps.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

/// Steps to the end, or until after_step says no, which is told.
bool steps(Simulation& sim, Observer& observer, const AfterStep& after_step) {
  using Clock = std::chrono::steady_clock;
  double seconds = observer.record().seconds;
  while (!sim.finished()) {
    observer.before_step();
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

/// The scene.toml of a run folder; empty if it is missing.
std::string scene_text_in(const fs::path& folder) {
  const fs::path file = folder / "scene.toml";
  constexpr InputFile scene{.noun = "scene file", .may_be_empty = true};
  return fs::exists(file) ? read_input(file, scene) : "";
}

/// A checkpoint may have been copied from another run. Earlier resumes may have changed the keys in
/// scene.toml that no step depends on.
void check_scene(const RunCheckpoint& c, const fs::path& checkpoint, const fs::path& folder) {
  const std::string text = scene_text_in(folder), file = (folder / "scene.toml").string();
  if (text.empty()) return;
  const std::string key = differing_key(c.scene, checkpoint.string(), text, file);
  if (!key.empty())
    throw Error(Error::Kind::scene, checkpoint.string(),
                fmt::format("this checkpoint is of another scene: {} differs from {}; move away "
                            "the checkpoint if it is of another run, or else put back scene.toml",
                            key, file));
}

/// The newest checkpoint that is whole; what is wrong with newer ones is told.
RunCheckpoint newest_checkpoint(const ResumeOptions& options) {
  std::vector<Diagnostic> wrong;
  for (const fs::path& file : checkpoints_of(options.folder)) {
    RunCheckpoint c;
    try {
      c = read_checkpoint(file);
    } catch (const Error& error) {
      wrong.push_back(error.diagnostics().front());
      continue;
    }
    check_scene(c, file, options.folder);
    for (Diagnostic& d : wrong) {
      d.severity = Diagnostic::Severity::warning;
      d.message += fmt::format("; going on from step {}", c.steps);
    }
    if (options.warn) options.warn(wrong);
    return c;
  }
  if (!wrong.empty()) throw Error(Error::Kind::run, std::move(wrong));
  const bool is_run = fs::exists(options.folder / "manifest.json");
  throw Error(Error::Kind::scene, options.folder.string(),
              is_run ? "this run has left no checkpoint to resume from; run its scene.toml again, "
                       "and set output.checkpoint_every"
                     : "this folder holds no run; name the folder of one");
}

/// A run cannot end before the moment that it has reached. An end within the last step is that of
/// a run that has reached it.
void check_end(const Simulation& sim, const ResumeOptions& options) {
  for (const auto& [key, value] : options.overrides)
    if (key == "time.end" &&
        sim.scene().time.end <= sim.time() - sim.time_steps().last * (1 - 1e-6))
      throw Error(
          Error::Kind::scene, "override time.end",
          fmt::format("time.end must be later than {:g} s, which the run has reached", sim.time()));
}

/// The run's own video is replaced, another file is not.
void check_resumed_video(const Scene& scene, const ResumeOptions& options, RunRecord& record) {
  const bool moves = !options.video.empty();
  if (moves && !record.video)
    throw Error(Error::Kind::scene, "option video " + options.video.string(),
                "this run makes no video; remove the option, or run the scene again with it");
  if (moves) record.video->file = fs::absolute(options.video);
  if (!record.video) return;
  try {
    check_video_of(scene, *record.video, !moves);
  } catch (const Error& error) {
    auto diagnostics = error.diagnostics();
    diagnostics.back().message += "; `video` names another file";
    diagnostics.back().options.push_back("video");
    throw Error(error.kind(), std::move(diagnostics));
  }
}

}  // namespace

Report run(const Scene& scene, const RunOptions& options) {
  Simulation sim(scene, options.execution);
  if (options.video) check_video_of(scene, *options.video, options.overwrite);
  Observer observer(sim, options);
  return run_observed(sim, observer, options.after_step);
}

Report resume(const ResumeOptions& options) {
  for (const Override& change : options.overrides)
    if (steps_depend_on(change.first) && steps_depend_on(change.first + "."))
      throw Error(
          Error::Kind::scene, place_of(change),
          "this changes what has been simulated; a resumed run can change time.end and the "
          "keys of output, surface, picture, camera and checks; for another simulation, run its "
          "scene.toml with this change");
  std::error_code ec;
  if (!fs::is_directory(options.folder, ec))
    throw Error(Error::Kind::scene, options.folder.string(),
                fs::exists(options.folder, ec)
                    ? "this is not a folder; name the folder of a run"
                    : "there is no such folder, and no run to resume; name the folder of a run");
  FolderLock lock(options.folder);
  RunCheckpoint checkpoint = newest_checkpoint(options);
  // an earlier resume may have prolonged the run and been killed before its first checkpoint
  const std::string text = scene_text_in(options.folder);
  const Scene scene = parse_scene(text.empty() ? checkpoint.scene : text,
                                  (options.folder / "scene.toml").string(), options.overrides);
  Simulation sim(scene, options.execution);
  sim.restore(checkpoint);
  check_record_of_scene(checkpoint.run, scene);
  check_end(sim, options);
  if (sim.finished() && fs::exists(options.folder / "report.json"))
    throw Error(
        Error::Kind::scene, options.folder.string(),
        fmt::format("this run has reached its end, {:g} s; `time.end` prolongs it", scene.time.end),
        {"time.end"});
  check_resumed_video(scene, options, checkpoint.run);
  if (checkpoint.run.video && options.tell_video) options.tell_video(checkpoint.run.video->file);
  Observer observer(sim, options, std::move(lock), std::move(checkpoint.run));
  return run_observed(sim, observer, options.after_step);
}

}  // namespace freshet
