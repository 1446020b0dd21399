// SPDX-License-Identifier: MIT
#include "surface/level_set.h"

#include <algorithm>
#include <cmath>

#include "core/nearest_on_triangle.h"

namespace freshet {
namespace {

using Point = GridMesh::Point;
using Corners = std::array<Point, 3>;

/// Rows of points run beside the grid by this much [cells]: vertices of marching cubes lie on its
/// lines, where a row would meet several triangles at once.
constexpr double aside_y = 3.1e-7, aside_z = 7.3e-7;

Corners corners_of(const GridMesh& mesh, std::size_t triangle) {
  const GridMesh::Triangle& t = mesh.triangles[triangle];
  return {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
}

struct Box {
  Point low, high;
};
Box box_of(const Corners& t) {
  const auto least = [](double a, double b) { return std::min(a, b); };
  const auto most = [](double a, double b) { return std::max(a, b); };
  return {each(each(t[0], t[1], least), t[2], least), each(each(t[0], t[1], most), t[2], most)};
}

/// Where the rows of points along x enter and leave the mesh.
class Rows {
 public:
  explicit Rows(const GridMesh& mesh) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) add(mesh, t);
    std::sort(all_.begin(), all_.end(), [](const Crossing& a, const Crossing& b) {
      return a.row != b.row ? a.row < b.row : a.x < b.x;
    });
  }
  /// Calls f(x, winding): from x on, up to the next call, the row has this winding number.
  template <class F> void walk(int y, int z, const F& f) const {
    const std::uint64_t row = row_of(y, z);
    auto at = std::lower_bound(all_.begin(), all_.end(), row,
                               [](const Crossing& c, std::uint64_t r) { return c.row < r; });
    int winding = 0;
    for (; at != all_.end() && at->row == row; ++at) f(at->x, winding += at->step);
  }
  /// Calls f(y, z) for each row that meets the mesh.
  template <class F> void for_each(const F& f) const {
    for (std::size_t k = 0; k < all_.size(); ++k)
      if (k == 0 || all_[k].row != all_[k - 1].row) f(all_[k].y, all_[k].z);
  }

 private:
  struct Crossing {
    std::uint64_t row;
    double x;
    int y, z, step;
  };
  static std::uint64_t row_of(int y, int z) {
    return std::uint64_t(std::uint32_t(z)) << 32 | std::uint32_t(y);
  }
  /// Twice the area of the triangle of an edge and a point of the plane of y and z. Both triangles
  /// of an edge get the same number, so a row passes one of them.
  static double side(const GridMesh& mesh, std::uint32_t from, std::uint32_t to, double y,
                     double z) {
    if (from > to) return -side(mesh, to, from, y, z);
    const Point a = mesh.points[from], b = mesh.points[to];
    return (b.y - a.y) * (z - a.z) - (b.z - a.z) * (y - a.y);
  }
  void add(const GridMesh& mesh, std::size_t triangle) {
    const GridMesh::Triangle& t = mesh.triangles[triangle];
    const Corners at = corners_of(mesh, triangle);
    const Box box = box_of(at);
    for (int z = int(std::floor(box.low.z)); z <= int(std::floor(box.high.z)); ++z)
      for (int y = int(std::floor(box.low.y)); y <= int(std::floor(box.high.y)); ++y) {
        const double py = y + aside_y, pz = z + aside_z;
        const double w[] = {side(mesh, t[1], t[2], py, pz), side(mesh, t[2], t[0], py, pz),
                            side(mesh, t[0], t[1], py, pz)};
        const bool front = w[0] > 0 && w[1] > 0 && w[2] > 0;
        if (!front && !(w[0] < 0 && w[1] < 0 && w[2] < 0)) continue;
        const double x = (w[0] * at[0].x + w[1] * at[1].x + w[2] * at[2].x) / (w[0] + w[1] + w[2]);
        all_.push_back({row_of(y, z), x, y, z, front ? -1 : 1});  // its normal has the sign of w
      }
  }
  std::vector<Crossing> all_;
};

/// A triangle near a block.
struct Near {
  std::uint64_t block;
  std::uint32_t triangle;
};

/// The triangles within the band of each block, by block and triangle.
std::vector<Near> triangles_near_blocks(const GridMesh& mesh) {
  std::vector<Near> near;
  const auto block = [](double x) { return floor_div(int(std::floor(x)), block_cells); };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Box box = box_of(corners_of(mesh, t));
    const double b = double(LevelSet::band);
    for (int z = block(box.low.z - b); z <= block(box.high.z + b); ++z)
      for (int y = block(box.low.y - b); y <= block(box.high.y + b); ++y)
        for (int x = block(box.low.x - b); x <= block(box.high.x + b); ++x)
          near.push_back({key_of({x, y, z}), std::uint32_t(t)});
  }
  std::sort(near.begin(), near.end(), [](const Near& a, const Near& b) {
    return a.block != b.block ? a.block < b.block : a.triangle < b.triangle;
  });
  return near;
}

