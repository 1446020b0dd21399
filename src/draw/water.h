// SPDX-License-Identifier: MIT
#pragma once
#include "draw/painter.h"

namespace freshet::gl {

/// The liquid as a surface in the space of the screen: the distance of the nearest ball, smoothed,
/// gives normals; the balls' thickness gives absorption.
class Water {
 public:
  Water();

  /// The target that the surroundings are drawn into first.
  Target& behind() { return behind_; }
  struct Shape {
    view::Matrix view, projection;
    float radius;                   ///< of a ball [m]
    float chord;                    ///< thickness over the sum of the balls' chords
    float half_width, half_height;  ///< of what is seen at a distance of 1
    float length;                   ///< of the domain, on which the clearness depends [m]
    view::Slice slice;
    Point light, up;  ///< as the camera sees them
  };
  /// Draws the surface over a copy of behind() into a framebuffer.
  void draw(const Vertices& balls, const Shape& shape, const Painter::Region& region, int detail,
            GLuint into);

 private:
  void splat(const Program& program, const Vertices& balls, const Shape& shape, int height);
  void smooth(const Shape& shape);

  Program depth_, thickness_, smooth_, water_, copy_;
  Vertices screen_;
  Target behind_, near_, turned_, thick_;
};

}  // namespace freshet::gl
