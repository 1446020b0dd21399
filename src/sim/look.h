// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <functional>
#include <optional>

#include "freshet/derived.h"
#include "freshet/simulation.h"

namespace freshet {

/// A particle that a message points at.
struct Witness {
  std::uint64_t id = 0;
  std::array<double, 3> x{};  ///< [m]; the third is 0 in 2D
  double value = -1;          ///< what it was chosen for
};

/// What one pass over the particles finds. Which particle it names does not depend on their order.
struct Look {
  std::optional<Witness> lost;  ///< no number, or ten domain diagonals out; value 1: no number
  std::int64_t left = 0;        ///< how many are where a wall should have kept them from
  Witness first_left;           ///< of these the least id
  Witness fastest;              ///< by its speed [m/s] about the mean velocity
  Witness densest;              ///< by its density [kg/m^3]
  double density_error = 0;     ///< mean of max(0, rho/rho0 - 1)
  double compression = 0;       ///< mean of its square
  double kinetic = 0, potential = 0;  ///< energies of a mean particle [J/kg]; potential of -g x
  double agitation = 0;               ///< root mean square of the velocity about its mean [m/s]
};

/// A function that takes such a look. It costs a few nanoseconds a particle and takes no memory.
///
/// A particle has left where it is further than a support radius beyond a side of the domain that
/// is not `open`, or as deep in a wall inside of it. Who left through an open side is on its own:
/// what is beyond the other sides there has not come through them.
std::function<Look(const ParticleView&)> look_at(const Scene& scene, const Derived& derived);

}  // namespace freshet
