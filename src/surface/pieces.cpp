// SPDX-License-Identifier: MIT
#include "surface/pieces.h"

#include <algorithm>
#include <cmath>

#include "surface/merged_sets.h"
#include "surface/smoothing.h"

namespace freshet {
namespace {

using Point = GridMesh::Point;

/// The grid points that reach the level, by connected sets within each block.
class InsidePoints {
 public:
  InsidePoints(const DensityField& field, float level, const Threads& threads)
      : field_(field), level_(level), sets_(std::size_t(field.blocks())) {
    constexpr int chunk = 32;
    const int n = field.blocks();
    threads.parts((n + chunk - 1) / chunk, [&](int part) {
      for (int b = part * chunk; b < std::min(n, (part + 1) * chunk); ++b)
        if (field_.side(b, level_) == DensityField::Side::mixed) label(b);
    });
    first_.push_back(0);
    for (int b = 0; b < n; ++b) {
      const auto side = field_.side(b, level_);
      const int count = side == DensityField::Side::mixed ? sets_[std::size_t(b)].count
                                                          : int(side == DensityField::Side::above);
      first_.push_back(first_.back() + count);
    }
  }
  std::size_t count() const { return std::size_t(first_.back()); }
  /// The set of a point of a block, or -1 if the point does not reach the level.
  int set(int block, int point) const {
    const auto b = std::size_t(block);
    if (first_[b + 1] == first_[b]) return -1;
    if (sets_[b].of.empty()) return first_[b];  // all points of the block
    const int own = sets_[b].of[std::size_t(point)];
    return own < 0 ? -1 : first_[b] + own;
  }
  /// Merges the sets of neighbouring points in different blocks.
  void merge_blocks(MergedSets& merged) const {
    for (int b = 0; b < field_.blocks(); ++b)
      for (int axis = 0; axis < 3; ++axis) {
        const Place step{axis == 0, axis == 1, axis == 2};
        const int other = field_.find(field_.place(b) + step);
        if (other >= 0) merge_face(merged, b, other, axis);
      }
  }

 private:
  struct Sets {
    std::vector<std::int16_t> of;  ///< of each point; empty if they are one set
    int count = 0;
  };
  void label(int block) {
    const DensityField::Values& values = field_.values(block);
    MergedSets merged(block_points);
    for (int z = 0; z < block_cells; ++z)
      for (int y = 0; y < block_cells; ++y)
        for (int x = 0; x < block_cells; ++x) {
          const int at = point_index(x, y, z);
          if (values[std::size_t(at)] < level_) continue;
          const int before[] = {x > 0 ? point_index(x - 1, y, z) : -1,
                                y > 0 ? point_index(x, y - 1, z) : -1,
                                z > 0 ? point_index(x, y, z - 1) : -1};
          for (const int other : before)
            if (other >= 0 && values[std::size_t(other)] >= level_) merged.merge(at, other);
        }
    Sets& sets = sets_[std::size_t(block)];
    sets.of.assign(block_points, -1);
    for (int k = 0; k < block_points; ++k) {
      if (values[std::size_t(k)] < level_) continue;
      const int first = merged.find(k);
      sets.of[std::size_t(k)] =
          first == k ? std::int16_t(sets.count++) : sets.of[std::size_t(first)];
    }
  }
  void merge_face(MergedSets& merged, int block, int other, int axis) const {
    constexpr int last = block_cells - 1;
    for (int v = 0; v < block_cells; ++v)
      for (int u = 0; u < block_cells; ++u) {
        const int near = axis == 0   ? point_index(last, u, v)
                         : axis == 1 ? point_index(u, last, v)
                                     : point_index(u, v, last);
        const int far = near - last * (axis == 0   ? 1
                                       : axis == 1 ? block_cells
                                                   : block_cells * block_cells);
        const int a = set(block, near), b = set(other, far);
        if (a >= 0 && b >= 0) merged.merge(a, b);
      }
  }

  const DensityField& field_;
  float level_;
  std::vector<Sets> sets_;
  std::vector<int> first_;  ///< the number of the first set of each block
};

/// Grid points by their coordinates.
class PointsOfGrid {
 public:
  PointsOfGrid(const DensityField& field, const InsidePoints& inside)
      : field_(field), inside_(inside) {}
  int set(int x, int y, int z) {
    const int block = block_of(x, y, z);
    return block < 0 ? -1 : inside_.set(block, index(x, y, z));
  }
  float value(int x, int y, int z) {
    const int block = block_of(x, y, z);
    return block < 0 ? 0 : field_.values(block)[std::size_t(index(x, y, z))];
  }

