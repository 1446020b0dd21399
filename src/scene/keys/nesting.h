// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <string_view>

namespace freshet {

/// Finds the first place of a TOML text where brackets or the parts of a key nest deeper than
/// `deepest`. The parser destroys its tables recursively, so that a hostile text could overflow the
/// stack. This scan needs no stack.
class NestingScan {
 public:
  static constexpr int deepest = 32;

  explicit NestingScan(std::string_view text) : text_(text) {
    while (at_ < text_.size() && !too_deep()) advance();
  }
  bool too_deep() const { return brackets_ > deepest || dots_ >= deepest; }
  std::size_t line() const {
    return 1 + std::size_t(std::count(text_.begin(), text_.begin() + std::ptrdiff_t(at_), '\n'));
  }

 private:
  void advance() {
    const char c = text_[at_];
    if (c == '#') return skip_to("\n");
    if (c == '"' || c == '\'') return skip_string(c);
    if (c == '[' || c == '{') ++brackets_;
    if (c == ']' || c == '}') brackets_ = std::max(0, brackets_ - 1);
    if (c == '.') ++dots_;
    else if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) dots_ = 0;
    ++at_;
  }
  void skip_string(char quote) {
    const char triple[] = {quote, quote, quote, 0};
    if (text_.substr(at_, 3) == triple) {
      at_ += 3;
      skip_to(triple, quote == '"');
      at_ = std::min(at_ + 3, text_.size());
      while (at_ < text_.size() && text_[at_] == quote) ++at_;  // its text may end with quotes
      return;
    }
    const char ends[] = {quote, 0};
    ++at_;
    skip_to(ends, quote == '"');
    at_ = std::min(at_ + 1, text_.size());
  }
  /// Skips to `end`. With `escapes`, a backslash hides the character after it.
  void skip_to(std::string_view end, bool escapes = false) {
    while (at_ < text_.size() && text_.substr(at_, end.size()) != end) {
      if (end.size() == 1 && text_[at_] == '\n') return;  // the string is not closed
      at_ += escapes && text_[at_] == '\\' ? 2 : 1;
    }
    at_ = std::min(at_, text_.size());
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int brackets_ = 0, dots_ = 0;
};

}  // namespace freshet
