// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include "freshet/run.h"
#include "io/video.h"

namespace freshet {

/// A video that shows each frame of a finished run until the time of the next one, in pictures of
/// equal duration.
class FrameVideo {
 public:
  /// width, height: of its pictures [px].
  FrameVideo(int width, int height, const VideoOptions& options)
      : per_second_(options.fps / options.speed),
        video_(make_video(options.file, width, height, options.fps)) {}

  /// `time`: of the frame [s].
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

}  // namespace freshet
