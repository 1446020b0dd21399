// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/sha256.h"
#include "io/folder.h"

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
  const Folder& folder() const { return folder_; }

 private:
  Folder folder_;  // its descriptor holds the lock
};

/// What a run may write or delete.
struct RunPlan {
  std::vector<std::string> files;
  std::vector<std::string> folders;  ///< of files that get their names later
};

/// The folder of a run. manifest.json names every file before it is written, so that a run that was
/// killed can be replaced or resumed. Files that neither this manifest nor that of the earlier run
/// names are never replaced or removed. Not thread-safe.
class RunFolder {
 public:
  enum class Take { empty, overwrite, resume };

  explicit RunFolder(FolderLock lock) : lock_(std::move(lock)) {}
  /// Takes the folder over before the first write. Throws Error, before anything changes, if a file
  /// of the plan exists that no run wrote, or if a part of its path is a symbolic link. See also
  /// freshet::run and freshet::resume.
  void take(Take take, const RunPlan& plan, Provenance provenance);

  const std::filesystem::path& path() const { return folder().path(); }
  void write(const std::string& file, std::string_view bytes);
  /// Writes a file that was not planned, and adds it to the manifest first. Throws Error (kind
  /// scene) if the file exists and no run wrote it.
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
  struct Manifest;
  const Folder& folder() const { return lock_.folder(); }
  Manifest earlier_manifest(Take take) const;
  void refuse_links(const RunPlan& plan, Take take) const;
  void refuse_files_of_others(const std::string& file, Take take) const;
  [[noreturn]] void refuse(const std::string& name, Take take, const std::string& why) const;
  void clear(const Manifest& old, Take take);
  void write_manifest(std::string_view state, const std::set<std::string>& files);

  FolderLock lock_;
  Take taken_ = Take::empty;
  std::size_t running_at_ = 0;  // where "running" begins in the manifest; 0: it has another state
  std::set<std::string> planned_;
  Provenance provenance_;
  std::map<std::string, Written> written_;
  std::map<std::string, Growing> growing_;
  std::string earlier_state_;
};

}  // namespace freshet
