// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <iterator>

#include "freshet/render.h"
#include "freshet/simulation.h"
#include "io/files.h"
#include "io/frame_files.h"
#include "io/video.h"
#include "render/draw.h"
#include "render/png.h"
#include "run/body_table.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

fs::path picture_name(const fs::path& folder, std::size_t k) {
  return folder / fmt::format("frame_{:04}.png", k);
}

/// The run's own scene; only what a picture shows may change.
Scene scene_of(const RenderOptions& options) {
  for (const auto& [key, value] : options.overrides)
    if (!key.starts_with("picture.") && !key.starts_with("camera.") && !key.starts_with("camera["))
      throw Error(
          Error::Kind::scene, "override " + key,
          "the run is over: only keys of [picture] and [camera] can change now; run the scene "
          "again for others");
  const fs::path file = options.run / "scene.toml";
  if (!fs::exists(file))
    throw Error(
        Error::Kind::scene, options.run.string(),
        "no run is in this folder (it has no scene.toml); name the folder of a finished run");
  return load_scene(file, options.overrides);
}

void check_output(const RenderOptions& options, const fs::path& folder, std::size_t frames) {
  std::error_code ec;
  fs::create_directories(folder, ec);
  if (ec) fail_file(folder, "make this folder", ec.value());
  for (std::size_t k = 0; k < frames && !options.overwrite; ++k)
    if (fs::exists(picture_name(folder, k)))
      throw Error(
          Error::Kind::scene, folder.string(),
          "this folder holds pictures; `overwrite` replaces them, or choose another `output`",
          {"overwrite", "output"});
  if (options.video) Video::check(options.video->file, options.overwrite);
}

std::map<std::int64_t, std::vector<BodyState>> bodies_of(const fs::path& run, const Scene& scene) {
  std::ifstream in(run / "bodies.csv", std::ios::binary);
  return read_bodies(std::string(std::istreambuf_iterator<char>(in), {}), scene);
}

/// A film that shows each frame until the next one's time, in pictures of one length.
class Film {
 public:
  Film(const Scene& scene, const VideoOptions& options)
      : fps_(options.fps),
        video_(options.file, int(scene.picture.width), int(scene.picture.height), options.fps) {}

  void add(const Image& image, double time) {
    if (!start_) start_ = time;
    const auto due = std::int64_t((time - *start_) * fps_ + 1e-6);
    for (; shown_ < due; ++shown_) video_.add(*last_);
    last_ = image;
  }
  void finish() {
    if (last_) video_.add(*last_);
    video_.finish();
  }

 private:
  double fps_;
  Video video_;
  std::optional<double> start_;
  std::optional<Image> last_;
  std::int64_t shown_ = 0;
};

}  // namespace

RenderReport render(const RenderOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const int threads = thread_count(options.threads);
  const Scene scene = scene_of(options);
  const std::vector<fs::path> files = frame_files(options.run);
  if (files.empty())
    throw Error(
        Error::Kind::scene, options.run.string(),
        "this run wrote no data to draw (its folder has no data/); run its scene again with "
        "data files switched on");
  const fs::path folder = options.output.empty() ? options.run / "pictures" : options.output;
  check_output(options, folder, files.size());
  std::optional<Film> film;
  if (options.video) film.emplace(scene, *options.video);
  const auto bodies = bodies_of(options.run, scene);
  RenderReport report;
  for (const fs::path& file : files) {
    Frame frame = read_frame(file);
    if (const auto at = bodies.find(frame.step); at != bodies.end()) frame.bodies = at->second;
    if (frame.dimension != scene.dimension())
      throw Error(Error::Kind::run, file.string(),
                  fmt::format("this frame is in {}D and the run's scene in {}D; run it again",
                              frame.dimension, scene.dimension()));
    const Image image = draw(scene, frame, threads);
    report.pictures.push_back(picture_name(folder, report.pictures.size()));
    write_file(report.pictures.back(), encode_png(image));
    if (film) film->add(image, frame.time);
    report.interrupted =
        options.after_picture && !options.after_picture(report.pictures.size(), files.size());
    if (report.interrupted) break;
  }
  if (film) film->finish();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace freshet
