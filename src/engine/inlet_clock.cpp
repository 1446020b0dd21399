// SPDX-License-Identifier: MIT
#include "engine/inlet_clock.h"

#include <algorithm>
#include <utility>

namespace freshet {

InletClock::InletClock(InletPlan plan)
    : plan_(std::move(plan)), crossings_(std::size_t(plan_.layers) + 2) {}

/// The crossing of a layer at constant speed: 1e-9 periods early, so that rounding does not delay
/// one at the end of a step [s].
double InletClock::scheduled(std::uint64_t layer) const {
  return plan_.start + (double(layer) + 0.5 - 1e-9) * (plan_.spacing / plan_.speed);
}

/// The crossing of the next layer [s]. After a change of the speed, it follows the last one.
double InletClock::due() const {
  if (state.born == 0) return scheduled(0);
  const double last = crossings_[(state.born - 1) % crossings_.size()];
  return last == scheduled(state.born - 1) ? scheduled(state.born)
                                           : last + plan_.spacing / plan_.speed;
}

double InletClock::overdue(double time) const {
  return (std::min(time, plan_.stop) - due()) * plan_.speed / plan_.spacing;
}

/// Whether another layer is due by `time`, and when it crosses the opening [s].
bool InletClock::next(double time, double dt, double& crossing) const {
  if (time < plan_.start) return false;
  const double period = plan_.spacing / plan_.speed, hair = 1e-9 * plan_.spacing;
  crossing = due();
  const bool at_start = state.born < std::uint64_t(plan_.layers);
  if (plan_.outlet >= 0 && !at_start) {
    if (state.waiting < plan_.particles()) return false;
    const double after = crossings_[(state.born - 1) % crossings_.size()] + period;
    // a layer that had to wait for its particles starts at the back of the zone
    const double ahead = plan_.speed * (time - after);
    const bool in_time = ahead < birth() + plan_.speed * dt + hair;
    crossing = in_time ? after : time - birth() / plan_.speed;
  }
  if (crossing > plan_.stop + 1e-9 * period) return false;
  return plan_.speed * (time - crossing) >= birth() - hair;
}

void InletClock::advance(double time, double dt) {
  fresh_.clear();
  for (double crossing; next(time, dt, crossing); ++state.born) {
    const bool again = plan_.outlet >= 0 && state.born >= std::uint64_t(plan_.layers);
    if (again) state.waiting -= plan_.particles();
    // in a long step a layer may enter and pass the opening at once
    if (state.born - state.through == crossings_.size()) ++state.through;
    crossings_[state.born % crossings_.size()] = crossing;
    fresh_.push_back({state.born, crossing});
  }
  while (state.through < state.born && ahead(state.through % crossings_.size(), time) >= 0)
    ++state.through;
}

}  // namespace freshet
