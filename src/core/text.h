// SPDX-License-Identifier: MIT
/// Helpers for readers of text files.
#pragma once
#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

#if defined(__EMSCRIPTEN__)
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <string>
#endif

namespace freshet {

/// The names of the axes in column names.
inline constexpr const char* axis_letters[] = {"x", "y", "z"};

/// Removes the first line from `bytes` and returns it without its line end (LF or CRLF).
inline std::string_view take_line(std::string_view& bytes) {
  const auto end = std::min(bytes.find('\n'), bytes.size());
  std::string_view line = bytes.substr(0, end);
  bytes.remove_prefix(std::min(end + 1, bytes.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

inline std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

#if defined(__EMSCRIPTEN__)
/// Reads a number as std::from_chars does, which libc++ 14 lacks. Returns the end of the number, or
/// `begin` if the text is not a number. The page keeps the locale "C", which strtod needs.
inline const char* read_double(const char* begin, const char* end, double& value) {
  const std::string text(begin, end);  // with a zero at its end
  if (text.empty() || text[0] == '+' || std::isspace(static_cast<unsigned char>(text[0])) ||
      text.find_first_of("xX") != std::string::npos)
    return begin;
  char* stop = nullptr;
  errno = 0;
  const double read = std::strtod(text.c_str(), &stop);
  if (stop == text.c_str() || errno == ERANGE) return begin;
  value = read;
  return begin + (stop - text.c_str());
}
#else
inline const char* read_double(const char* begin, const char* end, double& value) {
  const auto [stop, ec] = std::from_chars(begin, end, value);
  return ec == std::errc() ? stop : begin;
}
#endif

/// The whole text as a number; empty if it is not a number.
inline std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const char* const end = text.data() + text.size();
  if (text.empty() || read_double(text.data(), end, value) != end) return {};
  return value;
}

}  // namespace freshet
