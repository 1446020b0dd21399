// SPDX-License-Identifier: MIT
#include "surface/anisotropy.h"

#include <algorithm>
#include <cmath>

#include "surface/spline.h"

namespace freshet {
namespace {

constexpr float few = 12, many = 25;            // neighbours of a round and of a stretched kernel
constexpr float deep = 0.95f, exposed = 0.75f;  // sums of weights, of that deep in the liquid
constexpr float noise = 1.15f;                  // ratio of variances without a surface
constexpr float layer_half = 0.75f;             // half the thickness of a layer [spacings]
/// A raised particle raises the mean around it by 0.45 of its height at a pool's surface, by none
/// in a film.
constexpr float gain = 1.2f;
constexpr float farthest_shift = 0.5f;  // [spacings]
constexpr int lanes = 8;
constexpr int terms = 11;  // count, weight, three first and six second moments

/// The moments of the particles around one, weighted by 1 - (r/reach)³.
struct Moments {
  float count, weight;
  Vec<3, float> mean;  ///< relative to the particle
  Symmetric3 covariance;
};

Moments moments_at(const Nearby& all, Vec<3, float> x, float reach) {
  float partial[terms][lanes] = {};
  const float scale = 1 / reach;
  const auto add = [&](std::size_t j, std::size_t lane) {
    const float dx = all.x[j] - x.x, dy = all.y[j] - x.y, dz = all.z[j] - x.z;
    const float q = std::sqrt(dx * dx + dy * dy + dz * dz) * scale;
    const float w = std::max(1 - q * q * q, 0.0f);
    const float values[terms] = {
        w > 0 ? 1.0f : 0.0f, w,           w * dx,      w * dy,      w * dz,     w * dx * dx,
        w * dy * dy,         w * dz * dz, w * dx * dy, w * dx * dz, w * dy * dz};
    for (int k = 0; k < terms; ++k) partial[k][lane] += values[k];
  };
  const std::size_t whole = all.size() / lanes * lanes;
  for (std::size_t j = 0; j < whole; j += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) add(j + lane, lane);
  for (std::size_t j = whole; j < all.size(); ++j) add(j, j - whole);
  float s[terms] = {};
  for (int k = 0; k < terms; ++k)
    for (const float part : partial[k]) s[k] += part;
  const float one = 1 / s[1];  // the particle itself has the weight 1
  const Vec<3, float> m{s[2] * one, s[3] * one, s[4] * one};
  return {s[0],
          s[1],
          m,
          {s[5] * one - m.x * m.x, s[6] * one - m.y * m.y, s[7] * one - m.z * m.z,
           s[8] * one - m.x * m.y, s[9] * one - m.x * m.z, s[10] * one - m.y * m.z}};
}

/// What a particle's surroundings give it.
struct Surroundings {
  KernelShape shape;
  Vec<3, float> mean{0, 0, 0};    ///< of the particles around it, relative to it [cells]
  Vec<3, float> across{0, 0, 0};  ///< the shortest axis
  float smoothing = 0;            ///< 0: the centre stays; 1: at a surface
};

/// `full`: the sum of weights deep in the liquid.
Surroundings surroundings_of(const Moments& m, float full) {
  Surroundings out;
  const float known = std::clamp((m.count - few) / (many - few), 0.0f, 1.0f) *
                      std::clamp((deep - m.weight / full) / (deep - exposed), 0.0f, 1.0f);
  out.mean = m.mean;
  if (known == 0) return out;
  const Eigen3 eigen(m.covariance);
  const auto [low, high] = std::minmax_element(eigen.value.begin(), eigen.value.end());
  const double floor = std::max(*low, 1e-3 * *high);
  if (!(floor > 0)) return out;
  out.shape.shrink = {0, 0, 0, 0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const float ratio = float(eigen.value[k] / floor) / noise;
    const float stretch = 1 + known * (std::clamp(ratio, 1.0f, longest_stretch) - 1);
    out.shape.reach = std::max(out.shape.reach, stretch);
    const Vec<3, float> n{float(eigen.vector[k].x), float(eigen.vector[k].y),
                          float(eigen.vector[k].z)};
    const float by = 1 / stretch;
    Symmetric3& g = out.shape.shrink;
    g.xx += by * n.x * n.x;
    g.yy += by * n.y * n.y;
    g.zz += by * n.z * n.z;
    g.xy += by * n.x * n.y;
    g.xz += by * n.x * n.z;
    g.yz += by * n.y * n.z;
    if (&eigen.value[k] == &*low) out.across = n;
  }
  out.smoothing = known;
  return out;
}

/// The mean of what the neighbours in the same layer would move by.
Vec<3, float> layer_mean(const Nearby& nearby, Vec<3, float> x, const Surroundings& own,
                         const std::vector<Surroundings>& all, float reach, float half) {
  Vec<3, float> sum{0, 0, 0};
  float weight = 0;
  for (std::size_t j = 0; j < nearby.size(); ++j) {
    const Vec<3, float> d{nearby.x[j] - x.x, nearby.y[j] - x.y, nearby.z[j] - x.z};
    const float q2 = norm2(d) / (reach * reach), height = dot(d, own.across) / half;
    if (q2 >= 1 || height * height >= 1) continue;
    const float w = (1 - q2) * (1 - height * height);
    sum += w * all[std::size_t(nearby.particle[j])].mean;
    weight += w;
  }
  return 1 / weight * sum;
}

}  // namespace

Anisotropy anisotropy_of(const ParticleBins& bins, float support, float spacing,
                         const Threads& threads) {
  const float reach = shape_reach * support;
  // the integral of the weights over a sphere, in particles
  const float radius = reach / spacing, full = 2.0943951f * radius * radius * radius;
  std::vector<Surroundings> all(bins.size());
  for_each_particle(bins, threads, [&](int k, const Nearby& nearby) {
    all[std::size_t(k)] = surroundings_of(moments_at(nearby, bins.offset(k), reach), full);
  });
  Anisotropy out;
  out.shape.resize(bins.size());
  out.shift.assign(bins.size(), {0, 0, 0});
  for_each_particle(bins, threads, [&](int k, const Nearby& nearby) {
    const Surroundings& own = all[std::size_t(k)];
    const auto index = std::size_t(bins.frame_index(k));
    out.shape[index] = own.shape;
    if (own.smoothing == 0) return;
    const Vec<3, float> excess =
        own.mean - layer_mean(nearby, bins.offset(k), own, all, reach, layer_half * spacing);
    const Vec<3, float> shift = gain * own.smoothing * dot(excess, own.across) * own.across;
    const float length = norm(shift), most = farthest_shift * spacing;
    out.shift[index] = length > most ? most / length * shift : shift;
  });
  return out;
}

}  // namespace freshet
