// SPDX-License-Identifier: MIT
#include "core/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

namespace freshet {
namespace {

/// What a path that is not a regular file is.
const char* kind_of(mode_t mode) {
  if (S_ISFIFO(mode)) return "a named pipe (FIFO)";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

class InputReader {
 public:
  InputReader(const std::filesystem::path& file, const InputFile& rules)
      : file_(file), rules_(rules) {
    if (::stat(file.c_str(), &info_) != 0) {
      if (errno == ENOENT || errno == ENOTDIR)
        fail(std::string("no such ") + rules.noun + "; check the path");
      fail_to_read();
    }
    check_kind();
    // without blocking: another program may put a FIFO here between stat() and open()
    fd_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (fd_ < 0) fail_to_read();
  }
  InputReader(const InputReader&) = delete;
  ~InputReader() {
    if (fd_ >= 0) ::close(fd_);
  }

  std::string read() {
    if (::fstat(fd_, &info_) != 0) fail_to_read();
    check_kind();
    check_size(std::uintmax_t(std::max<off_t>(info_.st_size, 0)));
    std::vector<char> part(1 << 16);
    std::string bytes;
    for (;;) {
      const ssize_t got = ::read(fd_, part.data(), part.size());
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) fail_to_read();
      if (got == 0) break;
      bytes.append(part.data(), std::size_t(got));
      check_size(bytes.size());
    }
    if (bytes.empty() && !rules_.may_be_empty)
      fail(std::string("this file is empty; ") + rules_.remedy);
    return bytes;
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw Error(rules_.kind, file_.string(), why);
  }
  [[noreturn]] void fail_to_read() const {
    fail(std::string("cannot be read: ") + std::strerror(errno) + "; check its permissions, or " +
         rules_.remedy);
  }
  void check_kind() const {
    if (S_ISREG(info_.st_mode)) return;
    if (S_ISDIR(info_.st_mode)) fail(std::string("this is a folder; ") + rules_.remedy);
    fail(std::string("not a regular file but ") + kind_of(info_.st_mode) + "; " + rules_.remedy);
  }
  void check_size(std::uintmax_t bytes) const {
    if (bytes > rules_.largest)
      fail("larger than " + std::to_string(rules_.largest >> 20) + " MiB, the maximum of a " +
           rules_.noun + "; " + rules_.remedy);
  }

  const std::filesystem::path& file_;
  const InputFile& rules_;
  struct stat info_ = {};
  int fd_ = -1;
};

}  // namespace

std::string read_input(const std::filesystem::path& file, const InputFile& rules) {
  return InputReader(file, rules).read();
}

}  // namespace freshet
