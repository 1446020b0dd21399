// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <limits>

namespace freshet {

/// The time integration of positions and velocities. symplectic_euler is of first order, leapfrog
/// (kick-drift-kick) and verlet (drift-kick-drift) are of second order.
enum class Integrator { symplectic_euler, leapfrog, verlet };

/// Upper bounds of an explicit time step [s]; infinity where a bound does not apply. The formulas
/// are in src/solvers/time_step.h.
struct TimeStepBounds {
  double acoustic, force, viscous;
  double flow = std::numeric_limits<double>::infinity();       ///< pressure solvers: 0.4 h/max|v|
  double capillary = std::numeric_limits<double>::infinity();  ///< from surface tension
  double least() const { return std::min({acoustic, force, viscous, flow, capillary}); }
  /// The name of the smallest bound: "sound", "force", "viscosity", "flow" or "surface tension".
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
