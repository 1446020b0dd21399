// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "freshet/frame.h"
#include "scene/model/body_shape.h"

namespace freshet {

/// The load on a body without contacts [N, N m about its centre of mass].
struct Load {
  std::array<double, 3> force{}, torque{};
};

/// Contacts and hinges of rigid bodies, by Bullet. A step depends on the positions and velocities
/// of the bodies only; there is no other state.
class RigidWorld {
 public:
  /// `scene` must have its defaults filled in. It and the shapes must outlive this.
  RigidWorld(const Scene& scene, const std::vector<BodyShape>& shapes);
  ~RigidWorld();

  /// Moves the free bodies by dt [s]. The other bodies must have their positions before the step
  /// and their velocities over it.
  void step(std::vector<BodyState>& bodies, std::span<const Load> loads, double dt);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace freshet
