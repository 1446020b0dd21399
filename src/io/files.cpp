// SPDX-License-Identifier: MIT
#include "io/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "freshet/error.h"

namespace freshet {
namespace {

std::string remedy(int reason) {
  switch (reason) {
    case ENOSPC:
    case EDQUOT:
      return "make room on that disk or choose another --output";
    case EFBIG:
      return "the limit on file sizes (ulimit -f) is too low";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose an --output that you may write to";
    case ENOTDIR:
    case EEXIST:
      return "a file stands where a folder must be; choose another --output";
    default:
      return "choose another --output";
  }
}

/// A file descriptor. The destructor removes the temporary file unless it is kept.
class Temporary {
 public:
  explicit Temporary(std::filesystem::path file)
      : path(std::move(file)),
        fd(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {}
  Temporary(const Temporary&) = delete;
  ~Temporary() {
    if (fd >= 0) ::close(fd);
    if (!kept) ::unlink(path.c_str());
  }
  std::filesystem::path path;
  int fd;
  bool kept = false;
};

}  // namespace

void fail_file(const std::filesystem::path& path, const std::string& operation, int reason) {
  throw Error(Error::Kind::run, path.string(),
              fmt::format("cannot {}: {}; {}", operation, std::strerror(reason), remedy(reason)));
}

void write_file(const std::filesystem::path& file, std::string_view bytes) {
  Temporary beside(file.string() + ".part");
  if (beside.fd < 0) {
    beside.kept = true;  // open() failed: the file is not ours to remove
    fail_file(file, "write", errno);
  }
  while (!bytes.empty()) {
    const ssize_t written = ::write(beside.fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail_file(file, "write", written < 0 ? errno : ENOSPC);
    bytes.remove_prefix(std::size_t(written));
  }
  if (::fsync(beside.fd) != 0 && errno != EINVAL) fail_file(file, "write", errno);
  rename_file(beside.path, file);
  beside.kept = true;
}

void rename_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) fail_file(to, "write", errno);
}

}  // namespace freshet
