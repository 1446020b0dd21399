// SPDX-License-Identifier: MIT
/// Reads logs of actions, as of a stranger: what is not exactly a log is an error.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "core/check_checkpoint.h"
#include "core/input_file.h"
#include "scene/keys/parse_toml.h"
#include "view/actions.h"

namespace freshet::view {
namespace {

constexpr double largest = 1e30;  // number, so that a float holds it

/// A table of a log.
class LogTable {
 public:
  LogTable(const toml::table& table, std::string file) : table_(table), file_(std::move(file)) {}

  [[noreturn]] void fail(const std::string& why) const { fail(table_, why); }
  [[noreturn]] void fail(const toml::node& at, const std::string& why) const {
    throw Error(Error::Kind::scene, fmt::format("{}:{}", file_, at.source().begin.line),
                why + "; name a log that `freshet view` has saved");
  }
  bool has(const char* key) const { return table_.contains(key); }
  void allow(std::initializer_list<std::string_view> keys) const {
    for (const auto& [key, node] : table_)
      if (std::find(keys.begin(), keys.end(), key.str()) == keys.end())
        fail(node,
             fmt::format("unknown key {}; the keys here are {}", key.str(), fmt::join(keys, ", ")));
  }
  std::string text(const char* key) const {
    const auto value = needed(key).value<std::string>();
    if (!value) fail(needed(key), fmt::format("{} must be a string", key));
    return *value;
  }
  std::int64_t whole(const char* key, std::int64_t most) const {
    const toml::node& node = needed(key);
    const std::int64_t value = node.is_integer() ? node.value_or(std::int64_t(-1)) : -1;
    if (value < 0 || value > most)
      fail(node, fmt::format("{} must be a whole number from 0 to {}", key, most));
    return value;
  }
  double number(const char* key) const {
    const toml::node& node = needed(key);
    return number(node, key);
  }
  std::array<double, 3> triple(const char* key) const {
    const toml::array* values = needed(key).as_array();
    if (!values || values->size() != 3)
      fail(needed(key), fmt::format("{} must be three numbers in brackets", key));
    std::array<double, 3> all{};
    for (std::size_t d = 0; d < all.size(); ++d) all[d] = number(*values->get(d), key);
    return all;
  }
  /// Whether a switch is there; its only value is true.
  bool flag(const char* key) const {
    if (has(key) && needed(key).value<bool>() != true)
      fail(needed(key), fmt::format("{} must be true, or the key must be missing", key));
    return has(key);
  }
  /// The tables below [[key]].
  std::vector<LogTable> tables(const char* key) const {
    std::vector<LogTable> all;
    if (!has(key)) return all;
    if (!needed(key).is_array_of_tables())
      fail(needed(key), fmt::format("{} must be tables, each below [[{}]]", key, key));
    for (const toml::node& node : *needed(key).as_array())
      all.emplace_back(*node.as_table(), file_);
    return all;
  }

 private:
  const toml::node& needed(const char* key) const {
    if (!has(key)) fail(fmt::format("{} is missing", key));
    return *table_.get(key);
  }
  double number(const toml::node& node, const char* key) const {
    const auto value = node.value<double>();
    if (!value || !(std::abs(*value) <= largest))  // true for NaN as well
      fail(node, fmt::format("{} must be a number of at most {:g}", key, largest));
    return *value;
  }

  const toml::table& table_;
  std::string file_;
};

Override override_in(const LogTable& table) {
  const std::string key = table.text("key");
  if (table.flag("removed")) {
    if (table.has("value")) table.fail("removed excludes a value");
    return {key, std::nullopt};
  }
  return {key, table.text("value")};
}

Push push_in(const LogTable& table) {
  Push push{table.triple("center"), 0, table.triple("pull"), -1};
  if (table.has("body")) {
    push.body = int(table.whole("body", 1'000'000'000));
    if (table.has("radius")) table.fail("the pull of a body has no radius");
    return push;
  }
  push.radius = table.number("radius");
  if (!(push.radius > 0)) table.fail("radius must be greater than 0");
  return push;
}

Action action_in(const LogTable& table) {
  Action action;
  action.step = table.whole("step", most_counted);
  if (table.has("time")) action.time = table.number("time");  // for readers
  if (table.has("key")) {
    table.allow({"step", "time", "key", "value", "removed"});
    action.change = override_in(table);
  } else if (table.flag("released")) {
    table.allow({"step", "time", "released"});
    action.kind = Action::Kind::release;
  } else {
    table.allow({"step", "time", "center", "radius", "body", "pull"});
    action.kind = Action::Kind::push;
    action.push = push_in(table);
  }
  return action;
}

}  // namespace

ActionLog parse_log(const std::string& text, const std::filesystem::path& file) {
  const toml::table root = parse_toml(text, file.string(), "log of actions");
  const LogTable table(root, file.string());
  table.allow({"scene", "override", "action"});
  ActionLog log;
  log.scene = table.text("scene");
  if (log.scene.empty()) table.fail("scene is empty");
  if (log.scene.is_relative()) log.scene = (file.parent_path() / log.scene).lexically_normal();
  for (const LogTable& change : table.tables("override")) {
    change.allow({"key", "value", "removed"});
    log.overrides.push_back(override_in(change));
  }
  for (const LogTable& action : table.tables("action")) log.actions.push_back(action_in(action));
  std::stable_sort(log.actions.begin(), log.actions.end(),
                   [](const Action& a, const Action& b) { return a.step < b.step; });
  return log;
}

ActionLog read_log(const std::filesystem::path& file) {
  constexpr InputFile log{.noun = "log of actions",
                          .remedy = "name a log that `freshet view` has saved"};
  return parse_log(read_input(file, log), file);
}

}  // namespace freshet::view
