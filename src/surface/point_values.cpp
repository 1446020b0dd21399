// SPDX-License-Identifier: MIT
#include "surface/point_values.h"

#include <algorithm>

#include "surface/spline.h"

namespace freshet {
namespace {

constexpr float farthest_step = 0.25f;  // [cells]; keeps triangles from turning over
/// A droplet of one particle has a lower level, as its few flat triangles lie within the round
/// surface. Its volume is then that of the particle.
constexpr float droplet_level = 0.87f;

/// Computes the values of points, bin by bin.
class BinValues {
 public:
  explicit BinValues(const SurfaceField& field) : field_(field), spline_(field.kernels.radius) {}

  void place(Place bin) {
    bin_ = bin;
    low_ = bin_cells * bin;
  }
  void collect() { field_.bins.collect(bin_, 1, nearby_); }
  bool holds(GridMesh::Point p) const {
    const auto inside = [](double x, int low) { return x >= low && x < low + bin_cells; };
    return inside(p.x, low_.x) && inside(p.y, low_.y) && inside(p.z, low_.z);
  }

  void add(GridMesh::Point p, std::size_t k, PointValues& out) const {
    const Vec<3, float> at{float(p.x - low_.x), float(p.y - low_.y), float(p.z - low_.z)};
    const float radius2 = field_.kernels.radius * field_.kernels.radius;
    float crowd = 0, density = 0;
    Vec<3, float> momentum{0, 0, 0}, gradient{0, 0, 0};
    for (std::size_t j = 0; j < nearby_.size(); ++j) {
      const Vec<3, float> from = at - Vec<3, float>{nearby_.x[j], nearby_.y[j], nearby_.z[j]};
      const float r2 = norm2(from);
      const int particle = nearby_.particle[j];
      if (const float reach = field_.kernels.reach(particle); r2 >= reach * reach) continue;
      const float volume = field_.kernels.volume[std::size_t(particle)], round = spline_(r2);
      if (r2 < radius2) crowd += round;
      float w = round;
      Vec<3, float> slope = from;
      float s2 = r2;
      if (!field_.kernels.is_round(particle)) {
        const Symmetric3& shrink = field_.kernels.shape[std::size_t(particle)].shrink;
        const Vec<3, float> inner = shrink * from;
        s2 = norm2(inner);
        w = spline_(s2);
        slope = shrink * inner;
      }
      if (s2 >= radius2) continue;
      density += volume * w;
      momentum += volume * w * velocity_of(particle);
      gradient += volume * spline_.slope(s2) * slope;
    }
    const float fill = fill_of(crowd), empty = 1 - fill;
    const float level = field_.level * (1 - (1 - droplet_level) * empty * empty);
    out.fill[k] = fill;
    const float slope = norm(gradient);
    if (slope > 0) out.normal[k] = -1 / slope * gradient;
    out.step[k] = newton_step(level - density, gradient);
    if (!field_.velocity.empty() && density > 0)
      out.velocity[k] = {momentum.x / density, momentum.y / density, momentum.z / density};
  }

 private:
  /// From the sum of splines: that at the surface of a lone particle is the level, that at a flat
  /// surface a little less than half of that deep in the liquid.
  float fill_of(float crowd) const {
    constexpr float flat = 0.45f;
    const float alone = field_.level;
    const float t = std::clamp((crowd - alone) / (flat * field_.deep - alone), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
  }
  static Vec<3, float> newton_step(float rise, Vec<3, float> gradient) {
    const float slope2 = norm2(gradient);
    if (!(slope2 > 0)) return {0, 0, 0};
    const Vec<3, float> step = rise / slope2 * gradient;
    const float length = norm(step);
    return length > farthest_step ? farthest_step / length * step : step;
  }
  Vec<3, float> velocity_of(int particle) const {
    if (field_.velocity.empty()) return {0, 0, 0};
    const float* v = &field_.velocity[3 * std::size_t(field_.bins.frame_index(particle))];
    return {v[0], v[1], v[2]};
  }

  const SurfaceField& field_;
  Spline spline_;
  Nearby nearby_;
  Place bin_{}, low_{};
};

void add_block(const GridMesh& mesh, Place block, std::size_t first, std::size_t end,
               BinValues& values, PointValues& out) {
  if (first == end) return;
  for (int bin = 0; bin < block_bins * block_bins * block_bins; ++bin) {
    values.place(block_bins * block + Place{bin & 1, bin >> 1 & 1, bin >> 2});
    bool collected = false;
    for (std::size_t k = first; k < end; ++k) {
      if (!values.holds(mesh.points[k])) continue;
      if (!collected) values.collect();
      collected = true;
      values.add(mesh.points[k], k, out);
    }
  }
}

}  // namespace

PointValues point_values(const GridMesh& mesh, const DensityField& blocks,
                         const SurfaceField& field, const Threads& threads) {
  PointValues out;
  const std::size_t n = mesh.points.size();
  out.fill.assign(n, 0);
  out.normal.assign(n, {0, 0, 0});
  out.step.assign(n, {0, 0, 0});
  if (!field.velocity.empty()) out.velocity.assign(n, {0, 0, 0});
  constexpr int chunk = 32;
  threads.parts((blocks.blocks() + chunk - 1) / chunk, [&](int part) {
    BinValues values(field);
    for (int b = part * chunk; b < std::min(blocks.blocks(), (part + 1) * chunk); ++b) {
      const std::size_t first = b == 0 ? 0 : mesh.block_end[std::size_t(b) - 1];
      add_block(mesh, blocks.place(b), first, mesh.block_end[std::size_t(b)], values, out);
    }
  });
  return out;
}

}  // namespace freshet
