// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <new>
#include <nlohmann/json.hpp>

#include "command.h"
#include "freshet/run.h"
#include "interrupts.h"
#include "memory.h"
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

std::string check_words(const Report& r, const std::string& name, double scale = 1,
                        const char* unit = "") {
  for (const CheckResult& c : r.checks)
    if (c.name == name)
      return fmt::format("{} {:g}{}  {}", c.relation, scale * c.bound, unit,
                         c.passed ? "ok" : "FAILED");
  return "";
}

/// The report as a table, with the scene's checks beside their values.
std::string table(const Report& r) {
  const Statistics& s = r.statistics;
  std::string out;
  const auto row = [&](const char* name, const std::string& value, const std::string& check = "") {
    const std::string line = fmt::format("  {:<22}{:<26}{}", name, value, check);
    out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  };
  row("out of bounds", fmt::format("{} of {}", s.out_of_bounds, s.particles),
      check_words(r, "out of bounds"));
  row("density mean", fmt::format("{:.5f} kg/m²", s.density_mean), check_words(r, "density mean"));
  row("density min, max", fmt::format("{:.5f}, {:.5f}", s.density_min, s.density_max));
  row("speed mean", fmt::format("{:.6f} m/s", s.speed_mean), check_words(r, "speed mean"));
  row("speed max", fmt::format("{:.6f} m/s", s.speed_max));
  row("height mean", fmt::format("{:.6f} m", s.height_mean), check_words(r, "height mean"));
  row("bright pixels",
      fmt::format("{} ({:.1f} %)", r.picture.bright, 100 * r.picture.bright_fraction()),
      check_words(r, "bright fraction", 100, " %"));
  row("bottom third", fmt::format("{} pixels", r.picture.bottom_third));
  for (const Flow& flow : r.flows)
    row((flow.kind + " " + flow.name).c_str(),
        fmt::format("{:.6g} {}, {} particles{}", flow.volume, s.momentum.size() == 3 ? "m³" : "m²",
                    flow.particles,
                    flow.waiting > 0 ? fmt::format(", {} wait", flow.waiting) : ""));
  for (const SolveStatistics& solve : r.solves)
    row((solve.name + " solve").c_str(), solve_words(solve));
  if (!r.solves.empty()) row("steps halved", std::to_string(r.time_steps.retried));
  return out;
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

std::string end_event(const Report& r, const std::filesystem::path& output) {
  const bool cut = r.state == Report::State::interrupted;
  nlohmann::ordered_json json{{"event", cut ? "interrupted" : "done"},
                              {"steps", r.steps},
                              {"seconds", r.seconds},
                              {"output", output.string()},
                              {"state_sha256", r.state_sha256}};
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

int finish(const Report& r, const std::filesystem::path& output, const Progress& progress) {
  const bool cut = r.state == Report::State::interrupted;
  progress.say(fmt::format(
      "{}{} steps, {:.4g} s simulated in {:.3g} s: {} particle-steps/s\n{}"
      "wrote {}",
      cut ? "interrupted after " : "", r.steps, r.time, r.seconds,
      short_number(r.particle_steps_per_second()), table(r), (output / "result.png").string()));
  progress.event(end_event(r, output));
  for (const CheckResult& c : r.checks)
    if (!c.passed && !cut)
      print_error("error: check failed: {} is {:g}, and must be {} {:g}\n", c.name, c.value,
                  c.relation, c.bound);
  for (const Warning& w : r.warnings)
    if (r.state == Report::State::cannot_be_right && w.cannot_be_right)
      print_error("error: the run cannot be right: {} (seen in {} looks, last at step {})\n",
                  w.message, w.looks, w.last_step);
  return cut ? interrupted : r.state == Report::State::done ? done : failed;
}

/// What run and resume have in common.
struct Outcome {
  Progress progress;
  bool started = false;
  std::size_t told = 0;  // warnings

  AfterStep after_step() {
    return [this](const Simulation& sim, double seconds) {
      if (!std::exchange(started, true)) progress.start(sim);
      progress.update(sim, seconds);
      while (told < sim.warnings().size()) tell(sim.warnings()[told++], progress);
      if (memory_ran_short()) throw std::bad_alloc();
      return !stop_asked();
    };
  }
  template <class Run> int of(Run run, const std::filesystem::path& output) {
    catch_interrupts();
    try {
      const Report report = run();
      progress.end();
      return finish(report, output, progress);
    } catch (const Error&) {
      progress.end();
      throw;
    }
  }
};

int run_scene(const RunArguments& a, const std::vector<std::string>& command_line) {
  const Scene scene = a.scene.load();
  const std::filesystem::path file = find_scene(a.scene.name);
  RunOptions options;
  options.scene_name = file == a.scene.name ? file.stem().string() : a.scene.name;
  options.output = a.output.empty() ? "runs/" + options.scene_name : a.output;
  options.overwrite = a.overwrite;
  options.execution = a.scene.execution();
  options.command = command_line;
  if (!a.video.empty()) options.video = VideoOptions{a.video, a.fps, a.speed};
  Outcome outcome{Progress(Progress::choose(a.quiet, a.log == "json"))};
  options.after_step = outcome.after_step();
  if (!a.quiet) print_diagnostics(scene_warnings(scene));
  return outcome.of([&] { return run(scene, options); }, options.output);
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
  options.warn = print_diagnostics;
  Outcome outcome{Progress(Progress::choose(a.quiet, a.log == "json"))};
  options.after_step = outcome.after_step();
  return outcome.of([&] { return resume(options); }, options.folder);
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
  run.option("--output", a->output, "the folder (default: runs/SCENE)");
  run.flag("--overwrite", a->overwrite, "replace the run that the folder holds");
  add_log_options(run, a->quiet, a->log);
  run.option("--video", a->video, "make a video: FILE.gif, FILE.webp, or FILE.mp4 (needs ffmpeg)");
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
