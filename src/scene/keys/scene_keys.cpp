// SPDX-License-Identifier: MIT
/// The keys of a scene as a list, for programs that show and edit them.
#include "freshet/scene_keys.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

#include "freshet/solver_method.h"
#include "scene/check/check.h"
#include "scene/keys/keys.h"
#include "scene/keys/parse_toml.h"
#include "scene/model/setup.h"

namespace freshet {
namespace {

using Kind = SceneKey::Kind;

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

/// A value as a person writes it: numbers without the digits that rounding adds.
std::string text_of(const toml::node& node) {
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* text = node.as_string()) return quoted(text->get());
  std::ostringstream out;
  if (const auto* list = node.as_array()) {
    const char* comma = "";
    for (const toml::node& element : *list) out << std::exchange(comma, ", ") << text_of(element);
    return "[" + out.str() + "]";
  }
  node.visit([&](const auto& n) { out << n; });
  return out.str();
}

/// Walks the table of keys beside the TOML of a scene.
class KeyLister final : public KeyVisitor {
 public:
  explicit KeyLister(const toml::table& root) : table_(&root) {}
  std::vector<SceneKey> keys;

  void section(std::string_view name, std::string_view,
               const std::function<void()>& visit) override {
    static const toml::table empty;
    const toml::node* node = table_->get(name);
    enter(node && node->is_table() ? *node->as_table() : empty, std::string(name), visit);
  }
  void section_if_set(std::string_view name, std::string_view text,
                      const std::function<void()>& visit) override {
    if (table_->contains(name)) section(name, text, visit);
  }
  void sections(std::string_view name, std::string_view,
                const std::function<void(std::size_t)>& resize,
                const std::function<void(std::size_t)>& visit) override {
    std::vector<const toml::table*> tables;
    const toml::node* node = table_->get(name);
    if (!node) return;
    if (const auto* one = node->as_table()) tables.push_back(one);
    if (const auto* many = node->as_array())
      for (const toml::node& t : *many)
        if (t.is_table()) tables.push_back(t.as_table());
    resize(tables.size());
    for (std::size_t k = 0; k < tables.size(); ++k)
      enter(*tables[k], fmt::format("{}[{}]", name, k), [&] { visit(k); });
  }

  void text(std::string_view n, std::string& v, const KeyDoc& d) override {
    add(n, Kind::text, fmt::format("\"{}\"", v), d);
  }
  void texts(std::string_view n, std::vector<std::string>&, const KeyDoc& d) override {
    add(n, Kind::texts, "", d);
  }
  void number(std::string_view n, double& v, const KeyDoc& d) override {
    add(n, Kind::number, fmt::format("{}", v), d);
  }
  void number(std::string_view n, std::optional<double>&, const KeyDoc& d) override {
    add(n, Kind::number, "", d);
  }
  void integer(std::string_view n, std::int64_t& v, const KeyDoc& d) override {
    add(n, Kind::integer, fmt::format("{}", v), d);
  }
  void integer(std::string_view n, std::optional<std::int64_t>&, const KeyDoc& d) override {
    add(n, Kind::integer, "", d);
  }
  void vector(std::string_view n, Vector& v, const KeyDoc& d) override {
    add(n, Kind::numbers, v.empty() ? "" : fmt::format("[{}]", fmt::join(v, ", ")), d);
  }
  void numbers(std::string_view n, Vector&, std::size_t, const KeyDoc& d) override {
    add(n, Kind::numbers, "", d);
  }
  void components(std::string_view n, Vector&, std::span<const std::size_t>,
                  const KeyDoc& d) override {
    add(n, Kind::other, "", d);
  }
  void vectors(std::string_view n, std::vector<Vector>&, const KeyDoc& d) override {
    add(n, Kind::other, "", d);
  }
  void boolean(std::string_view n, bool& v, const KeyDoc& d) override {
    add(n, Kind::boolean, v ? "true" : "false", d);
  }
  void counts(std::string_view n, Counts&, const KeyDoc& d) override { add(n, Kind::other, "", d); }
  void number_or_word(std::string_view n, double&, bool&, const char*, const KeyDoc& d) override {
    add(n, Kind::other, "", d);
  }
  void word(std::string_view n, int& v, Words words, const KeyDoc& d) override {
    add(n, Kind::word, v < 0 ? "" : fmt::format("\"{}\"", words[std::size_t(v)]), d);
    if (!keys.empty() && keys.back().name == n) keys.back().words = {words.begin(), words.end()};
  }
  void word_list(std::string_view n, std::vector<int>&, Words, const KeyDoc& d) override {
    add(n, Kind::other, "", d);
  }

