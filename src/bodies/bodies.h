// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "bodies/rigid_world.h"
#include "freshet/frame.h"
#include "scene/body_motion.h"
#include "scene/body_shape.h"
#include "scene/expressions.h"

namespace freshet {

/// A velocity and an angular velocity, or a force and a torque, about a centre of mass.
using SixNumbers = std::array<double, 6>;

/// The rigid bodies of a scene: where they are, and what moves them. Numbers in three dimensions.
class Bodies {
 public:
  /// Of a scene with its defaults filled in, which outlives this.
  explicit Bodies(const Scene& scene);

  std::size_t size() const { return states_.size(); }
  const BodyShape& shape(std::size_t k) const { return shapes_[k]; }
  bool any_free() const { return any_free_; }
  /// Memory that a restart writes to: the bodies, and what the fluid did to them when it was last
  /// asked.
  std::vector<BodyState>& states() { return states_; }
  const std::vector<BodyState>& states() const { return states_; }
  std::vector<SixNumbers>& last_forces() { return last_forces_; }

  /// A body `ahead` seconds after `time`: a moved one by its motion, a free one as it flies.
  BodyState at(std::size_t k, double time, double ahead) const;
  /// How a body's motion changes by an impulse [1/kg, 1/(kg m²)]: zeros if it is not free. One that
  /// hangs on the world turns about its hinge only.
  std::array<SixNumbers, 6> mobility(std::size_t k) const;
  /// Gravity and the scene's body force on a free body [N].
  Load pull(std::size_t k, double time) const;
  /// Moves all bodies from time to time + dt, with these forces of the fluid.
  void step(double time, double dt, std::span<const SixNumbers> forces);
  /// The greatest speed of any place of a body [m/s].
  double fastest(double time) const;

  /// For a step that may be taken back.
  void save() { saved_ = {states_, last_forces_}; }
  void restore() { std::tie(states_, last_forces_) = saved_; }

 private:
  double mass(std::size_t k) const;
  /// A moved body at that time, any other as it is.
  BodyState placed(std::size_t k, double time) const;

  const Scene& scene_;
  std::vector<BodyShape> shapes_;
  std::vector<std::optional<PrescribedMotion>> motions_;
  std::vector<BodyState> states_;
  std::vector<SixNumbers> last_forces_;
  std::pair<std::vector<BodyState>, std::vector<SixNumbers>> saved_;
  std::optional<RigidWorld> world_;
  mutable Expressions body_force_;
  bool any_free_ = false;
};

}  // namespace freshet
