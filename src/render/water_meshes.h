// SPDX-License-Identifier: MIT
/// The surfaces of the liquids in a picture.
#pragma once
#include <limits>
#include <vector>

#include "freshet/frame.h"
#include "freshet/surface.h"
#include "render/bands.h"
#include "render/camera.h"

namespace freshet {

/// The liquids at the samples of a band: the nearest face that looks at the eye, and the depth of
/// each liquid along the line of sight, within the domain and in front of the background.
struct WaterBand {
  WaterBand(const Band& band, std::size_t liquids)
      : enter(band.depth.size()),
        leave(enter.size()),
        inside(enter.size()),
        front(enter.size(), std::numeric_limits<float>::infinity()),
        normal(enter.size()),
        thickness(liquids, std::vector<float>(front.size())) {}

  std::vector<float> enter, leave;            ///< the domain along the line of sight [m]
  std::vector<std::int16_t> inside;           ///< liquids where the line enters the domain
  std::vector<float> front;                   ///< [m] along the line of sight
  std::vector<Vec<3, float>> normal;          ///< of the nearest face; not of unit length
  std::vector<std::vector<float>> thickness;  ///< of each liquid [m] along the line of sight
};

class WaterMeshes {
 public:
  /// `view` has samples as its unit of pictures. The liquids end flat at the floor and the closed
  /// walls: they are continued by their mirror images, then cut. Particles that are not finite or
  /// far outside the domain are skipped.
  WaterMeshes(const Scene& scene, const Frame& fluid, const View& view, int threads);

  std::size_t liquids() const { return liquids_.size(); }
  /// The liquids in band k, in front of `background`.
  WaterBand draw(const Band& background, int k) const;

 private:
  /// A mesh and its points in the picture.
  struct Liquid {
    SurfaceMesh mesh;
    std::vector<View::Seen> seen;
    Bands bands;
  };
  /// Sets where the lines of sight enter and leave the domain and meet the background.
  void begin(WaterBand& water, const Band& background) const;
  /// Makes the domain's faces those of the liquids that they cut.
  void close(WaterBand& water, const Band& background) const;
  bool is_visible(const Liquid& liquid, std::uint32_t triangle) const;
  void draw_triangle(WaterBand& water, const Band& background, std::size_t liquid,
                     std::uint32_t triangle) const;

  View view_;
  Point low_, high_;  // corners of the domain; infinite at the upper side and at open ones
  std::vector<Liquid> liquids_;
};

}  // namespace freshet