 private:
  void enter(const toml::table& table, std::string section, const std::function<void()>& visit) {
    const toml::table* outer = std::exchange(table_, &table);
    const std::string outer_section = std::exchange(section_, std::move(section));
    visit();
    table_ = outer;
    section_ = outer_section;
  }
  void add(std::string_view name, Kind kind, std::string fixed, const KeyDoc& d) {
    SceneKey key;
    key.section = section_;
    key.name = name;
    key.path = section_.empty() ? key.name : section_ + "." + key.name;
    key.unit = d.unit;
    key.text = d.text;
    key.kind = kind;
    key.fallback = d.fallback;
    key.min = d.min;
    key.max = d.max;
    key.above = d.above;
    key.live = may_change_while_running(key.path);
    const toml::node* node = table_->get(name);
    key.is_set = node != nullptr;
    if (node) key.value = text_of(*node);
    else if (d.fallback.empty() && !d.required) key.value = std::move(fixed);
    keys.push_back(std::move(key));
  }

  const toml::table* table_;
  std::string section_;
};

/// Whether only other solvers read a key.
bool only_others_read(const SolverMethod& own, const std::string& path) {
  const auto& methods = solver_methods();
  return !own.reads(path) && std::any_of(methods.begin(), methods.end(), [&](const auto* m) {
    return std::find(m->keys.begin(), m->keys.end(), path) != m->keys.end();
  });
}

/// The keys that nothing would read if they were set.
std::set<std::string> keys_without_use(Scene scene, const std::vector<SceneKey>& keys) {
  for (const SceneKey& key : keys) scene.places.emplace(key.path, key.path);
  std::set<std::string> unused;
  for (const UnusedKey& key : unused_keys(scene, {})) unused.insert(key.key);
  return unused;
}

/// Shows the numbers that the scene's defaults have.
void fill_defaults(const Scene& scene, SceneKey& key) {
  if (key.is_set || !key.value.empty()) return;
  const auto number = [&](double value) { key.value = fmt::format("{:.6g}", value); };
  if (key.path == "domain.gravity")
    key.value = fmt::format("[{}]", fmt::join(scene.domain.gravity, ", "));
  if (key.path == "solver.sound_speed") number(sound_speed(scene));
  if (key.path == "solver.stiffness") number(stiffness(scene));
  if (key.path == "solver.artificial_viscosity") number(artificial_viscosity(scene));
  if (key.path == "solver.density_tolerance") number(density_tolerance(scene));
}

}  // namespace

std::vector<SceneKey> keys_of(const Scene& scene) {
  if (scene.source.empty()) return {};
  const toml::table root = parse_toml(scene.source, "scene.toml");
  KeyLister lister(root);
  Scene defaults;
  visit_keys(lister, defaults);
  const std::set<std::string> unused = keys_without_use(scene, lister.keys);
  std::erase_if(lister.keys, [&](const SceneKey& key) {
    return !key.is_set && (unused.contains(key.path) || only_others_read(scene.method(), key.path));
  });
  for (SceneKey& key : lister.keys) fill_defaults(scene, key);
  return std::move(lister.keys);
}

}  // namespace freshet
