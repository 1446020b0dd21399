// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "freshet/frame.h"

namespace freshet {

struct Scene;

/// A velocity and an angular velocity, or a force and a torque, about a centre of mass: three
/// linear components, then three angular ones.
using SixNumbers = std::array<double, 6>;

/// The rigid bodies of a scene: their states and their motion. Vectors are three-dimensional, also
/// in 2D scenes.
class Bodies {
 public:
  /// `scene` must have its defaults filled in and must outlive this.
  explicit Bodies(const Scene& scene);
  Bodies(const Bodies&) = delete;
  ~Bodies();

  std::size_t size() const { return states_.size(); }
  /// The initial centre of mass [m].
  std::array<double, 3> center(std::size_t k) const;
  /// Whether the fluid moves any of them.
  bool any_free() const;
  /// The state that a restart writes: the bodies, and the last evaluated forces of the fluid.
  std::vector<BodyState>& states() { return states_; }
  const std::vector<BodyState>& states() const { return states_; }
  std::vector<SixNumbers>& last_forces() { return last_forces_; }

  /// The state of a body `ahead` seconds after `time`: that of a moved body by its prescribed
  /// motion, that of a free body extrapolated by its velocity.
  BodyState at(std::size_t k, double time, double ahead) const;
  /// The inverse mass matrix: the change of a body's motion by an impulse [1/kg, 1/(kg m²);
  /// times m in 2D]; zero if the body is not free. One with a hinge to the world turns about it only.
  std::array<SixNumbers, 6> mobility(std::size_t k) const;
  /// A further load on a free body until the next call [N, N m; per m in 2D]. No part of the state.
  void push(std::size_t k, const SixNumbers& load) { pushes_[k] = load; }
  const std::vector<SixNumbers>& pushes() const { return pushes_; }
  /// Gravity, body force and push on a free body [N, N m; per m in 2D]; zeros for other bodies.
  SixNumbers pull(std::size_t k, double time) const;
  /// Moves all bodies from `time` to `time` + dt [s] by the fluid's forces [N, N m; per m in 2D].
  void step(double time, double dt, std::span<const SixNumbers> forces);
  /// The maximum speed of any point of a body [m/s], without free bodies that have left through an
  /// open side.
  double fastest(double time) const;

  /// Saves and restores the state, for a step that may be rolled back.
  void save();
  void restore();

 private:
  struct Impl;
  /// The state of a moved body at `time`; the present state of any other body.
  BodyState placed(std::size_t k, double time) const;

  std::vector<BodyState> states_, saved_states_;
  std::vector<SixNumbers> last_forces_, saved_forces_, pushes_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace freshet
