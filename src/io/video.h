// SPDX-License-Identifier: MIT
#pragma once
#include <sys/types.h>

#include <filesystem>

#include "io/files.h"
#include "render/image.h"

namespace freshet {

/// Pipes pictures to ffmpeg, which encodes an .mp4 or a .gif. The file appears when it is complete.
class Video {
 public:
  /// Throws Error (kind scene) if ffmpeg is missing, the extension is neither .mp4 nor .gif, or the
  /// file exists and may not be replaced. Call it before a run changes its folder.
  static void check(const std::filesystem::path& file, bool overwrite);

  Video(std::filesystem::path file, int width, int height, double fps);
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  /// Adds a picture. Throws Error (kind run) with the last output of ffmpeg if it ended early.
  void add(const Image& image);
  void finish();

 private:
  [[noreturn]] void fail();
  bool wait();

  std::filesystem::path file_;
  PartialFile partial_;  // which ffmpeg opens by its name
  int pipe_ = -1, words_ = -1;
  pid_t ffmpeg_ = -1;
};

}  // namespace freshet
