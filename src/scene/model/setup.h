// SPDX-License-Identifier: MIT
#pragma once
#include "core/inlet_plan.h"
#include "core/sample.h"
#include "freshet/derived.h"

namespace freshet {

/// The scene with defaults in place of empty vectors. Loading a scene calls this. A scene made in
/// code must pass through here before its vectors are read.
Scene with_defaults(Scene scene);

/// Whether a scene has fluid at the start or from an inlet. Others have bodies alone.
inline bool has_fluid(const Scene& s) { return !s.fluid.empty() || !s.inlet.empty(); }

/// The lattice that a fluid starts on: `count` particles `spacing` apart, the first at `from`.
/// Other shapes than a box or a lattice have the lattice of the box around them. Empty for points.
struct Lattice {
  Vector from;
  Counts count;
  double particles() const;  ///< as a double, which huge counts do not overflow
  Vector last(double spacing) const;
};
Lattice lattice_of(const Scene& scene, const Scene::Fluid& fluid);

/// The radius at which the kernels end: as set, or twice the spacing [m].
double support_radius(const Scene& scene);
/// k in p = k(rho - rho0) [m²/s²] of mueller2003; else the square of the speed of sound.
double stiffness(const Scene& scene);
double sound_speed(const Scene& scene);  ///< [m/s]
/// The time-step limits that follow from the scene alone, without sampling: those of a fluid at
/// rest. The scene must have its defaults filled in.
TimeStepBounds bounds_at_rest(const Scene& scene);
/// Whether pressures keep the velocity divergence-free and remove errors of the density in many
/// steps (solver.density_correction).
bool corrects_gradually(const Scene& scene);
/// The tolerances of the pressure solvers: as set, or the default of the solver.
double divergence_tolerance(const Scene& scene);  ///< of the mean of dt |Drho/Dt|/rho0 in a step
double density_tolerance(const Scene& scene);     ///< of the mean of max(0, rho/rho0 - 1)

/// Whether a solver advances the density in time, so that its initial value matters.
bool evolves_density(const Scene& scene);
/// Whether the initial pressure of a fluid matters beside the positions of its particles.
bool keeps_start_pressure(const Scene& scene);

/// alpha of Monaghan's artificial viscosity: as set, else 0.05 if it is the only viscosity, else 0.
double artificial_viscosity(const Scene& scene);

/// The distance between the particles of a resting fluid and the boundary particles of akinci2012
/// [m]. At this distance the fluid has its rest density up to the wall. Half a spacing of it
/// belongs to the fluid.
double single_layer_distance(const Scene& scene);

/// The volumes of boundary particles of akinci2012 over 1/sum_l W_kl, at a distance [m] from the
/// outermost particles of a resting fluid that gives these their rest density. It is below 1 where
/// the layer is closer than single_layer_distance().
double single_layer_volume(const Scene& scene, double distance);

/// The method of body particles: adami2012 if that is walls.method or its default, else akinci2012.
WallMethod body_method(const Scene& scene);

/// The point from which an engine measures positions [m]. It is 0 along an axis where the domain is
/// no farther from 0 than its largest extent: there it would gain one bit at most. Elsewhere it is
/// the domain's lower end, so that a scene flows alike at any distance from 0.
Triple origin_of(const Scene& scene);
/// The largest coordinate in the domain, measured from origin_of() [m].
double farthest_position(const Scene& scene);
/// The distance between neighbouring numbers there [m].
double rounding_of_positions(const Scene& scene);

/// The particles at the start. Writes the number of particles of each fluid to `of_fluids`.
Sample sample(const Scene& scene, Counts* of_fluids = nullptr);

/// An upper bound on the number of boundary particles of the walls, without sampling them.
double most_wall_samples(const Scene& scene);
/// An upper bound on the number of body particles and their images beyond periodic ends.
double most_body_samples(const Scene& scene);

}  // namespace freshet
