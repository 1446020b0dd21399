// SPDX-License-Identifier: MIT
/// What the fluid does to its walls, in sums that depend on neither threads nor backends.
#pragma once
#include <vector>

#include "boundary/confinement.h"
#include "boundary/wall_sets.h"
#include "core/fluid_particles.h"
#include "core/over.h"
#include "freshet/scene.h"
#include "pairs/mueller2003_forces.h"
#include "pairs/reaction.h"
#include "sim/wall_patch.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The acceleration in a sum of a particle of density rho.
template <int D, class Sum> Vec<D> acceleration_of(const Sum& sum, Real) {
  return acceleration(sum);
}
template <int D> Vec<D> acceleration_of(const ForceDensities<D, Real>& sum, Real rho) {
  return (sum.pressure + sum.viscosity) / rho;
}

template <int D> class WallForces {
 public:
  /// m: the mass of a particle of the densest liquid [kg]; accelerations are as if of it.
  WallForces(std::size_t walls, double m) : m_(m), force_(walls, Vector(std::size_t(D), 0.0)) {}
  /// Of nothing but these patches.
  WallForces(std::vector<PatchOnWall<D>> patches, double m)
      : m_(m),
        patches_(std::move(patches)),
        on_patch_(patches_.size(), Vector(std::size_t(D), 0.0)) {}
  const std::vector<Vector>& list() const { return force_; }
  /// Along the axes of each patch, over its area; once.
  const std::vector<Vector>& tractions() {
    for (std::size_t p = 0; p < on_patch_.size(); ++p)
      for (double& a : on_patch_[p]) a /= patches_[p].area();
    return on_patch_;
  }

  /// On samples: the reaction of the term by which they act.
  template <class B, class Wall, class Fluid, class Term>
  void add(B& backend, Real h, const Wall& wall, const Fluid& f, const Term& term) {
    if (wall.n == 0) return;
    backend.list_neighbors("wall forces", h, wall, f);
    const auto force = wall.force;
    backend.sum_pairs("wall forces", wall, over(f, Reaction<D, Term>{term}), StoreForce<D>{force});
    const auto number = wall.wall;
    for (int w = 0; w < int(force_.size()); ++w)
      for (int d = 0; d < D; ++d)
        force_[std::size_t(w)][std::size_t(d)] += m_ * backend.sum("wall forces", wall, [=](int k) {
          Vec<D> f_k = force[k];
          return number[k] == w ? double(component(f_k, d)) : 0.0;
        });
    for (std::size_t p = 0; p < patches_.size(); ++p)
      for (int d = 0; d < D; ++d)
        on_patch_[p][std::size_t(d)] +=
            m_ * backend.sum("wall forces", wall,
                             ForceOnPatch<D>{patches_[p], patches_[p].axis[d], wall.x, force});
  }

  /// On ghost walls: against what their mirror images do. An image in a corner counts for the wall
  /// that is named first.
  template <class B, class Fluid, class Term>
  void add_ghosts(B& backend, const Fluid& f, const Term& term, const std::vector<int>& walls,
                  Field<Vec<D>> force) {
    for (std::size_t r = 0; r < walls.size(); ++r) {
      if (walls[r] < 0) continue;
      const auto rho = f.rho;
      backend.sum_pairs(
          "wall forces", f, over_copies(int(r), f, term),
          [=](int i, const auto& sum) { force[i] = acceleration_of<D>(sum, rho[i]); });
      for (int d = 0; d < D; ++d)
        force_[std::size_t(walls[r])][std::size_t(d)] -=
            m_ * backend.sum("wall forces", f, [=](int i) {
              Vec<D> f_i = force[i];
              return double(component(f_i, d));
            });
    }
  }

  /// On reflecting walls: against the velocities that they gave in this time.
  template <class B>
  void add_bounces(B& backend, const FluidParticles<D>& f, const Liquids& liquids,
                   const Confinement<D>& c, const std::vector<int>& shapes, double interval) {
    const int walls = c.walls();
    if (!c.bounced.data || !(interval > 0)) return;
    const auto bounced = c.bounced;
    const auto total = [&](int wall, int d) {
      return -m_ / interval * backend.sum("wall forces", f, [=](int i) {
        Vec<D, double> dv = bounced[i * walls + wall];
        return component(dv, d) / double(liquids.lightness(f, i));
      });
    };
    for (int d = 0; d < D; ++d) {
      force_[std::size_t(2 * d)][std::size_t(d)] += total(0, d);
      force_[std::size_t(2 * d + 1)][std::size_t(d)] += total(1, d);
      for (std::size_t s = 0; s < shapes.size(); ++s)
        force_[std::size_t(shapes[s])][std::size_t(d)] += total(2 + int(s), d);
    }
  }

 private:
  double m_;
  std::vector<Vector> force_;
  std::vector<PatchOnWall<D>> patches_;
  std::vector<Vector> on_patch_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
