// SPDX-License-Identifier: MIT
#include "surface/smoothing.h"

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

}  // namespace

void smooth(GridMesh& mesh, const Smoothing& smoothing, const Threads& threads) {
  if (smoothing.steps == 0) return;
  const Neighbors neighbors(mesh);
  const std::vector<Point> once = smoothed(mesh.points, neighbors, smoothing, threads);
  std::vector<Point> taken(once.size());
  for (std::size_t k = 0; k < once.size(); ++k) taken[k] = mesh.points[k] - once[k];
  taken = smoothed(std::move(taken), neighbors, smoothing, threads);
  for (std::size_t k = 0; k < once.size(); ++k) mesh.points[k] = once[k] + taken[k];
}

}  // namespace freshet
