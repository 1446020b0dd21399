// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace freshet {

/// The place of a parser in a file, for its messages.
class FilePlace {
 public:
  explicit FilePlace(std::string file) : file_(std::move(file)) {}

  /// Throws Error (kind scene) at FILE, or FILE:LINE.
  [[noreturn]] void fail(const std::string& why) const;

  std::size_t line = 0;  ///< current line of the parser; 0: none

 private:
  std::string file_;
};

/// The beginning of a name, for messages: a damaged file may have names of any length.
inline std::string_view shown(std::string_view name) { return name.substr(0, 40); }

}  // namespace freshet
