// SPDX-License-Identifier: MIT
/// Videos by ffmpeg, in a process of its own.
#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "freshet/error.h"
#include "io/child_process.h"
#include "io/files.h"
#include "io/video.h"

namespace freshet {
namespace {

/// The encoder of a kind of file, by the options of ffmpeg.
std::vector<std::string> encoder(const std::string& kind) {
  if (kind == ".gif") return {"-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse", "-f", "gif"};
  if (kind == ".webp") return {"-c:v", "libwebp", "-quality", "90", "-loop", "0", "-f", "webp"};
  return {"-vf",       "pad=ceil(iw/2)*2:ceil(ih/2)*2",
          "-pix_fmt",  "yuv420p",
          "-crf",      "18",
          "-movflags", "+faststart",
          "-f",        "mp4"};
}

std::vector<std::string> arguments(const std::filesystem::path& to, const std::string& kind,
                                   int width, int height, double fps) {
  std::vector<std::string> all{"ffmpeg",   "-v",
                               "error",    "-y",
                               "-f",       "rawvideo",
                               "-pix_fmt", "rgb24",
                               "-s",       fmt::format("{}x{}", width, height),
                               "-r",       fmt::format("{}", fps),
                               "-i",       "-"};
  for (std::string& word : encoder(kind)) all.push_back(std::move(word));
  all.push_back(to.string());
  return all;
}

/// Pipes pictures to ffmpeg.
class FfmpegVideo final : public Video {
 public:
  FfmpegVideo(std::filesystem::path file, int width, int height, double fps)
      : file_(std::move(file)),
        partial_(file_),
        ffmpeg_(file_, arguments(partial_.path(), file_.extension().string(), width, height, fps),
                ChildProcess::Input::pipe) {}
  void add(const Image& image) override {
    const char* data = reinterpret_cast<const char*>(image.pixels.data());
    if (!ffmpeg_.send({data, 3 * image.pixels.size()})) fail();
  }
  void finish() override {
    if (!ffmpeg_.finish()) fail();
    partial_.finish();
  }

 private:
  [[noreturn]] void fail();

  std::filesystem::path file_;
  PartialFile partial_;  // which ffmpeg opens by its name
  ChildProcess ffmpeg_;
};

void FfmpegVideo::fail() {
  ffmpeg_.finish();
  std::string words = ffmpeg_.output(4000);
  words = words.substr(0, words.find('\n'));
  throw Error(Error::Kind::run, file_.string(),
              fmt::format("ffmpeg could not make this film: {}; "
                          "make room or choose another name",
                          words.empty() ? "it ended early" : words));
}

}  // namespace

std::unique_ptr<Video> make_ffmpeg_video(const std::filesystem::path& file, int width, int height,
                                         double fps) {
  return std::make_unique<FfmpegVideo>(file, width, height, fps);
}

}  // namespace freshet
