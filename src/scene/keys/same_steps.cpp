// SPDX-License-Identifier: MIT
#include "scene/keys/same_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "scene/keys/parse_toml.h"

namespace freshet {
namespace {

std::string difference_of(const toml::node* a, const toml::node* b, const std::string& key);

std::string table_difference(const toml::table& a, const toml::table& b, const std::string& key) {
  std::set<std::string> names;
  for (const toml::table* table : {&a, &b})
    for (const auto& [name, value] : *table) names.insert(std::string(name.str()));
  for (const std::string& name : names) {
    const std::string inner = key.empty() ? name : fmt::format("{}.{}", key, name);
    if (const std::string other = difference_of(a.get(name), b.get(name), inner); !other.empty())
      return other;
  }
  return "";
}

std::string array_difference(const toml::array& a, const toml::array& b, const std::string& key) {
  if (a.size() != b.size()) return key;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const std::string inner = a[k].is_table() ? fmt::format("{}[{}]", key, k) : key;
    if (const std::string other = difference_of(&a[k], &b[k], inner); !other.empty()) return other;
  }
  return "";
}

/// Whether a key may differ between a scene and its copy in a run folder.
bool names_a_file_or_backend(const std::string& key) {
  const bool of_fluid = key.starts_with("fluid");  // the copy names the data file itself
  return key == "solver.backend" || key.ends_with(".file") || key.ends_with(".path") ||
         (of_fluid &&
          (key.ends_with(".from_run") || key.ends_with(".time") || key.ends_with(".frame")));
}

/// The key, or the first one in it, where two values differ. A missing value is null.
std::string difference_of(const toml::node* a, const toml::node* b, const std::string& key) {
  if (!steps_depend_on(key) || !steps_depend_on(key + ".") || names_a_file_or_backend(key))
    return "";
  const bool is_table = (a && a->is_table()) || (b && b->is_table());
  static const toml::table empty;  // a missing table equals an empty one
  if (is_table && (!a || a->is_table()) && (!b || b->is_table()))
    return table_difference(a ? *a->as_table() : empty, b ? *b->as_table() : empty, key);
  if (!a || !b) return key;
  if (a->is_array() && b->is_array()) return array_difference(*a->as_array(), *b->as_array(), key);
  if (a->is_number() && b->is_number()) return a->value<double>() == b->value<double>() ? "" : key;
  if (a->is_string() && b->is_string())
    return a->value<std::string>() == b->value<std::string>() ? "" : key;
  if (a->is_boolean() && b->is_boolean()) return a->value<bool>() == b->value<bool>() ? "" : key;
  return key;
}

}  // namespace

bool steps_depend_on(const std::string& key) {
  static constexpr const char* free[] = {"time.end", "title", "description"};
  static constexpr const char* free_tables[] = {"output.", "surface.", "picture.", "camera",
                                                "checks."};
  return std::none_of(std::begin(free), std::end(free), [&](auto name) { return key == name; }) &&
         std::none_of(std::begin(free_tables), std::end(free_tables),
                      [&](auto table) { return key.starts_with(table); });
}

std::string differing_key(const std::string& a, const std::string& name_a, const std::string& b,
                          const std::string& name_b) {
  return a == b ? "" : table_difference(parse_toml(a, name_a), parse_toml(b, name_b), "");
}

}  // namespace freshet
