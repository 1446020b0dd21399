// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "command.h"
#include "freshet/render.h"
#include "interrupts.h"

namespace freshet::cli {
namespace {

struct RenderArguments {
  std::string run, output, video;
  std::vector<std::string> set;
  double fps = 30;
  int threads = 0;
  bool overwrite = false, quiet = false;
};

int render_run(const RenderArguments& a) {
  RenderOptions options;
  options.run = a.run;
  options.output = a.output;
  options.overwrite = a.overwrite;
  options.threads = a.threads;
  options.overrides = overrides_of(a.set);
  if (!a.video.empty()) options.video = VideoOptions{a.video, a.fps};
  const bool bar = !a.quiet && isatty(STDOUT_FILENO) == 1;
  options.after_picture = [bar](std::size_t done, std::size_t all) {
    if (bar) fmt::print("\r{} of {} pictures", done, all);
    if (bar) std::fflush(stdout);
    return !stop_asked();
  };
  catch_interrupts();
  const RenderReport r = render(options);
  if (!a.quiet)
    fmt::print("{}{}{} pictures in {:.3g} s\nwrote {}\n", bar ? "\r" : "",
               r.interrupted ? "interrupted after " : "", r.pictures.size(), r.seconds,
               r.pictures.empty() ? "" : r.pictures.back().string());
  return r.interrupted ? interrupted : done;
}

}  // namespace

void add_render(CLI::App& app, int& code) {
  const auto a = std::make_shared<RenderArguments>();
  CLI::App* render = app.add_subcommand("render", "Draw a finished run again, without simulating");
  render->add_option("DIR", a->run, "the folder of a run")->required();
  render->add_option("--set", a->set, "KEY=VALUE: change a key of picture or camera")
      ->take_all()
      ->allow_extra_args(false);
  render->add_option("--output", a->output, "where the pictures go (default: DIR/pictures)");
  render->add_flag("--overwrite", a->overwrite, "replace pictures that are there");
  render->add_option("--threads", a->threads, "threads (default: all)")->check(CLI::Range(1, 4096));
  render->add_flag("--quiet", a->quiet, "say nothing but errors");
  render->add_option("--video", a->video, "make a film, FILE.mp4 or FILE.gif (needs ffmpeg)");
  render->add_option("--fps", a->fps, "the film's pictures per simulated second (default: 30)")
      ->check(CLI::Range(0.001, 1e6));
  render->footer(
      "Example:\n  freshet render runs/dam_break_3d --set picture.color_by=pressure --set "
      "camera.orbit=30 --video film.mp4");
  render->callback([a, &code] { code = render_run(*a); });
}

}  // namespace freshet::cli
