// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <vector>

#include "freshet/frame.h"
#include "freshet/scene.h"

namespace freshet {

/// Counts the particles that cross the counters of a scene from frame to frame, by their ids. A
/// particle moves straight between two frames that both have it. What it does between them, and
/// particles that only one of them has, cannot be counted.
class FrameFlows {
 public:
  /// Particles through a counter, along its direction minus against it.
  struct Passed {
    double volume =
        0;  ///< since the first frame, each particle with its volume at rest [m^3; m^2 in 2D]
    double rate = 0;  ///< mean since the frame before; 0 at the first [m^3/s; m^2/s in 2D]
  };
  /// The scene must have its defaults filled in.
  explicit FrameFlows(const Scene& scene);
  ~FrameFlows();

  /// Moves on to a later frame. Returns what passed each counter.
  std::vector<Passed> advance(const Frame& frame);

  struct Counters;

 private:
  std::unique_ptr<Counters> counters_;
};

}  // namespace freshet
