// SPDX-License-Identifier: MIT
#include "freshet/film.h"

#include <fmt/format.h>

#include <charconv>

#include "command.h"
#include "interrupts.h"
#include "print.h"
#include "progress.h"

namespace freshet::cli {
namespace {

namespace fs = std::filesystem;

struct FilmArguments {
  std::string run, output, size = "960x540", video;
  KeyArguments keys;
  FilmOptions options;
  double at = -1, fps = 30, speed = 1, shutter = -1;
  bool quiet = false;
};

/// Our script for Blender, installed or in the sources. Its usual place if it is missing.
fs::path film_script() {
  const std::string name = "integrations/blender/render_film.py";
  const std::vector<fs::path> places = folders_that_come_along(name);
  std::error_code ec;
  for (const fs::path& place : places)
    if (fs::is_regular_file(place, ec)) return fs::weakly_canonical(place);
  return places.front();
}

/// Reads "960x540".
void set_size(FilmOptions& options, const std::string& text) {
  const char* end = text.data() + text.size();
  const auto [x, fault] = std::from_chars(text.data(), end, options.width);
  const bool starts = fault == std::errc() && x != end && *x == 'x';
  const auto [rest, second] =
      starts ? std::from_chars(x + 1, end, options.height) : std::from_chars_result{x, fault};
  if (!starts || second != std::errc() || rest != end)
    throw Error(Error::Kind::scene, "option size " + text,
                "write WIDTHxHEIGHT in pixels, for example 1920x1080");
}

int film_of(const FilmArguments& a) {
  FilmOptions options = a.options;
  options.run = a.run;
  options.output = a.output;
  options.script = film_script();
  options.overrides = a.keys.overrides();
  set_size(options, a.size);
  if (a.at >= 0) options.at = a.at;
  if (a.shutter >= 0) options.shutter = a.shutter;
  if (!a.video.empty()) options.video = VideoOptions{a.video, a.fps, a.speed};
  const char* noun = options.scene_only ? "frames" : "pictures";
  const Count count(a.quiet, noun);
  options.after_picture = count;
  options.while_rendering = [] { return !stop_asked(); };
  if (!a.quiet) options.warn = print_diagnostics;
  catch_interrupts();
  const FilmReport r = make_film(options);
  count.finish();
  if (!a.quiet)
    print_out("{}{} {} in {}\nwrote {}\n{}", r.interrupted ? "interrupted after " : "",
              r.pictures.size(), noun, duration(r.seconds),
              r.pictures.empty() ? "" : printable(r.pictures.back().string()),
              !options.video || options.scene_only ? "" : "wrote " + printable(a.video) + "\n");
  return r.interrupted ? interrupted : done;
}

void add_frames(const Command& film, FilmArguments& a) {
  const Option at = film.option("--at", a.at, "only the frame nearest to this time")
                        .value("SECONDS")
                        .range(0.0, 1e30);
  film.option("--every", a.options.every, "take every N-th data file (default: 1)")
      .value("N")
      .at_least(1)
      .excludes(at);
}

void add_video(const Command& film, FilmArguments& a) {
  film.option("--video", a.video, "make a video: FILE.gif, FILE.webp, or FILE.mp4 (needs ffmpeg)")
      .value("FILE");
  film.option("--fps", a.fps, "pictures per second of the video (default: 30)").range(0.001, 1e6);
  film.option("--speed", a.speed,
              "simulated seconds per second of the video (default: 1; 0.25 is slow motion)")
      .range(1e-9, 1e9);
}

}  // namespace

void add_film(Program& program) {
  const auto a = std::make_shared<FilmArguments>();
  const Command film =
      program.add("film", "Render a finished run in 3D as liquid, by ray tracing in Blender");
  film.option("DIR", a->run, "the folder of a run").required();
  add_frames(film, *a);
  film.option("--size", a->size, "size of the pictures in pixels (default: 960x540)").value("WxH");
  film.option("--samples", a->options.samples,
              "light paths per pixel; more is less noisy and slower (default: 32)")
      .range(1, 65536);
  film.flag("--denoise", a->options.denoise, "smooth the noise of few samples");
  film.option("--shutter", a->shutter,
              "seconds that the shutter is open; 0 turns motion blur off (default: a quarter of "
              "the time between "
              "pictures, at most 0.004)")
      .value("SECONDS")
      .range(0.0, 1e9);
  film.option("--material", a->options.materials,
              "the look of a liquid or a body, such as liquid=milk or rabbit=metal")
      .value("NAME=PRESET")
      .repeatable_value();
  a->keys.add_to(film, "a key of camera");
  film.option("--output", a->output, "the folder of the pictures (default: DIR/film)")
      .value("FOLDER");
  film.flag("--overwrite", a->options.overwrite, "replace existing pictures");
  film.flag("--keep", a->options.keep, "keep the folder scene/ that Blender reads");
  film.flag("--scene-only", a->options.scene_only,
            "write the folder scene/ for the add-on, and no pictures");
  film.option("--threads", a->options.threads, "threads (default: all)").at_least(1);
  film.flag("--quiet", a->quiet, "print nothing but errors");
  add_video(film, *a);
  film.footer(
      "Examples:\n  freshet film runs/dam_break_3d --at 0.5\n"
      "  freshet film runs/dam_break_3d --size 640x360 --samples 12 --denoise --video splash.webp");
  film.action([a] { return film_of(*a); });
}

}  // namespace freshet::cli
