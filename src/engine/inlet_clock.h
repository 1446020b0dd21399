// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "core/inlet_plan.h"

namespace freshet {

/// The schedule of the layers of an inlet, and their positions. Its state is `state` and the
/// crossing times.
///
/// Layer k crosses the opening at start + (k + 1/2) spacing/speed, so the emitted volume is exact
/// to half a layer. Before that it moves with the inlet's speed. It is created half a spacing in
/// front of the back of the zone, or further on if the step is long. At `start` the zone is filled.
///
/// A recycling inlet creates the layers of the zone at the start. It creates a further layer when
/// enough particles wait and the previous layer has made room.
class InletClock {
 public:
  struct State {
    std::uint64_t born = 0, through = 0;  ///< layers created, and those of them past the opening
    std::uint64_t waiting = 0;            ///< particles that left and are not yet emitted again
  };
  explicit InletClock(InletPlan plan);

  const InletPlan& plan() const { return plan_; }
  /// The maximum number of layers held at the same time.
  int slots() const { return plan_.layers + 2; }
  /// The times at which the last `slots()` layers cross the opening [s]; layer k is at k mod
  /// slots().
  std::vector<double>& crossings() { return crossings_; }
  const std::vector<double>& crossings() const { return crossings_; }
  /// The position of the layer in a slot along the inlet's direction [m]: negative behind the
  /// opening.
  double ahead(std::size_t slot, double time) const {
    return plan_.speed * (time - crossings_[slot]);
  }
  /// The position at which a layer is created [m], negative.
  double birth() const { return -plan_.depth() + plan_.spacing / 2; }

  struct Layer {
    std::uint64_t number;
    double crossing;  ///< time at which it crosses the opening [s]
  };
  /// The number of layers that are not created although they have crossed the opening by `time`.
  double overdue(double time) const;
  /// Advances to `time`, dt after the last call [s].
  void advance(double time, double dt);
  /// The layers that the last advance() created.
  const std::vector<Layer>& fresh() const { return fresh_; }

  State state;

 private:
  double scheduled(std::uint64_t layer) const;
  double due() const;
  bool next(double time, double dt, double& crossing) const;

  InletPlan plan_;
  std::vector<double> crossings_;
  std::vector<Layer> fresh_;
};

}  // namespace freshet
