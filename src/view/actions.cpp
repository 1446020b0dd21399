// SPDX-License-Identifier: MIT
#include "view/actions.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>

#include "core/input_file.h"

namespace freshet::view {
namespace {

Simulation::Force force_of(const Push& push) {
  return [push](const ParticleView& fluid, double, std::span<double> acceleration) {
    const auto D = std::size_t(fluid.dimension);
    for (std::size_t i = 0; i < fluid.size(); ++i) {
      double r2 = 0;
      for (std::size_t d = 0; d < D; ++d) {
        const double along = fluid.position(i, d) - push.center[d];
        r2 += along * along;
      }
      const double share = 1 - r2 / (push.radius * push.radius);
      if (!(share > 0)) continue;
      for (std::size_t d = 0; d < D; ++d) acceleration[D * i + d] += share * push.pull[d];
    }
  };
}

void pull_body(Simulation& simulation, const Push& push) {
  const auto k = std::size_t(push.body);
  const std::vector<BodyState> bodies = simulation.bodies();
  std::array<double, 3> torque{};
  if (k < bodies.size()) {
    std::array<double, 3> arm{};
    for (std::size_t d = 0; d < 3; ++d) arm[d] = push.center[d] - bodies[k].position[d];
    for (std::size_t d = 0; d < 3; ++d) {
      const std::size_t e = (d + 1) % 3, f = (d + 2) % 3;
      torque[d] = arm[e] * push.pull[f] - arm[f] * push.pull[e];
    }
  }
  simulation.push_body(k, push.pull, torque);
}

void release(Simulation& simulation) {
  simulation.set_force({});
  for (std::size_t k = 0; k < simulation.scene().body.size(); ++k)
    if (simulation.scene().body[k].motion == BodyMotion::free) simulation.push_body(k, {});
}

toml::array array_of(const std::array<double, 3>& a) { return toml::array{a[0], a[1], a[2]}; }

std::array<double, 3> triple_in(const toml::table& table, const char* name) {
  std::array<double, 3> a{};
  const toml::array* values = table[name].as_array();
  for (std::size_t d = 0; values && d < 3 && d < values->size(); ++d)
    a[d] = values->get(d)->value<double>().value_or(0);
  return a;
}

toml::table table_of(const Override& change) {
  toml::table table{{"key", change.first}};
  if (change.second) table.insert("value", *change.second);
  else table.insert("removed", true);
  return table;
}

Override override_in(const toml::table& table) {
  Override change{table["key"].value_or(std::string()), std::nullopt};
  if (!table["removed"].value_or(false)) change.second = table["value"].value_or(std::string());
  return change;
}

Action action_in(const toml::table& table) {
  Action action;
  action.step = table["step"].value_or(std::int64_t(0));
  action.time = table["time"].value_or(0.0);
  if (table.contains("key")) {
    action.change = override_in(table);
  } else if (table["released"].value_or(false)) {
    action.kind = Action::Kind::release;
  } else {
    action.kind = Action::Kind::push;
    action.push = {triple_in(table, "center"), table["radius"].value_or(0.0),
                   triple_in(table, "pull"), int(table["body"].value_or(std::int64_t(-1)))};
  }
  return action;
}

}  // namespace

void apply(Simulation& simulation, const Action& action) {
  switch (action.kind) {
    case Action::Kind::change:
      return simulation.change({action.change});
    case Action::Kind::push:
      if (action.push.body >= 0) pull_body(simulation, action.push);
      else simulation.set_force(force_of(action.push));
      return;
    case Action::Kind::release:
      return release(simulation);
  }
}

std::string ActionLog::text() const {
  toml::array overridden, list;
  for (const Override& change : overrides) overridden.push_back(table_of(change));
  for (const Action& a : actions) {
    toml::table table;
    if (a.kind == Action::Kind::change) table = table_of(a.change);
    if (a.kind == Action::Kind::release) table.insert("released", true);
    if (a.kind == Action::Kind::push) {
      table.insert("center", array_of(a.push.center));
      table.insert("pull", array_of(a.push.pull));
      if (a.push.body >= 0) table.insert("body", a.push.body);
      else table.insert("radius", a.push.radius);
    }
    table.insert("step", a.step);
    table.insert("time", a.time);
    list.push_back(std::move(table));
  }
  toml::table root{{"scene", scene.string()}};
  if (!overridden.empty()) root.insert("override", std::move(overridden));
  if (!list.empty()) root.insert("action", std::move(list));
  std::ostringstream out;
  out << "# The actions of a session of `freshet view`, by the number of steps before them.\n"
      << root << "\n";
  return out.str();
}

ActionLog parse_log(const std::string& text, const std::filesystem::path& file) {
  const auto refuse = [&](const std::string& why) {
    throw Error(Error::Kind::scene, file.string(),
                why + "; name a log that `freshet view` has saved");
  };
  toml::table root;
  try {
    root = toml::parse(text);
  } catch (const toml::parse_error& e) {
    refuse(fmt::format("this is not a log of actions: {}", e.description()));
  }
  ActionLog log;
  log.scene = root["scene"].value_or(std::string());
  if (log.scene.empty()) refuse("this log of actions names no scene");
  if (log.scene.is_relative()) log.scene = (file.parent_path() / log.scene).lexically_normal();
  const auto each = [&](const char* name, const auto& add) {
    const toml::array* tables = root[name].as_array();
    for (std::size_t k = 0; tables && k < tables->size(); ++k)
      if (const toml::table* table = tables->get(k)->as_table()) add(*table);
  };
  each("override", [&](const toml::table& t) { log.overrides.push_back(override_in(t)); });
  each("action", [&](const toml::table& t) { log.actions.push_back(action_in(t)); });
  std::stable_sort(log.actions.begin(), log.actions.end(),
                   [](const Action& a, const Action& b) { return a.step < b.step; });
  return log;
}

ActionLog read_log(const std::filesystem::path& file) {
  constexpr InputFile log{};
  return parse_log(read_input(file.string(), log), file);
}

}  // namespace freshet::view
