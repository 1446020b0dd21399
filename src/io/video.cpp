// SPDX-License-Identifier: MIT
#include "io/video.h"

#include <string>

#include "freshet/error.h"
#include "io/child_process.h"

namespace freshet {
namespace {

constexpr double most_gif_fps = 100;  // a GIF counts hundredths of a second

/// How to get an encoder for a kind of file; empty if there is one.
std::string missing_encoder(const std::string& kind) {
  if ((kind == ".gif" && has_gif()) || (kind == ".webp" && has_webp()) || in_path("ffmpeg"))
    return "";
  const std::string ffmpeg =
      "needs ffmpeg, which is not installed; on Debian: sudo apt-get install "
      "ffmpeg";
  if (kind == ".mp4") return ffmpeg + ", or choose FILE.gif or FILE.webp";
  return ffmpeg + ", or install " + (kind == ".gif" ? "libgif-dev" : "libwebp-dev") +
         " and build Freshet again";
}

}  // namespace

std::unique_ptr<Video> make_video(const std::filesystem::path& file, int width, int height,
                                  double fps) {
  std::unique_ptr<Video> video;
  if (file.extension() == ".gif") video = make_gif_video(file, width, height, fps);
  if (file.extension() == ".webp") video = make_webp_video(file, width, height, fps);
  return video ? std::move(video) : make_ffmpeg_video(file, width, height, fps);
}

void check_video(const std::filesystem::path& file, double fps, bool overwrite) {
  const auto refuse = [&](const std::string& why) {
    throw Error(Error::Kind::scene, "option video " + file.string(), why, {"overwrite"});
  };
  const std::string kind = file.extension().string();
  if (kind != ".mp4" && kind != ".gif" && kind != ".webp")
    refuse("the name must end in .mp4, .gif or .webp");
  std::error_code ec;
  if (file.has_parent_path() && !std::filesystem::is_directory(file.parent_path(), ec))
    refuse("the folder of this file does not exist; make it, or choose another");
  if (std::filesystem::exists(file) && !overwrite)
    refuse("this file exists; `overwrite` replaces it");
  if (kind == ".gif" && fps > most_gif_fps)
    refuse("a GIF has at most 100 pictures per second; choose fewer");
  if (const std::string missing = missing_encoder(kind); !missing.empty()) refuse(missing);
}

}  // namespace freshet
