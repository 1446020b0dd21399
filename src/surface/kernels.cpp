// SPDX-License-Identifier: MIT
#include "surface/kernels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "surface/spline.h"

namespace freshet {
namespace {

/// Σ w and |Σ w·(x_j - x)| over particles.
struct Sums {
  float splines, moment;
};

/// Over collected particles. The eight partial sums let the compiler use SIMD; they are added in a
/// fixed order, so the bits do not depend on the instruction set.
Sums sums_at(const Nearby& all, Vec<3, float> x, Spline spline) {
  constexpr int lanes = 8;
  float partial[4][lanes] = {};
  const std::size_t whole = all.size() / lanes * lanes;
  const auto add = [&](std::size_t j, std::size_t lane) {
    const float dx = all.x[j] - x.x, dy = all.y[j] - x.y, dz = all.z[j] - x.z;
    const float w = spline(dx * dx + dy * dy + dz * dz);
    partial[0][lane] += w;
    partial[1][lane] += w * dx;
    partial[2][lane] += w * dy;
    partial[3][lane] += w * dz;
  };
  for (std::size_t j = 0; j < whole; j += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) add(j + lane, lane);
  for (std::size_t j = whole; j < all.size(); ++j) add(j, j - whole);
  float sum[4] = {};
  for (int k = 0; k < 4; ++k)
    for (const float part : partial[k]) sum[k] += part;
  return {sum[0], std::sqrt(sum[1] * sum[1] + sum[2] * sum[2] + sum[3] * sum[3])};
}

/// Σ w over particles, of a kernel with a shape.
float shaped_sum(const Nearby& all, Vec<3, float> x, Spline spline, const Symmetric3& shrink) {
  constexpr int lanes = 8;
  float partial[lanes] = {};
  const auto add = [&](std::size_t j, std::size_t lane) {
    const Vec<3, float> d{all.x[j] - x.x, all.y[j] - x.y, all.z[j] - x.z};
    partial[lane] += spline(norm2(shrink * d));
  };
  const std::size_t whole = all.size() / lanes * lanes;
  for (std::size_t j = 0; j < whole; j += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) add(j + lane, lane);
  for (std::size_t j = whole; j < all.size(); ++j) add(j, j - whole);
  float sum = 0;
  for (const float part : partial) sum += part;
  return sum;
}

/// Sums of splines over the planes of a lattice, in spacings.
struct LatticePlanes {
  explicit LatticePlanes(float radius) : spline(radius), reach(int(std::ceil(radius))) {}
  /// Over a plane at the distance z, from (x, y) between its sites.
  float plane(float z, float x, float y) const {
    float sum = 0;
    for (int j = -reach; j <= reach; ++j)
      for (int i = -reach; i <= reach; ++i) {
        const float dx = float(i) - x, dy = float(j) - y;
        sum += spline(dx * dx + dy * dy + z * z);
      }
    return sum;
  }
  /// The mean over a plane.
  float mean(float z) const {
    return (plane(z, 0, 0) + plane(z, 0.5f, 0.5f) + 2 * plane(z, 0.5f, 0)) / 4;
  }
  Spline spline;
  int reach;
};

}  // namespace

FilmModel::FilmModel(float support, float spacing) {
  const LatticePlanes lattice(support / spacing);
  const float film = lattice.plane(0, 0, 0);
  float below = 0, moment = 0, pool = 0;
  for (int k = 1; k <= lattice.reach; ++k) {
    below += lattice.plane(float(k), 0, 0);
    moment += float(k) * lattice.plane(float(k), 0, 0);
  }
  float layer = film + below;                // the sum at a particle of layer k of a pool
  for (int k = 0; k < lattice.reach; ++k) {  // the density half a spacing above the pool
    pool += lattice.mean(float(k) + 0.5f) / layer;
    layer += lattice.plane(float(k) + 1, 0, 0);
  }
  deep = film + 2 * below;
  flat = moment * spacing;
  const float excess = 1 - pool * film / lattice.mean(0.5f);
  const float filled = (film - 1) / (deep - 1);
  strength = filled > 0 && filled < 1 ? std::max(excess, 0.0f) / (filled * (1 - filled)) : 0;
}

float FilmModel::factor(float sum, float moment) const {
  const float filled = std::clamp((sum - 1) / (deep - 1), 0.0f, 1.0f), side = moment / flat;
  return 1 - strength * filled * (1 - filled) * std::max(0.0f, 1 - side * side);
}

Kernels kernels_of(const ParticleBins& bins, float radius, std::vector<KernelShape> shapes,
                   const FilmModel& films, const Threads& threads) {
  Kernels kernels{radius, std::vector<float>(bins.size()), std::move(shapes)};
  const Spline spline(radius);
  for_each_particle(bins, threads, [&](int k, const Nearby& nearby) {
    const Sums sums = sums_at(nearby, bins.offset(k), spline);
    const float own = kernels.is_round(k) ? sums.splines
                                          : shaped_sum(nearby, bins.offset(k), spline,
                                                       kernels.shape[std::size_t(k)].shrink);
    kernels.volume[std::size_t(k)] = films.factor(sums.splines, sums.moment) / own;
  });
  return kernels;
}

}  // namespace freshet
