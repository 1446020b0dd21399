// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <string_view>

namespace freshet {

/// Finds the first place of a TOML text where brackets nest, or the parts of a key follow each
/// other, deeper than any scene does. The parser's tables are destroyed recursively, so that a
/// hostile text could use up the stack; this scan keeps no stack at all.
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
      while (at_ < text_.size() && text_[at_] == quote) ++at_;  // up to two more belong to it
      return;
    }
    const char ends[] = {quote, 0};
    ++at_;
    skip_to(ends, quote == '"');
    at_ = std::min(at_ + 1, text_.size());
  }
  /// Up to `end`; a backslash hides the character after it where `escapes` is set.
  void skip_to(std::string_view end, bool escapes = false) {
    while (at_ < text_.size() && text_.substr(at_, end.size()) != end) {
      if (end.size() == 1 && text_[at_] == '\n') return;  // the string was not closed
      at_ += escapes && text_[at_] == '\\' ? 2 : 1;
    }
    at_ = std::min(at_, text_.size());
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int brackets_ = 0, dots_ = 0;
};

}  // namespace freshet
