// SPDX-License-Identifier: MIT
#include "import/toml_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace freshet {

std::string toml_number(double value) { return fmt::format("{:.9g}", value == 0 ? 0.0 : value); }

std::string toml_string(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) out += fmt::format("\\u{:04x}", int(c));
    else out += c;
  }
  return out + "\"";
}

std::string toml_vector(const Vec<3, double>& a, int dimension) {
  std::string out = fmt::format("[{}, {}", toml_number(a.x), toml_number(a.y));
  return out + (dimension == 3 ? ", " + toml_number(a.z) : "") + "]";
}

std::string path_for_toml(const std::string& file, const std::filesystem::path& from,
                          const std::filesystem::path& to) {
  namespace fs = std::filesystem;
  if (fs::path(file).is_absolute()) return file;
  const fs::path target = fs::absolute(from / file).lexically_normal();
  const fs::path relative = target.lexically_relative(fs::absolute(to).lexically_normal());
  return (relative.empty() ? target : relative).generic_string();
}

void TomlTable::line(const std::string& key, const std::string& value) {
  text_ += key + " = " + value + "\n";
}

std::string TomlTable::table(const std::string& name) const {
  return text_.empty() ? "" : "\n[" + name + "]\n" + text_;
}

std::string TomlTable::item(const std::string& name) const {
  return "\n[[" + name + "]]\n" + text_;
}

std::string in_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; }, '?');
  return text;
}

}  // namespace freshet
