// SPDX-License-Identifier: MIT
#include "freshet/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "freshet/simulation.h"
#include "surface/anisotropy.h"
#include "surface/fluid_grids.h"
#include "surface/kernel_rows.h"
#include "surface/pieces.h"
#include "surface/point_values.h"
#include "surface/simplify.h"
#include "surface/smoothing.h"

namespace freshet {
namespace {

using Point = GridMesh::Point;

constexpr double farthest_fit = 0.1;  // [spacings]; errors of density and level are smaller

[[noreturn]] void fail(const std::string& message, std::vector<std::string> options = {}) {
  throw Error(Error::Kind::scene, "", message, std::move(options));
}

/// Checks the ranges of settings.
struct RangeCheck {
  void number(const char* name, double value, double low, double high, const char*) {
    if (!(value >= low && value <= high))  // true for NaN as well
      throw Error(Error::Kind::scene, fmt::format("option {} {}", name, value),
                  fmt::format("it must be from {:g} to {:g}", low, high));
  }
  void count(const char* name, int value, int low, int high, const char* text) {
    number(name, value, low, high, text);
  }
  template <class E, class Names> void choice(const char*, E, const Names&, const char*) {}
};

/// A frame's place in space and the size of its grid.
struct Grid {
  std::array<double, 3> origin;  ///< [m]
  double cell;                   ///< [m]
  Point to_cells(const float* x) const {
    return {(double(x[0]) - origin[0]) / cell, (double(x[1]) - origin[1]) / cell,
            (double(x[2]) - origin[2]) / cell};
  }
  SurfaceMesh::Point to_meters(Point p) const {
    return {float(origin[0] + cell * p.x), float(origin[1] + cell * p.y),
            float(origin[2] + cell * p.z)};
  }
};

std::vector<Point> positions_of(const Frame& frame, const Grid& grid) {
  std::vector<Point> positions;
  positions.reserve(frame.size());
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Point x = grid.to_cells(&frame.x[3 * i]);
    constexpr double farthest = double(bin_cells) * farthest_place;
    const bool near = std::abs(x.x) < farthest && std::abs(x.y) < farthest &&
                      std::abs(x.z) < farthest;  // false for NaN as well
    if (!near)
      fail(fmt::format("particle {} is at ({:g}, {:g}, {:g}) m; positions must be finite, and at "
                       "most {:g} grid cells of {:g} m away from the domain's corner; run the "
                       "scene again, or use a larger `cell`",
                       frame.id[i], frame.x[3 * i], frame.x[3 * i + 1], frame.x[3 * i + 2],
                       farthest, grid.cell),
           {"cell"});
    positions.push_back(x);
  }
  return positions;
}

/// Particles and their kernels.
struct Particles {
  ParticleBins bins;
  Kernels kernels;
};

Particles particles_of(std::vector<Point> positions, const SurfaceSettings& s,
                       const Threads& threads) {
  const float radius = float(s.radius / s.cell), spacing = float(1 / s.cell);
  const FilmModel films(radius, spacing);
  if (s.kernels == SurfaceKernels::isotropic) {
    ParticleBins bins(positions, radius);
    Kernels kernels = kernels_of(bins, radius, {}, films, threads);
    return {std::move(bins), std::move(kernels)};
  }
  const Anisotropy anisotropy =
      anisotropy_of(ParticleBins(positions, shape_reach * radius), radius, spacing, threads);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec<3, float> shift = anisotropy.shift[i];
    positions[i] += Point{double(shift.x), double(shift.y), double(shift.z)};
  }
  ParticleBins bins(positions, longest_stretch * radius);
  std::vector<KernelShape> shapes;
  for (int k = 0; k < int(bins.size()); ++k)
    shapes.push_back(anisotropy.shape[std::size_t(bins.frame_index(k))]);
  Kernels kernels = kernels_of(bins, radius, std::move(shapes), films, threads);
  return {std::move(bins), std::move(kernels)};
}

SurfaceMesh::Point unit(Point n) {
  const double length = norm(n);
  if (!(length > 0)) return {0, 1, 0};
  return {float(n.x / length), float(n.y / length), float(n.z / length)};
}

/// Unit normals: the mean of the triangles around each point by their area. Droplets have few
/// triangles: theirs are the field's normals.
std::vector<SurfaceMesh::Point> normals_of(const GridMesh& mesh, const Smoothing& field) {
  std::vector<Point> sum = area_vectors(mesh);
  std::vector<SurfaceMesh::Point> normals;
  normals.reserve(sum.size());
  for (std::size_t k = 0; k < sum.size(); ++k) {
    const double length = norm(sum[k]), weight = double(field.weight[k]);
    const Vec<3, float> n = field.normal[k];
    if (length > 0) sum[k] = weight / length * sum[k];
    normals.push_back(unit(sum[k] + (1 - weight) * Point{double(n.x), double(n.y), double(n.z)}));
  }
  return normals;
}

SurfaceMesh in_meters(GridMesh mesh, const Grid& grid, const Smoothing& field) {
  SurfaceMesh out;
  out.normal = normals_of(mesh, field);
  out.position.reserve(mesh.points.size());
  for (const Point& p : mesh.points) out.position.push_back(grid.to_meters(p));
  out.triangles = std::move(mesh.triangles);
  return out;
}

/// The values of the points that stay. Points without values keep none.
template <class T> void keep(const std::vector<std::uint32_t>& points, std::vector<T>& values) {
  if (values.empty()) return;
  for (std::size_t k = 0; k < points.size(); ++k) values[k] = values[points[k]];
  values.resize(points.size());
}

