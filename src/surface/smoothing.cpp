// SPDX-License-Identifier: MIT
#include "surface/smoothing.h"

#include <algorithm>
#include <cmath>

namespace freshet {
namespace {

using Point = GridMesh::Point;

/// The points that share an edge with each point.
struct Neighbors {
  explicit Neighbors(const GridMesh& mesh) : end(mesh.points.size() + 1, 0) {
    // A closed mesh has each edge once in each direction.
    for (const auto& t : mesh.triangles)
      for (const std::uint32_t corner : t) ++end[corner + 1];
    for (std::size_t k = 1; k < end.size(); ++k) end[k] += end[k - 1];
    all.resize(3 * mesh.triangles.size());
    std::vector<std::size_t> next(end.begin(), end.end() - 1);
    for (const auto& t : mesh.triangles)
      for (std::size_t c = 0; c < 3; ++c) all[next[t[c]]++] = t[(c + 1) % 3];
  }
  std::vector<std::size_t> end;  ///< those of point k begin at end[k] and end before end[k + 1]
  std::vector<std::uint32_t> all;
};

/// The step of a point towards the mean of its neighbours.
Point step_to(Point mean, Point from, float weight, Vec<3, float> n) {
  const Point normal{double(n.x), double(n.y), double(n.z)};
  const Point step = mean - from;
  return step - (1 - double(weight)) * dot(step, normal) * normal;
}

std::vector<Point> smoothed(std::vector<Point> from, const Neighbors& neighbors,
                            const Smoothing& smoothing, const Threads& threads) {
  std::vector<Point> to(from.size());
  for (int step = 0; step < smoothing.steps; ++step) {
    threads.blocks(int(from.size()), [&](int begin, int end) {
      for (auto k = std::size_t(begin); k < std::size_t(end); ++k) {
        const std::size_t first = neighbors.end[k], last = neighbors.end[k + 1];
        Point sum{0, 0, 0};
        for (std::size_t j = first; j < last; ++j) sum += from[neighbors.all[j]];
        to[k] = from[k] + step_to(sum / double(last - first), from[k], smoothing.weight[k],
                                  smoothing.normal[k]);
      }
    });
    from.swap(to);
  }
  return from;
}

/// The connected parts of a mesh: a number for each point.
struct Parts {
  std::vector<int> of;
  std::vector<std::uint32_t> first;  ///< a point of each part
  explicit Parts(const Neighbors& neighbors) : of(neighbors.end.size() - 1, -1) {
    std::vector<std::uint32_t> open;
    for (std::uint32_t start = 0; start < of.size(); ++start) {
      if (of[start] >= 0) continue;
      const int part = int(first.size());
      first.push_back(start);
      of[start] = part;
      open.push_back(start);
      while (!open.empty()) {
        const std::uint32_t k = open.back();
        open.pop_back();
        for (std::size_t j = neighbors.end[k]; j < neighbors.end[k + 1]; ++j) {
          const std::uint32_t next = neighbors.all[j];
          if (of[next] >= 0) continue;
          of[next] = part;
          open.push_back(next);
        }
      }
    }
  }
};

std::vector<double> volumes_of(const GridMesh& mesh, const Parts& parts) {
  std::vector<double> volumes(parts.first.size(), 0);
  for (const auto& t : mesh.triangles) {
    const auto part = std::size_t(parts.of[t[0]]);
    const Point from = mesh.points[parts.first[part]];  // near, for accuracy
    const Point a = mesh.points[t[0]] - from, b = mesh.points[t[1]] - from,
                c = mesh.points[t[2]] - from;
    volumes[part] += dot(a, cross(b, c)) / 6;
  }
  return volumes;
}

/// Moves the points of each part along their normals until it has its volume again, to first order.
void restore_volumes(GridMesh& mesh, const Parts& parts, const std::vector<double>& before) {
  constexpr double farthest = 0.5;  // [cells]
  const std::vector<double> now = volumes_of(mesh, parts);
  const std::vector<Point> sums = area_vectors(mesh);
  std::vector<double> growth(now.size(), 0);  // of a part's volume, for a step of length 1
  for (std::size_t k = 0; k < sums.size(); ++k)
    growth[std::size_t(parts.of[k])] += norm(sums[k]) / 3;
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const auto part = std::size_t(parts.of[k]);
    const double length = norm(sums[k]);
    if (!(length > 0) || !(growth[part] > 0)) continue;
    const double step = std::clamp((before[part] - now[part]) / growth[part], -farthest, farthest);
    mesh.points[k] += step / length * sums[k];
  }
}

/// Puts the parts back that smoothing has spoiled: those whose volume could not be restored. They
/// are as small as a cell, or too many steps have thinned them.
void put_back_spoiled(GridMesh& mesh, const std::vector<Point>& rough, const Parts& parts,
                      const std::vector<double>& before) {
  constexpr double tolerance = 0.1;
  const std::vector<double> now = volumes_of(mesh, parts);
  for (std::size_t k = 0; k < rough.size(); ++k) {
    const auto part = std::size_t(parts.of[k]);
    if (!(std::abs(now[part] - before[part]) <= tolerance * std::abs(before[part])))
      mesh.points[k] = rough[k];
  }
}

}  // namespace

std::vector<Point> area_vectors(const GridMesh& mesh) {
  std::vector<Point> sums(mesh.points.size(), Point{0, 0, 0});
  for (const auto& t : mesh.triangles) {
    const Point a = mesh.points[t[0]];
    const Point area = 0.5 * cross(mesh.points[t[1]] - a, mesh.points[t[2]] - a);
    for (const std::uint32_t corner : t) sums[corner] += area;
  }
  return sums;
}

void smooth(GridMesh& mesh, const Smoothing& smoothing, const Threads& threads) {
  if (smoothing.steps == 0) return;
  const Neighbors neighbors(mesh);
  const Parts parts(neighbors);
  const std::vector<double> volumes = volumes_of(mesh, parts);
  const std::vector<Point> rough = mesh.points;
  const std::vector<Point> once = smoothed(rough, neighbors, smoothing, threads);
  std::vector<Point> taken(once.size());
  for (std::size_t k = 0; k < once.size(); ++k) taken[k] = rough[k] - once[k];
  taken = smoothed(std::move(taken), neighbors, smoothing, threads);
  for (std::size_t k = 0; k < once.size(); ++k) mesh.points[k] = once[k] + taken[k];
  for (int pass = 0; pass < 2; ++pass) restore_volumes(mesh, parts, volumes);
  put_back_spoiled(mesh, rough, parts, volumes);
}

}  // namespace freshet
