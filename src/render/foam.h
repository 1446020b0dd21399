// SPDX-License-Identifier: MIT
/// Spray and foam over clear liquids.
#pragma once
#include <vector>

#include "freshet/frame.h"
#include "render/bands.h"
#include "render/camera.h"
#include "render/water_meshes.h"

namespace freshet {

inline constexpr double foam_radius = 0.2;  ///< of a whitewater particle, in particle spacings
inline constexpr Color foam_color{236, 243, 247};

/// The visible spray and foam of a picture. Each particle is a soft disc that covers what is behind
/// it in part; many of them are white.
class FoamLayer {
 public:
  /// `view` has samples as its unit of pictures.
  FoamLayer(const WhitewaterFrame& whitewater, double spacing, const View& view);

  /// Draws over band k, in which the liquids have been painted.
  void draw(Band& band, const WaterBand& water, int k) const;

 private:
  std::vector<Ball> all_;
  float sinks_;  // how far below a liquid's surface foam is still drawn [m]
  Bands bands_;
};

}  // namespace freshet
