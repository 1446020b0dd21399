// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>

#include "freshet/film.h"
#include "freshet/simulation.h"
#include "io/child_process.h"
#include "io/surface_files.h"
#include "render/png.h"
#include "run/film_scene.h"
#include "run/frame_gaps.h"
#include "run/frame_surface.h"
#include "run/frame_video.h"
#include "run/result_folder.h"
#include "surface/liquid_part.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

constexpr const char* blender = "blender";
constexpr const char* rendered = "picture.png";  // by Blender, in the scene folder

void check_number(const char* option, std::int64_t value, std::int64_t low, std::int64_t high) {
  if (value < low || value > high)
    throw Error(Error::Kind::scene, fmt::format("option {} {}", option, value),
                fmt::format("it must be from {} to {}", low, high));
}

void check_options(const FilmOptions& options) {
  check_number("width", options.width, 16, 8192);
  check_number("height", options.height, 16, 8192);
  check_number("samples", options.samples, 1, 65536);
  check_number("every", options.every, 1, 1'000'000'000);
  if (options.at && !(*options.at >= 0 && std::isfinite(*options.at)))
    throw Error(Error::Kind::scene, fmt::format("option at {}", *options.at),
                "it must be a time from 0 on, in seconds");
  if (options.shutter && !(*options.shutter >= 0 && std::isfinite(*options.shutter)))
    throw Error(Error::Kind::scene, fmt::format("option shutter {}", *options.shutter),
                "it must be 0 or more, in seconds");
  if (options.video) check_video(options.video->file, options.video->fps, options.overwrite);
}

void require_blender(const fs::path& script) {
  if (!in_path(blender))
    throw Error(Error::Kind::scene, "",
                "Blender renders the pictures, and it is not installed (no folder of PATH has a "
                "program blender); on Debian: sudo apt-get install blender");
  std::error_code ec;
  if (!fs::is_regular_file(script, ec))
    throw Error(Error::Kind::scene, script.string(),
                "the script for Blender is missing; install Freshet again");
}

/// The scene for a film: its camera sees the whole domain in pictures of this size.
Scene scene_of_film(const FilmOptions& options) {
  Scene scene = scene_in_3d(
      options.run, options.overrides,
      {{"camera"}, "only keys of [camera] can change in a film; run the scene again for others"},
      "a film");
  scene.picture.width = options.width;
  scene.picture.height = options.height;
  scene.picture.color_bar = false;
  return scene;
}

/// The data file nearest to a time. Times increase with the numbers, so few files are read.
FrameFile nearest_frame(const FinishedRun& run, double time) {
  const auto time_of = [&](const FrameFile& file) { return run.read(file).time; };
  const auto& files = run.files();
  const double last = time_of(files.back());
  if (time > last * (1 + 1e-6))
    throw Error(
        Error::Kind::scene, fmt::format("option at {}", time),
        fmt::format("the data files of this run end at {:g} s; choose a time up to it", last));
  const auto after = std::partition_point(files.begin(), files.end() - 1,
                                          [&](const FrameFile& f) { return time_of(f) < time; });
  if (after == files.begin()) return *after;
  const auto before = after - 1;
  return time - time_of(*before) < time_of(*after) - time ? *before : *after;
}

std::vector<FrameFile> chosen_frames(const FilmOptions& options, const FinishedRun& run) {
  if (options.at) return {nearest_frame(run, *options.at)};
  std::vector<FrameFile> chosen;
  for (const FrameFile& file : run.files())
    if (file.number % options.every == 0) chosen.push_back(file);
  if (chosen.empty())
    throw Error(Error::Kind::scene, fmt::format("option every {}", options.every),
                fmt::format("no data file has a number that is a multiple of it; they have "
                            "numbers from {:04} to {:04}",
                            run.files().front().number, run.files().back().number));
  return chosen;
}

/// What the chosen frames show. The time of a frame beside a single one bounds the shutter.
FilmView view_of(const Scene& scene, const FinishedRun& run, const std::vector<FrameFile>& chosen) {
  FilmViewer viewer(scene);
  if (chosen.size() == 1 && run.files().size() > 1) {
    const auto& all = run.files();
    const auto at = std::find(all.begin(), all.end(), chosen.front());
    viewer.add_time(run.read(at == all.begin() ? *(at + 1) : *(at - 1)).time);
  }
  for (const FrameFile& file : chosen) viewer.add(run.read(file));
  return viewer.view();
}

/// The last lines of a program's output, in one line.
std::string last_lines(const std::string& output) {
  constexpr std::size_t most = 6;
  std::vector<std::string> lines;
  std::istringstream in(output);
  for (std::string line; std::getline(in, line);)
    if (line.find_first_not_of(" \t\r") != std::string::npos && line != "Blender quit")
      lines.push_back(line.substr(line.find_first_not_of(" \t")));
  std::string text;
  for (std::size_t k = lines.size() - std::min(most, lines.size()); k < lines.size(); ++k)
    text += (text.empty() ? "" : " | ") + lines[k];
  return text;
}

/// Renders frames, one at a time.
class FilmSeries {
 public:
  FilmSeries(const FilmOptions& options, const Scene& scene, const FilmLook& look,
             const std::vector<FrameFile>& frames)
      : options_(options),
        scene_(scene),
        look_(look),
        pictures_(options.run, options.output, "film"),
        folder_(options.run, options.output.empty() ? options.output : options.output / "scene",
                "film/scene") {
    if (options.overwrite) return;
    std::vector<std::string> names;
    for (const FrameFile& frame : frames)
      names.push_back(options.scene_only ? film_frame_file(frame.number) : picture_name(frame));
    if (options.scene_only) folder_.refuse_existing(names, "scenes for Blender");
    else pictures_.refuse_existing(names, "pictures");
  }
  /// Removes the scene folder unless it is kept.
  ~FilmSeries() {
    if (options_.keep || options_.scene_only) return;
    try {
      for (const std::string& name : common_) folder_.remove(name);
      remove_frame();
    } catch (const Error&) {  // the folder stays
    }
    std::error_code ignored;
    fs::remove(folder_.path(), ignored);  // if it is empty
  }
  FilmSeries(const FilmSeries&) = delete;
  FilmSeries& operator=(const FilmSeries&) = delete;

  void write_scene() {
    for (const auto& [name, bytes] : encode_film_solids(scene_)) write(name, bytes, common_);
    write(film_scene_file, encode_film_scene(scene_, look_), common_);
  }

  /// Returns the picture, or nothing if the film was stopped.
  std::optional<Image> render(const Frame& frame, const FrameFile& file) {
    write_frame(frame, file);
    std::optional<Image> image;
    if (run_blender(file)) image = picture(file);
    remove_frame();
    return image;
  }
  /// Writes the files that Blender reads, and returns the path of frame_0007.json.
  fs::path write_frame(const Frame& frame, const FrameFile& file) {
    of_frame_.clear();
    const std::size_t liquids = scene_.liquids().size();
    for (std::size_t k = 0; k < liquids; ++k) {
      const Frame part = liquids > 1 ? liquid_part(frame, int(k)) : frame;
      const SurfaceMesh mesh = surface_of_frame(scene_, part, file.path, {}, options_.threads);
      write(film_surface_file(k, file.number), encode_surface_glb(mesh, {frame.time, frame.step}),
            of_frame_);
    }
    if (frame.whitewater.size() > 0)
      write(film_whitewater_file(file.number), encode_ply(whitewater_table(frame)), of_frame_);
    write(film_frame_file(file.number), encode_film_frame(scene_, frame, file.number, look_.view),
          of_frame_);
    return folder_.path() / film_frame_file(file.number);
  }
  fs::path write(const FrameFile& file, const Image& image) const {
    return pictures_.write(picture_name(file), encode_png(image));
  }

 private:
  void write(const std::string& name, const std::string& bytes, std::vector<std::string>& names) {
    names.push_back(name);
    folder_.write(name, bytes);
  }
  void remove_frame() {
    folder_.remove(rendered);
    if (!options_.keep)
      for (const std::string& name : of_frame_) folder_.remove(name);
    of_frame_.clear();
  }
  bool run_blender(const FrameFile& file) {
    folder_.remove(rendered);
    const fs::path place = fs::absolute(folder_.path());
    ChildProcess process(
        pictures_.path() / picture_name(file),
        {blender, "-b", "-noaudio", "--factory-startup", "--python-exit-code", "3", "-t",
         fmt::format("{}", options_.threads), "-P", fs::absolute(options_.script).string(), "--",
         place.string(), film_frame_file(file.number), (place / rendered).string()},
        ChildProcess::Input::empty);
    while (!process.ends_within(std::chrono::milliseconds(100)))
      if (options_.while_rendering && !options_.while_rendering()) {
        process.stop();
        return false;
      }
    if (!process.finish()) fail(file, process);
    output_ = process.output(most_output);
    return true;
  }
  Image picture(const FrameFile& file) const {
    const auto bytes = folder_.read(rendered);
    if (!bytes) fail(file, "it wrote no picture: " + last_lines(output_));
    try {
      Image image = decode_png(*bytes);
      if (image.width == options_.width && image.height == options_.height) return image;
    } catch (const Error&) {  // reported below
    }
    fail(file, "its picture is damaged: " + last_lines(output_));
  }
  [[noreturn]] void fail(const FrameFile& file, const ChildProcess& process) const {
    const std::string lines = last_lines(process.output(most_output));
    fail(file, lines.empty() ? "it ended early" : "the end of its output is: " + lines);
  }
  [[noreturn]] void fail(const FrameFile& file, const std::string& reason) const {
    throw Error(Error::Kind::run, (pictures_.path() / picture_name(file)).string(),
                fmt::format("Blender could not render this picture: {}", reason));
  }

  static constexpr std::size_t most_output = 4000;
  const FilmOptions& options_;
  const Scene& scene_;
  const FilmLook& look_;
  ResultFolder pictures_, folder_;
  std::vector<std::string> common_, of_frame_;  // files of all frames, and of this one
  std::string output_;                          // of Blender
};

}  // namespace

