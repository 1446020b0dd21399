// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/scene.h"

namespace freshet {

/// The margin between the view's edge and the visible region in 2D [px].
inline constexpr int picture_margin = 5;

/// The default direction of the eye in 3D, from the front [rad].
inline constexpr double camera_from_right = 0.5, camera_from_above = 0.42;

/// The parts of a picture [px]. The view is centred in the room that the colour bar leaves.
struct PictureLayout {
  int width, height;  ///< of the whole picture
  struct View {
    int left, top, width, height;
  } view;         ///< shows the domain or picture.window, and in 3D what the camera sees
  int color_bar;  ///< width of the strip on the right; 0 without a colour bar

  double font_size() const;
};

/// The layout of a scene's pictures. Sizes that are not set follow the proportions of the domain.
/// If both are set, the view of a 2D scene has equal scales, unless picture.stretch is set.
PictureLayout picture_layout(const Scene& scene);

/// The corners of the region that a 2D picture shows [m]: picture.window or the domain.
struct PictureRegion {
  double min[2], max[2];
  double extent(int axis) const { return max[axis] - min[axis]; }
};
PictureRegion picture_region(const Scene& scene);

}  // namespace freshet
