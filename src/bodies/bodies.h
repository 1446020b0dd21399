// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "freshet/frame.h"

namespace freshet {

struct Scene;

/// A velocity and an angular velocity, or a force and a torque, about a centre of mass.
using SixNumbers = std::array<double, 6>;

/// The rigid bodies of a scene: where they are, and what moves them. Numbers in three dimensions.
class Bodies {
 public:
  /// Of a scene with its defaults filled in, which outlives this.
  explicit Bodies(const Scene& scene);
  Bodies(const Bodies&) = delete;
  ~Bodies();

  std::size_t size() const { return states_.size(); }
  /// The centre of mass at the start [m].
  std::array<double, 3> center(std::size_t k) const;
  /// Whether the fluid moves any of them.
  bool any_free() const;
  /// Memory that a restart writes to: the bodies, and the forces of the fluid when it was last
  /// asked.
  std::vector<BodyState>& states() { return states_; }
  const std::vector<BodyState>& states() const { return states_; }
  std::vector<SixNumbers>& last_forces() { return last_forces_; }

  /// A body `ahead` seconds after `time`: a moved one by its motion, a free one by its velocity.
  BodyState at(std::size_t k, double time, double ahead) const;
  /// The change of a body's motion by an impulse [1/kg, 1/(kg m²)]: zeros if it is not free. A body
  /// that hangs on the world turns about its hinge only.
  std::array<SixNumbers, 6> mobility(std::size_t k) const;
  /// Gravity and the scene's body force on a free body, zeros on others [N, N m].
  SixNumbers pull(std::size_t k, double time) const;
  /// Moves all bodies from time to time + dt, with these forces of the fluid.
  void step(double time, double dt, std::span<const SixNumbers> forces);
  /// The greatest speed of any point of a body [m/s].
  double fastest(double time) const;

  /// For a step that may be rolled back.
  void save();
  void restore();

 private:
  struct Impl;
  /// A moved body at that time, any other as it is.
  BodyState placed(std::size_t k, double time) const;

  std::vector<BodyState> states_, saved_states_;
  std::vector<SixNumbers> last_forces_, saved_forces_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace freshet
