// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

  /// Prepares the folder, and creates it unless a run is resumed. `planned` are the files that the
  /// run may write. Throws Error like freshet::run and freshet::resume.
  RunFolder(const std::filesystem::path& folder, Take take, std::vector<std::string> planned,
            Provenance provenance);
  RunFolder(FolderLock lock, Take take, std::vector<std::string> planned, Provenance provenance);

  const std::filesystem::path& path() const { return lock_.folder(); }
  void write(const std::string& file, std::string_view bytes);
  /// Writes a file that was not planned, and adds it to the manifest first.
  void write_more(const std::string& file, std::string_view bytes);
  void remove(const std::string& file);
  /// Writes the final manifest: `state`, and the existing files with their sizes and digests.
  void finish(std::string_view state);
  /// The state in the manifest of the earlier run; "running" if it was killed.
  const std::string& earlier_state() const { return earlier_state_; }

 private:
  struct Written {
    std::size_t bytes;
    std::string sha256;
  };
  void clear(Take take);
  void make_places(const std::vector<std::string>& files) const;
  void write_manifest(std::string_view state, const std::set<std::string>& files) const;

  FolderLock lock_;
  std::set<std::string> planned_;
  Provenance provenance_;
  std::map<std::string, Written> written_;
  std::string earlier_state_;
};

}  // namespace freshet
