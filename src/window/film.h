// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <optional>

#include "run/frame_video.h"

namespace freshet::window {

/// Pictures of a window as a video that shows simulated time at an even speed.
class Film {
 public:
  bool recording() const { return video_ != nullptr; }
  const std::filesystem::path& file() const { return file_; }
  std::size_t pictures() const { return pictures_; }
  /// Throws Error (kind scene) if no such video can be made.
  void begin(const std::filesystem::path& file, int width, int height, double speed) {
    check_video(file, fps, true);
    video_ = std::make_unique<FrameVideo>(width, height, VideoOptions{file, fps, speed});
    file_ = file;
    width_ = width;
    height_ = height;
    interval_ = speed / fps;
    last_.reset();
    pictures_ = 0;
  }
  /// Whether the picture at a time [s] is one of the film.
  bool wants(double time) const {
    return recording() && (!last_ || time >= *last_ + 0.999 * interval_);
  }
  /// Pictures of another size are skipped: the window was resized.
  void add(const Image& image, double time) {
    if (image.width != width_ || image.height != height_) return;
    video_->add(image, time);
    last_ = time;
    ++pictures_;
  }
  /// Writes the file. Throws Error (kind run) if that fails.
  void finish() {
    const auto video = std::move(video_);
    video->finish();
  }

 private:
  static constexpr double fps = 30;
  std::unique_ptr<FrameVideo> video_;
  std::filesystem::path file_;
  int width_ = 0, height_ = 0;
  double interval_ = 0;
  std::optional<double> last_;
  std::size_t pictures_ = 0;
};

}  // namespace freshet::window
