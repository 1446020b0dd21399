// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "core/vec.h"
#include "freshet/simulation.h"

namespace freshet {

/// Where the scene's probes ask, by probe: nowhere in the fluid those of walls.
class ProbePlaces {
 public:
  /// Keeps a reference to the scene.
  explicit ProbePlaces(const Scene& scene);
  const std::vector<std::vector<Vector>>& at_the_start() const { return start_; }
  /// Whether bodies carry any of them.
  bool move() const;
  /// Where bodies have carried them.
  std::vector<std::vector<Vector>> now(const std::vector<BodyState>& bodies) const;
  /// Of the probes of walls, in their order, where bodies have carried them.
  std::vector<WallPatch> patches(const std::vector<BodyState>& bodies) const;

 private:
  struct Carrier {
    std::size_t body;
    Vec<3, double> center;  ///< at the start [m]
  };
  static Vector carried(const Carrier& by, const std::vector<BodyState>& bodies,
                        const Vector& place);

  const Scene& scene_;
  std::vector<std::vector<Vector>> start_;
  std::vector<std::optional<Carrier>> carriers_;  ///< by probe
};

}  // namespace freshet