/// A surface and what it was made of.
struct Surface {
  Particles particles;
  DensityField field;
  GridMesh mesh;
  Smoothing smoothing;
  std::vector<SurfaceMesh::Point> velocity;
};

Surface make(const Frame& frame, const Grid& grid, const SurfaceSettings& s,
             const Threads& threads) {
  check_surface_settings(s);
  if (frame.dimension != 3) fail("this frame is in 2D; a surface needs a run in 3D");
  Particles particles = particles_of(positions_of(frame, grid), s, threads);
  const ParticleBins& bins = particles.bins;
  DensityField field(bins, particles.kernels, threads);
  const float level = float(s.level);
  GridMesh mesh = marching_cubes(field, level, threads);
  const bool fits = s.volume == SurfaceVolume::particles;
  Pieces pieces = fits ? pieces_of(mesh, field, level, bins, threads) : Pieces{};
  // the spline's integral over a spacing³, as a sum over particles deep in the liquid
  const double deep = 3.14159265358979 / 8 * s.radius * s.radius * s.radius;
  PointValues values =
      point_values(mesh, field, {bins, particles.kernels, frame.v, level, float(deep)}, threads);
  for (std::size_t k = 0; k < mesh.points.size(); ++k)
    mesh.points[k] +=
        Point{double(values.step[k].x), double(values.step[k].y), double(values.step[k].z)};
  Smoothing smoothing{std::move(values.fill), std::move(values.normal), s.smooth};
  smooth(mesh, smoothing, threads);
  if (fits) fit_volumes(mesh, pieces, 1 / (s.cell * s.cell * s.cell), farthest_fit / s.cell);
  if (s.simplify > 0) {
    const std::vector<std::uint32_t> kept = simplify(mesh, s.simplify / s.cell, threads);
    keep(kept, pieces.of);
    keep(kept, smoothing.weight);
    keep(kept, smoothing.normal);
    keep(kept, values.velocity);
  }
  return {std::move(particles), std::move(field), std::move(mesh), std::move(smoothing),
          std::move(values.velocity)};
}

/// The velocities of the fluid at the points of the field's blocks.
std::vector<std::array<FluidGrids::Values, 3>> velocities_of(const Surface& surface,
                                                             const std::vector<float>& v,
                                                             const Threads& threads) {
  const ParticleBins& bins = surface.particles.bins;
  const Kernels& kernels = surface.particles.kernels;
  const Spline spline(kernels.radius);
  std::vector<std::array<FluidGrids::Values, 3>> out(std::size_t(surface.field.blocks()));
  threads.parts(surface.field.blocks(), [&](int b) {
    std::array<FluidGrids::Values, 3>& sums = out[std::size_t(b)];
    for (FluidGrids::Values& values : sums) values.fill(0);
    Nearby nearby;
    bins.collect(block_bins * surface.field.place(b), block_bins, nearby);
    for (std::size_t j = 0; j < nearby.size(); ++j) {
      const float volume = kernels.volume[std::size_t(nearby.particle[j])];
      const float* of = &v[3 * std::size_t(bins.frame_index(nearby.particle[j]))];
      for_each_weight(kernels, spline, nearby, j, [&](std::size_t k, float w) {
        for (std::size_t a = 0; a < 3; ++a) sums[a][k] += volume * w * of[a];
      });
    }
    const FluidGrids::Values& density = surface.field.values(b);
    for (FluidGrids::Values& values : sums)
      for (std::size_t k = 0; k < values.size(); ++k)
        values[k] = density[k] > 0 ? values[k] / density[k] : 0;
  });
  return out;
}

}  // namespace

void check_surface_settings(const SurfaceSettings& s) {
  RangeCheck ranges;
  visit_settings(ranges, s);
  if (s.cell > s.radius / 2)
    throw Error(
        Error::Kind::scene, fmt::format("option cell {}", s.cell),
        fmt::format("it must be at most half of `radius`, which is {}; a coarser grid misses "
                    "particles",
                    s.radius),
        {"radius"});
  if (s.simplify > 0 && !simplifies_surfaces())
    throw Error(Error::Kind::scene, fmt::format("option simplify {}", s.simplify),
                "it needs meshoptimizer, and this Freshet was built without it; install "
                "libmeshoptimizer-dev and rebuild, or leave it at 0");
}

SurfaceMesh surface_of(const Frame& frame, double spacing, const std::array<double, 3>& origin,
                       const SurfaceSettings& s, int threads) {
  const Grid grid{origin, s.cell * spacing};
  Surface surface = make(frame, grid, s, Threads(thread_count(threads)));
  SurfaceMesh out = in_meters(std::move(surface.mesh), grid, surface.smoothing);
  out.velocity = std::move(surface.velocity);
  return out;
}

FluidGrids grids_of(const Frame& frame, double spacing, const std::array<double, 3>& origin,
                    const SurfaceSettings& s, int threads) {
  const Threads team(thread_count(threads));
  const Grid grid{origin, s.cell * spacing};
  const Surface surface = make(frame, grid, s, team);
  FluidGrids out{origin, grid.cell, level_set_of(surface.mesh, team), {}, {}, {}};
  for (int b = 0; b < surface.field.blocks(); ++b) {
    out.blocks.push_back(surface.field.place(b));
    out.density.push_back(surface.field.values(b));
  }
  if (!frame.v.empty()) out.velocity = velocities_of(surface, frame.v, team);
  return out;
}

}  // namespace freshet
