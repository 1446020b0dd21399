// SPDX-License-Identifier: MIT
#include "surface/marching_cubes.h"

#include <algorithm>
#include <limits>

#include "freshet/error.h"
#include "surface/cube_table.h"

namespace freshet {
namespace {

/// A surface keeps this distance from grid points, so that no two of its points coincide [cells].
constexpr float clearance = 0.02f;

constexpr int side_points = block_cells + 1;

/// The values at the corners of all cubes of a block: those of the block and of the planes behind
/// it.
class Corners {
 public:
  void load(const DensityField& field, const std::array<int, 8>& blocks) {
    for (int z = 0; z < side_points; ++z)
      for (int y = 0; y < side_points; ++y) {
        const int beside = (y / block_cells) << 1 | (z / block_cells) << 2;
        const int from = point_index(0, y % block_cells, z % block_cells);
        float* row = &value_[std::size_t(index(0, y, z))];
        const int own = blocks[std::size_t(beside)], behind = blocks[std::size_t(beside | 1)];
        if (own < 0) std::fill_n(row, block_cells, 0.0f);
        else std::copy_n(field.values(own).data() + from, block_cells, row);
        row[block_cells] = behind < 0 ? 0 : field.values(behind)[std::size_t(from)];
      }
  }
  static constexpr int index(int x, int y, int z) {
    return (z * side_points + y) * side_points + x;
  }
  static constexpr int stride(int axis) { return axis == 0 ? 1 : axis == 1 ? 9 : 81; }
  float operator[](int k) const { return value_[std::size_t(k)]; }
  /// The corners of a cube that are inside, one bit each.
  int inside(int k, float level) const {
    int bits = 0;
    for (int c = 0; c < 8; ++c) {
      const int corner = k + (c & 1) + (c >> 1 & 1) * stride(1) + (c >> 2) * stride(2);
      bits |= int((*this)[corner] >= level) << c;
    }
    return bits;
  }

 private:
  std::array<float, side_points * side_points * side_points> value_;
};

template <class F> void for_each_point(F f) {
  for (int z = 0; z < block_cells; ++z)
    for (int y = 0; y < block_cells; ++y)
      for (int x = 0; x < block_cells; ++x) f(x, y, z);
}

/// The cut edges that begin at the points of a block, by point and axis: their places among the
/// cuts of the block.
using Cuts = std::array<std::uint16_t, 3 * block_points>;

class MarchingCubes {
 public:
  MarchingCubes(const DensityField& field, float level, const Threads& threads)
      : field_(field), level_(level), threads_(threads) {}

  GridMesh mesh() {
    const auto n = std::size_t(field_.blocks());
    points_.assign(n + 1, 0);
    triangles_.assign(n + 1, 0);
    for_blocks([this](int b, Corners& corners) { count(b, corners); });
    std::vector<int> slot(n, -1);  // of blocks with cuts, in cuts_
    int slots = 0;
    for (std::size_t b = 0; b < n; ++b) {
      if (points_[b + 1] > 0) slot[b] = slots++;
      points_[b + 1] += points_[b];
      triangles_[b + 1] += triangles_[b];
    }
    constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
    if (points_[n] > most || triangles_[n] > most)
      throw Error(Error::Kind::run, "",
                  "the surface has more than 2^32 points; use a larger `cell`", {"cell"});
    slot_ = std::move(slot);
    cuts_.resize(std::size_t(slots));
    mesh_.points.resize(points_[n]);
    mesh_.triangles.resize(triangles_[n]);
    for_blocks([this](int b, Corners& corners) { place_points(b, corners); });
    for_blocks([this](int b, Corners& corners) { connect(b, corners); });
    mesh_.block_end.assign(points_.begin() + 1, points_.end());
    return std::move(mesh_);
  }

