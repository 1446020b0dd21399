// SPDX-License-Identifier: MIT
/// Unified spray, foam and air bubbles for particle-based fluids [Ihmsen, Akinci, Akinci, Teschner
/// 2012]. It differs from the paper where the paper's numbers depend on the resolution or on the
/// time step; docs/whitewater.md lists the differences.
#pragma once
#include "boundary/confinement.h"
#include "boundary/wall_sets.h"
#include "core/fluid_particles.h"
#include "core/over.h"
#include "freshet/whitewater.h"
#include "pairs/ihmsen2012.h"
#include "pairs/wall_contacts.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// A range over which a potential grows from 0 to 1.
struct Limits {
  Real low, high;
  /// Phi of the paper's eq. 1.
  FRESHET_HD Real operator()(Real a) const {
    return min(max((a - low) / (high - low), Real(0)), Real(1));
  }
};

template <int D> struct Ihmsen2012Parameters {
  Real support, spacing;         ///< [m]
  Real neighbors_inside;         ///< of a resting lattice, the particle itself not counted
  Real trapped_air, wave_crest;  ///< births per spacing of path at full potential
  Limits trapped_limits;         ///< of the trapped air [m/s]
  Limits crest_limits;           ///< of the wave crest [1]
  Limits energy_limits;          ///< of the kinetic energy over the mass [m^2/s^2]
  Real buoyancy, rise_speed;     ///< k_b [1], of a bubble in still water [m/s]
  Vec<D> min, max;               ///< of the domain [m]
  unsigned closed;               ///< bit mask of the sides that keep whitewater inside
  /// Less than 6 of about 33 neighbours inside are spray, more than 20 a bubble [sec. 3.3].
  Real spray_below = Real(0.18f), bubble_above = Real(0.6f);

  FRESHET_HD WhitewaterKind kind(Real neighbors) const {
    const Real share = neighbors / neighbors_inside;
    return share < spray_below    ? WhitewaterKind::spray
           : share > bubble_above ? WhitewaterKind::bubble
                                  : WhitewaterKind::foam;
  }
};

template <int D> struct WhitewaterParticles : Particles<D> {
  Field<int> kind;       ///< kept: a WhitewaterKind
  Field<Real> age;       ///< kept: since birth [s]
  Field<Real> life;      ///< kept: what is left of a foam particle's life [s]
  Field<Vec<D>> around;  ///< scratch: the mean velocity of the fluid around it [m/s]
  Field<Real> near;      ///< scratch: the number of fluid particles around it
};

/// Scratch of the fluid: its outward normal at the surface, else 0; the births expected; and the
/// number of neighbours.
template <int D> struct WhitewaterSources {
  Field<Vec<D>> n;
  Field<Real> births, near;
};

/// n = -grad c/|grad c| of the colour field c where a neighbourhood is one-sided. A flat surface
/// has a gradient of 1.4 over the support radius; the disorder inside of a splash has less than
/// the limit of 0.5.
template <int D> struct SurfaceNormal {
  Field<Vec<D>> n;
  Real V, support;
  FRESHET_HD void operator()(int i, Vec<D> sum) const {
    const Vec<D> gradient = V * sum;
    const Real size = norm(gradient);
    n[i] = size * support > Real(0.5f) ? (-1 / size) * gradient : Vec<D>{};
  }
};

/// The births expected while a particle moves for dt  [eq. 9].
template <int D> struct ExpectBirths {
  Ihmsen2012Parameters<D> c;
  WhitewaterSources<D> of;
  Field<Vec<D>> v;
  Real dt;
  FRESHET_HD void operator()(int i, const Ihmsen2012Sums<D, Real>& sums) const {
    of.near[i] = sums.neighbors;
    of.births[i] = 0;
    if (!(sums.weight > 0)) return;
    const Real speed = norm(v[i]);
    const bool crest = dot(v[i], of.n[i]) >= Real(0.6f) * speed;  // eq. 7
    const Real made = c.trapped_air * c.trapped_limits(sums.trapped_air / sums.weight) +
                      (crest ? c.wave_crest * c.crest_limits(sums.wave_crest / sums.weight) : 0);
    of.births[i] = c.energy_limits(square(speed) / 2) * made * (speed * dt / c.spacing);
  }
};

template <int D> struct StoreFlow {
  WhitewaterParticles<D> set;
  FRESHET_HD void operator()(int i, const Ihmsen2012Flow<D, Real>& sums) const {
    set.near[i] = sums.neighbors;
    set.around[i] = sums.weight > 0 ? sums.v / sums.weight : Vec<D>{};
  }
};

