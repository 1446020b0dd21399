// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <filesystem>
#include <memory>

#include "render/image.h"

namespace freshet {

/// Encodes pictures of equal size and duration. The file appears when it is complete.
class Video {
 public:
  virtual ~Video() = default;
  /// Adds a picture. Throws Error (kind run), as finish does, if it cannot be encoded or written.
  virtual void add(const Image& image) = 0;
  virtual void finish() = 0;
};

/// A video by the extension of its file: .mp4 by ffmpeg; .gif and .webp by giflib and libwebp, or
/// by ffmpeg where Freshet was built without these libraries.
std::unique_ptr<Video> make_video(const std::filesystem::path& file, int width, int height,
                                  double fps);

/// Throws Error (kind scene) if the extension is unknown, a library or ffmpeg is missing, the
/// folder is missing, or the file exists and may not be replaced. Call it before a run changes its
/// folder.
void check_video(const std::filesystem::path& file, double fps, bool overwrite);

/// The encoders. The last two return null if Freshet was built without their library.
std::unique_ptr<Video> make_ffmpeg_video(const std::filesystem::path& file, int width, int height,
                                         double fps);
std::unique_ptr<Video> make_gif_video(const std::filesystem::path& file, int width, int height,
                                      double fps);
std::unique_ptr<Video> make_webp_video(const std::filesystem::path& file, int width, int height,
                                       double fps);
bool has_gif();
bool has_webp();

/// The end of the k-th picture, in so many units per second: durations that are whole numbers of
/// units add up without drift.
inline long video_time(long k, double fps, double units_per_second) {
  return std::lround(double(k + 1) * units_per_second / fps);
}

}  // namespace freshet
