// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <filesystem>

#include "command.h"
#include "freshet/render.h"
#include "interrupts.h"
#include "print.h"
#include "progress.h"

namespace freshet::cli {
namespace {

struct RenderArguments {
  std::string run, output, video;
  KeyArguments keys;
  double fps = 30, speed = 1;
  int threads = 0;
  bool overwrite = false, video_only = false, quiet = false;
};

int render_run(const RenderArguments& a) {
  RenderOptions options;
  options.run = a.run;
  options.output = a.output;
  options.overwrite = a.overwrite;
  options.pictures = !a.video_only;
  options.threads = a.threads;
  options.overrides = a.keys.overrides();
  if (!a.video.empty()) options.video = VideoOptions{a.video, a.fps, a.speed};
  const Count count(a.quiet, "pictures");
  options.after_picture = count;
  if (!a.quiet) options.warn = print_diagnostics;
  catch_interrupts();
  const RenderReport r = render(options);
  count.finish();
  if (!a.quiet)
    print_out("{}{} pictures in {}\n{}{}", r.interrupted ? "interrupted after " : "", r.frames,
              duration(r.seconds),
              r.pictures.empty() ? "" : "wrote " + printable(r.pictures.back().string()) + "\n",
              a.video.empty() ? "" : "wrote " + printable(a.video) + "\n");
  return r.interrupted ? interrupted : done;
}

}  // namespace

void add_render(Program& program) {
  const auto a = std::make_shared<RenderArguments>();
  const Command render = program.add("render", "Draw a finished run again, without simulating");
  render.option("DIR", a->run, "the folder of a run").required();
  a->keys.add_to(render, "a key of picture or camera");
  render.option("--output", a->output, "the folder of the pictures (default: DIR/pictures)")
      .value("FOLDER");
  render.flag("--overwrite", a->overwrite, "replace existing pictures");
  render.option("--threads", a->threads, "threads (default: all)").at_least(1);
  render.flag("--quiet", a->quiet, "print nothing but errors");
  render
      .option("--video", a->video, "make a video: FILE.gif, FILE.webp, or FILE.mp4 (needs ffmpeg)")
      .value("FILE");
  render.flag("--no-pictures", a->video_only, "make the video only");
  render.option("--fps", a->fps, "pictures per second of the video (default: 30)")
      .range(0.001, 1e6);
  render
      .option("--speed", a->speed,
              "simulated seconds per second of the video (default: 1; 0.25 is slow motion)")
      .range(1e-9, 1e9);
  render.footer(
      "Examples:\n  freshet render runs/dam_break_2d --set picture.color_by=pressure --video "
      "film.mp4\n"
      "  freshet render runs/dam_break_3d --set picture.style=balls --set camera.orbit=30");
  render.action([a] { return render_run(*a); });
}

}  // namespace freshet::cli
