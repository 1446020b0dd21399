// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/derived.h"
#include "freshet/real.h"

namespace freshet {

/// The lattice that a fluid starts on: `count` particles `spacing` apart, the first at `from`.
struct Lattice {
  Vector from;
  Counts count;
  double particles() const;  ///< as a double: absurd numbers do not overflow
  Vector last(double spacing) const;
};
Lattice lattice_of(const Scene::Fluid& fluid, double spacing);

/// Where the particles start, D numbers each; ids count from 0 in this order.
struct Sample {
  std::vector<Real> x, v;
  std::int64_t outside = 0;  ///< how many start outside the domain
};
Sample sample(const Scene& scene);

}  // namespace freshet
