// SPDX-License-Identifier: MIT
#pragma once
#include "core/vec.h"
#include "freshet/scene.h"

namespace freshet {

/// What a body of density 1 weighs, and how it is spread, where it stands at the start; of a scene
/// in 2D a metre of it, in the plane z = 0.
struct BodyShape {
  double volume = 0;          ///< [m³]; in 2D the area [m²]
  Vec<3, double> center{};    ///< of mass [m]
  double inertia[3][3] = {};  ///< about it, over the density [m⁵]; in 2D zz counts [m⁴]
  double reach = 0;           ///< from the centre to its farthest place [m]
};
/// Whether this build moves free bodies: it does where it found Bullet.
bool moves_free_bodies();

/// Of a scene with its defaults filled in.
BodyShape body_shape(const Scene::Body& body);

}  // namespace freshet
