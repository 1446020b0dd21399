// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <optional>

#include "freshet/scene.h"

namespace freshet {

/// Quantities that follow from an inlet's keys.
struct DerivedInlet {
  std::string name;
  double particles;  ///< per layer
  double speed;      ///< [m/s]
  double rate;       ///< [m^3/s; m^2/s in 2D]
};

/// The volume of a fluid at the start [m^D].
struct DerivedFluid {
  double filled;  ///< the number of particles times spacing^D
  /// The volume of the shape inside the domain, without walls and bodies; empty for points.
  std::optional<double> asked;

  /// filled over asked, less 1; 0 for points.
  double error() const { return asked && *asked > 0 ? filled / *asked - 1 : 0; }
};

/// Numbers that follow from a scene. SI units.
struct Derived {
  double particles;       ///< at the start; a double, so that huge scenes do not overflow
  double most_particles;  ///< estimated maximum with inlets; at most what the domain has room for
  std::vector<DerivedFluid> fluids;  ///< those of the scene, in its order
  std::vector<DerivedInlet> inlets;
  std::int64_t outside;                        ///< particles that start outside the domain
  std::int64_t left_out;                       ///< lattice sites of fluids that walls exclude
  std::int64_t wall_particles;                 ///< boundary particles and body particles
  std::int64_t frames;                         ///< pictures that a run writes, without result.png
  std::int64_t picture_width, picture_height;  ///< [px]
  std::int64_t data_frames;                    ///< frames that a run writes as data files
  double data_bytes;                           ///< approximate total size of the data files
  std::int64_t surface_frames;                 ///< frames of which a run writes meshes
  double surface_bytes;            ///< approximate size of these; all if they are as the first
  double support_radius, spacing;  ///< [m]
  double rest_density;             ///< of the densest liquid [kg/m^3]
  double lightness;                ///< maximum over minimum rest density of the liquids, >= 1
  double viscosity;       ///< maximum kinematic viscosity of the liquids times rest_density [Pa s]
  double mass;            ///< rest_density · spacing^D, or particles.mass [kg; kg/m in 2D]
  double lattice_sum;     ///< divisor of density sums; 1 where particles.mass is set
  double density_error;   ///< relative error of the undivided density sum over the resting lattice
  double gradient_error;  ///< relative error of the discrete gradient of a linear field on the
                          ///< lattice; Spiky for mueller2003, else the scene's kernel
  double neighbors;       ///< in the resting lattice, the particle itself not counted
  double fastest;  ///< maximum of the speeds at the start, of inlets, moved bodies and walls, and
                   ///< of a fall from the top of the fluid to the end of the domain [m/s]
  /// Stiffness [m²/s²] and speed of sound [m/s], stiffness = sound_speed². The pressure solvers
  /// have no sound. For them sound_speed is ten times `fastest`.
  double stiffness, sound_speed;
  /// Upper bounds of the time step [s], with h half the support radius [Monaghan 1992, 2005;
  /// Morris 2000].
  double acoustic_step;      ///< 0.4 h/c; infinity without sound
  double force_step;         ///< 0.25 √(h/|g|)
  double viscous_step;       ///< 0.125 h² ρ0/μ
  double flow_step;          ///< 0.4 h/max|v| at the start; infinity unless a pressure solver runs
  double capillary_step;     ///< 0.25 √(ρ0 h³/2πσ); infinity without surface tension
  double density_tolerance;  ///< of the pressure solve, a fraction; 0 without a pressure solve
  double divergence_tolerance;  ///< of the divergence solve, a fraction of a step

  /// The maximum number of whitewater particles of a scene that has [whitewater].
  double whitewater(const Scene& scene) const {
    return double(
        scene.whitewater->max_particles.value_or(std::int64_t(std::min(3 * most_particles, 1e9))));
  }
  /// The minimum of the time-step bounds [s], and its name.
  double step_bound() const;
  const char* step_bound_name() const;
};

/// Derives the numbers of a scene. Samples the fluid once. Throws Error (kind scene) for an invalid
/// scene.
Derived derive(const Scene& scene);

}  // namespace freshet
