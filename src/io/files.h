// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace freshet {

/// A file descriptor, closed by the destructor.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~Descriptor();
  int get() const { return fd_; }
  bool good() const { return fd_ >= 0; }

 private:
  int fd_;
};

/// A file that is written beside its place, as NAME.part, and renamed when it is complete. The file
/// is always new: what another run left there is removed, and a symbolic link is not followed. A
/// device or a FIFO at the final place is an error, as the file would replace it.
class PartialFile {
 public:
  /// `file` is the final path. Throws Error (kind run), as every member does, with the path, the
  /// system's reason and a remedy.
  explicit PartialFile(const std::filesystem::path& file);
  /// In a folder that is open already. Messages contain `file`.
  PartialFile(Descriptor folder, std::filesystem::path file);
  /// Removes the file unless it is finished.
  ~PartialFile();
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

  std::filesystem::path path() const { return file_.string() + ".part"; }
  /// Writes bytes and syncs the file.
  void write(std::string_view bytes);
  /// Renames the file to its final name, which replaces an existing file.
  void finish();

 private:
  std::string name() const { return file_.filename().string() + ".part"; }

  std::filesystem::path file_;
  Descriptor folder_, partial_;
  bool finished_ = false;
};

/// Writes a file: to a temporary file in the same folder, synced, then renamed. Throws Error (kind
/// run) with the path, the system's reason and a remedy; an existing file then stays unchanged.
void write_file(const std::filesystem::path& file, std::string_view bytes);

/// Writes and syncs. Messages contain `file`.
void write_all(int fd, const std::filesystem::path& file, std::string_view bytes);

/// Makes a folder where it is missing, and those that it is in. Returns it.
std::filesystem::path made_folder(const std::filesystem::path& folder);

/// Throws Error (kind run): `operation` on `path` failed for `reason`, a value of errno.
[[noreturn]] void fail_file(const std::filesystem::path& path, const std::string& operation,
                            int reason);

}  // namespace freshet
