// SPDX-License-Identifier: MIT
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <concepts>
#include <string>
#include <string_view>
#include <vector>

namespace freshet::web {

/// The text of a JSON object, for the panels of the page. Infinity and NaN become null.
class Json {
 public:
  Json& add(std::string_view key, const std::string& value) { return put(key, quoted(value)); }
  Json& add(std::string_view key, const char* value) { return add(key, std::string(value)); }
  Json& add(std::string_view key, bool value) { return put(key, value ? "true" : "false"); }
  template <std::integral T> Json& add(std::string_view key, T value) {
    return put(key, fmt::format("{}", value));
  }
  Json& add(std::string_view key, double value) { return put(key, number(value)); }
  Json& add(std::string_view key, const std::vector<double>& values) {
    std::string list;
    for (const double v : values) list += number(v) + ",";
    return add_list(key, list);
  }
  /// Entries that are JSON, each followed by a comma.
  Json& add_list(std::string_view key, std::string entries) {
    if (!entries.empty()) entries.pop_back();
    return put(key, "[" + entries + "]");
  }
  std::string text() const { return "{" + members_ + "}"; }

 private:
  static std::string number(double v) { return std::isfinite(v) ? fmt::format("{}", v) : "null"; }
  static std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
      if (c == '"' || c == '\\') out += '\\';
      if (static_cast<unsigned char>(c) < 0x20) out += fmt::format("\\u{:04x}", int(c));
      else out += c;
    }
    return out + "\"";
  }
  Json& put(std::string_view key, const std::string& value) {
    members_ += fmt::format("{}\"{}\":{}", members_.empty() ? "" : ",", key, value);
    return *this;
  }

  std::string members_;
};

}  // namespace freshet::web
