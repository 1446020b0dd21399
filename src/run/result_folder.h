// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/folder.h"

namespace freshet {

/// The folder of files that are made from a finished run.
class ResultFolder {
 public:
  /// The folder `output`, or RUN/`standard` if that is empty. It is made where it is missing.
  ResultFolder(const std::filesystem::path& run, const std::filesystem::path& output,
               const std::string& standard);
  /// Throws Error (kind scene) if one of these files exists. `noun`: what the files are.
  void refuse_existing(const std::vector<std::string>& names, const std::string& noun) const;
  std::filesystem::path write(const std::string& name, std::string_view bytes) const;
  std::filesystem::path path() const { return folder_.path() / below_; }
  /// The bytes of a regular file. Empty if the file does not exist.
  std::optional<std::string> read(const std::string& name) const {
    return folder_.read(below_ + name);
  }
  /// Removes a file. A missing one is no error.
  void remove(const std::string& name) const { folder_.remove(below_ + name); }

 private:
  std::string below_;
  Folder folder_;
};

}  // namespace freshet
