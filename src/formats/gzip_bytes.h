// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "formats/file_place.h"

namespace freshet {

/// The bytes of a file in their order. A file compressed by gzip is inflated step by step, so its
/// memory does not exceed what the reader asks for.
class InputBytes {
 public:
  InputBytes(std::string_view bytes, const FilePlace& place);
  InputBytes(const InputBytes&) = delete;
  ~InputBytes();

  /// The next bytes; valid until the next call. Fails if the file ends before.
  std::string_view take(std::size_t size) {
    std::string_view taken;
    if (size <= most_left()) taken = gzip_ ? inflate(size) : bytes_.substr(0, size);
    if (taken.size() < size) place_.fail("the file ends too early; it is cut off");
    if (!gzip_) bytes_.remove_prefix(size);
    return taken;
  }

  /// An upper bound of the number of bytes that follow.
  std::uint64_t most_left() const {
    constexpr std::uint64_t most_deflated = 1032, window = 1 << 16;  // the window is not yet read
    return gzip_ ? bytes_.size() * most_deflated + window : bytes_.size();
  }

 private:
  struct Gzip;

  static bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1F\x8B"); }
  /// Returns fewer bytes if the file ends before.
  std::string_view inflate(std::size_t size);

  std::string_view bytes_;  // not yet read
  const FilePlace& place_;
  std::unique_ptr<Gzip> gzip_;  // null if the file is not compressed
};

}  // namespace freshet
