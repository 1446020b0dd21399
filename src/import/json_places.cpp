// SPDX-License-Identifier: MIT
#include "import/json_places.h"

#include <algorithm>

#include "import/text_of_path.h"

namespace freshet {
namespace {

/// Walks valid JSON.
class PlaceScanner {
 public:
  explicit PlaceScanner(std::string_view json) : json_(json) {}

  JsonPlaces places() {
    value("");
    return std::move(places_);
  }

 private:
  void skip_space() { at_ = std::min(json_.find_first_not_of(" \t\r\n", at_), json_.size()); }
  char next() {
    skip_space();
    return at_ < json_.size() ? json_[at_] : '\0';
  }
  /// Skips a string and returns what is between its quotes.
  std::string_view string() {
    const std::size_t begin = ++at_;
    while (at_ < json_.size() && json_[at_] != '"') at_ += json_[at_] == '\\' ? 2 : 1;
    const std::size_t end = std::min(at_, json_.size());
    ++at_;
    return json_.substr(begin, end - begin);
  }
  void remember(const std::string& path, std::size_t byte) {
    if (!places_.byte.insert_or_assign(path, byte).second) places_.twice.push_back(path);
  }
  void value(const std::string& path) {
    const char first = next();
    if (first == '{') object(path);
    else if (first == '[') list(path);
    else if (first == '"') string();
    else at_ = std::min(json_.find_first_of(",]} \t\r\n", at_), json_.size());
  }
  void object(const std::string& path) {
    ++at_;
    while (next() == '"') {
      const std::size_t byte = at_;
      const std::string key = path_below(path, string());
      remember(key, byte);
      if (next() == ':') ++at_;
      value(key);
      if (next() == ',') ++at_;
    }
    ++at_;
  }
  void list(const std::string& path) {
    ++at_;
    for (std::size_t k = 0; next() != ']' && at_ < json_.size(); ++k) {
      const std::string item = path_below(path, k);
      remember(item, at_);
      value(item);
      if (next() == ',') ++at_;
    }
    ++at_;
  }

  std::string_view json_;
  std::size_t at_ = 0;
  JsonPlaces places_;
};

}  // namespace

std::string line_and_column(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  const auto line_end = before.rfind('\n');
  const std::string_view line =
      line_end == std::string_view::npos ? before : before.substr(line_end + 1);
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const auto characters = std::count_if(line.begin(), line.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  });
  return std::to_string(lines + 1) + ":" + std::to_string(characters + 1);
}

JsonPlaces places_in(std::string_view json) { return PlaceScanner(json).places(); }

int depth_of_json(std::string_view json) {
  int depth = 0, deepest = 0;
  bool quoted = false;
  for (std::size_t k = 0; k < json.size(); ++k) {
    const char c = json[k];
    if (quoted && c == '\\') ++k;
    else if (c == '"') quoted = !quoted;
    else if (!quoted && (c == '{' || c == '[')) deepest = std::max(deepest, ++depth);
    else if (!quoted && (c == '}' || c == ']')) --depth;
  }
  return deepest;
}

}  // namespace freshet
