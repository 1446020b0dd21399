// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/sha256.h"

namespace freshet {

/// The origin of a run, for its manifest.
struct Provenance {
  std::vector<std::string> command;
  std::string backend, isa;
  int threads = 1;
};

/// The lock of a folder: one run at a time may write into it.
class FolderLock {
 public:
  /// Throws Error (kind scene) if another run writes into the folder, (kind run) if it does not
  /// exist.
  explicit FolderLock(std::filesystem::path folder);
  /// Of a folder that is made where it is missing.
  static FolderLock of_new(const std::filesystem::path& folder);
  FolderLock(FolderLock&& o) noexcept
      : folder_(std::move(o.folder_)), fd_(std::exchange(o.fd_, -1)) {}
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  int fd_ = -1;
};

/// The folder of a run. manifest.json names every file before it is written, so that a run that was
/// killed can be replaced or resumed. Not thread-safe.
class RunFolder {
 public:
  enum class Take { empty, overwrite, resume };

  explicit RunFolder(FolderLock lock) : lock_(std::move(lock)) {}
  /// Takes the folder over before the first write. `planned` are files that the run may write.
  /// Throws Error: see freshet::run and freshet::resume.
  void take(Take take, const std::vector<std::string>& planned, Provenance provenance);

  const std::filesystem::path& path() const { return lock_.folder(); }
  void write(const std::string& file, std::string_view bytes);
  /// Writes a file that was not planned, and adds it to the manifest first.
  void write_more(const std::string& file, std::string_view bytes);
  /// Adds bytes at the end of a planned file, which the first call makes.
  void append(const std::string& file, std::string_view bytes);
  /// SHA-256 of the first `bytes` bytes that append has written.
  std::string appended_sha256(const std::string& file, std::size_t bytes) const;
  /// Resumes a file of append: its first `bytes` bytes stay if they have that digest. False if the
  /// file is missing. Throws Error (kind run) if it begins otherwise.
  bool continue_file(const std::string& file, std::size_t bytes, const std::string& sha256);
  void remove(const std::string& file);
  /// Writes the final manifest: `state`, and the existing files with their sizes and digests.
  void finish(std::string_view state);
  /// Makes the state "failed" in the manifest of a run that take() has begun, in place: that needs
  /// neither memory nor room on the disk.
  void mark_failed() noexcept;
  /// Writes the final manifest of a run that failed, or marks it where that cannot be written.
  void fail() noexcept;
  /// The state in the manifest of the earlier run; "running" if it was killed.
  const std::string& earlier_state() const { return earlier_state_; }

 private:
  struct Written {
    std::size_t bytes;
    std::string sha256;
  };
  struct Growing {
    std::size_t bytes = 0;
    Sha256 sha;
  };
  void clear(Take take);
  void make_places(const std::vector<std::string>& files) const;
  void write_manifest(std::string_view state, const std::set<std::string>& files);

  FolderLock lock_;
  std::filesystem::path manifest_;
  std::size_t running_at_ = 0;  // where "running" begins in the manifest; 0: it has another state
  std::set<std::string> planned_;
  Provenance provenance_;
  std::map<std::string, Written> written_;
  std::map<std::string, Growing> growing_;
  std::string earlier_state_;
};

}  // namespace freshet
