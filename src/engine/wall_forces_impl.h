// SPDX-License-Identifier: MIT
/// The definitions of wall_forces.h, compiled once per backend and dimension.
#pragma once
#include "engine/wall_forces.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D, class B>
WallForces<D, B>::WallForces(B& backend, std::size_t walls, const GhostWalls<D>& ghosts, double m)
    : backend_(backend), m_(m), ghosts_(ghosts), force_(walls, Vector(std::size_t(D), 0.0)) {}

template <int D, class B>
WallForces<D, B>::WallForces(B& backend, std::vector<PatchOnWall<D>> patches, double m)
    : backend_(backend),
      m_(m),
      patches_(std::move(patches)),
      on_patch_(patches_.size(), Vector(std::size_t(D), 0.0)) {}

template <int D, class B>
WallForces<D, B>::WallForces(B& backend, double m) : backend_(backend), m_(m), by_particle_(true) {}

template <int D, class B> const std::vector<Vector>& WallForces<D, B>::tractions() {
  for (std::size_t p = 0; p < on_patch_.size(); ++p)
    for (double& a : on_patch_[p]) a /= patches_[p].area();
  return on_patch_;
}

template <int D, class B> void WallForces<D, B>::add_stored(const WallParticles<D>& wall) {
  const auto force = wall.force;
  const auto number = wall.wall;
  for (int w = 0; w < int(force_.size()); ++w)
    for (int d = 0; d < D; ++d)
      force_[std::size_t(w)][std::size_t(d)] += m_ * backend_.sum("wall forces", wall, [=](int k) {
        Vec<D> f_k = force[k];
        return number[k] == w ? double(component(f_k, d)) : 0.0;
      });
  for (std::size_t p = 0; p < patches_.size(); ++p)
    for (int d = 0; d < D; ++d)
      on_patch_[p][std::size_t(d)] +=
          m_ * backend_.sum("wall forces", wall,
                            ForceOnPatch<D>{patches_[p], patches_[p].axis[d], wall.x, force});
  if (!by_particle_) return;
  auto& on_particle = on_particle_[wall.set];
  on_particle.resize(std::size_t(wall.n));
  for (int k = 0; k < wall.n; ++k) on_particle[std::size_t(k)] += m_ * to_double<D>(force[k]);
}

template <int D, class B> void WallForces<D, B>::add_stored_ghost(const Particles<D>& f, int wall) {
  const auto a = ghosts_.acceleration;
  for (int d = 0; d < D; ++d)
    force_[std::size_t(wall)][std::size_t(d)] -= m_ * backend_.sum("wall forces", f, [=](int i) {
      Vec<D> a_i = a[i];
      return double(component(a_i, d));
    });
}

template <int D, class B>
void WallForces<D, B>::add_bounces(const FluidParticles<D>& f, const Confinement<D>& c,
                                   const std::vector<int>& shapes) {
  const int walls = c.walls();
  if (!c.bounced.data) return;
  const auto bounced = c.bounced;
  const auto total = [&](int wall, int d) {
    return -m_ * backend_.sum("wall forces", f, [=](int i) {
      Vec<D, double> dv = bounced[i * walls + wall];
      return component(dv, d);
    });
  };
  for (int d = 0; d < D; ++d) {
    force_[std::size_t(2 * d)][std::size_t(d)] += total(0, d);
    force_[std::size_t(2 * d + 1)][std::size_t(d)] += total(1, d);
    for (std::size_t s = 0; s < shapes.size(); ++s)
      force_[std::size_t(shapes[s])][std::size_t(d)] += total(2 + int(s), d);
  }
}

}  // namespace FRESHET_ISA
}  // namespace freshet
