// SPDX-License-Identifier: MIT
#include "io/folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "freshet/error.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

/// The type of what has this name, a value of S_IFMT; 0 if there is nothing.
mode_t type_at(int folder, const fs::path& name) {
  struct stat status;
  if (::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) return 0;
  return status.st_mode & S_IFMT;
}

bool is_regular(int fd) {
  struct stat status;
  return ::fstat(fd, &status) == 0 && S_ISREG(status.st_mode);
}

Descriptor not_opened(int reason) {
  errno = reason;
  return Descriptor(-1);
}

std::string last_of(const std::string& file) { return fs::path(file).filename().string(); }

}  // namespace

Folder::Folder(fs::path path)
    : path_(std::move(path)), folder_(::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (!folder_.good()) fail_file(path_, "open this folder", errno);
}

/// Opens the folder that holds a file. The descriptor is invalid on failure, with the reason in
/// errno.
Descriptor Folder::parent_of(const std::string& file, bool make) const {
  const fs::path name(file);
  if (name.is_absolute()) return not_opened(EINVAL);
  Descriptor at(::openat(folder_.get(), ".", O_PATH | O_DIRECTORY | O_CLOEXEC));
  for (const fs::path& part : name.parent_path()) {
    if (part == "..") return not_opened(EINVAL);
    if (make && ::mkdirat(at.get(), part.c_str(), 0777) != 0 && errno != EEXIST)
      return not_opened(errno);
    Descriptor next(
        ::openat(at.get(), part.c_str(), O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    const int reason = errno;
    if (!next.good()) return not_opened(type_at(at.get(), part) == S_IFLNK ? ELOOP : reason);
    at = std::move(next);
  }
  return at;
}

void Folder::make_folder_of(const std::string& file) const {
  if (!parent_of(file, true).good())
    fail_file((path_ / file).parent_path(), "make this folder", errno);
}

std::string Folder::link_in(const std::string& file) const {
  fs::path begin;
  for (const fs::path& part : fs::path(file)) {
    begin /= part;
    const Descriptor parent = parent_of(begin.string());
    if (!parent.good()) return "";
    if (type_at(parent.get(), begin.filename()) == S_IFLNK) return begin.string();
  }
  return "";
}

bool Folder::holds(const std::string& file) const {
  const Descriptor parent = parent_of(file);
  return parent.good() && type_at(parent.get(), last_of(file)) != 0;
}

std::optional<std::string> Folder::read(const std::string& file) const {
  const Descriptor parent = parent_of(file);
  if (!parent.good()) return {};
  const Descriptor from(::openat(parent.get(), last_of(file).c_str(),
                                 O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (!from.good() || !is_regular(from.get())) return {};
  std::string bytes;
  for (;;) {
    constexpr std::size_t block = 1 << 18;
    const std::size_t size = bytes.size();
    bytes.resize(size + block);
    const ssize_t n = ::read(from.get(), bytes.data() + size, block);
    bytes.resize(size + std::size_t(n > 0 ? n : 0));
    if (n == 0) return bytes;
    if (n < 0 && errno != EINTR) return {};
  }
}

void Folder::write(const std::string& file, std::string_view bytes) const {
  Descriptor parent = parent_of(file);
  if (!parent.good()) fail_file(path_ / file, "write", errno);
  PartialFile partial(std::move(parent), path_ / file);
  partial.write(bytes);
  partial.finish();
}

void Folder::append(const std::string& file, std::size_t size, std::string_view bytes) const {
  const fs::path place = path_ / file;
  const std::string name = last_of(file);
  const Descriptor parent = parent_of(file);
  if (!parent.good()) fail_file(place, "write", errno);
  if (size == 0) ::unlinkat(parent.get(), name.c_str(), 0);
  const Descriptor to(::openat(
      parent.get(), name.c_str(),
      O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | (size == 0 ? O_CREAT | O_EXCL : 0), 0666));
  if (!to.good()) fail_file(place, "write", errno);
  const off_t end = ::lseek(to.get(), 0, SEEK_END);
  if (!is_regular(to.get()) || end < off_t(size))
    throw Error(Error::Kind::run, place.string(),
                fmt::format("this file has {} bytes, and the run wrote {}: another program cut it; "
                            "keep other programs from changing it",
                            end, size));
  if (::ftruncate(to.get(), off_t(size)) != 0 || ::lseek(to.get(), off_t(size), SEEK_SET) < 0)
    fail_file(place, "write", errno);
  try {
    write_all(to.get(), place, bytes);
  } catch (const Error&) {
    static_cast<void>(::ftruncate(to.get(), off_t(size)));
    throw;
  }
}

void Folder::remove(const std::string& file) const {
  const Descriptor parent = parent_of(file);
  if (parent.good()) ::unlinkat(parent.get(), last_of(file).c_str(), 0);
}

}  // namespace freshet
