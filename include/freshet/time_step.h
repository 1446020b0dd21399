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
  double flow = std::numeric_limits<double>::infinity();  ///< of solvers without sound
  double least() const { return std::min({acoustic, force, viscous, flow}); }
  /// "sound", "force", "viscosity" or "flow": which of them is the least.
  const char* ruling() const {
    const double least = this->least();
    return least == acoustic  ? "sound"
           : least == force   ? "force"
           : least == viscous ? "viscosity"
                              : "flow";
  }
};

}  // namespace freshet
