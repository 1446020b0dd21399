// SPDX-License-Identifier: MIT
#include "scene/check/names.h"

#include <algorithm>
#include <iterator>

namespace freshet {
namespace {

constexpr std::size_t longest_file_name = 200;  // bytes; file systems allow 255 with the ending

struct CodePoints {
  char32_t first, last;
};

// Of Unicode: characters that are invisible, or that change the direction of the text around them.
constexpr CodePoints invisible[] = {
    {0x00, 0x1F},     {0x7F, 0x9F},     {0xAD, 0xAD},     {0x61C, 0x61C},     {0x180E, 0x180E},
    {0x200B, 0x200F}, {0x2028, 0x202E}, {0x2060, 0x206F}, {0xD800, 0xDFFF},   {0xFDD0, 0xFDEF},
    {0xFEFF, 0xFEFF}, {0xFFF0, 0xFFFB}, {0xFFFE, 0xFFFF}, {0xE0000, 0xE0FFF}, {0x110000, ~0u}};
constexpr CodePoints spaces[] = {{0x20, 0x20},     {0xA0, 0xA0},     {0x1680, 0x1680},
                                 {0x2000, 0x200A}, {0x202F, 0x202F}, {0x205F, 0x205F},
                                 {0x3000, 0x3000}};

template <std::size_t N> bool is_in(const CodePoints (&all)[N], char32_t c) {
  return std::any_of(std::begin(all), std::end(all),
                     [=](CodePoints range) { return c >= range.first && c <= range.last; });
}

/// Removes the first character from UTF-8 text and returns it; ~0 where the text is not UTF-8.
char32_t take_character(std::string_view& text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t more = lead < 0x80 ? 0 : lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : 1;
  const bool valid = (lead < 0x80 || (lead >= 0xC2 && lead < 0xF5)) && more < text.size();
  char32_t c = more == 0 ? lead : lead & (0x3Fu >> more);
  for (std::size_t k = 1; valid && k <= more; ++k) {
    const auto next = static_cast<unsigned char>(text[k]);
    if ((next & 0xC0) != 0x80) {
      text.remove_prefix(k);
      return ~char32_t(0);
    }
    c = c << 6 | (next & 0x3Fu);
  }
  text.remove_prefix(valid ? more + 1 : 1);
  return valid ? c : ~char32_t(0);
}

template <class Allowed> bool all_of(std::string_view name, Allowed allowed) {
  while (!name.empty())
    if (const char32_t c = take_character(name); is_in(invisible, c) || !allowed(c)) return false;
  return true;
}

bool is_ascii_letter_or_digit(char32_t c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

}  // namespace

bool names_column(std::string_view name) {
  return all_of(name, [](char32_t c) { return c != ',' && c != '"'; });
}

bool names_file(std::string_view name) {
  return !name.starts_with('.') && name.size() <= longest_file_name && all_of(name, [](char32_t c) {
    return c >= 0x80 ? !is_in(spaces, c)
                     : is_ascii_letter_or_digit(c) || c == '_' || c == '-' || c == '.';
  });
}

}  // namespace freshet
