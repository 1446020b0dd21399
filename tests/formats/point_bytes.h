// SPDX-License-Identifier: MIT
/// Helpers for tests of point files.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>

#include "freshet/error.h"
#include "scene/sample/point_cloud.h"

namespace freshet::test {

/// The error message of reading these bytes.
inline std::string read_error(const std::string& bytes, const std::string& file,
                              int dimension = 3) {
  try {
    points_in(bytes, file, dimension);
    return "read without an error";
  } catch (const Error& e) {
    return e.what();
  }
}

/// Numbers in big-endian order.
template <class T> std::string big_endian(std::initializer_list<T> values) {
  std::string bytes;
  for (const T value : values) {
    char part[sizeof(T)];
    std::memcpy(part, &value, sizeof part);
    std::reverse(part, part + sizeof part);
    bytes.append(part, sizeof part);
  }
  return bytes;
}

/// Reads all beginnings of a file, and the file with single bytes changed: each gives points or an
/// Error. Beginnings shorter than `needed` must be errors.
inline void damage(const std::string& whole, const std::string& file, std::size_t needed,
                   std::size_t most_numbers) {
  for (std::size_t n = 0; n < needed; ++n)
    EXPECT_NE("read without an error", read_error(whole.substr(0, n), file)) << n << " bytes";
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (const char byte : {'\0', '9', ' ', '\n', '\xFF'}) {
      std::string bytes = whole;
      bytes[at] = byte;
      try {
        EXPECT_LE(points_in(bytes, file, 3).x.size(), most_numbers);
      } catch (const Error& e) {
        EXPECT_TRUE(std::string(e.what()).starts_with(file)) << e.what();
      }
    }
}

}  // namespace freshet::test
