// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/scene.h"

namespace freshet {

/// What an inlet comes to.
struct DerivedInlet {
  std::string name;
  double particles;  ///< of a layer
  double speed;      ///< [m/s]
  double rate;       ///< [m^3/s; m^2/s in 2D]
};

/// Numbers that follow from a scene. SI units.
struct Derived {
  double particles;       ///< at the start; a double, so that absurd scenes do not overflow
  double most_particles;  ///< that there may be: with what inlets bring, but no more than the
                          ///< domain holds
  std::vector<DerivedInlet> inlets;
  std::int64_t outside;         ///< particles that start outside the domain
  std::int64_t left_out;        ///< places of a fluid's lattice that a wall takes
  std::int64_t wall_particles;  ///< samples of all walls and bodies
  std::int64_t frames;          ///< pictures that a run writes, the result not counted
  std::int64_t data_frames;     ///< moments that a run writes data files of
  double data_bytes;            ///< of all its data files, about
  double support_radius, spacing;
  double rest_density;    ///< of the densest liquid
  double lightness;       ///< that over the rest density of the least dense, >= 1
  double viscosity;       ///< kinematic, of the liquid where it is greatest, times rest_density
  double mass;            ///< rest_density · spacing^D, or as given (scheme article)
  double lattice_sum;     ///< what density sums are divided by; 1 where the mass is given
  double density_error;   ///< of the density sum over the resting lattice, before that division
  double gradient_error;  ///< of the gradient (Spiky's, or the kernel's) of a linear field on the
                          ///< lattice
  double neighbors;       ///< in the resting lattice, the particle itself not counted
  /// Of the solvers that solve for the pressure there is neither: for scales, ten times the faster
  /// of a fall through the domain and of how the fluid starts, and its square.
  double stiffness, sound_speed;
  double acoustic_step;  ///< upper bound of the time step [s]: 0.4 h/c; infinity without sound
  double force_step;     ///< 0.25 √(h/|g|)
  double viscous_step;   ///< 0.125 h² ρ0/μ, all with h half the support [Monaghan 1992, 2005]
  double flow_step;  ///< 0.4 h/|v| at the start, where the pressure is solved for; else infinity
  double capillary_step;  ///< 0.25 √(ρ0 h³/2πσ); infinity without surface tension [Morris 2000]
  double density_tolerance;  ///< of the solve for the pressure, a fraction; 0 where there is none

  /// The least of the bounds, and its name.
  double step_bound() const;
  const char* step_bound_name() const;
};

/// Throws Error (kind scene) where check_scene would. Samples the fluid once.
Derived derive(const Scene& scene);

}  // namespace freshet
