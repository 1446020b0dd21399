// SPDX-License-Identifier: MIT
#pragma once
#include "core/sample.h"
#include "freshet/derived.h"

namespace freshet {

/// The scene with its defaults in the place of empty vectors. Loading does it; a scene
/// made in code goes through here before anything looks at its vectors.
Scene with_defaults(Scene scene);

/// The lattice that a fluid starts on: `count` particles `spacing` apart, the first at `from`. Of a
/// box as the fluid fills it; of another shape the places of the box around it. Empty for points.
struct Lattice {
  Vector from;
  Counts count;
  double particles() const;  ///< as a double: absurd numbers do not overflow
  Vector last(double spacing) const;
};
Lattice lattice_of(const Scene& scene, const Scene::Fluid& fluid);

/// Where the kernels end: as given, or twice the spacing [m].
double support_radius(const Scene& scene);
/// k in p = k(rho - rho0) [m²/s²]; that of mueller2003, else the square of the speed of sound.
double stiffness(const Scene& scene);
double sound_speed(const Scene& scene);  ///< [m/s]
/// Of the solvers that solve for the pressure: as given, or what suits the solver.
double density_tolerance(const Scene& scene);  ///< of the mean of max(0, rho/rho0 - 1)

/// alpha of Monaghan's term: as given; else 0.05 where it is the only viscosity, or 0.
double artificial_viscosity(const Scene& scene);

/// How far from a resting fluid the samples of akinci2012 stand [m], so that it has its rest
/// density up to the wall: half a spacing of it is the fluid's.
double single_layer_distance(const Scene& scene);

/// What bodies are made of: adami2012 where walls.method is that, else akinci2012.
WallMethod body_method(const Scene& scene);

/// Where the particles start.
Sample sample(const Scene& scene);

/// At least as many samples as the walls of the scene get; costs nothing.
double most_wall_samples(const Scene& scene);
/// The same of its bodies, and their images beyond periodic ends.
double most_body_samples(const Scene& scene);

}  // namespace freshet
