// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <new>
#include <nlohmann/json.hpp>
#include <optional>

#include "closing_table.h"
#include "command.h"
#include "freshet/run.h"
#include "interrupts.h"
#include "memory.h"
#include "output_folder.h"
#include "print.h"
#include "progress.h"

namespace freshet::cli {
namespace {

struct RunArguments {
  SceneArguments scene;
  std::string output, log = "text", video;
  double fps = 30, speed = 1;
  bool overwrite = false, quiet = false;
};

/// The warnings before the first step: lines, or events.
void warn(const std::vector<Diagnostic>& warnings, const Progress& progress) {
  for (const Diagnostic& d : warnings) {
    const Diagnostic shown = in_command_line_words(d);
    progress.event(json_text(nlohmann::ordered_json{{"event", "warning"},
                                                    {"kind", "scene"},
                                                    {"place", shown.place},
                                                    {"message", shown.message}}));
    if (progress.style() != Progress::Style::json && progress.style() != Progress::Style::quiet)
      print_diagnostics({d});
  }
}

/// What the conversion of another program's scene takes instead: lines, or events.
void tell(const std::vector<ImportNote>& notes, const Progress& progress) {
  for (const ImportNote& note : notes)
    progress.event(json_text(nlohmann::ordered_json{
        {"event", "note"}, {"place", note.place}, {"key", note.key}, {"message", note.message}}));
  if (progress.style() != Progress::Style::json && progress.style() != Progress::Style::quiet)
    print_notes(notes);
}

/// The scene of a file: TOML, or a scene of another program.
Scene scene_of(const std::filesystem::path& file, const std::vector<Override>& overrides,
               const Progress& progress) {
  if (!is_foreign_scene(file)) return load_scene(file, overrides);
  const ImportedScene imported = import_foreign(file, file.parent_path());
  tell(imported.notes, progress);
  return load_converted(imported, file, overrides);
}

/// A warning when it is first seen: a line for people, or an event.
void tell(const Warning& w, Progress& progress) {
  progress.event(json_text(nlohmann::ordered_json{{"event", "warning"},
                                                  {"kind", w.kind},
                                                  {"step", w.first_step},
                                                  {"time", w.first_time},
                                                  {"message", w.message}}));
  if (progress.style() == Progress::Style::json || progress.style() == Progress::Style::quiet)
    return;
  progress.end();
  print_diagnostics({{Diagnostic::Severity::warning, "", w.message}});
}

/// A command of this program, as a shell reads it.
std::string shell_command(const std::string& program, const std::string& verb,
                          const std::filesystem::path& folder) {
  const auto quoted = [](const std::string& word) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+./:,@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string out = "'";
    for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
  };
  return quoted(program) + " " + verb + " " + quoted(folder.string());
}

/// Where a run writes, and what resumes it.
struct Place {
  std::filesystem::path output;
  std::string video;  // empty without --video
  std::string resume;

  Place(std::filesystem::path folder, std::string film,
        const std::vector<std::string>& command_line)
      : output(std::move(folder)),
        video(std::move(film)),
        resume(shell_command(command_line.front(), "resume", output)) {}
};

std::string end_event(const Report& r, const Place& place) {
  const bool cut = r.state == Report::State::interrupted;
  nlohmann::ordered_json json{{"event", cut ? "interrupted" : "done"},
                              {"steps", r.steps},
                              {"seconds", r.seconds},
                              {"output", place.output.string()},
                              {"state_sha256", r.state_sha256}};
  if (cut) json["resume"] = place.resume;
  for (const SolveStatistics& s : r.solves)
    json["solves"].push_back({{"name", s.name},
                              {"mean_iterations", s.mean_iterations()},
                              {"most_iterations", s.most_iterations},
                              {"error", s.last_error},
                              {"worst_error", s.worst_error},
                              {"not_converged", s.not_converged}});
  if (!r.solves.empty()) json["retried"] = r.time_steps.retried;
  return json_text(json);
}

int finish(const Report& r, const std::string& table, const Place& place,
           const Progress& progress) {
  const bool cut = r.state == Report::State::interrupted;
  progress.say(
      fmt::format("{}{} steps, {:.4g} s simulated in {}: {} particle-steps/s\n{}"
                  "wrote {}{}{}",
                  cut ? "interrupted after " : "", r.steps, r.time, duration(r.seconds),
                  short_number(r.particle_steps_per_second()), table,
                  printable((place.output / "result.png").string()),
                  place.video.empty() ? "" : "\nwrote " + printable(place.video),
                  cut ? "\nto resume: " + place.resume : ""));
  progress.event(end_event(r, place));
  for (const CheckResult& c : r.checks)
    if (!c.passed && !cut)
      print_error("error: check failed: {} is {:g}, and must be {} {:g}\n", c.name, c.value,
                  c.relation, c.bound);
  for (const Warning& w : r.warnings)
    if (r.state == Report::State::cannot_be_right && w.cannot_be_right)
      print_error("error: the run cannot be right: {} (in {} health check{}, last at step {})\n",
                  w.message, w.looks, w.looks == 1 ? "" : "s", w.last_step);
  return cut ? interrupted : r.state == Report::State::done ? done : failed;
}

/// What run and resume have in common.
struct Outcome {
  Progress progress;
  std::optional<Scene> scene = {};  // from the first step on
  std::size_t reported = 0;         // warnings

