// SPDX-License-Identifier: MIT
/// The coupling of fluid and rigid bodies: versatile rigid-fluid coupling [Akinci, Ihmsen, Akinci,
/// Solenthaler, Teschner 2012], with the boundary particles of any wall method.
#pragma once
#include "boundary/wall_sets.h"
#include "pairs/density_rate.h"
#include "pairs/reaction.h"
#include "solvers/backend.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Adds a body's velocity at each body particle to a field, or overwrites the field with it.
template <int D> struct MoveSamples {
  using Twist = typename RigidBodies<D>::Twist;
  Field<std::uint64_t> id;
  Field<Vec<D>> field;
  const Twist* motion;
  const int* body_of;
  const Vec<D>* arm;
  std::uint64_t first, count;
  bool add;
  FRESHET_HD void operator()(int k) const {
    Vec<D> v{};
    if (id[k] >= first) {
      const std::uint64_t number = (id[k] - first) % count;
      v = velocity_at<D>(motion[body_of[number]], arm[number]);
    }
    field[k] = add ? field[k] + v : v;
  }
};

/// Sets velocity u and acceleration a of body particles of adami2012; those of walls are zero.
template <int D> struct ShowMotion {
  AdamiWall<D> samples;
  const typename RigidBodies<D>::Body* bodies;
  const int* body_of;
  const Vec<D>* arm;
  std::uint64_t first, count;
  FRESHET_HD void operator()(int k) const {
    Vec<D> u{}, a{};
    if (samples.id[k] >= first) {
      const std::uint64_t number = (samples.id[k] - first) % count;
      const auto& body = bodies[body_of[number]];
      u = velocity_at<D>(body.motion, arm[number]);
      a = acceleration_at<D>(body.acceleration, body.motion, arm[number]);
    }
    samples.u[k] = u;
    samples.a[k] = a;
  }
};

/// The force and torque of a body particle on its body [N, N m; per m in 2D].
template <int D> struct SampleWrench {
  struct Item {
    int group;
    typename RigidBodies<D>::Twist value;
  };
  Field<std::uint64_t> id;
  Field<Vec<D>> force;
  const int* body_of;
  const Vec<D>* arm;
  double m;
  FRESHET_HD Item operator()(int k) const {
    return {body_of[id[k]], m * wrench_of<D>(force[k], arm[id[k]])};
  }
};

template <int D> struct BodyCoupling {
  using Twist = typename RigidBodies<D>::Twist;
  using Body = typename RigidBodies<D>::Body;

  /// Sums the reaction of a pair term of body particles, as force and torque on each body, into
  /// `totals` [N, N m; per m in 2D].
  template <class B, class Fluid, class Term>
  static void sum_reactions(B& backend, const Walls<D>& w, const Fluid& f, const Term& term) {
    sum_reactions(backend, *w.bodies, w.of_bodies, f, term);
  }
  template <class B, class Fluid, class Term>
  static void sum_reactions(B& backend, RigidBodies<D>& bodies, const WallParticles<D>& samples,
                            const Fluid& f, const Term& term) {
    bodies.totals.resize(bodies.all.size());
    backend.sum_pairs("bodies", samples, over(f, Reaction<D, Term>{term}),
                      StoreForce<D>{samples.force});
    backend.sum_groups("bodies", samples, bodies.count(),
                       SampleWrench<D>{samples.id, samples.force, bodies.body_of.data(),
                                       bodies.arm.data(), double(bodies.m)},
                       bodies.totals.data());
  }

  /// Sets the velocities of body particles in both sets to those of the twist motion(body).
  template <class B, class Motion>
  static void set_velocities(B& backend, const Walls<D>& w, const Motion& motion) {
    move(backend, w, motion, false, [](const auto& set) { return set.v; });
  }
  /// Moves body particles in both sets by the displacement of the twist motion(body) [m, rad].
  template <class B, class Motion>
  static void displace(B& backend, const Walls<D>& w, const Motion& motion) {
    move(backend, w, motion, true, [](const auto& set) { return set.x; });
  }

  /// Computes the density rate by moving boundary particles, which is subtracted from density
  /// rates.
  template <class B, class Fluid, class Kernel>
  static void set_rate(B& backend, const Walls<D>& w, const Fluid& f, const Kernel& W) {
    const auto rate = w.rate;
    backend.sum_pairs("bodies: rate", f,
                      over(w.akinci2012, MovingDensityRate{W, w.akinci2012.psi, w.akinci2012.v}),
                      [=] FRESHET_LAMBDA(int i, Real sum) { rate[i] = sum; });
  }

  /// Sets velocity and acceleration of body particles of adami2012 in both sets.
  template <class B> static void show_motion(B& backend, const Walls<D>& w) {
    const RigidBodies<D>& bodies = *w.bodies;
    const auto visit = [&](const AdamiWall<D>& set, std::uint64_t first) {
      backend.for_each("bodies", set,
                       ShowMotion<D>{set, bodies.all.data(), bodies.body_of.data(),
                                     bodies.arm.data(), first, std::uint64_t(bodies.arm.size())});
    };
    visit(w.adami2012, bodies.first_id);
    visit(w.of_layered_bodies, 0);
  }

 private:
  template <class B, class Motion, class FieldOf>
  static void move(B& backend, const Walls<D>& w, const Motion& motion, bool add,
                   const FieldOf& field_of) {
    RigidBodies<D>& bodies = *w.bodies;
    bodies.totals.clear();
    for (const Body& body : bodies.all) bodies.totals.push_back(motion(body));
    const auto visit = [&](const auto& set, std::uint64_t first) {
      backend.for_each(
          "bodies", set,
          MoveSamples<D>{set.id, field_of(set), bodies.totals.data(), bodies.body_of.data(),
                         bodies.arm.data(), first, std::uint64_t(bodies.arm.size()), add});
    };
    visit(w.akinci2012, bodies.first_id);
    visit(w.of_bodies, 0);
  }
};

/// Evaluates the force on each body for a solver that computes its forces once a step. `term` is
/// for body particles of akinci2012, `layered_term` for those of adami2012.
template <int D, class B, class Fluid, class Term, class LayeredTerm>
void ask_bodies(B& backend, const Walls<D>& w, const Fluid& f, const Term& term,
                const LayeredTerm& layered_term) {
  if (!w.bodies) return;
  if (w.of_layered_bodies.n > 0)
    BodyCoupling<D>::sum_reactions(backend, *w.bodies, w.of_layered_bodies, f, layered_term);
  else BodyCoupling<D>::sum_reactions(backend, w, f, term);
  for (std::size_t b = 0; b < w.bodies->all.size(); ++b) {
    auto& body = w.bodies->all[b];
    body.force_before = body.force;
    body.force = w.bodies->totals[b];
  }
}

}  // namespace FRESHET_ISA
}  // namespace freshet
