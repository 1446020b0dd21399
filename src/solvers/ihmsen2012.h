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
#include "pairs/bender2019.h"
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
  Real support, spacing;  ///< [m]
  Real neighbors_inside;  ///< of a resting lattice, the particle itself not counted
  /// Births per spacing of path at full potential.
  Real trapped_air, wave_crest, turbulence;
  Limits trapped_limits;      ///< of the trapped air [m/s]
  Limits crest_limits;        ///< of the wave crest [1]
  Limits turbulence_limits;   ///< of the turbulence [m/s]
  Limits energy_limits;       ///< of the kinetic energy over the mass [m^2/s^2]
  Real buoyancy, rise_speed;  ///< k_b [1], of a bubble in still water [m/s]
  Vec<D> min, max;            ///< of the domain [m]
  unsigned closed;            ///< bit mask of the sides that keep whitewater inside
  /// Less than 6 of about 33 neighbours inside are spray, more than 20 a bubble [sec. 3.3].
  Real spray_below = Real(0.18f), bubble_above = Real(0.6f);
  /// More of the neighbours inside are around no particle of a surface.
  Real surface_below = Real(0.85f);

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

/// Scratch of the fluid.
template <int D> struct WhitewaterSources {
  Field<Vec<D>> n;     ///< the outward normal of a fast particle at the surface, else 0
  Field<Vec<D>> spin;  ///< angular velocity of the fluid around it [1/s]; without turbulence none
  Field<Real> births;  ///< expected, of fast particles; else 0
  Field<Real> near;    ///< number of neighbours of fast particles
};

/// The particles whose energy is high enough for births.
template <int D> struct IsFast {
  Field<Vec<D>> v;
  Real energy;  ///< over the mass [m^2/s^2]
  FRESHET_HD bool operator()(int i) const { return norm2(v[i]) > 2 * energy; }
};
/// Fast particles with too few neighbours to be inside.
template <int D> struct MayBeAtSurface {
  IsFast<D> fast;
  Field<Real> near;
  Real below;
  FRESHET_HD bool operator()(int i) const { return fast(i) && near[i] < below; }
};
/// Particles at the surface that move outwards  [eq. 7].
template <int D> struct MovesOutwards {
  Field<Vec<D>> v, n;
  FRESHET_HD bool operator()(int i) const {
    const Real along = dot(v[i], n[i]);
    return along > 0 && along >= Real(0.6f) * norm(v[i]);
  }
};

/// n = -grad c/|grad c| of the colour field c where a neighbourhood is one-sided. A flat surface
/// has a gradient of 1.4 over the support radius; the disorder inside of a splash has less than
/// the limit of 0.5.
template <int D> struct SurfaceNormal {
  MayBeAtSurface<D> at_surface;
  Field<Vec<D>> n;
  Real V, support;
  FRESHET_HD void operator()(int i, Vec<D> sum) const {
    n[i] = {};
    if (!at_surface(i)) return;
    const Vec<D> gradient = V * sum;
    const Real size = norm(gradient);
    if (size * support > Real(0.5f)) n[i] = (-1 / size) * gradient;
  }
};

/// The births expected while a particle moves for dt  [eq. 9], of the first potential.
template <int D> struct ExpectBirths {
  Ihmsen2012Parameters<D> c;
  WhitewaterSources<D> of;
  IsFast<D> fast;
  Real dt;
  FRESHET_HD void operator()(int i, const Ihmsen2012Sums<D, Real>& sums) const {
    of.births[i] = 0;
    of.near[i] = 0;
    if (!fast(i)) return;
    of.near[i] = sums.neighbors;
    of.births[i] = factor(i) * c.trapped_air * c.trapped_limits(sums.mean());
  }
  FRESHET_HD Real factor(int i) const {
    const Real speed = norm(fast.v[i]);
    return c.energy_limits(square(speed) / 2) * (speed * dt / c.spacing);
  }
};
/// Adds those of another potential.
template <int D, class Where> struct AddBirths {
  ExpectBirths<D> expect;
  Where where;
  Real most;
  Limits limits;
  FRESHET_HD void operator()(int i, const Ihmsen2012Mean<D, Real>& sums) const {
    if (where(i)) expect.of.births[i] += expect.factor(i) * most * limits(sums.mean());
  }
};
template <int D> struct StoreSpin {
  Field<Vec<D>> spin;
  FRESHET_HD void operator()(int i, const Bender2019Moments<D, Real>& sums) const {
    spin[i] = bender2019_spin<D>(sums);
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
    constexpr const char* line = "whitewater: births";
    const IsFast<D> fast{f.v, c.energy_limits.low};
    const ExpectBirths<D> expect{c, of, fast, dt};
    backend.share("whitewater", f, f.v);
    backend.sum_pairs(line, f, over(f, only_where(fast, Ihmsen2012TrappedAir<D>{c.support, f.v})),
                      expect);
    if (c.wave_crest > 0) add_crests(backend, f, w, of, expect);
    if (!(c.turbulence > 0)) return;
    backend.sum_pairs(line, f, over(f, Bender2019Spin<D>{c.support, f.v}), StoreSpin<D>{of.spin});
    backend.share("whitewater", f, of.spin);
    backend.sum_pairs(line, f,
                      over(f, only_where(fast, Bender2019Turbulence<D>{c.support, of.spin})),
                      AddBirths<D, IsFast<D>>{expect, fast, c.turbulence, c.turbulence_limits});
  }
  /// Those in the crests of waves.
  void add_crests(B& backend, const FluidParticles<D>& f, const Walls<D>& w,
                  const WhitewaterSources<D>& of, const ExpectBirths<D>& expect) const {
    constexpr const char* line = "whitewater: births";
    Real V = c.spacing;
    for (int k = 1; k < D; ++k) V *= c.spacing;
    const MayBeAtSurface<D> near{expect.fast, of.near, c.surface_below * c.neighbors_inside};
    const auto gradient = only_where(near, Ihmsen2012Gradient<D, Kernel>{W});
    backend.sum_pairs(line, f, over(f, gradient), over(w.akinci2012, gradient),
                      over(w.adami2012, gradient), over(w.monaghan2009, gradient),
                      SurfaceNormal<D>{near, of.n, V, c.support});
    backend.share("whitewater", f, of.n);
    const MovesOutwards<D> outwards{f.v, of.n};
    backend.sum_pairs(
        line, f, over(f, only_where(outwards, Ihmsen2012WaveCrest<D>{c.support, of.n})),
        AddBirths<D, MovesOutwards<D>>{expect, outwards, c.wave_crest, c.crest_limits});
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
