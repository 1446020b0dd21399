// SPDX-License-Identifier: MIT
#include "render/water.h"

#include <algorithm>

#include "render/ball_layer.h"
#include "render/foam.h"
#include "render/share_out.h"
#include "render/stage.h"
#include "render/water_light.h"
#include "render/water_meshes.h"
#include "scene/model/picture_layout.h"

namespace freshet {
namespace {

constexpr StageStyle water_stage{.fluid_opacity = 0.03f, .tiles = true};
constexpr double film = 0.6;  // thickness from which a liquid reflects fully [particle spacings]

using Direction = Vec<3, float>;

Direction direction(Point p) { return {float(p.x), float(p.y), float(p.z)}; }
Light times(Light a, Light b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

Direction unit(Direction d) { return (1 / norm(d)) * d; }
Light brighter(Light a, Light b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

/// The length of a scene, on which the liquids' clearness depends [m].
double scale_of(const Scene& s) {
  const Point size = point_of(s.domain.max) - point_of(s.domain.min);
  return std::cbrt(size.x * size.y * size.z);
}

/// Everything but the liquids, in one band as high as the picture.
Band draw_background(const Scene& scene, const Frame& fluid, const View& view, Color ground,
                     int threads) {
  const int wide = int(2 * view.middle_x), high = int(2 * view.middle_y);
  Band whole(wide, 0, high, ground);
  const Stage stage(scene, fluid, view, ground, water_stage);
  const BallLayer walls(scene, fluid, nullptr, view);
  share_out(band_count(high), threads, [&](int k) {
    Band band = band_of(k, wide, high, ground);
    stage.draw(band);
    walls.draw(band, k);
    std::copy(band.depth.begin(), band.depth.end(), &whole.depth[whole.at(0, band.top)]);
    std::copy(band.what.begin(), band.what.end(), &whole.what[whole.at(0, band.top)]);
  });
  return whole;
}

/// Computes the light of samples that show liquids.
class WaterShader {
 public:
  WaterShader(const Scene& scene, const View& view, const Band& background)
      : view_(view), background_(background), film_(float(film * scene.particles.spacing)) {
    for (const Color c : liquid_colors(scene)) liquids_.emplace_back(c, scale_of(scene));
  }

  /// Sample k of the band is that at (x, y) of the picture.
  void paint(Band& band, const WaterBand& water, int x, int y) const {
    const std::size_t k = band.at(x, y);
    const Point ray = view_.ray(x + 0.5, y + 0.5);
    const float stretch = float(norm(ray));  // of lengths along the line of sight
    float total = 0;
    for (const auto& thickness : water.thickness) total += std::max(0.0f, stretch * thickness[k]);
    if (total <= 0) return;
    Light through{1, 1, 1}, scattered{0, 0, 0};
    for (std::size_t l = 0; l < liquids_.size(); ++l) {
      const float length = std::max(0.0f, stretch * water.thickness[l][k]);
      if (length == 0) continue;
      const auto passed = liquids_[l](length);
      scattered = scattered + (length / total) * passed.scattered;
      through = times(through, passed.through);
    }
    const float z = water.front[k];
    if (!std::isfinite(z)) {  // the eye is in the liquid
      const Light behind = light_of(Band::color(background_.what[background_.at(x, y)]));
      band.what[k] = Band::code(color_of(times(behind, through) + scattered));
      return;
    }
    const Direction eye_ray = (1 / stretch) * direction(ray);
    const Direction normal = unit(water.normal[k]);
    const float facing = std::max(0.0f, -dot(eye_ray, normal));
    const Direction mirrored = eye_ray + (2 * facing) * normal;
    const float whole = std::min(1.0f, total / film_), mirror = whole * fresnel(facing);
    const Direction bent = refracted(eye_ray, normal);
    const Light behind =
        refraction(view_.eye + double(z) * ray, bent, unit(2 * bent - eye_ray), total, x, y, z);
    const Light inside = times(behind, through) + scattered;
    band.what[k] = Band::code(color_of((1 - mirror) * inside + mirror * sky_light(mirrored)));
  }

 private:
  /// The background where the refracted ray leaves the liquid, as the eye sees this place. What is
  /// in front of the liquid there does not count. Where nothing is behind, the sky of the direction
  /// `beyond` is, unless the background is lighter.
  Light refraction(Point surface, Direction bent, Direction beyond, float length, int x, int y,
                   float z) const {
    const Point leaves =
        surface + double(length) * Point{double(bent.x), double(bent.y), double(bent.z)};
    const auto seen = view_(leaves);
    int px = x, py = y;
    if (seen.z > view_.nearest) {
      px = int(std::clamp(std::floor(seen.x), 0.0, double(background_.width - 1)));
      py = int(std::clamp(std::floor(seen.y), 0.0, double(background_.rows - 1)));
    }
    if (background_.depth[background_.at(px, py)] < z) px = x, py = y;
    const std::size_t k = background_.at(px, py);
    const Light behind = light_of(Band::color(background_.what[k]));
    return std::isfinite(background_.depth[k]) ? behind : brighter(behind, sky_light(beyond));
  }

  const View& view_;
  const Band& background_;
  float film_;  // [m]
  std::vector<Absorption> liquids_;
};

}  // namespace

Image draw_water(const Scene& scene, const Frame& fluid, int threads) {
  const Color ground = ground_color(scene);
  const PictureLayout layout = picture_layout(scene);
  Image image(layout.view.width, layout.view.height, ground);
  const int wide = oversampling * image.width, high = oversampling * image.height;
  const View view(pose_at(scene, fluid.time), wide, high);
  const Band background = draw_background(scene, fluid, view, ground, threads);
  const WaterMeshes meshes(scene, fluid, view, threads);
  const WaterShader shader(scene, view, background);
  const FoamLayer foam(fluid.whitewater, scene.particles.spacing, view);
  share_out(band_count(high), threads, [&](int k) {
    Band band = band_of(k, wide, high, ground);
    std::copy_n(&background.depth[background.at(0, band.top)], band.depth.size(),
                band.depth.begin());
    std::copy_n(&background.what[background.at(0, band.top)], band.what.size(), band.what.begin());
    const WaterBand water = meshes.draw(band, k);
    for (int y = band.top; y < band.top + band.rows; ++y)
      for (int x = 0; x < wide; ++x) shader.paint(band, water, x, y);
    foam.draw(band, water, k);
    resolve(band, image);
  });
  Image whole(layout.width, layout.height, ground);
  whole.paste(image, layout.view.left, layout.view.top);
  return whole;
}

}  // namespace freshet
