// SPDX-License-Identifier: MIT
#include "run/video_output.h"

#include <fmt/format.h>

#include <algorithm>
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

std::int64_t VideoOutput::next(double from) const {
  if (!times().empty()) return std::llround(times().back() / interval()) + 1;
  return from == 0 ? 0 : count_by(from);
}

bool VideoOutput::shows_between(double from, double to) const {
  return double(next(from)) * interval() < to;
}

bool VideoOutput::write(const StepTaken& step) {
  for (std::int64_t k = next(step.before); k < count_by(step.after); ++k) {
    const double time = std::min(double(k) * interval(), step.after);
    site_.background.add([site = site_, file = picture_file(times().size()),
                          frame = site_.frames.at(time), ranges = site_.ranges] {
      site.folder.write(file, encode_png(draw(site.sim.scene(), *frame, ranges)));
    });
    times().push_back(time);
  }
  return true;
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

void VideoOutput::finish() {
  if (times().empty()) return;
  const PictureLayout layout = picture_layout(site_.sim.scene());
  const auto video = make_video(options_.file, layout.width, layout.height, options_.fps);
  for (std::size_t k = 0; k < times().size(); ++k)
    video->add(read_picture(site_.folder.path() / picture_file(k)));
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
