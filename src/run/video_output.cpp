// SPDX-License-Identifier: MIT
#include "run/video_output.h"

#include <fmt/format.h>

#include <cmath>

#include "core/input_file.h"
#include "freshet/error.h"
#include "io/video.h"
#include "render/draw.h"
#include "render/png.h"
#include "scene/model/picture_layout.h"

namespace freshet {
namespace {

constexpr double most_pictures = 100000;
constexpr double time_slack = 1e-9;  // of an interval

std::string picture_file(std::size_t k) { return fmt::format("video/picture_{:06}.png", k); }

Image read_picture(const std::filesystem::path& file) {
  constexpr InputFile picture{.noun = "picture", .remedy = "run the scene again"};
  return decode_png(read_input(file, picture));
}

}  // namespace

std::int64_t VideoOutput::count_by(double time) const {
  return std::int64_t(std::floor(time / interval() + time_slack)) + 1;
}

std::vector<std::string> VideoOutput::files() const {
  std::vector<std::string> all;
  const auto count = std::size_t(count_by(site_.sim.scene().time.end) + 1);
  for (std::size_t k = 0; k < count; ++k) all.push_back(picture_file(k));
  return all;
}

bool VideoOutput::due(const StepTaken& step) const {
  return times().empty() || count_by(step.after) > count_by(times().back());
}

void VideoOutput::write(const StepTaken&) {
  site_.background.add([site = site_, file = picture_file(times().size()),
                        frame = std::make_shared<Frame>(site_.sim.frame()), ranges = site_.ranges] {
    site.folder.write(file, encode_png(draw(site.sim.scene(), *frame, ranges)));
  });
  times().push_back(site_.sim.time());
}

/// Whether the last picture before the checkpoint exists and has the size of those to come.
bool VideoOutput::can_continue() const {
  const auto file = site_.folder.path() / picture_file(times().size() - 1);
  std::error_code ec;
  if (!std::filesystem::is_regular_file(file, ec)) return false;
  const PictureLayout layout = picture_layout(site_.sim.scene());
  const Image last = read_picture(file);
  return last.width == layout.width && last.height == layout.height;
}

std::vector<Diagnostic> VideoOutput::resume() {
  if (times().empty() || can_continue()) return {};
  site_.record.series[name()] = {};
  return {{Diagnostic::Severity::warning, (site_.folder.path() / "video").string(),
           fmt::format("the pictures of the video are missing or have another size; {} starts anew "
                       "at {:g} s",
                       options_.file.string(), site_.sim.time())}};
}

/// Each picture of the video is the first that was drawn at its time or later.
void VideoOutput::finish() {
  if (times().empty()) return;
  const PictureLayout layout = picture_layout(site_.sim.scene());
  const auto video = make_video(options_.file, layout.width, layout.height, options_.fps);
  std::int64_t shown = count_by(times().front()) - 1;
  for (std::size_t k = 0; k < times().size(); ++k) {
    const Image image = read_picture(site_.folder.path() / picture_file(k));
    for (const std::int64_t count = count_by(times()[k]); shown < count; ++shown) video->add(image);
  }
  video->finish();
}

void check_video_of(const Scene& scene, const VideoOptions& options, bool overwrite) {
  check_video(options.file, options.fps, overwrite);
  const double count = scene.time.end * options.fps / options.speed;
  if (count > most_pictures)
    throw Error(Error::Kind::scene, "option video " + options.file.string(),
                fmt::format("the video would have {:.4g} pictures; at most {:.0f} are allowed; "
                            "choose fewer pictures per second or a higher speed",
                            count, most_pictures));
}

}  // namespace freshet
