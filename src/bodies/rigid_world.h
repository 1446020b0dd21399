// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "freshet/frame.h"
#include "scene/model/body_shape.h"

namespace freshet {

/// What pulls at a body beside what it touches [N, N m about its centre of mass].
struct Load {
  std::array<double, 3> force{}, torque{};
};

/// Bodies that push each other and hang on hinges, by Bullet. Nothing is remembered from step to
/// step: the bodies' places and velocities are all that the next one follows from.
class RigidWorld {
 public:
  /// Of a scene with its defaults filled in; it and the shapes outlive this.
  RigidWorld(const Scene& scene, const std::vector<BodyShape>& shapes);
  ~RigidWorld();

  /// Moves the free bodies by dt. The others are where they were before the step, with the velocity
  /// that they have over it.
  void step(std::vector<BodyState>& bodies, std::span<const Load> loads, double dt);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace freshet
