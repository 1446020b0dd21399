// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace freshet {

/// The length of the UTF-8 character at the start of a text that is not empty; 0 if none is there.
inline std::size_t utf8_length(std::string_view text) {
  const auto at = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char first = at(0);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((at(k) & 0xC0) != 0x80) return 0;
  if (first == 0xE0 && at(1) < 0xA0) return 0;   // could be shorter
  if (first == 0xED && at(1) >= 0xA0) return 0;  // a surrogate
  if (first == 0xF0 && at(1) < 0x90) return 0;   // could be shorter
  if (first == 0xF4 && at(1) >= 0x90) return 0;  // beyond U+10FFFF
  return length;
}

/// The text with U+FFFD in place of bytes that are not UTF-8. File names may hold such bytes.
inline std::string valid_utf8(std::string_view text) {
  std::string valid;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length > 0) valid += text.substr(0, length);
    else valid += "\xEF\xBF\xBD";
    text.remove_prefix(length > 0 ? length : 1);
  }
  return valid;
}

}  // namespace freshet
