// SPDX-License-Identifier: MIT
#include "scene/keys/overrides.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <sstream>

#include "freshet/suggest.h"
#include "scene/keys/nesting.h"
#include "scene/keys/override_place.h"

namespace freshet {
namespace {

[[noreturn]] void fail(const std::string& key, const std::string& message) {
  throw Error(Error::Kind::scene, "override " + key, message);
}

/// "fluid[2]" -> {"fluid", 2}; -1 without an index.
std::pair<std::string, int> split_count(const std::string& key, const std::string& segment) {
  const auto open = segment.find('[');
  const std::string name = segment.substr(0, open);
  int count = -1;
  if (open != std::string::npos) {
    if (!segment.ends_with(']'))
      fail(key, "not a key; write for example fluid.viscosity or fluid[1].viscosity");
    const char* end = segment.data() + segment.size() - 1;
    const auto [stop, ec] = std::from_chars(segment.data() + open + 1, end, count);
    if (ec != std::errc() || stop != end || count < 0)
      fail(key, "not a key; write for example fluid.viscosity or fluid[1].viscosity");
  }
  if (name.empty()) fail(key, "not a key; write for example time.end=2");
  return {name, count};
}

/// Inserts a copy of the value, whatever its type.
void put(toml::table& table, const std::string& name, const toml::node& value) {
  value.visit([&](const auto& v) { table.insert_or_assign(name, v); });
}

/// The table `segment` of `table`; creates it if it is missing.
toml::table& enter(toml::table& table, const std::string& key, const std::string& segment,
                   std::string& path) {
  const auto [name, count] = split_count(key, segment);
  if (!table.contains(name)) table.insert(name, toml::table{});
  toml::node& node = *table.get(name);
  path += name;
  if (auto* array = node.as_array()) {
    const std::size_t k = count < 0 ? 0 : std::size_t(count);
    if (!array->is_homogeneous<toml::table>())
      fail(key, fmt::format("{} is a value, not a table of keys", name));
    if (count < 0 && array->size() != 1)
      fail(key, fmt::format("there are {} tables {}; choose one of {}[0] to {}[{}]", array->size(),
                            name, name, name, array->size() - 1));
    if (k >= array->size() || !array->get(k)->is_table())
      fail(key, fmt::format("there is no {}[{}]; the scene has {}", name, k, array->size()));
    path += fmt::format("[{}].", k);
    return *array->get(k)->as_table();
  }
  if (!node.is_table()) fail(key, fmt::format("{} is a value, not a table of keys", name));
  if (count > 0) fail(key, fmt::format("there is no {}[{}]; the scene has 1", name, count));
  // a single [fluid] has the path fluid[0], as in SceneReader
  static constexpr const char* several[] = {"fluid",  "wall",  "inlet", "outlet", "counter",
                                            "camera", "probe", "body",  "joint"};
  const bool one_of_them =
      std::find(std::begin(several), std::end(several), name) != std::end(several);
  path += one_of_them ? "[0]." : ".";
  return *node.as_table();
}

toml::table parse_value(const std::string& key, const std::string& value) {
  const std::string text = "value = " + value;
  if (NestingScan(text).too_deep())
    fail(key, fmt::format("the value is nested too deeply; at most {} levels are allowed",
                          NestingScan::deepest));
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& e) {
    if (e.description().find("utf-8") != std::string_view::npos)
      fail(key, "the value is not UTF-8 text");
    return toml::table{{"value", value}};
  }
}

std::vector<std::string> split_key(const std::string& key) {
  std::vector<std::string> names;
  std::istringstream segments(key + ".");
  for (std::string segment; std::getline(segments, segment, '.');) names.push_back(segment);
  if (names.size() > NestingScan::deepest) fail(key.substr(0, 40) + "...", "not a key: too long");
  return names;
}

void set_key(toml::table& root, const std::string& key, const std::string& value,
             std::map<std::string, std::string>& where) {
  toml::table* table = &root;
  std::string path;
  const std::vector<std::string> names = split_key(key);
  for (std::size_t k = 0; k + 1 < names.size(); ++k) table = &enter(*table, key, names[k], path);
  const auto [name, count] = split_count(key, names.back());
  if (count >= 0) fail(key, "names a whole table; name one of its keys");
  toml::table parsed = parse_value(key, value);
  // "1\nother = 2" is valid TOML, but more than one value
  put(*table, name,
      parsed.size() == 1 ? *parsed.get("value")
                         : static_cast<const toml::node&>(toml::value{value}));
  where[path + name] = "override " + key;
}

/// The message about a key that is not in its table.
std::string missing_key(const toml::table& table, const std::string& name) {
  std::set<std::string, std::less<>> known;
  for (const auto& [other, value] : table) known.insert(std::string(other.str()));
  if (known.empty()) return "the scene does not set it, so it cannot be removed";
  const std::string guess = nearest(name, known);
  return "the scene does not set it, so it cannot be removed; " +
         (guess.empty() ? fmt::format("set here: {}", fmt::join(known, ", "))
                        : fmt::format("did you mean {}?", guess));
}

void remove_key(toml::table& root, const std::string& key) {
  toml::table* table = &root;
  std::string path;
  const std::vector<std::string> names = split_key(key);
  for (std::size_t k = 0; k + 1 < names.size(); ++k) {
    const std::string name = split_count(key, names[k]).first;
    if (!table->contains(name)) fail(key, missing_key(*table, name));
    table = &enter(*table, key, names[k], path);
  }
  const auto [name, count] = split_count(key, names.back());
  if (count >= 0) fail(key, "names one table of several; name one of its keys, or all of them");
  if (table->erase(name) == 0) fail(key, missing_key(*table, name));
}

}  // namespace

std::map<std::string, std::string> apply_overrides(toml::table& root,
                                                   const std::vector<Override>& overrides) {
  std::map<std::string, std::string> where;
  for (const Override& change : overrides) try {
      if (change.second) set_key(root, change.first, *change.second, where);
      else remove_key(root, change.first);
    } catch (const Error& error) {
      throw Error(Error::Kind::scene, place_of(change), error.diagnostics().front().message);
    }
  return where;
}

}  // namespace freshet
