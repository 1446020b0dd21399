// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "core/vec.h"
#include "freshet/scene.h"

namespace freshet {

using Point = Vec<3, double>;

inline Point point_of(const Vector& v) { return {v[0], v[1], v[2]}; }

/// Where the camera of a scene in 3D is at one time.
struct Pose {
  Point eye, target;
  double field_of_view;  ///< [degrees]
};

/// At `time` [s]: the one camera, turned as it orbits, or between its key frames. One without a
/// place stands in front, to the right and above, where all of the domain is seen.
Pose pose_at(const Scene& scene, double time);

/// Points of the world in a picture: a perspective with y up.
class View {
 public:
  /// A picture of this size [px].
  View(const Pose& pose, double width, double height);

  struct Seen {
    double x, y;  ///< [px], y down from the top
    double z;     ///< distance along the line of sight [m]; not in the picture if below `nearest`
  };
  Seen operator()(Point p) const {
    const Point q = p - eye;
    const double z = dot(q, forward), scale = focal / z;
    return {middle_x + dot(q, right) * scale, middle_y - dot(q, up) * scale, z};
  }
  /// From the eye through a place in the picture, 1 along the line of sight.
  Point ray(double x, double y) const {
    return forward + (x - middle_x) / focal * right - (y - middle_y) / focal * up;
  }

  Point eye, right, up, forward;  ///< unit vectors
  double focal;                   ///< pixels that a metre takes a metre away
  double middle_x, middle_y;      ///< [px]
  double nearest;                 ///< [m]
};

}  // namespace freshet
