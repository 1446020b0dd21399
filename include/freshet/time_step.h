// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <limits>

namespace freshet {

/// How positions and velocities follow from accelerations.
enum class Integrator { symplectic_euler, leapfrog, verlet };

/// What bounds an explicit time step [s]; infinity where nothing does.
struct TimeStepBounds {
  double acoustic, force, viscous;
  double flow = std::numeric_limits<double>::infinity();       ///< of solvers without sound
  double capillary = std::numeric_limits<double>::infinity();  ///< of surface tension
  double least() const { return std::min({acoustic, force, viscous, flow, capillary}); }
  /// "sound", "force", "viscosity", "flow" or "surface tension": which of them is the least.
  const char* ruling() const {
    const double least = this->least();
    return least == acoustic  ? "sound"
           : least == force   ? "force"
           : least == viscous ? "viscosity"
           : least == flow    ? "flow"
                              : "surface tension";
  }
};

}  // namespace freshet
