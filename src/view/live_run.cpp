// SPDX-License-Identifier: MIT
#include "view/live_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/model/setup.h"

namespace freshet::view {

LiveRun::LiveRun(const ActionLog& log, const Execution& execution)
    : log_(log),
      to_repeat_(log.actions.rbegin(), log.actions.rend()),
      sim_(load_scene(log.scene, log.overrides), execution),
      scene_(std::make_shared<Scene>(sim_.scene())),
      support_radius_(freshet::support_radius(*scene_)) {
  log_.actions.clear();
  if (!scene_->probe.empty()) probes_.emplace(*scene_);
}

void LiveRun::record(const Action& action) {
  apply(sim_, action);
  if (action.kind == Action::Kind::change) {
    auto changed = std::make_shared<Scene>(sim_.scene());
    if (probes_) probes_.emplace(*changed);
    scene_ = std::move(changed);
  }
  log_.actions.push_back(action);
}

void LiveRun::repeat() {
  while (!to_repeat_.empty() && to_repeat_.back().step <= sim_.steps_done()) {
    Action action = to_repeat_.back();
    to_repeat_.pop_back();
    action.step = sim_.steps_done();
    action.time = sim_.time();
    record(action);
  }
}

void LiveRun::step() {
  repeat();
  sim_.step();
}

void LiveRun::change(const Override& change) {
  record({sim_.steps_done(), sim_.time(), Action::Kind::change, change, {}});
}

void LiveRun::push(const std::optional<Push>& push) {
  if (push == pushed_) return;
  const bool other = pushed_ && push && (pushed_->body != push->body);
  if (other || !push) record({sim_.steps_done(), sim_.time(), Action::Kind::release, {}, {}});
  if (push) record({sim_.steps_done(), sim_.time(), Action::Kind::push, {}, *push});
  pushed_ = push;
}

ActionLog LiveRun::log(bool whole) const {
  ActionLog log = log_;
  if (whole) log.actions.insert(log.actions.end(), to_repeat_.rbegin(), to_repeat_.rend());
  return log;
}

void LiveRun::measure(Snapshot& s) {
  s.statistics = sim_.statistics();
  s.flows = sim_.flows();
  if (!probes_) return;
  const auto readings = probes_->measure(sim_);
  for (std::size_t k = 0; k < readings.size(); ++k) {
    if (readings[k].size() != 1) continue;  // a place of a curve or a plane is not a time series
    const auto quantities = probes_->quantities(k);
    for (std::size_t q = 0; q < quantities.size() && q < readings[k][0].values.size(); ++q)
      s.readings.emplace_back(
          fmt::format("{}: {}{}", scene_->probe[k].name, quantities[q].name,
                      quantities[q].unit.empty() ? "" : " [" + quantities[q].unit + "]"),
          readings[k][0].values[q]);
  }
}

void LiveRun::show(Snapshot& s, bool all) {
  s.scene = scene_;
  s.frame = sim_.frame();
  s.ended = ended();
  s.time_step = sim_.time_steps().last;
  s.threads = sim_.threads();
  s.support_radius = support_radius_;
  s.solves = sim_.solves();
  s.warnings = sim_.warnings();
  s.actions = log_.actions.size();
  if (all) measure(s);
}

}  // namespace freshet::view