 private:
  /// Calls f(block, its corners) for each block that the surface may cross.
  template <class F> void for_blocks(F f) {
    constexpr int chunk = 32;
    const int n = field_.blocks();
    threads_.parts((n + chunk - 1) / chunk, [&](int part) {
      Corners corners;
      for (int b = part * chunk; b < std::min(n, (part + 1) * chunk); ++b) {
        const auto blocks = with_neighbors(b);
        const auto side = field_.side(b, level_);
        if (side != DensityField::Side::mixed &&
            std::all_of(blocks.begin(), blocks.end(),
                        [&](int other) { return field_.side(other, level_) == side; }))
          continue;
        corners.load(field_, blocks);
        f(b, corners);
      }
    });
  }
  /// The block and those behind it, by a bit per axis.
  std::array<int, 8> with_neighbors(int block) const {
    std::array<int, 8> all;
    const Place at = field_.place(block);
    all[0] = block;
    for (int k = 1; k < 8; ++k)
      all[std::size_t(k)] = field_.find(at + Place{k & 1, k >> 1 & 1, k >> 2});
    return all;
  }
  bool is_cut(const Corners& corners, int k, int axis) const {
    return (corners[k] >= level_) != (corners[k + Corners::stride(axis)] >= level_);
  }

  void count(int b, const Corners& corners) {
    std::uint64_t points = 0, triangles = 0;
    for_each_point([&](int x, int y, int z) {
      const int k = Corners::index(x, y, z);
      for (int axis = 0; axis < 3; ++axis) points += is_cut(corners, k, axis);
      triangles += std::uint64_t(cube_table()[std::size_t(corners.inside(k, level_))].count);
    });
    points_[std::size_t(b) + 1] = points;
    triangles_[std::size_t(b) + 1] = triangles;
  }

  void place_points(int b, const Corners& corners) {
    if (slot_[std::size_t(b)] < 0) return;
    Cuts& cuts = cuts_[std::size_t(slot_[std::size_t(b)])];
    const Place low = block_cells * field_.place(b);
    const std::uint64_t first = points_[std::size_t(b)];
    std::uint16_t next = 0;
    for_each_point([&](int x, int y, int z) {
      const int k = Corners::index(x, y, z);
      for (int axis = 0; axis < 3; ++axis) {
        if (!is_cut(corners, k, axis)) continue;
        const float a = corners[k], c = corners[k + Corners::stride(axis)];
        const float t = std::clamp((level_ - a) / (c - a), clearance, 1 - clearance);
        GridMesh::Point point{double(low.x + x), double(low.y + y), double(low.z + z)};
        component(point, axis) += double(t);
        mesh_.points[first + next] = point;
        cuts[std::size_t(3 * point_index(x, y, z) + axis)] = next++;
      }
    });
  }

  void connect(int b, const Corners& corners) {
    const auto blocks = with_neighbors(b);
    GridMesh::Triangle* out = mesh_.triangles.data() + triangles_[std::size_t(b)];
    for_each_point([&](int x, int y, int z) {
      const int inside = corners.inside(Corners::index(x, y, z), level_);
      const CubeTriangles& cube = cube_table()[std::size_t(inside)];
      for (int k = 0; k < cube.count; ++k, ++out)
        for (std::size_t c = 0; c < 3; ++c)
          (*out)[c] = point_on(blocks, x, y, z, cube.edges[std::size_t(k)][c]);
    });
  }
  /// The point on an edge of the cube at (x, y, z).
  std::uint32_t point_on(const std::array<int, 8>& blocks, int x, int y, int z, int edge) const {
    const int corner = edge_corner(edge);
    x += corner & 1;
    y += corner >> 1 & 1;
    z += corner >> 2;
    const int beside = x / block_cells | (y / block_cells) << 1 | (z / block_cells) << 2;
    const auto block = std::size_t(blocks[std::size_t(beside)]);
    const int point = point_index(x % block_cells, y % block_cells, z % block_cells);
    return std::uint32_t(points_[block] +
                         cuts_[std::size_t(slot_[block])][std::size_t(3 * point + edge / 4)]);
  }

  const DensityField& field_;
  float level_;
  const Threads& threads_;
  std::vector<std::uint64_t> points_, triangles_;  // of the blocks before each
  std::vector<int> slot_;
  std::vector<Cuts> cuts_;
  GridMesh mesh_;
};

}  // namespace

GridMesh marching_cubes(const DensityField& field, float level, const Threads& threads) {
  return MarchingCubes(field, level, threads).mesh();
}

}  // namespace freshet
