// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "core/inlet_plan.h"

namespace freshet {

/// When the layers of an inlet come in, and where they are. All that it remembers is in `State`.
///
/// Layer k goes through the opening at start + (k + 1/2) spacing/speed, so that what has come in by
/// a time is the flow to within half a layer; before that it moves with the inlet's speed. It comes
/// into being half a spacing before the zone's back, or where it is by then. At `start` the zone is
/// filled.
///
/// An inlet that recycles brings so many layers at the start, and each further one when as many
/// particles wait as it has places, and the one before has made room.
class InletClock {
 public:
  struct State {
    std::uint64_t born = 0, through = 0;  ///< layers so far, and those of them past the opening
    std::uint64_t waiting = 0;            ///< particles that are to come in again
  };
  explicit InletClock(InletPlan plan);

  const InletPlan& plan() const { return plan_; }
  /// Layers that are held at once, at most.
  int slots() const { return plan_.layers + 2; }
  /// Of the last `slots()` layers, by k mod slots(), when each goes through the opening [s].
  std::vector<double>& crossings() { return crossings_; }
  const std::vector<double>& crossings() const { return crossings_; }
  /// Where the layer in a slot is before the opening [m].
  double ahead(std::size_t slot, double time) const {
    return plan_.speed * (time - crossings_[slot]);
  }
  /// Where a layer comes into being [m].
  double birth() const { return -plan_.depth() + plan_.spacing / 2; }

  struct Layer {
    std::uint64_t number;
    double crossing;  ///< when it goes through the opening [s]
  };
  /// The time is now `time`, dt after the last.
  void advance(double time, double dt);
  /// The layers that the last call brought.
  const std::vector<Layer>& fresh() const { return fresh_; }

  State state;

 private:
  bool next(double time, double dt, double& crossing) const;

  InletPlan plan_;
  std::vector<double> crossings_;
  std::vector<Layer> fresh_;
};

}  // namespace freshet
