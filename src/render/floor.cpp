// SPDX-License-Identifier: MIT
#include "render/floor.h"

#include <algorithm>

#include "render/triangle.h"
#include "scene/model/loaded_mesh.h"

namespace freshet {
namespace {

constexpr double finest = 1.0 / 400;  // side of a cell over the floor's longer side
constexpr int shadow_softness = 5;    // radius of the blur in cells; it is applied three times

}  // namespace

Bounds bounds_of(const Solid<3, double>& s) {
  Point half = s.half;
  if (s.kind == SolidKind::ball) half = {s.radius, s.radius, s.radius};
  if (s.kind == SolidKind::cylinder) {
    const auto reach = [&](double a) {
      return std::abs(a) * s.half_length + s.radius * std::sqrt(std::max(0.0, 1 - a * a));
    };
    half = {reach(s.axis.x), reach(s.axis.y), reach(s.axis.z)};
  }
  return {s.center - half, s.center + half};
}

FloorShadow::FloorShadow(const Scene& scene, const Frame& fluid,
                         const std::vector<Solid<3, double>>& solids,
                         const std::vector<TriangleMesh>& bodies, float fluid_opacity)
    : low_(point_of(scene.domain.min)), high_(point_of(scene.domain.max)) {
  const Point size = high_ - low_;
  side_ = finest * std::max(size.x, size.z);
  nx_ = int(std::ceil(size.x / side_));
  nz_ = int(std::ceil(size.z / side_));
  dark_.assign(std::size_t(nx_) * std::size_t(nz_), 0);
  add_fluid(scene, fluid);
  for (float& d : dark_) d = 1 - std::exp(-fluid_opacity * d);
  for (const auto& solid : solids)
    if (solid.kind != SolidKind::plane && !solid.fluid_inside) add_solid(solid);
  for (const Scene::Wall& wall : scene.wall)
    if (wall.loaded && wall.side == Side::outside) add_mesh(wall.loaded->distance.mesh());
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (scene.body[k].side == Side::outside) add_mesh(bodies[k]);
  for (int pass = 0; pass < 3; ++pass) blur(shadow_softness);
}

/// Adds the shadow of each ball, taken as a square, to the cells that it covers.
void FloorShadow::add_fluid(const Scene& scene, const Frame& fluid) {
  constexpr float of_square = 0.785f;  // area of a disc over that of its square
  const Point l = light_direction();
  const double half = scene.particles.spacing / (2 * side_);
  const auto overlap = [half](int k, double center) {
    return float(std::min(k + 1.0, center + half) - std::max(double(k), center - half));
  };
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const float* x = &fluid.x[3 * i];
    const double up = double(x[1]) - low_.y;
    const double u = (double(x[0]) - l.x / l.y * up - low_.x) / side_;
    const double v = (double(x[2]) - l.z / l.y * up - low_.z) / side_;
    if (!(u > -half && u < nx_ + half && v > -half && v < nz_ + half)) continue;
    const int right = std::min(nx_ - 1, int(u + half)), far = std::min(nz_ - 1, int(v + half));
    for (int q = int(std::max(0.0, v - half)); q <= far; ++q)
      for (int p = int(std::max(0.0, u - half)); p <= right; ++p)
        cell(p, q) += of_square * overlap(p, u) * overlap(q, v);
  }
}

/// Darkens the cells whose ray to the light meets the solid.
void FloorShadow::add_solid(const Solid<3, double>& solid) {
  const Point l = light_direction();
  const Bounds b = bounds_of(solid);
  const double top = std::min(b.high.y, high_.y) - low_.y;
  if (top <= 0) return;
  const auto cells = [&](double low, double high, double slope, double origin, int n) {
    const double shift = -slope * top;
    const double first = (low + std::min(0.0, shift) - origin) / side_;
    const double last = (high + std::max(0.0, shift) - origin) / side_;
    return std::pair{int(std::clamp(first - 1, 0.0, double(n))),
                     int(std::clamp(last + 2, 0.0, double(n)))};
  };
  const auto [i0, i1] = cells(b.low.x, b.high.x, l.x / l.y, low_.x, nx_);
  const auto [j0, j1] = cells(b.low.z, b.high.z, l.z / l.y, low_.z, nz_);
  for (int j = j0; j < j1; ++j)
    for (int i = i0; i < i1; ++i) {
      Point p{low_.x + (i + 0.5) * side_, low_.y, low_.z + (j + 0.5) * side_};
      while (p.y <= low_.y + top) {
        const double d = solid.distance(p);
        if (d < side_ / 4) {
          cell(i, j) = 1;
          break;
        }
        p += d * l;
      }
    }
}

/// Adds the shadow of each triangle.
void FloorShadow::add_mesh(const TriangleMesh& mesh) {
  const Point l = light_direction();
  const auto shadow = [&](Point p) {
    const double up = std::max(0.0, p.y - low_.y);
    return Vec<2, double>{(p.x - l.x / l.y * up - low_.x) / side_,
                          (p.z - l.z / l.y * up - low_.z) / side_};
  };
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto [a, b, c] = mesh.corners(int(k));
    for_each_cell({shadow(a), shadow(b), shadow(c)}, nx_, 0, nz_,
                  [this](int i, int j, Point) { cell(i, j) = 1; });
  }
}

/// Replaces each cell by the mean of 2·radius + 1 cells, along x, then along z.
void FloorShadow::blur(int radius) {
  const auto along = [&](int n, int lines, auto at) {
    std::vector<float> line(std::size_t(n) + std::size_t(2 * radius) + 1);
    for (int k = 0; k < lines; ++k) {
      std::fill(line.begin(), line.end(), 0.0f);
      for (int i = 0; i < n; ++i) line[std::size_t(i + radius)] = at(i, k);
      for (int i = 0; i < n; ++i) {
        float sum = 0;
        for (int j = 0; j <= 2 * radius; ++j) sum += line[std::size_t(i + j)];
        at(i, k) = sum / float(2 * radius + 1);
      }
    }
  };
  along(nx_, nz_, [&](int i, int k) -> float& { return cell(i, k); });
  along(nz_, nx_, [&](int i, int k) -> float& { return cell(k, i); });
}

float FloorShadow::operator()(double x, double z) const {
  const double u = std::clamp((x - low_.x) / side_ - 0.5, 0.0, double(nx_ - 1));
  const double v = std::clamp((z - low_.z) / side_ - 0.5, 0.0, double(nz_ - 1));
  const int i = std::min(int(u), std::max(0, nx_ - 2)), j = std::min(int(v), std::max(0, nz_ - 2));
  const float fu = float(u - i), fv = float(v - j);
  const auto value = [&](int a, int b) {
    return dark_[std::size_t(std::min(b, nz_ - 1)) * std::size_t(nx_) +
                 std::size_t(std::min(a, nx_ - 1))];
  };
  return (value(i, j) * (1 - fu) + value(i + 1, j) * fu) * (1 - fv) +
         (value(i, j + 1) * (1 - fu) + value(i + 1, j + 1) * fu) * fv;
}

}  // namespace freshet