/// The motion of spray (eq. 10), foam (eq. 12) and bubbles (eq. 11) over dt. A bubble is pulled
/// along in the time tau in which it reaches its rising speed k_b g tau; it is implicit in time, so
/// that the speed does not depend on dt.
template <int D> struct MoveWhitewater {
  Ihmsen2012Parameters<D> c;
  WhitewaterParticles<D> set;
  Confinement<D> confine;
  Vec<D> gravity;
  Real dt;
  FRESHET_HD void operator()(int i) const {
    const WhitewaterKind kind = c.kind(set.near[i]);
    set.kind[i] = int(kind);
    set.age[i] += dt;
    Vec<D>& v = set.v[i];
    if (kind == WhitewaterKind::spray) {
      v += dt * gravity;
    } else if (kind == WhitewaterKind::foam) {
      v = set.around[i];
      set.life[i] += -dt;
    } else {
      const Real pull = c.buoyancy * norm(gravity), s = pull > 0 ? dt * pull / c.rise_speed : 0;
      v = pull > 0 ? (v + (-dt * c.buoyancy) * gravity + s * set.around[i]) / (1 + s)
                   : set.around[i];
    }
    const Vec<D> from = set.x[i];
    set.x[i] += dt * v;
    FluidParticles<D> at{};
    at.x = set.x;
    confine(i, at, v, from);
  }
};

/// Puts a particle in front of boundary particles and takes its velocity into them.
template <int D> struct KeepOutOfWalls {
  WhitewaterParticles<D> set;
  Real spacing;
  FRESHET_HD void operator()(int i, const WallContact<D, Real>& sums) const {
    const Real depth = sums.weight - Real(0.5f), size = norm(sums.x);
    if (!(depth > 0) || !(size > 0)) return;
    const Vec<D> n = sums.x / size;
    set.x[i] += (min(depth, Real(0.5f)) * spacing) * n;
    const Real v_n = dot(set.v[i] - sums.u / sums.weight, n);
    if (v_n < 0) set.v[i] += (-v_n) * n;
  }
};

template <int D, class B, template <int> class Kernel> struct Ihmsen2012 {
  Ihmsen2012Parameters<D> c;
  Kernel<D> W;

  /// The births expected of each fluid particle in dt. Lists of the fluid's neighbours exist.
  void find_births(B& backend, const FluidParticles<D>& f, const Walls<D>& w,
                   const WhitewaterSources<D>& of, Real dt) const {
    Real V = c.spacing;
    for (int k = 1; k < D; ++k) V *= c.spacing;
    const Ihmsen2012Gradient gradient{W};
    backend.share("whitewater", f, f.v);
    backend.sum_pairs("whitewater: births", f, over(f, gradient), over(w.akinci2012, gradient),
                      over(w.adami2012, gradient), over(w.monaghan2009, gradient),
                      SurfaceNormal<D>{of.n, V, c.support});
    backend.share("whitewater", f, of.n);
    backend.sum_pairs("whitewater: births", f,
                      over(f, Ihmsen2012Potentials<D>{c.support, f.v, of.n}),
                      ExpectBirths<D>{c, of, f.v, dt});
  }

  /// Moves the particles over dt.
  void move(B& backend, WhitewaterParticles<D>& set, const FluidParticles<D>& f, const Walls<D>& w,
            Confinement<D> confine, Vec<D> gravity, Real dt) const {
    confine.bounced = {};
    confine.box.sides = c.closed;
    confine.box.restitution = 0;
    confine.box.onto_wall = false;
    set.moves = true;  // the first search sorts the set
    backend.list_neighbors("whitewater: search", c.support, set, f);
    set.moves = false;
    for (const Particles<D>* wall : {static_cast<const Particles<D>*>(&w.akinci2012),
                                     static_cast<const Particles<D>*>(&w.adami2012),
                                     static_cast<const Particles<D>*>(&w.monaghan2009)})
      backend.list_neighbors("whitewater: search", c.support, set, *wall);
    backend.sum_pairs("whitewater: motion", set, over(f, Ihmsen2012FlowAround{W, c.support, f.v}),
                      StoreFlow<D>{set});
    // In two halves: on its way of up to 0.7 spacings a particle would jump over a layer of
    // boundary particles, which reaches half a spacing to either side.
    for (int half = 0; half < 2; ++half) {
      backend.for_each("whitewater: motion", set,
                       MoveWhitewater<D>{c, set, confine, gravity, dt / 2});
      backend.sum_pairs("whitewater: motion", set,
                        over(w.akinci2012, WallContacts<D>{c.spacing, w.akinci2012.v}),
                        over(w.adami2012, WallContacts<D>{c.spacing, w.adami2012.u}),
                        over(w.monaghan2009, WallContacts<D>{c.spacing, w.monaghan2009.v}),
                        KeepOutOfWalls<D>{set, c.spacing});
    }
  }

  /// Whether a particle is at its end: its foam has dissolved, it has left through an open side, or
  /// it is lost.
  bool is_gone(const WhitewaterParticles<D>& set, int i) const {
    Vec<D> x = set.x[i], low = c.min, high = c.max;
    for (int k = 0; k < D; ++k)
      if (!(component(x, k) >= component(low, k) && component(x, k) <= component(high, k)))
        return true;
    return set.life[i] < 0;
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet
