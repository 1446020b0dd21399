// SPDX-License-Identifier: MIT
#pragma once
#include "core/vec.h"
#include "freshet/scene.h"

namespace freshet {

/// Volume, centre of mass and inertia of a body at the start. In 2D the body is one metre deep, and
/// its centre is in the plane z = 0.
struct BodyShape {
  double volume = 0;          ///< [m³]; in 2D the area [m²]
  Vec<3, double> center{};    ///< of mass [m]
  double inertia[3][3] = {};  ///< about the centre, per density [m⁵]; in 2D zz counts [m⁴]
  double reach = 0;           ///< from the centre to the farthest point [m]
};
/// Whether this build moves free bodies, which needs Bullet.
bool moves_free_bodies();

/// The body must be of a scene with its defaults filled in.
BodyShape body_shape(const Scene::Body& body);

}  // namespace freshet
