// SPDX-License-Identifier: MIT
/// Videos by ffmpeg, in a process of its own.
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <utility>
#include <vector>

#include "freshet/error.h"
#include "io/files.h"
#include "io/video.h"

extern "C" char** environ;  // POSIX headers do not declare it

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
  FfmpegVideo(std::filesystem::path file, int width, int height, double fps);
  ~FfmpegVideo() override;
  FfmpegVideo(const FfmpegVideo&) = delete;
  FfmpegVideo& operator=(const FfmpegVideo&) = delete;
  void add(const Image& image) override;
  void finish() override;

 private:
  [[noreturn]] void fail();
  bool wait();

  std::filesystem::path file_;
  PartialFile partial_;  // which ffmpeg opens by its name
  int pipe_ = -1, words_ = -1;
  pid_t ffmpeg_ = -1;
};

FfmpegVideo::FfmpegVideo(std::filesystem::path file, int width, int height, double fps)
    : file_(std::move(file)), partial_(file_) {
  int ends[2];
  words_ = ::memfd_create("ffmpeg's words", MFD_CLOEXEC);
  if (words_ < 0 || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    fail_file(file_, "start ffmpeg for this file", errno);
  pipe_ = ends[0];
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], 0);
  posix_spawn_file_actions_adddup2(&actions, words_, 1);
  posix_spawn_file_actions_adddup2(&actions, words_, 2);
  std::vector<std::string> words =
      arguments(partial_.path(), file_.extension().string(), width, height, fps);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawnattr_t own_group;  // Ctrl-C ends the run only, which then lets ffmpeg finish the video
  posix_spawnattr_init(&own_group);
  posix_spawnattr_setflags(&own_group, POSIX_SPAWN_SETPGROUP);
  const int code = ::posix_spawnp(&ffmpeg_, "ffmpeg", &actions, &own_group, argv.data(), ::environ);
  posix_spawnattr_destroy(&own_group);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  if (code != 0) fail_file(file_, "start ffmpeg for this file", code);
}

FfmpegVideo::~FfmpegVideo() {
  wait();
  ::close(words_);
}

bool FfmpegVideo::wait() {
  if (pipe_ >= 0) ::close(std::exchange(pipe_, -1));
  int status = 0;
  if (ffmpeg_ > 0) ::waitpid(std::exchange(ffmpeg_, -1), &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void FfmpegVideo::fail() {
  wait();
  char text[400] = {};
  const ssize_t n = ::pread(words_, text, sizeof text - 1, 0);
  std::string words(text, n > 0 ? std::size_t(n) : 0);
  words = words.substr(0, words.find('\n'));
  throw Error(Error::Kind::run, file_.string(),
              fmt::format("ffmpeg could not make this film: {}; "
                          "make room or choose another name",
                          words.empty() ? "it ended early" : words));
}

void FfmpegVideo::add(const Image& image) {
  const char* data = reinterpret_cast<const char*>(image.pixels.data());
  for (std::size_t left = 3 * image.pixels.size(); left > 0;) {
    const ssize_t sent = ::send(pipe_, data, left, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) fail();
    data += sent;
    left -= std::size_t(sent);
  }
}

void FfmpegVideo::finish() {
  if (!wait()) fail();
  partial_.finish();
}

}  // namespace

std::unique_ptr<Video> make_ffmpeg_video(const std::filesystem::path& file, int width, int height,
                                         double fps) {
  return std::make_unique<FfmpegVideo>(file, width, height, fps);
}

}  // namespace freshet
