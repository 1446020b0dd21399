// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace freshet {

/// Who made a run, for its manifest.
struct Provenance {
  std::vector<std::string> command;
  std::string backend, isa;
  int threads = 1;
};

/// The folder of a run, which one run at a time may write into. manifest.json names every file from
/// the start, so that a run that was killed can be cleared away as well.
class RunFolder {
 public:
  /// Makes or takes over the folder. `planned` are the files that the run may write.
  /// Throws Error: see freshet::run.
  RunFolder(std::filesystem::path folder, bool overwrite, std::vector<std::string> planned,
            Provenance provenance);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  void write(const std::string& file, std::string_view bytes);
  /// The last word of the manifest: the files that are there, with their sizes and digests.
  void finish(std::string_view state);

 private:
  struct Written {
    std::size_t bytes;
    std::string sha256;
  };
  void lock();
  void clear(bool overwrite);
  void write_manifest(std::string_view state, const std::vector<std::string>& files) const;

  std::filesystem::path folder_;
  std::vector<std::string> planned_;
  Provenance provenance_;
  std::map<std::string, Written> written_;
  int lock_ = -1;
};

}  // namespace freshet
