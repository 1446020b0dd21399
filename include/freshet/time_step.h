// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>

namespace freshet {

/// How positions and velocities follow from accelerations.
enum class Integrator { symplectic_euler, leapfrog, verlet };

/// What bounds an explicit time step [s]; infinity where nothing does.
struct TimeStepBounds {
  double acoustic, force, viscous;
  double least() const { return std::min({acoustic, force, viscous}); }
  /// "sound", "force" or "viscosity": which of them is the least.
  const char* ruling() const {
    return least() == acoustic ? "sound" : least() == force ? "force" : "viscosity";
  }
};

}  // namespace freshet
