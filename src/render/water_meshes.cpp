// SPDX-License-Identifier: MIT
#include "render/water_meshes.h"

#include <algorithm>

#include "render/box_span.h"
#include "render/fixed_triangle.h"
#include "surface/liquid_part.h"

namespace freshet {
namespace {

constexpr int lid = 3;               // the upper side: drops that touch it stay round
constexpr double infinite = 1e30;    // [m]
constexpr double image_reach = 3.5;  // of mirror images, in particle spacings
constexpr SurfaceSettings rounded{
    .cell = 0.5, .radius = 2.5, .level = 0.55, .smooth = 20, .volume = SurfaceVolume::level};

/// The particles of a frame within the domain, enlarged by its size on each side.
Frame near_part(const Scene& scene, const Frame& frame) {
  const Point low = point_of(scene.domain.min), high = point_of(scene.domain.max),
              size = high - low;
  const auto near = [](double x, double a, double b, double margin) {
    return x > a - margin && x < b + margin;  // false for NaN
  };
  Frame part;
  part.dimension = 3;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const float* x = &frame.x[3 * i];
    if (!near(double(x[0]), low.x, high.x, size.x) || !near(double(x[1]), low.y, high.y, size.y) ||
        !near(double(x[2]), low.z, high.z, size.z))
      continue;
    part.id.push_back(frame.id[i]);
    part.x.insert(part.x.end(), x, x + 3);
    part.v.insert(part.v.end(), &frame.v[3 * i], &frame.v[3 * i] + 3);
    if (!frame.liquid.empty()) part.liquid.push_back(frame.liquid[i]);
  }
  return part;
}

/// Adds the mirror images behind a side of the domain of the particles near it.
void add_images(Frame& frame, std::size_t axis, double side, double reach) {
  const std::size_t n = frame.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (std::abs(double(frame.x[3 * i + axis]) - side) > reach) continue;
    for (std::size_t d = 0; d < 3; ++d) {
      const float x = frame.x[3 * i + d];
      frame.x.push_back(d == axis ? float(2 * side - double(x)) : x);
      frame.v.push_back(0);
    }
    frame.id.push_back(frame.id[i]);
    if (!frame.liquid.empty()) frame.liquid.push_back(frame.liquid[i]);
  }
}

FixedPoint fixed(const View::Seen& s) {
  const auto round = [](double v) { return std::int64_t(std::floor(v * FixedPoint::one + 0.5)); };
  return {round(s.x), round(s.y)};
}

Vec<3, float> vector_of(const SurfaceMesh::Point& p) { return {p[0], p[1], p[2]}; }

}  // namespace

WaterMeshes::WaterMeshes(const Scene& scene, const Frame& fluid, const View& view, int threads)
    : view_(view),
      low_(point_of(scene.domain.min)),
      high_(point_of(scene.domain.max)),
      liquids_(scene.liquids().size()) {
  Frame near = near_part(scene, fluid);
  const Point low = low_;
  for (int side = 0; side < 6; ++side) {
    double& place = component(side % 2 == 0 ? low_ : high_, side / 2);
    if (side == lid || scene.is_open(side)) place = side % 2 == 0 ? -infinite : infinite;
    else add_images(near, std::size_t(side / 2), place, image_reach * scene.particles.spacing);
  }
  const int rows = int(2 * view.middle_y);
  for (std::size_t k = 0; k < liquids_.size(); ++k) {
    Liquid& liquid = liquids_[k];
    liquid.mesh = surface_of(liquid_part(near, int(k)), scene.particles.spacing,
                             {low.x, low.y, low.z}, rounded, std::max(1, threads));
    liquid.seen.reserve(liquid.mesh.position.size());
    for (const auto& p : liquid.mesh.position)
      liquid.seen.push_back(view({double(p[0]), double(p[1]), double(p[2])}));
    liquid.bands = Bands(liquid.mesh.triangles.size(), rows, [&](std::uint32_t t) {
      if (!is_visible(liquid, t)) return std::pair{0, -1};
      const auto& c = liquid.mesh.triangles[t];
      const auto [top, bottom] =
          std::minmax({liquid.seen[c[0]].y, liquid.seen[c[1]].y, liquid.seen[c[2]].y});
      return std::pair{int(std::floor(top)), int(std::floor(bottom)) + 1};
    });
  }
}

