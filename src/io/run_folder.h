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

/// Who made a run, for its manifest.
struct Provenance {
  std::vector<std::string> command;
  std::string backend, isa;
  int threads = 1;
};

/// A folder that one run at a time may write into.
class FolderLock {
 public:
  /// Throws Error (kind scene) if another run writes into it, (kind run) if there is no such
  /// folder.
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
/// killed can be cleared away, or goes on, as well. One thread at a time.
class RunFolder {
 public:
  enum class Take { empty, overwrite, resume };

  /// Takes the folder over, which is made unless a run goes on in it. `planned` are files that the
  /// run may write. Throws Error: see freshet::run and freshet::resume.
  RunFolder(const std::filesystem::path& folder, Take take, std::vector<std::string> planned,
            Provenance provenance);
  RunFolder(FolderLock lock, Take take, std::vector<std::string> planned, Provenance provenance);

  const std::filesystem::path& path() const { return lock_.folder(); }
  void write(const std::string& file, std::string_view bytes);
  /// The same of a file that was not planned.
  void write_more(const std::string& file, std::string_view bytes);
  void remove(const std::string& file);
  /// The last word of the manifest: the files that are there, with their sizes and digests.
  void finish(std::string_view state);
  /// How the run that goes on here had ended; "running" if it was killed.
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
