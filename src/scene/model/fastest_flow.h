// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "freshet/scene.h"

namespace freshet {

/// The maximum speed that a scene gives its fluid, and what gives it ("a fall through the domain
/// reaches").
struct FastestFlow {
  double speed = 0;  ///< [m/s]
  std::string cause;
};

/// The largest of: the speed of a fall sqrt(v^2 + 2 g H) from the highest place of a fluid or an
/// inlet to the end of the domain, with the velocity v at the start; the speeds of moved bodies and
/// of walls. Falls of free bodies start at the domain's upper end. The scene must have its defaults
/// filled in.
FastestFlow fastest_flow(const Scene& scene);

/// The speed of a fall from one end of the domain to the other [m/s].
double fall_through_domain(const Scene& scene);

}  // namespace freshet