/// Faces that are nearer than the nearest visible distance are not drawn: the eye is in the liquid.
bool WaterMeshes::is_visible(const Liquid& liquid, std::uint32_t triangle) const {
  const auto& corners = liquid.mesh.triangles[triangle];
  return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t c) {
    const View::Seen& s = liquid.seen[c];
    return s.z > view_.nearest && std::abs(s.x) < FixedPoint::farthest &&
           std::abs(s.y) < FixedPoint::farthest;
  });
}

WaterBand WaterMeshes::draw(const Band& background, int k) const {
  WaterBand water(background, liquids_.size());
  begin(water, background);
  for (std::size_t l = 0; l < liquids_.size(); ++l)
    liquids_[l].bands.each_in(
        k, [&](std::uint32_t triangle) { draw_triangle(water, background, l, triangle); });
  close(water, background);
  return water;
}

void WaterMeshes::begin(WaterBand& water, const Band& background) const {
  for (int y = background.top; y < background.top + background.rows; ++y)
    for (int x = 0; x < background.width; ++x) {
      const std::size_t k = background.at(x, y);
      const auto span =
          box_span(low_, high_, view_.eye, view_.ray(x + 0.5, y + 0.5), view_.nearest);
      water.enter[k] = span ? float(span->enter) : 0;
      water.leave[k] =
          span ? std::max(water.enter[k], std::min(float(span->leave), background.depth[k])) : 0;
    }
}

void WaterMeshes::close(WaterBand& water, const Band& background) const {
  for (int y = background.top; y < background.top + background.rows; ++y)
    for (int x = 0; x < background.width; ++x) {
      const std::size_t k = background.at(x, y);
      if (water.inside[k] <= 0 || water.enter[k] >= water.leave[k]) continue;
      const auto span =
          box_span(low_, high_, view_.eye, view_.ray(x + 0.5, y + 0.5), view_.nearest);
      const Point n = span->face;
      if (norm2(n) == 0) continue;  // the eye is in the liquid
      water.front[k] = water.enter[k];
      water.normal[k] = {float(n.x), float(n.y), float(n.z)};
    }
}

/// Adds the depth of a back face and subtracts that of a front face: the sum over a closed mesh is
/// the thickness. Depths are limited to the domain in front of the background.
void WaterMeshes::draw_triangle(WaterBand& water, const Band& background, std::size_t liquid,
                                std::uint32_t triangle) const {
  const Liquid& l = liquids_[liquid];
  const auto& c = l.mesh.triangles[triangle];
  const FixedTriangle shape({fixed(l.seen[c[0]]), fixed(l.seen[c[1]]), fixed(l.seen[c[2]])});
  const bool front = shape.area() < 0;  // counterclockwise where y points up
  const Point inverse{1 / l.seen[c[0]].z, 1 / l.seen[c[1]].z, 1 / l.seen[c[2]].z};
  std::vector<float>& thickness = water.thickness[liquid];
  shape.each_sample(background.width, background.top, background.top + background.rows,
                    [&](int x, int y, Point shares) {
                      const std::size_t k = background.at(x, y);
                      const float z = float(1 / dot(shares, inverse)),
                                  reached = std::clamp(z, water.enter[k], water.leave[k]);
                      thickness[k] += front ? -reached : reached;
                      if (z <= water.enter[k])
                        water.inside[k] = std::int16_t(water.inside[k] + (front ? 1 : -1));
                      else if (front && z < water.front[k] && z < water.leave[k]) {
                        water.front[k] = z;
                        water.normal[k] =
                            float(shares.x * inverse.x) * vector_of(l.mesh.normal[c[0]]) +
                            float(shares.y * inverse.y) * vector_of(l.mesh.normal[c[1]]) +
                            float(shares.z * inverse.z) * vector_of(l.mesh.normal[c[2]]);
                      }
                    });
}

}  // namespace freshet
