// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "freshet/simulation.h"

namespace freshet {

/// The fluid and the bodies at a time between two frames [cubic Hermite interpolation of the
/// positions, by the velocities of both frames; linear interpolation of everything else]. A
/// particle that only one frame has is in the result if that frame is nearer. Positions stay inside
/// periodic ends.
Frame frame_between(const Frame& earlier, const Frame& later, double time, const Scene& scene);

/// Frames at any time within the last step. They never change a step.
class FrameSource {
 public:
  /// Keeps a reference to the simulation.
  explicit FrameSource(const Simulation& sim) : sim_(sim) {}

  /// Call it before each step. `keep`: a frame within the step may be asked for.
  void before_step(bool keep);
  /// A time that the last step has reached or passed, after its start if nothing was kept.
  std::shared_ptr<const Frame> at(double time);

 private:
  const Simulation& sim_;
  std::shared_ptr<const Frame> earlier_, later_, last_;  // last_: of the last call
};

}  // namespace freshet
