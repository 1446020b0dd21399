// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "core/vec.h"
#include "freshet/scene.h"

namespace freshet {

using Point = Vec<3, double>;

inline Point point_of(const Vector& v) { return {v[0], v[1], v[2]}; }

/// The corners of a box.
struct Bounds {
  Point low, high;
};

/// The position and direction of the camera of a 3D scene at one time.
struct Pose {
  Point eye, target;
  double field_of_view;  ///< [degrees]
};

/// The pose at `time` [s]: that of a single camera, rotated by its orbit, or interpolated between
/// key frames. A camera without a position is placed in front, to the right and above, where it
/// sees the whole domain.
Pose pose_at(const Scene& scene, double time);
/// The pose of a camera that sees the box `seen` where pose_at sees the whole domain.
Pose pose_at(const Scene& scene, double time, const Bounds& seen);

/// The perspective projection of points to a picture, with y up.
class View {
 public:
  /// width, height: size of the picture [px].
  View(const Pose& pose, double width, double height);

  struct Seen {
    double x, y;  ///< [px], y down from the top
    double z;     ///< distance along the line of sight [m]; not visible if below `nearest`
  };
  Seen operator()(Point p) const {
    const Point q = p - eye;
    const double z = dot(q, forward), scale = focal / z;
    return {middle_x + dot(q, right) * scale, middle_y - dot(q, up) * scale, z};
  }
  /// The ray from the eye through a place in the picture [px]; its component along the line of
  /// sight is 1.
  Point ray(double x, double y) const {
    return forward + (x - middle_x) / focal * right - (y - middle_y) / focal * up;
  }

  Point eye, right, up, forward;  ///< unit vectors
  double focal;                   ///< pixels per metre at a distance of one metre
  double middle_x, middle_y;      ///< [px]
  double nearest;                 ///< minimum distance of visible points [m]
};

}  // namespace freshet
