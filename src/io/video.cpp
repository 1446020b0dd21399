// SPDX-License-Identifier: MIT
#include "io/video.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "freshet/error.h"
#include "io/files.h"

extern "C" char** environ;  // POSIX headers do not declare it

namespace freshet {
namespace {

bool in_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((folder + "/" + program).c_str(), X_OK) == 0) return true;
  return false;
}

std::vector<std::string> arguments(const std::filesystem::path& to, bool gif, int width, int height,
                                   double fps) {
  const std::string filter =
      gif ? "split[a][b];[a]palettegen[p];[b][p]paletteuse" : "pad=ceil(iw/2)*2:ceil(ih/2)*2";
  std::vector<std::string> all{"ffmpeg",   "-v",
                               "error",    "-y",
                               "-f",       "rawvideo",
                               "-pix_fmt", "rgb24",
                               "-s",       fmt::format("{}x{}", width, height),
                               "-r",       fmt::format("{}", fps),
                               "-i",       "-",
                               "-vf",      filter};
  if (!gif) all.insert(all.end(), {"-pix_fmt", "yuv420p", "-crf", "18", "-movflags", "+faststart"});
  all.insert(all.end(), {"-f", gif ? "gif" : "mp4", to.string()});
  return all;
}

}  // namespace

void Video::check(const std::filesystem::path& file, bool overwrite) {
  const auto refuse = [&](const std::string& why) {
    throw Error(Error::Kind::scene, "option video " + file.string(), why, {"overwrite"});
  };
  if (file.extension() != ".gif" && file.extension() != ".mp4")
    refuse("the name must end in .mp4 or .gif");
  if (std::filesystem::exists(file) && !overwrite)
    refuse("this file exists; `overwrite` replaces it");
  if (!in_path("ffmpeg"))
    refuse("needs ffmpeg, which is not installed; on Debian: sudo apt-get install ffmpeg");
}

Video::Video(std::filesystem::path file, int width, int height, double fps)
    : file_(std::move(file)), partial_(file_) {
  const bool gif = file_.extension() == ".gif";
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
  std::vector<std::string> words = arguments(partial_.path(), gif, width, height, fps);
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

Video::~Video() {
  wait();
  ::close(words_);
}

bool Video::wait() {
  if (pipe_ >= 0) ::close(std::exchange(pipe_, -1));
  int status = 0;
  if (ffmpeg_ > 0) ::waitpid(std::exchange(ffmpeg_, -1), &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void Video::fail() {
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

void Video::add(const Image& image) {
  const char* data = reinterpret_cast<const char*>(image.pixels.data());
  for (std::size_t left = 3 * image.pixels.size(); left > 0;) {
    const ssize_t sent = ::send(pipe_, data, left, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) fail();
    data += sent;
    left -= std::size_t(sent);
  }
}

void Video::finish() {
  if (!wait()) fail();
  partial_.finish();
}

}  // namespace freshet
