// SPDX-License-Identifier: MIT
/// The one place where the library opens files that it reads as input.
#pragma once
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>

#include "freshet/error.h"

namespace freshet {

/// The messages about an input file, and its limits.
struct InputFile {
  const char* noun = "file";                            ///< "no such NOUN; check the path"
  const char* remedy = "name a file that can be read";  ///< "this is a folder; REMEDY"
  Error::Kind kind = Error::Kind::scene;
  bool may_be_empty = false;
  std::uintmax_t largest = std::numeric_limits<std::uintmax_t>::max();  ///< [bytes]
};

/// Reads all bytes of a regular file. Throws Error at the file if it is missing, empty, too large
/// or cannot be read. Rejects everything that is not a regular file before opening it: a FIFO or a
/// device may block or have no end.
std::string read_input(const std::filesystem::path& file, const InputFile& rules = {});

}  // namespace freshet
