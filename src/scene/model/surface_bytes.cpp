// SPDX-License-Identifier: MIT
#include "scene/model/surface_bytes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace freshet {

#ifdef FRESHET_MESHOPTIMIZER
bool simplifies_surfaces() { return true; }
#else
bool simplifies_surfaces() { return false; }
#endif

double points_of_mesh(const std::vector<Real>& x, double spacing) {
  using Line = std::array<std::int32_t, 2>;
  std::vector<Line> lines(x.size() / 3);
  double count = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto cell = [&](std::size_t i, std::size_t d) {
      return std::int32_t(std::floor(double(x[3 * i + d]) / spacing));
    };
    for (std::size_t i = 0; i < lines.size(); ++i)
      lines[i] = {cell(i, (axis + 1) % 3), cell(i, (axis + 2) % 3)};
    std::sort(lines.begin(), lines.end());
    count += double(std::unique(lines.begin(), lines.end()) - lines.begin());
  }
  return 2 * count;
}

namespace {

/// The bytes of a *.vdb file: a layer of distances of four bytes around the surface, values of
/// eight bytes where a particle reaches, and upper nodes.
double vdb_bytes(const SurfaceSettings& s, double points, double particles) {
  const double area = points / 1.25;  // 1.5 points an area in all directions, 1 of a box [spacing²]
  const double reached = particles + 0.85 * s.radius * area;
  return (30.4 * area + 8.8 * reached / s.cell) / (s.cell * s.cell) + 60000;
}

}  // namespace

double surface_bytes(const SurfaceMeshFiles& files, double points, double particles) {
  // per point, with its two triangles
  constexpr double ply = 36 + 2 * 13, obj = 36 + 26 + 2 * 44, vtp = 36 + 2 * 32, glb = 36 + 2 * 12;
  const double cell = files.settings.cell;
  switch (files.format) {
    case SurfaceFormat::ply:
      return ply * points / (cell * cell) + 300;
    case SurfaceFormat::obj:
      return obj * points / (cell * cell) + 30;
    case SurfaceFormat::vtp:
      return vtp * points / (cell * cell) + 1200;
    case SurfaceFormat::glb:
      return glb * points / (cell * cell) + 900;
    case SurfaceFormat::vdb:
      return vdb_bytes(files.settings, points, particles);
  }
  return 0;
}

}  // namespace freshet
