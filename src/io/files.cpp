// SPDX-License-Identifier: MIT
#include "io/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
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
    case ELOOP:
      return "a symbolic link is in the way, and files are written only below the folder; remove "
             "the link or choose another `output`";
    default:
      return "choose another `output`";
  }
}

/// The folder that a file is in. Links in its path are the user's choice.
Descriptor folder_of(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  Descriptor opened(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (!opened.good()) fail_file(file, "write", errno);
  return opened;
}

/// A file is renamed to its place, which would replace a device or a FIFO that stands there.
void refuse_special(int folder, const std::filesystem::path& file) {
  struct stat there;
  if (::fstatat(folder, file.filename().c_str(), &there, 0) != 0) return;
  if (S_ISREG(there.st_mode) || S_ISDIR(there.st_mode)) return;
  throw Error(Error::Kind::run, file.string(),
              fmt::format("cannot write: {}, which a file would replace; choose another `output`",
                          S_ISFIFO(there.st_mode)   ? "this is a named pipe (FIFO)"
                          : S_ISSOCK(there.st_mode) ? "this is a socket"
                                                    : "this is a device"),
              {"output"});
}

}  // namespace

Descriptor::~Descriptor() {
  if (fd_ >= 0) ::close(fd_);
}

PartialFile::PartialFile(const std::filesystem::path& file) : PartialFile(folder_of(file), file) {}

PartialFile::PartialFile(Descriptor folder, std::filesystem::path file)
    : file_(std::move(file)), folder_(std::move(folder)), partial_(-1) {
  refuse_special(folder_.get(), file_);
  ::unlinkat(folder_.get(), name().c_str(), 0);  // of a run that was killed, or a planted link
  partial_ = Descriptor(::openat(folder_.get(), name().c_str(),
                                 O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
  if (!partial_.good()) fail_file(file_, "write", errno);
}

PartialFile::~PartialFile() {
  if (!finished_) ::unlinkat(folder_.get(), name().c_str(), 0);
}

void PartialFile::write(std::string_view bytes) { write_all(partial_.get(), file_, bytes); }

void PartialFile::finish() {
  const std::string to = file_.filename().string();
  if (::renameat(folder_.get(), name().c_str(), folder_.get(), to.c_str()) != 0)
    fail_file(file_, "write", errno);
  finished_ = true;
}

void write_file(const std::filesystem::path& file, std::string_view bytes) {
  PartialFile partial(file);
  partial.write(bytes);
  partial.finish();
}

void write_all(int fd, const std::filesystem::path& file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail_file(file, "write", written < 0 ? errno : ENOSPC);
    bytes.remove_prefix(std::size_t(written));
  }
  if (::fsync(fd) != 0 && errno != EINVAL) fail_file(file, "write", errno);
}

std::filesystem::path made_folder(const std::filesystem::path& folder) {
  std::error_code ec;
  std::filesystem::create_directories(folder, ec);
  if (ec) fail_file(folder, "make this folder", ec.value());
  return folder;
}

void fail_file(const std::filesystem::path& path, const std::string& operation, int reason) {
  throw Error(Error::Kind::run, path.string(),
              fmt::format("cannot {}: {}; {}", operation, std::strerror(reason), remedy(reason)),
              {"output"});
}

}  // namespace freshet
