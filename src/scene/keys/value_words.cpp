// SPDX-License-Identifier: MIT
#include "scene/keys/value_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace freshet {

namespace {

constexpr double largest = 1e15, smallest = 1e-30;  // in SI units; 32-bit numbers hold both
constexpr double largest_whole = 9e15;              // a double holds it exactly

}  // namespace

std::string printable(std::string_view words) {
  constexpr std::size_t longest = 40;
  std::size_t end = std::min(words.size(), longest);
  while (end < words.size() && end > 0 && (words[end] & 0xC0) == 0x80) --end;  // no cut in UTF-8
  std::string text(words.substr(0, end));
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 0x7F; }, '?');
  return text + (end < words.size() ? "..." : "");
}

std::string found(const toml::node& node) {
  if (const auto* s = node.as_string())
    return fmt::format("the string \"{}\"", printable(s->get()));
  if (const auto* i = node.as_integer()) return fmt::format("{}", i->get());
  if (const auto* f = node.as_floating_point()) return fmt::format("{}", f->get());
  if (const auto* b = node.as_boolean()) return b->get() ? "true" : "false";
  if (const auto* a = node.as_array())
    return a->empty() ? "an empty array"
                      : fmt::format("an array of {} value{}", a->size(), a->size() == 1 ? "" : "s");
  return node.is_table() ? "a table" : "a date or time";
}

double number_of(const toml::node& node) {
  if (const auto* i = node.as_integer()) return double(i->get());
  const auto* f = node.as_floating_point();
  return f ? f->get() : NAN;
}

Range::Range(const KeyDoc& doc, bool whole) {
  const double most = whole ? largest_whole : largest;
  low = doc.above ? doc.min + smallest : std::max(doc.min, -most);
  high = std::min(doc.max, most);
}

std::string limits(const toml::node& node, const KeyDoc& doc, bool whole) {
  const Range range(doc, whole);
  const double value = number_of(node);
  std::string text = whole ? "a whole number" : "a number";
  const bool tiny = doc.above && value > doc.min && value < range.low;
  const bool low = std::isfinite(doc.min) || value < range.low;
  if (doc.above && !tiny) text += fmt::format(" > {:.10g}", doc.min);
  else if (low) text += fmt::format(" >= {:.10g}", range.low);
  if (std::isfinite(doc.max) || value > range.high)
    text += fmt::format("{} <= {:.10g}", low ? " and" : "", range.high);
  return text + (doc.unit.empty() ? "" : fmt::format(" ({})", doc.unit));
}

std::string vector_words(std::size_t dimension, const char* numbers) {
  if (dimension == 0) return fmt::format("2 or 3 {}, [x, y] or [x, y, z]", numbers);
  return fmt::format("{} {}, {}, like domain.max", dimension, numbers,
                     dimension == 2 ? "[x, y]" : "[x, y, z]");
}

std::string one_of(Words words) {
  std::string list;
  for (std::size_t k = 0; k < words.size(); ++k)
    list += fmt::format("{}\"{}\"", k == 0 ? "" : k + 1 == words.size() ? " or " : ", ", words[k]);
  return list;
}

}  // namespace freshet
