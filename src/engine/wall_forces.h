// SPDX-License-Identifier: MIT
/// The force of the fluid on its walls, in sums that depend neither on threads nor on backends.
#pragma once
#include <map>
#include <vector>

#include "boundary/confinement.h"
#include "boundary/wall_sets.h"
#include "core/fluid_particles.h"
#include "core/over.h"
#include "engine/wall_patch.h"
#include "pairs/mueller2003_forces.h"
#include "pairs/reaction.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The acceleration in the sum of a particle of density rho [m/s^2].
template <int D, class Sum> Vec<D> acceleration_of(const Sum& sum, Real) {
  return acceleration(sum);
}
template <int D> Vec<D> acceleration_of(const ForceDensities<D, Real>& sum, Real rho) {
  return (sum.pressure + sum.viscosity) / rho;
}

/// Walls of mirror images: the index of the wall by copy rule (-1: none), and memory for an
/// acceleration per fluid particle.
template <int D> struct GhostWalls {
  std::vector<int> wall_of_rule;
  Field<Vec<D>> acceleration;
};

/// Sums the reactions of the pair terms by which walls act on the fluid. The neighbours of wall
/// particles among the fluid must have been listed.
template <int D, class B> class WallForces {
 public:
  /// m: mass of a particle of the densest liquid [kg/m^(3-D)]; it makes accelerations forces.
  WallForces(B& backend, std::size_t walls, const GhostWalls<D>& ghosts, double m);
  /// Sums the forces on these patches only.
  WallForces(B& backend, std::vector<PatchOnWall<D>> patches, double m);
  /// Sums the forces on each boundary particle only.
  WallForces(B& backend, double m);

  /// One force per wall [N; N/m in 2D].
  const std::vector<Vector>& list() const { return force_; }
  /// The force on each patch along its axes over its area [Pa]. Call it once.
  const std::vector<Vector>& tractions();
  /// The force on each boundary particle of a set, in its order [N; N/m in 2D]; empty if no term
  /// acts on it.
  const std::vector<Vec<D, double>>& on_particles(const WallParticles<D>& wall) {
    return on_particle_[wall.set];
  }

  /// Adds the reaction of a pair term on boundary particles.
  template <class Wall, class Fluid, class Term>
  void add(const Wall& wall, const Fluid& f, const Term& term) {
    if (wall.n == 0) return;
    backend_.sum_pairs("wall forces", wall, over(f, Reaction<D, Term>{term}),
                       StoreForce<D>{wall.force});
    add_stored(wall);
  }
  /// Adds the reaction of a pair term on walls of mirror images. An image in a corner counts for
  /// the wall of the first rule that made it.
  template <class Fluid, class Term> void add_ghosts(const Fluid& f, const Term& term) {
    const auto a = ghosts_.acceleration;
    const auto rho = f.rho;
    for (std::size_t rule = 0; rule < ghosts_.wall_of_rule.size(); ++rule) {
      if (ghosts_.wall_of_rule[rule] < 0) continue;
      backend_.sum_pairs("wall forces", f, over_copies(int(rule), f, term),
                         [=](int i, const auto& sum) { a[i] = acceleration_of<D>(sum, rho[i]); });
      add_stored_ghost(f, ghosts_.wall_of_rule[rule]);
    }
  }
  /// The impulse on reflecting walls: against the changes of velocity that they made.
  void add_bounces(const FluidParticles<D>& f, const Confinement<D>& c,
                   const std::vector<int>& shapes);

 private:
  void add_stored(const WallParticles<D>& wall);
  void add_stored_ghost(const Particles<D>& f, int wall);

  B& backend_;
  double m_;
  GhostWalls<D> ghosts_;
  std::vector<Vector> force_;
  std::vector<PatchOnWall<D>> patches_;
  std::vector<Vector> on_patch_;
  bool by_particle_ = false;
  std::map<int, std::vector<Vec<D, double>>> on_particle_;  // by set
};

}  // namespace FRESHET_ISA
}  // namespace freshet
