// SPDX-License-Identifier: MIT
/// What a film shows: the box around the liquid, the bodies and the walls near them.
#pragma once
#include <array>

#include "freshet/frame.h"
#include "render/camera.h"

namespace freshet {

struct FilmView {
  Bounds seen{};                  ///< the cameras see it by default
  std::array<bool, 6> touched{};  ///< whether the liquid comes near x_min, x_max, y_min, ...
  double tank_top = 0;            ///< the sides of the domain are shown up to here [m]
  double shutter = 0;             ///< seconds of motion in a picture, by default
};

/// Collects what the frames of a film show.
class FilmViewer {
 public:
  /// Keeps a reference to the scene, which must be in 3D.
  explicit FilmViewer(const Scene& scene);
  /// The frames must be in the order of their times.
  void add(const Frame& frame);
  /// The gap to a frame that is not shown bounds the shutter, too.
  void add_time(double time);
  FilmView view() const;

 private:
  void add_bodies(const Frame& frame);
  void add_wall(const Bounds& wall, Bounds& seen) const;

  const Scene& scene_;
  Bounds liquid_, bodies_;
  std::vector<double> times_;
};

}  // namespace freshet
