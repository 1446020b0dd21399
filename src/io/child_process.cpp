// SPDX-License-Identifier: MIT
#include "io/child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <thread>

extern "C" char** environ;  // POSIX headers do not declare it

namespace freshet {
namespace {

/// What a process is started with.
class Start {
 public:
  explicit Start(std::vector<std::string>& words) {
    for (std::string& word : words) argv_.push_back(word.data());
    argv_.push_back(nullptr);
    posix_spawn_file_actions_init(&actions_);
    posix_spawnattr_init(&own_group_);
    posix_spawnattr_setflags(&own_group_, POSIX_SPAWN_SETPGROUP);
  }
  ~Start() {
    posix_spawnattr_destroy(&own_group_);
    posix_spawn_file_actions_destroy(&actions_);
  }
  Start(const Start&) = delete;
  Start& operator=(const Start&) = delete;
  void connect(int from, int to) { posix_spawn_file_actions_adddup2(&actions_, from, to); }
  void close_input() { posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0); }
  /// Returns a value of errno, or 0.
  int run(pid_t& process) const {
    return ::posix_spawnp(&process, argv_[0], &actions_, &own_group_, argv_.data(), ::environ);
  }

 private:
  std::vector<char*> argv_;
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t own_group_;
};

}  // namespace

bool in_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((folder + "/" + program).c_str(), X_OK) == 0) return true;
  return false;
}

ChildProcess::ChildProcess(const std::filesystem::path& file, std::vector<std::string> words,
                           Input input)
    : name_(words.at(0)), pipe_(-1), output_(::memfd_create("output of a program", MFD_CLOEXEC)) {
  const std::string starting = "start " + name_ + " for this file";
  if (!output_.good()) fail_file(file, starting, errno);
  int ends[2] = {-1, -1};
  if (input == Input::pipe && ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    fail_file(file, starting, errno);
  pipe_ = Descriptor(ends[0]);
  const Descriptor other_end(ends[1]);
  Start start(words);
  if (input == Input::pipe) start.connect(other_end.get(), 0);
  else start.close_input();
  start.connect(output_.get(), 1);
  start.connect(output_.get(), 2);
  if (const int code = start.run(process_); code != 0) {
    process_ = -1;
    fail_file(file, starting, code);
  }
}

ChildProcess::~ChildProcess() { finish(); }

bool ChildProcess::send(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(pipe_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    bytes.remove_prefix(std::size_t(sent));
  }
  return true;
}

bool ChildProcess::ends_within(std::chrono::milliseconds time) {
  constexpr std::chrono::milliseconds pause{20};
  for (std::chrono::milliseconds waited{0}; process_ > 0; waited += pause) {
    if (::waitpid(process_, &status_, WNOHANG) == process_) process_ = -1;
    else if (waited >= time) return false;
    else std::this_thread::sleep_for(pause);
  }
  return true;
}

void ChildProcess::stop() {
  if (process_ > 0) ::kill(-process_, SIGTERM);
  finish();
}

bool ChildProcess::finish() {
  pipe_ = Descriptor(-1);
  if (process_ > 0) {
    while (::waitpid(process_, &status_, 0) < 0 && errno == EINTR) continue;
    process_ = -1;
  }
  return WIFEXITED(status_) && WEXITSTATUS(status_) == 0;
}

std::string ChildProcess::output(std::size_t most) const {
  struct stat about {};
  if (::fstat(output_.get(), &about) != 0) return "";
  const auto size = std::min(most, std::size_t(about.st_size));
  std::string text(size, '\0');
  const ssize_t n =
      ::pread(output_.get(), text.data(), size, about.st_size - static_cast<off_t>(size));
  text.resize(n > 0 ? std::size_t(n) : 0);
  return text;
}

}  // namespace freshet