namespace {

/// Makes the pictures of a film, or only its scene folder.
void make_frames(FilmSeries& film, const FilmOptions& options, const FinishedRun& run,
                 const std::vector<FrameFile>& frames, FilmReport& report) {
  std::optional<FrameVideo> video;
  if (options.video && !options.scene_only)
    video.emplace(options.width, options.height, *options.video);
  for (const FrameFile& file : frames) {
    const Frame frame = run.read(file);
    if (options.scene_only) {
      report.pictures.push_back(film.write_frame(frame, file));
    } else {
      const std::optional<Image> image = film.render(frame, file);
      report.interrupted = !image;
      if (report.interrupted) break;
      report.pictures.push_back(film.write(file, *image));
      if (video) video->add(*image, frame.time);
    }
    report.interrupted =
        options.after_picture && !options.after_picture(report.pictures.size(), frames.size());
    if (report.interrupted) break;
  }
  if (video && !report.pictures.empty()) video->finish();
}

}  // namespace

FilmReport make_film(const FilmOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  check_options(options);
  thread_count(options.threads);  // throws for too many
  const Scene scene = scene_of_film(options);
  const FilmMaterials materials = film_materials(scene, options.materials);
  const FinishedRun run(options.run, scene, "make a film of");
  if (!options.scene_only) require_blender(options.script);
  const std::vector<FrameFile> frames = chosen_frames(options, run);
  if (const auto gaps = gaps_in(frames, "they get no picture, and the others keep their numbers", 0,
                                options.every);
      options.warn && !options.at && !gaps.empty())
    options.warn(gaps);
  const FilmView view = view_of(scene, run, frames);
  const FilmLook look{{options.width, options.height, options.samples,
                       options.shutter.value_or(view.shutter), options.denoise},
                      view,
                      materials};
  FilmSeries film(options, scene, look, frames);
  film.write_scene();
  FilmReport report;
  make_frames(film, options, run, frames, report);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace freshet
