// SPDX-License-Identifier: MIT
/// The link between Bodies and a solver: it places the body particles for a step, and applies the
/// forces of the fluid to the bodies after it.
#pragma once
#include <map>

#include "bodies/bodies.h"
#include "boundary/wall_sets.h"
#include "core/rotation.h"
#include "engine/plan.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The time within a step at which a solver evaluates its forces. Bodies are placed at their
/// positions at that time.
struct ForceMoment {
  double share;  ///< fraction of the step, 0 to 1
  bool mean;     ///< velocities change by the mean of the forces before and after the step
};

template <int D> class CarriedBodies {
 public:
  using Twist = typename RigidBodies<D>::Twist;

  CarriedBodies(const EnginePlan& p, Walls<D>& walls)
      : bodies_(*p.bodies), moment_(moment_of(p)), layered_(p.layered_bodies), origin_(p.origin) {
    const BodySample& sample = p.sample.bodies;
    for (std::size_t k = 0; k < sample.body.size(); ++k) {
      const auto b = std::size_t(sample.body[k]);
      Vec<3, double> x{sample.x[D * k], sample.x[D * k + 1], 0};
      if (D == 3) x.z = sample.x[D * k + 2];
      const auto center = bodies_.center(b);
      local_.push_back(x - Vec<3, double>{center[0], center[1], center[2]});
      rigid_.body_of.push_back(int(b));
    }
    rigid_.arm.resize(local_.size());
    rigid_.all.resize(bodies_.size());
    rigid_.m = Real(p.mass);
    rigid_.respond = bodies_.any_free();
    for (std::size_t k = 0; k < D; ++k)
      if (p.periodic[k]) {
        periodic_.push_back(int(k));
        low_.push_back(p.min[k]);
        length_.push_back(p.max[k] - low_.back());
      }
    walls.bodies = &rigid_;
    wall_set_ = layered_ ? walls.adami2012.set : walls.akinci2012.set;
    rigid_.first_id = (layered_ ? p.sample.adami2012 : p.sample.akinci2012).wall.size();
  }
  CarriedBodies(const CarriedBodies&) = delete;

  Bodies& bodies() { return bodies_; }
  const Bodies& bodies() const { return bodies_; }
  int samples() const { return int(local_.size()); }
  int body_of(int sample) const { return rigid_.body_of[std::size_t(sample)]; }
  /// The number of times that a body particle is in the set of walls: itself and its images.
  int places() const { return 1 << periodic_.size(); }

  /// psi [kg/m^(3-D)] of the particles of each body, without other bodies and walls [Akinci
  /// 2012, eqs. 4 and 5], times their volume factors.
  template <class Kernel>
  std::vector<Real> psi(const Kernel& W, Real support, Real rho0,
                        const std::vector<Real>& volume_factor) const {
    std::map<std::array<std::int64_t, 4>, std::vector<int>> cells;
    const auto cell = [&](int k, const int(&off)[3]) {
      const auto& x = local_[std::size_t(k)];
      const auto at = [&](double a, int d) {
        return std::int64_t(std::floor(a / double(support))) + off[d];
      };
      return std::array<std::int64_t, 4>{body_of(k), at(x.x, 0), at(x.y, 1), at(x.z, 2)};
    };
    for (int k = 0; k < samples(); ++k) cells[cell(k, {0, 0, 0})].push_back(k);
    std::vector<Real> all;
    for (int k = 0; k < samples(); ++k) {
      Real sum = 0;
      for (int c = 0; c < 27; ++c) {
        const auto near = cells.find(cell(k, {c % 3 - 1, c / 3 % 3 - 1, c / 9 - 1}));
        if (near == cells.end()) continue;
        for (const int j : near->second) {
          const auto x = local_[std::size_t(k)] - local_[std::size_t(j)];
          if (norm2(x) < square(double(support))) sum += W(Pair<D, Real>(flat(x)));
        }
      }
      all.push_back(rho0 / sum * volume_factor[std::size_t(k)]);
    }
    return all;
  }

  /// The body of a particle in the set of walls that has this id; -1 for periodic images and for
  /// particles of walls.
  int body_of_wall(std::uint64_t id) const {
    const std::uint64_t number = id - rigid_.first_id;
    return id < rigid_.first_id || number >= local_.size() ? -1 : body_of(int(number));
  }
  /// The set of walls that holds the body particles.
  int wall_set() const { return wall_set_; }

  /// Places the body particles for these states at `time`. Moved bodies accelerate as within `dt`.
  void show(Walls<D>& walls, const std::vector<BodyState>& states, double time, double dt) {
    bodies_.states() = states;
    for (std::size_t b = 0; b < states.size(); ++b) {
      SixNumbers& forces = bodies_.last_forces()[b];
      std::copy(states[b].force.begin(), states[b].force.end(), forces.begin());
      std::copy(states[b].torque.begin(), states[b].torque.end(), forces.begin() + 3);
    }
    begin(walls, time, dt);
  }

  /// Before a step of dt from `time` on: sets the bodies' motion and places their particles.
  void begin(Walls<D>& walls, double time, double dt) {
    const double ahead = moment_.share * dt;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const BodyState now = bodies_.at(b, time, ahead);
      auto& body = rigid_.all[b];
      body.motion = twist(now.velocity, now.angular_velocity);
      body.impulse = body.push = body.before = {};
      body.force = body.force_before = flat(bodies_.last_forces()[b]);
      const auto mobility = bodies_.mobility(b);
      for (int i = 0; i < freedoms; ++i)
        for (int j = 0; j < freedoms; ++j)
          body.mobility[i][j] = mobility[std::size_t(axis(i))][std::size_t(axis(j))];
      body.pull = body.answer(flat(bodies_.pull(b, time)));
      const BodyState start = bodies_.at(b, time, 0), end = bodies_.at(b, time, dt);
      body.acceleration = body.answer(body.force) + body.pull +
                          1 / dt *
                              (twist(end.velocity, end.angular_velocity) -
                               twist(start.velocity, start.angular_velocity));
      turn_.emplace_back(now.orientation);
      center_.push_back({now.position[0] - origin_[0], now.position[1] - origin_[1],
                         now.position[2] - origin_[2]});
    }
    place();
    if (layered_) put(walls.of_layered_bodies, walls.adami2012);
    else put(walls.of_bodies, walls.akinci2012);
    turn_.clear();
    center_.clear();
  }
  /// After a step of dt from `time` on: moves the bodies by the forces of the fluid.
  void end(double time, double dt, bool iterates) {
    std::vector<SixNumbers> forces(bodies_.size());
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const auto& body = rigid_.all[b];
      const Twist force = iterates       ? 1 / dt * body.impulse
                          : moment_.mean ? 0.5 * (body.force_before + body.force)
                                         : body.force;
      for (int i = 0; i < freedoms; ++i) {
        forces[b][std::size_t(axis(i))] = force[i];
        bodies_.last_forces()[b][std::size_t(axis(i))] = body.force[i];
      }
    }
    bodies_.step(time, dt, forces);
  }

 private:
  static ForceMoment moment_of(const EnginePlan& p) {
    if (p.incompressible) return {p.predicts_places ? 1.0 : 0.0, false};
    const bool leapfrog = p.integrator == Integrator::leapfrog;
    return {leapfrog ? 1 : p.integrator == Integrator::verlet ? 0.5 : 0, leapfrog};
  }
  static constexpr int freedoms = RigidBodies<D>::freedoms;
  /// The index in SixNumbers of the i-th component of a twist.
  static constexpr int axis(int i) { return D == 3 || i < 2 ? i : 5; }
  static Twist flat(const SixNumbers& six) {
    Twist t{};
    for (int i = 0; i < freedoms; ++i) t[i] = six[std::size_t(axis(i))];
    return t;
  }
  static Twist twist(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return flat({a[0], a[1], a[2], b[0], b[1], b[2]});
  }
  static Vec<D> flat(Vec<3, double> x) {
    if constexpr (D == 3) return {Real(x.x), Real(x.y), Real(x.z)};
    else return {Real(x.x), Real(x.y)};
  }

  void place() {
    const std::size_t n = local_.size();
    places_.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      const auto b = std::size_t(rigid_.body_of[k]);
      const auto arm = turn_[b](local_[k]);
      rigid_.arm[k] = flat(arm);
      places_[k] = center_[b] + arm;
      for (std::size_t p = 0; p < periodic_.size(); ++p) {
        double& x = component(places_[k], periodic_[p]);
        x -= length_[p] * std::floor((x - low_[p]) / length_[p]);
      }
    }
  }
  template <class Wall> void put(const Wall& samples, const Wall& wall) const {
    const std::size_t n = local_.size();
    for (int k = 0; k < samples.n; ++k) samples.x[k] = flat(places_[samples.id[k]]);
    for (int k = 0; k < wall.n; ++k) {
      if (wall.id[k] < rigid_.first_id) continue;
      const std::uint64_t number = wall.id[k] - rigid_.first_id;
      wall.x[k] = flat(image(places_[number % n], number / n));
    }
  }
  /// The image of x. Bit p of `images` shifts it by one period along the p-th periodic axis, away
  /// from the nearer end.
  Vec<3, double> image(Vec<3, double> x, std::uint64_t images) const {
    for (std::size_t p = 0; p < periodic_.size(); ++p) {
      double& a = component(x, periodic_[p]);
      if (images >> p & 1) a += a < low_[p] + length_[p] / 2 ? length_[p] : -length_[p];
    }
    return x;
  }

  Bodies& bodies_;
  ForceMoment moment_;
  bool layered_;
  int wall_set_ = 0;  // that the body particles are in
  Triple origin_;     // of the plan
  RigidBodies<D> rigid_;
  // local_: from the centre of mass at the start; places_: positions now; center_: of mass, now;
  // the last two are relative to the origin
  std::vector<Vec<3, double>> local_, places_, center_;
  std::vector<Rotation> turn_;
  std::vector<int> periodic_;
  std::vector<double> low_, length_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
