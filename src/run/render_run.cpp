// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>

#include "freshet/render.h"
#include "freshet/simulation.h"
#include "io/video.h"
#include "render/draw.h"
#include "render/png.h"
#include "run/finished_run.h"
#include "run/frame_gaps.h"
#include "run/frame_video.h"
#include "run/percentile_table.h"
#include "run/result_folder.h"
#include "scene/model/picture_layout.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

/// The folder of the pictures: one that the options name, or RUN/pictures.
ResultFolder picture_folder(const RenderOptions& options, const std::vector<FrameFile>& frames) {
  ResultFolder folder(options.run, options.output, "pictures");
  std::vector<std::string> names;
  for (const FrameFile& frame : frames) names.push_back(picture_name(frame));
  if (!options.overwrite) folder.refuse_existing(names, "pictures");
  return folder;
}

/// Throws if a data file lacks the field that picture.color_by shows: it would read as 0.
void check_color_field(const Scene& scene, const DataFields& stored, const fs::path& file) {
  const auto require = [&](const char* field, bool has) {
    if (!has)
      throw Error(Error::Kind::scene, file.string(),
                  fmt::format("this data file has no {0}, which picture.color_by needs; choose "
                              "another, such as \"height\", or add \"{0}\" to output.fields and "
                              "run the scene again",
                              field));
  };
  if (scene.picture.style == PictureStyle::water) return;  // shows liquids
  switch (scene.picture.color_by) {
    case ColorBy::speed:
    case ColorBy::velocity_x:
    case ColorBy::velocity_y:
    case ColorBy::velocity_z:
      return require("velocity", stored.velocity);
    case ColorBy::density:
    case ColorBy::density_error:
      return require("density", stored.density);
    case ColorBy::pressure:
      return require("pressure", stored.pressure);
    case ColorBy::id:
      return require("id", stored.id);
    case ColorBy::height:
    case ColorBy::liquid:
      return;
  }
}

/// The colour ranges of the frames of a run, by percentiles.csv. Runs of older versions have none:
/// the frames themselves then count in their order.
class FrameRanges {
 public:
  FrameRanges(const RenderOptions& options, const Scene& scene) : scene_(scene) {
    const fs::path file = options.run / percentile_file;
    std::error_code ec;
    recorded_ = fs::is_regular_file(file, ec);
    if (recorded_) rows_ = RangesByStep(file, scene);
    const bool used =
        scene.picture.style != PictureStyle::water && scene.picture.color_range.empty() &&
        scene.picture.color_scale == ColorScale::run && scene.picture.color_by != ColorBy::liquid;
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

}  // namespace

RenderReport render(const RenderOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const int threads = thread_count(options.threads);
  const Scene scene =
      scene_of_run(options.run, options.overrides,
                   {{"picture", "camera"},
                    "the run is over: only keys of [picture] and [camera] can change now, such as "
                    "picture.color_by; run the scene again for others"});
  const FinishedRun run(options.run, scene, "draw");
  if (!options.pictures && !options.video)
    throw Error(Error::Kind::scene, "option no-pictures",
                "neither pictures nor a video are to be made; name a file with `video`", {"video"});
  std::optional<ResultFolder> pictures;
  if (options.pictures) pictures.emplace(picture_folder(options, run.files()));
  if (options.video) check_video(options.video->file, options.video->fps, options.overwrite);
  if (const auto gaps =
          gaps_in(run.files(), "they get no picture, and the others keep their numbers");
      options.warn && !gaps.empty())
    options.warn(gaps);
  FrameRanges ranges(options, scene);
  std::optional<FrameVideo> film;
  if (options.video) {
    const PictureLayout picture = picture_layout(scene);
    film.emplace(picture.width, picture.height, *options.video);
  }
  RenderReport report;
  for (const FrameFile& file : run.files()) {
    DataFields stored;
    const Frame frame = run.read(file, &stored);
    check_color_field(scene, stored, file.path);
    const Image image = draw(scene, frame, ranges.of(frame), threads);
    ++report.frames;
    if (pictures) report.pictures.push_back(pictures->write(picture_name(file), encode_png(image)));
    if (film) film->add(image, frame.time);
    report.interrupted =
        options.after_picture && !options.after_picture(report.frames, run.files().size());
    if (report.interrupted) break;
  }
  if (film) film->finish();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace freshet