 private:
  static int index(int x, int y, int z) {
    constexpr int mask = block_cells - 1;
    return point_index(x & mask, y & mask, z & mask);
  }
  int block_of(int x, int y, int z) {
    const Place at{floor_div(x, block_cells), floor_div(y, block_cells), floor_div(z, block_cells)};
    const std::uint64_t key = key_of(at);
    if (key != key_ || first_) block_ = field_.find(at);
    key_ = key;
    first_ = false;
    return block_;
  }
  const DensityField& field_;
  const InsidePoints& inside_;
  std::uint64_t key_ = 0;
  int block_ = -1;
  bool first_ = true;
};

/// The set of the inner end of the grid edge on which a point of the mesh lies.
int set_of_point(PointsOfGrid& grid, Point p) {
  const int x = int(std::floor(p.x)), y = int(std::floor(p.y)), z = int(std::floor(p.z));
  const int set = grid.set(x, y, z);
  if (set >= 0) return set;
  return grid.set(x + (p.x > x), y + (p.y > y), z + (p.z > z));
}

/// The set around a particle: that of the corner of its cell with the highest value.
int set_of_particle(PointsOfGrid& grid, Place low) {
  int set = -1;
  float highest = 0;
  for (int c = 0; c < 8; ++c) {
    const int x = low.x + (c & 1), y = low.y + (c >> 1 & 1), z = low.z + (c >> 2);
    const float value = grid.value(x, y, z);
    if (value <= highest) continue;
    highest = value;
    set = grid.set(x, y, z);
  }
  return set;
}

std::vector<double> volumes_of(const GridMesh& mesh, const Pieces& pieces) {
  std::vector<double> volumes(pieces.particles.size(), 0);
  std::vector<Point> from(volumes.size());  // near each piece, for accuracy
  for (std::size_t k = mesh.points.size(); k-- > 0;)
    from[std::size_t(pieces.of[k])] = mesh.points[k];
  for (const auto& t : mesh.triangles) {
    const auto piece = std::size_t(pieces.of[t[0]]);
    const Point a = mesh.points[t[0]] - from[piece], b = mesh.points[t[1]] - from[piece],
                c = mesh.points[t[2]] - from[piece];
    volumes[piece] += dot(a, cross(b, c)) / 6;
  }
  return volumes;
}

}  // namespace

Pieces pieces_of(const GridMesh& mesh, const DensityField& field, float level,
                 const ParticleBins& bins, const Threads& threads) {
  const InsidePoints inside(field, level, threads);
  MergedSets merged(inside.count());
  inside.merge_blocks(merged);
  PointsOfGrid grid(field, inside);
  Pieces pieces;
  pieces.of.reserve(mesh.points.size());
  for (const Point& p : mesh.points) pieces.of.push_back(set_of_point(grid, p));
  for (const auto& t : mesh.triangles)  // cubes join points across a face's diagonal
    for (std::size_t c = 1; c < 3; ++c) merged.merge(pieces.of[t[0]], pieces.of[t[c]]);

  std::vector<int> number(inside.count(), -1);
  const auto piece_of = [&](int set) {
    int& piece = number[std::size_t(merged.find(set))];
    if (piece < 0) {
      piece = int(pieces.particles.size());
      pieces.particles.push_back(0);
    }
    return piece;
  };
  for (int& of : pieces.of) of = piece_of(of);
  for (const ParticleBins::Bin& bin : bins.bins())
    for (int k = bin.first; k < bin.end; ++k) {
      const Vec<3, float> at = bins.offset(k);
      const Place low = bin_cells * place_of(bin.key);
      const int set = set_of_particle(
          grid, low + Place{int(std::floor(at.x)), int(std::floor(at.y)), int(std::floor(at.z))});
      if (set >= 0) ++pieces.particles[std::size_t(piece_of(set))];
    }
  return pieces;
}

void fit_volumes(GridMesh& mesh, const Pieces& pieces, double particle_volume, double farthest) {
  std::vector<double> moved(pieces.particles.size(), 0);
  for (int pass = 0; pass < 3; ++pass) {
    const std::vector<double> now = volumes_of(mesh, pieces);
    const std::vector<Point> sums = area_vectors(mesh);
    std::vector<double> growth(now.size(), 0), step(now.size(), 0);  // of volume, for a step of 1
    for (std::size_t k = 0; k < sums.size(); ++k)
      growth[std::size_t(pieces.of[k])] += norm(sums[k]) / 3;
    for (std::size_t k = 0; k < now.size(); ++k) {
      if (!(growth[k] > 0) || pieces.particles[k] == 0) continue;
      const double wanted = (pieces.particles[k] * particle_volume - now[k]) / growth[k];
      step[k] = std::clamp(wanted, -farthest - moved[k], farthest - moved[k]);
      moved[k] += step[k];
    }
    for (std::size_t k = 0; k < sums.size(); ++k) {
      const double length = norm(sums[k]);
      if (length > 0) mesh.points[k] += step[std::size_t(pieces.of[k])] / length * sums[k];
    }
  }
}

}  // namespace freshet