  AfterStep after_step() {
    return [this](const Simulation& sim, double seconds) {
      if (!scene) {
        scene = sim.scene();
        progress.start(sim);
      }
      progress.update(sim, seconds);
      while (reported < sim.warnings().size()) tell(sim.warnings()[reported++], progress);
      if (memory_ran_short()) throw std::bad_alloc();
      return !stop_asked();
    };
  }
  template <class Run> int of(Run run, const Place& place) {
    catch_interrupts();
    try {
      const Report report = run();
      progress.end();
      return finish(report, scene ? closing_table(*scene, report, place.output) : "", place,
                    progress);
    } catch (const Error&) {
      progress.end();
      throw;
    }
  }
};

/// The folder of a run without --output, runs/SCENE, unless that holds a run. Then a terminal is
/// asked whether to replace it; otherwise the folder gets a number.
void choose_output(RunOptions& options, const Progress& progress) {
  const std::filesystem::path usual = "runs/" + options.scene_name;
  options.output = usual;
  if (options.overwrite || !holds_run(usual)) return;
  const std::filesystem::path next = next_free(usual);
  const bool quiet = progress.style() == Progress::Style::quiet,
             json = progress.style() == Progress::Style::json;
  if (!quiet && !json && is_terminal()) {
    options.overwrite = ask(fmt::format("{} holds a run. Replace it? [y/N] ", usual.string()));
    if (options.overwrite) return;
  }
  options.output = next;
  if (json)
    progress.event(
        json_text(nlohmann::ordered_json{{"event", "output"}, {"output", next.string()}}));
  else if (!quiet)
    print_error("{} holds a run; this one is written to {}\n", usual.string(), next.string());
}

int run_scene(const RunArguments& a, const std::vector<std::string>& command_line) {
  Outcome outcome{Progress(Progress::choose(a.quiet, a.log == "json"))};
  const SceneChange change = a.scene.change();
  warn(change.dropped, outcome.progress);
  const std::filesystem::path file = find_scene(a.scene.name);
  const Scene scene = scene_of(file, change.overrides, outcome.progress);
  RunOptions options;
  options.scene_name = file == a.scene.name ? file.stem().string() : a.scene.name;
  options.output = a.output;
  options.overwrite = a.overwrite;
  options.execution = a.scene.execution();
  options.command = command_line;
  if (!a.video.empty()) options.video = VideoOptions{a.video, a.fps, a.speed};
  if (a.output.empty()) choose_output(options, outcome.progress);
  options.after_step = outcome.after_step();
  warn(scene_warnings(scene), outcome.progress);
  return outcome.of([&] { return run(scene, options); }, {options.output, a.video, command_line});
}

struct ResumeArguments {
  ChangeArguments changes;
  std::string folder, log = "text", video;
  bool quiet = false;
};

int resume_run(const ResumeArguments& a, const std::vector<std::string>& command_line) {
  ResumeOptions options;
  options.folder = a.folder;
  options.overrides = a.changes.overrides();
  options.execution = a.changes.execution();
  options.command = command_line;
  options.video = a.video;
  Outcome outcome{Progress(Progress::choose(a.quiet, a.log == "json"))};
  options.warn = [&](const auto& warnings) { warn(warnings, outcome.progress); };
  options.after_step = outcome.after_step();
  Place place(options.folder, a.video, command_line);
  options.tell_video = [&](const std::filesystem::path& file) {
    if (place.video.empty()) place.video = std::filesystem::proximate(file).string();
  };
  return outcome.of([&] { return resume(options); }, place);
}

void add_log_options(const Command& command, bool& quiet, std::string& log) {
  command.flag("--quiet", quiet, "print nothing but errors");
  command.option("--log", log, "text, or json: one JSON object per line").one_of({"text", "json"});
}

}  // namespace

void add_run(Program& program, const std::vector<std::string>& command_line) {
  const auto a = std::make_shared<RunArguments>();
  const Command run = program.add("run", "Run a scene into a folder of pictures and numbers");
  a->scene.add_to(run);
  run.option("--output", a->output,
             "the folder (default: runs/SCENE, or runs/SCENE-2 if that holds a run)")
      .value("FOLDER");
  run.flag("--overwrite", a->overwrite, "replace the run that the folder holds");
  add_log_options(run, a->quiet, a->log);
  run.option("--video", a->video, "make a video: FILE.gif, FILE.webp, or FILE.mp4 (needs ffmpeg)")
      .value("FILE");
  run.option("--fps", a->fps, "pictures per second of the video (default: 30)").range(0.001, 1e6);
  run.option("--speed", a->speed,
             "simulated seconds per second of the video (default: 1; 0.25 is slow motion)")
      .range(1e-9, 1e9);
  run.footer("Example:\n  freshet run article --output runs/article --video water.mp4");
  run.action([a, command_line] { return run_scene(*a, command_line); });
}

void add_resume(Program& program, const std::vector<std::string>& command_line) {
  const auto a = std::make_shared<ResumeArguments>();
  const Command resume = program.add("resume", "Resume a run that was stopped, or prolong one");
  resume.option("DIR", a->folder, "the folder of the run").required();
  a->changes.add_to(resume);
  add_log_options(resume, a->quiet, a->log);
  resume.option("--video", a->video, "another file for the video of the run");
  resume.footer("Example:\n  freshet resume runs/article --set time.end=4");
  resume.action([a, command_line] { return resume_run(*a, command_line); });
}

}  // namespace freshet::cli
