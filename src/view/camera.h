// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "render/camera.h"

namespace freshet::view {

/// Column by column, as OpenGL reads it.
using Matrix = std::array<float, 16>;

/// A camera that a viewer moves: it orbits about its target in 3D. In 2D it looks along -z without
/// perspective.
class Camera {
 public:
  /// What a camera shows first, in a window of any shape.
  struct Start {
    bool flat = false;
    Point target{};
    double distance = 1, yaw = 0, pitch = 0, field_of_view = 35;
    double width = 1, height = 1;  ///< in 2D [m]; in 3D their ratio counts
  };
  Camera() = default;
  /// `aspect`: width over height of the window.
  Camera(const Start& start, double aspect);
  /// That of the scene's pictures at `time` [s], or one that shows the domain.
  static Camera of(const Scene& scene, double time, double aspect);

  bool flat() const { return flat_; }
  Point target{};
  double distance = 1;        ///< of the eye from the target [m]
  double yaw = 0, pitch = 0;  ///< of the eye seen from the target [rad]
  double field_of_view = 35;  ///< vertical [degrees]
  double height = 1;          ///< in 2D: of what the window shows [m]

  /// By parts of the window's height.
  void orbit(double right, double up);
  void pan(double right, double up);
  /// Below 1: nearer. The place (x, y) in the window stays where it is in 2D: -1 to 1 from its
  /// middle to its edges, y upwards.
  void zoom(double factor, double x, double y, double aspect);

  Point eye() const;
  Point forward() const;
  Point right() const;
  Point up() const;
  Matrix view() const;
  Matrix projection(double aspect) const;
  double nearest() const { return 0.01 * distance; }
  double farthest() const { return 100 * distance; }

  struct Ray {
    Point from, along;  ///< `along` has length 1
  };
  Ray ray(double x, double y, double aspect) const;
  /// Where the ray of a place meets the plane through `point` that faces the camera.
  Point on_plane(double x, double y, double aspect, Point point) const;
  /// The metres that the window's height shows at a point.
  double height_at(Point point) const;

 private:
  bool flat_ = false;
};

/// The camera of the scene's pictures at `time` [s].
Camera::Start start_of(const Scene& scene, double time);

}  // namespace freshet::view
