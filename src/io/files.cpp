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
      return "make room on that disk or choose another `output`";
    case EFBIG:
      return "the limit on file sizes (ulimit -f) is too low";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose an `output` that you may write to";
    case ENOTDIR:
    case EEXIST:
      return "a file stands where a folder must be; choose another `output`";
    default:
      return "choose another `output`";
  }
}

struct Descriptor {
  explicit Descriptor(int descriptor) : fd(descriptor) {}
  Descriptor(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
  int fd;
};

/// Writes and syncs; `file` is the name in messages.
void write_all(int fd, const std::filesystem::path& file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail_file(file, "write", written < 0 ? errno : ENOSPC);
    bytes.remove_prefix(std::size_t(written));
  }
  if (::fsync(fd) != 0 && errno != EINVAL) fail_file(file, "write", errno);
}

/// A file descriptor; its temporary file goes unless it was kept.
class Temporary : public Descriptor {
 public:
  explicit Temporary(std::filesystem::path file)
      : Descriptor(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)),
        path(std::move(file)) {}
  ~Temporary() {
    if (!kept) ::unlink(path.c_str());
  }
  std::filesystem::path path;
  bool kept = false;
};

}  // namespace

void fail_file(const std::filesystem::path& path, const std::string& operation, int reason) {
  throw Error(Error::Kind::run, path.string(),
              fmt::format("cannot {}: {}; {}", operation, std::strerror(reason), remedy(reason)),
              {"output"});
}

void write_file(const std::filesystem::path& file, std::string_view bytes) {
  Temporary beside(file.string() + ".part");
  if (beside.fd < 0) {
    beside.kept = true;  // open() failed: the file is not ours to remove
    fail_file(file, "write", errno);
  }
  write_all(beside.fd, file, bytes);
  rename_file(beside.path, file);
  beside.kept = true;
}

void append_file(const std::filesystem::path& file, std::size_t size, std::string_view bytes) {
  const Descriptor to(::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666));
  if (to.fd < 0) fail_file(file, "write", errno);
  const off_t end = ::lseek(to.fd, 0, SEEK_END);
  if (end < off_t(size))
    throw Error(Error::Kind::run, file.string(),
                fmt::format("this file has {} bytes, and the run wrote {}: another program cut it; "
                            "keep other programs from changing it",
                            end, size));
  if (::ftruncate(to.fd, off_t(size)) != 0 || ::lseek(to.fd, off_t(size), SEEK_SET) < 0)
    fail_file(file, "write", errno);
  try {
    write_all(to.fd, file, bytes);
  } catch (const Error&) {
    static_cast<void>(::ftruncate(to.fd, off_t(size)));
    throw;
  }
}

void rename_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) fail_file(to, "write", errno);
}

}  // namespace freshet