/// Lowers the distances at the points of a block to those from a triangle.
void lower(LevelSet::Values& values, const Corners& triangle, Place corner) {
  const Point low{double(corner.x), double(corner.y), double(corner.z)};
  std::array<Vec<3, float>, 3> t;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point p = triangle[k] - low;
    t[k] = {float(p.x), float(p.y), float(p.z)};
  }
  const Vec<3, float> center = 1 / 3.0f * (t[0] + t[1] + t[2]);
  float radius2 = 0;
  for (const Vec<3, float>& p : t) radius2 = std::max(radius2, norm2(p - center));
  const float radius = std::sqrt(radius2), reach = radius + LevelSet::band;
  const auto first = [&](float c) { return std::max(0, int(std::ceil(c - reach))); };
  const auto last = [&](float c) { return std::min(block_cells - 1, int(std::floor(c + reach))); };
  for (int z = first(center.z); z <= last(center.z); ++z)
    for (int y = first(center.y); y <= last(center.y); ++y)
      for (int x = first(center.x); x <= last(center.x); ++x) {
        const Vec<3, float> p{float(x), float(y), float(z)};
        float& value = values[std::size_t(point_index(x, y, z))];
        const float farthest = value + radius;
        if (norm2(p - center) >= farthest * farthest) continue;
        value = std::min(value, norm(p - nearest_on_triangle(t, p)));
      }
}

/// Makes the distances at the points inside negative.
void set_signs(LevelSet::Values& values, Place corner, const Rows& rows) {
  for (int z = 0; z < block_cells; ++z)
    for (int y = 0; y < block_cells; ++y) {
      bool inside = false;
      int next = 0;  // the first point without a sign
      const auto sign_up_to = [&](int end) {
        for (; next < std::min(end, block_cells); ++next)
          if (inside) values[std::size_t(point_index(next, y, z))] *= -1;
      };
      rows.walk(corner.y + y, corner.z + z, [&](double x, int winding) {
        const double beyond = std::ceil(x) - corner.x;
        sign_up_to(int(std::clamp(beyond, 0.0, double(block_cells))));
        inside = winding > 0;
      });
      sign_up_to(block_cells);
    }
}

/// The blocks inside the mesh that are not among `known`.
std::vector<Place> blocks_inside(const Rows& rows, const std::vector<Place>& known) {
  std::vector<Place> inside;
  const auto is_known = [&](Place p) {
    return std::binary_search(known.begin(), known.end(), p,
                              [](Place a, Place b) { return key_of(a) < key_of(b); });
  };
  rows.for_each([&](int y, int z) {
    const Place at{0, floor_div(y, block_cells), floor_div(z, block_cells)};
    if (block_cells * at.y != y || block_cells * at.z != z) return;
    double from = 0;
    int before = 0;
    rows.walk(y, z, [&](double x, int winding) {
      if (before > 0)
        for (int b = int(std::ceil(from / block_cells)); b * block_cells < x; ++b)
          if (const Place p{b, at.y, at.z}; !is_known(p)) inside.push_back(p);
      from = x;
      before = winding;
    });
  });
  return inside;
}

}  // namespace

LevelSet level_set_of(const GridMesh& mesh, const Threads& threads) {
  const std::vector<Near> near = triangles_near_blocks(mesh);
  std::vector<std::size_t> first;  // of the triangles of each block
  for (std::size_t k = 0; k < near.size(); ++k)
    if (k == 0 || near[k].block != near[k - 1].block) first.push_back(k);
  const std::size_t blocks = first.size();
  first.push_back(near.size());
  const Rows rows(mesh);
  std::vector<LevelSet::Values> values(blocks);
  threads.parts(int(blocks), [&](int part) {
    const auto b = std::size_t(part);
    const Place corner = block_cells * place_of(near[first[b]].block);
    values[b].fill(LevelSet::band);
    for (std::size_t k = first[b]; k < first[b + 1]; ++k)
      lower(values[b], corners_of(mesh, near[k].triangle), corner);
    set_signs(values[b], corner, rows);
  });
  LevelSet out;
  for (std::size_t b = 0; b < blocks; ++b) {
    const auto in_band = [](float d) { return std::abs(d) < LevelSet::band; };
    if (std::none_of(values[b].begin(), values[b].end(), in_band)) continue;
    out.blocks.push_back(place_of(near[first[b]].block));
    out.values.push_back(values[b]);
  }
  out.inside = blocks_inside(rows, out.blocks);
  return out;
}

}  // namespace freshet
