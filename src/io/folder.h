// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "io/files.h"

namespace freshet {

/// A folder that is held open. The names of its files are relative to it. Nothing is read, written
/// or removed through a symbolic link below it or through "..", so nothing outside changes.
///
/// Each component of a name is opened by openat with O_NOFOLLOW, which needs no openat2: a name
/// without ".." and without links cannot leave the folder.
class Folder {
 public:
  /// The path of the folder itself may contain links. Throws Error (kind run) if it cannot be
  /// opened.
  explicit Folder(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  int descriptor() const { return folder_.get(); }

  /// Makes the folders that a file is in. Throws Error (kind run).
  void make_folder_of(const std::string& file) const;
  /// The first component of a name that is a symbolic link, the last one included. Empty if there
  /// is none.
  std::string link_in(const std::string& file) const;
  /// Whether something has this name; links are not followed.
  bool holds(const std::string& file) const;
  /// The bytes of a regular file. Empty if there is none or it cannot be read.
  std::optional<std::string> read(const std::string& file) const;

  /// Writes a file as write_file does.
  void write(const std::string& file, std::string_view bytes) const;
  /// Writes `bytes` at the end of a file that has `size` bytes by now, and syncs it. What stands
  /// behind these, a row that a killed run left, is cut off. A file of size 0 is made anew. Throws
  /// Error (kind run); the file then has its `size` bytes, unless another program cut it.
  void append(const std::string& file, std::size_t size, std::string_view bytes) const;
  /// Removes a file or a link, but no folder. A missing file is no error.
  void remove(const std::string& file) const;

 private:
  Descriptor parent_of(const std::string& file, bool make = false) const;

  std::filesystem::path path_;
  Descriptor folder_;
};

}  // namespace freshet
