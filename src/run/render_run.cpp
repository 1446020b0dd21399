// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/input_file.h"
#include "freshet/render.h"
#include "freshet/simulation.h"
#include "io/frame_files.h"
#include "io/video.h"
#include "render/draw.h"
#include "render/png.h"
#include "run/body_table.h"
#include "run/frame_gaps.h"
#include "run/percentile_table.h"
#include "run/result_folder.h"
#include "scene/keys/override_place.h"
#include "scene/model/picture_layout.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

/// The run's own scene; only what a picture shows may change.
Scene scene_of(const RenderOptions& options) {
  for (const Override& change : options.overrides) {
    const std::string& key = change.first;
    if (key != "picture" && key != "camera" && !key.starts_with("picture.") &&
        !key.starts_with("camera.") && !key.starts_with("camera["))
      throw Error(
          Error::Kind::scene, place_of(change),
          "the run is over: only keys of [picture] and [camera] can change now; run the scene "
          "again for others");
  }
  const fs::path file = options.run / "scene.toml";
  if (!fs::exists(file))
    throw Error(
        Error::Kind::scene, options.run.string(),
        "no run is in this folder (it has no scene.toml); name the folder of a finished run");
  return load_scene(file, options.overrides);
}

std::string picture_name(const FrameFile& frame) {
  return fmt::format("frame_{:04}.png", frame.number);
}

/// The folder of the pictures: one that the options name, or RUN/pictures.
ResultFolder picture_folder(const RenderOptions& options, const std::vector<FrameFile>& frames) {
  ResultFolder folder(options.run, options.output, "pictures");
  std::vector<std::string> names;
  for (const FrameFile& frame : frames) names.push_back(picture_name(frame));
  if (!options.overwrite) folder.refuse_existing(names, "pictures");
  return folder;
}

/// The bodies of the frames of a run, by bodies.csv.
class FrameBodies {
 public:
  FrameBodies(const fs::path& run, const Scene& scene)
      : exist_(!scene.body.empty()), table_((run / "bodies.csv").string()) {
    if (!exist_) return;
    std::error_code ec;
    if (!fs::is_regular_file(table_, ec))
      throw Error(Error::Kind::scene, table_,
                  "this table is missing or cannot be read, and the bodies are drawn from it; put "
                  "it back, or run the scene again");
    constexpr InputFile table{.may_be_empty = true};
    times_ = read_bodies(read_input(table_, table), scene, table_);
  }
  void put_into(Frame& frame, const fs::path& file) const {
    if (!exist_) return;
    const double close = 1e-8 * std::abs(frame.time);  // the table has nine digits
    const auto at = times_.lower_bound(frame.time - close);
    if (at == times_.end() || at->first > frame.time + close)
      throw Error(Error::Kind::scene, table_,
                  fmt::format("there is no row for each body at {:g} s, which {} shows; put the "
                              "table back as the run wrote it, or run the scene again",
                              frame.time, file.string()));
    frame.bodies = at->second;
  }

 private:
  bool exist_;
  std::string table_;
  std::map<double, std::vector<BodyState>> times_;
};

/// The colour ranges of the frames of a run, by percentiles.csv. Runs of older versions have none:
/// the frames themselves then count in their order.
class FrameRanges {
 public:
  FrameRanges(const RenderOptions& options, const Scene& scene) : scene_(scene) {
    const fs::path file = options.run / percentile_file;
    std::error_code ec;
    recorded_ = fs::is_regular_file(file, ec);
    if (recorded_) rows_ = RangesByStep(file, scene);
    const bool used = scene.picture.color_range.empty() &&
                      scene.picture.color_scale == ColorScale::run &&
                      scene.picture.color_by != ColorBy::liquid;
    if (!recorded_ && used && options.warn)
      options.warn({{Diagnostic::Severity::warning, file.string(),
                     "this table is missing; the colours follow the data files instead, and can "
                     "differ from those of the run's own pictures; to have these, put it back"}});
  }
  ColorRanges of(const Frame& frame) {
    if (recorded_) return rows_.up_to(frame.step);
    include(seen_, percentiles_of(scene_, frame));
    return seen_;
  }

 private:
  const Scene& scene_;
  bool recorded_;
  RangesByStep rows_;
  ColorRanges seen_;
};

/// A film that shows each frame until the next one's time, in pictures of one length.
class Film {
 public:
  Film(const PictureLayout& picture, const VideoOptions& options)
      : per_second_(options.fps / options.speed),
        video_(make_video(options.file, picture.width, picture.height, options.fps)) {}

  void add(const Image& image, double time) {
    if (!start_) start_ = time;
    const auto due = std::int64_t((time - *start_) * per_second_ + 1e-6);
    for (; shown_ < due; ++shown_) video_->add(*last_);
    last_ = image;
  }
  void finish() {
    if (last_) video_->add(*last_);
    video_->finish();
  }

 private:
  double per_second_;  // pictures per simulated second
  std::unique_ptr<Video> video_;
  std::optional<double> start_;
  std::optional<Image> last_;
  std::int64_t shown_ = 0;
};

}  // namespace

RenderReport render(const RenderOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const int threads = thread_count(options.threads);
  const Scene scene = scene_of(options);
  const std::vector<FrameFile> frames = frame_files(options.run);
  if (frames.empty())
    throw Error(
        Error::Kind::scene, options.run.string(),
        "this run wrote no data to draw (its folder has no data/); run its scene again with "
        "data files switched on");
  const FrameBodies bodies(options.run, scene);
  const ResultFolder pictures = picture_folder(options, frames);
  if (options.video) check_video(options.video->file, options.video->fps, options.overwrite);
  if (const auto gaps = gaps_in(frames, "picture"); options.warn && !gaps.empty())
    options.warn(gaps);
  FrameRanges ranges(options, scene);
  std::optional<Film> film;
  if (options.video) film.emplace(picture_layout(scene), *options.video);
  RenderReport report;
  for (const FrameFile& file : frames) {
    Frame frame = read_frame(file.path);
    if (frame.dimension != scene.dimension())
      throw Error(Error::Kind::run, file.path.string(),
                  fmt::format("this frame is in {}D and the run's scene in {}D; run it again",
                              frame.dimension, scene.dimension()));
    bodies.put_into(frame, file.path);
    const Image image = draw(scene, frame, ranges.of(frame), threads);
    report.pictures.push_back(pictures.write(picture_name(file), encode_png(image)));
    if (film) film->add(image, frame.time);
    report.interrupted =
        options.after_picture && !options.after_picture(report.pictures.size(), frames.size());
    if (report.interrupted) break;
  }
  if (film) film->finish();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace freshet
