// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "core/vec.h"
#include "freshet/scene.h"

namespace freshet {

/// Volume, centre of mass and inertia of a body at the start. In 2D the body is one metre deep, and
/// its centre is in the plane z = 0.
struct BodyShape {
  double volume = 0;          ///< [m³]; in 2D the area [m²]
  double mass = 0;            ///< of a free body [kg/m^(3-D)]
  Vec<3, double> middle{};    ///< of the shape: the centre of mass of an even density [m]
  Vec<3, double> center{};    ///< of mass [m]
  double inertia[3][3] = {};  ///< about the centre, per mean density [m⁵]; in 2D zz counts [m⁴]
  double extent = 0;          ///< of the shape: twice the distance of its farthest point [m]
  double reach = 0;           ///< at least the distance of the farthest point from the centre [m]

  double density() const { return mass / volume; }  ///< mean density [kg/m³]
};
/// Whether this build moves free bodies, which needs Bullet.
bool moves_free_bodies();

/// The body must be of a scene with its defaults filled in.
BodyShape body_shape(const Scene::Body& body);

/// Whether a free body can move along x, y and z, and turn about them.
std::array<bool, 6> freedoms_of(const Scene::Body& body, int dimension);

}  // namespace freshet
