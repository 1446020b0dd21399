// SPDX-License-Identifier: MIT
/// Writes the tables of a scene.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/vec.h"

namespace freshet {

/// A number with nine digits, which a float of the other program has.
std::string toml_number(double value);
/// A string in quotes.
std::string toml_string(const std::string& text);
/// The first `dimension` components.
std::string toml_vector(const Vec<3, double>& a, int dimension);

/// A file that a scene in `from` names, as a TOML in `to` names it.
std::string path_for_toml(const std::string& file, const std::filesystem::path& from,
                          const std::filesystem::path& to);

/// The lines of a table.
class TomlTable {
 public:
  void set(const std::string& key, double value) { line(key, toml_number(value)); }
  void set(const std::string& key, const std::string& text) { line(key, toml_string(text)); }
  void set(const std::string& key, const char* text) { line(key, toml_string(text)); }
  void set(const std::string& key, const Vec<3, double>& a, int dimension) {
    line(key, toml_vector(a, dimension));
  }
  /// `value` is TOML.
  void line(const std::string& key, const std::string& value);
  void add(const TomlTable& other) { text_ += other.text_; }
  const std::string& lines() const { return text_; }
  /// "\n[NAME]" and the lines; nothing if there are none.
  std::string table(const std::string& name) const;
  /// "\n[[NAME]]" and the lines.
  std::string item(const std::string& name) const;

 private:
  std::string text_;
};

/// Text without line ends and other control characters, for a comment.
std::string in_one_line(std::string text);

}  // namespace freshet
