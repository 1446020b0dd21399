// SPDX-License-Identifier: MIT
#include "view/actions.h"

#include <toml++/toml.h>

#include <sstream>

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

toml::table table_of(const Override& change) {
  toml::table table{{"key", change.first}};
  if (change.second) table.insert("value", *change.second);
  else table.insert("removed", true);
  return table;
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

}  // namespace freshet::view
