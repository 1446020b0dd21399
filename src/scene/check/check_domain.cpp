// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "freshet/real.h"
#include "kernels/poly6.h"
#include "kernels/scene_kernel.h"
#include "kernels/spiky.h"
#include "scene/check/findings.h"
#include "scene/keys/keys.h"
#include "scene/model/setup.h"

namespace freshet {
namespace {

constexpr double widest_support = 10;
constexpr double most_distance = 5e8;  // [m]; the cpu backend pads its lists with places at 1e9 m

/// W(0) and the gradient at a quarter of the support radius, both over their size [1].
template <int D, class Density, class Gradient>
std::array<double, 2> scaled(const Density& density, const Gradient& gradient, double support) {
  Vec<D> aside{};
  aside.x = Real(support / 4);
  const double volume = std::pow(support, D);
  return {double(density(Pair<D, Real>({}))) * volume,
          double(gradient.gradient(Pair<D, Real>(aside)).x) * volume * support};
}
template <int D> std::array<double, 2> scaled_kernels(const Scene& s, double support) {
  const auto h = Real(support);
  if (s.method().has_own_kernels()) return scaled<D>(Poly6<D>(h), Spiky<D>(h), support);
  const SceneKernel<D> W(h, s.solver.kernel);
  return scaled<D>(W, W, support);
}

/// Whether kernels of this support equal those of a support of 1 m, without overflow or underflow. Numbers lose bits before they underflow, which four times the support shows.
template <int D> bool kernels_are_normal(const Scene& s, double support) {
  const auto right = scaled_kernels<D>(s, 1);
  bool good = true;
  for (const double h : {support, 4 * support}) {
    const auto here = scaled_kernels<D>(s, h);
    for (std::size_t k = 0; k < 2; ++k)
      good = good && std::abs(here[k] - right[k]) < 1e-3 * std::abs(right[k]);
  }
  return good;
}

}  // namespace

bool good_domain(const Scene& s) {
  const std::size_t n = s.domain.max.size();
  if ((n != 2 && n != 3) || s.domain.min.size() != n) return false;
  for (std::size_t k = 0; k < n; ++k)
    if (!(s.domain.max[k] > s.domain.min[k])) return false;
  return true;
}

void check_domain(const Scene& s, Findings& out) {
  if (good_domain(s)) return;
  const std::size_t n = s.domain.max.size();
  if (n != 2 && n != 3)
    return out.error("domain.max", fmt::format("domain.max has {} numbers; set the upper corner, "
                                               "[x, y] in 2D or [x, y, z] in 3D",
                                               n));
  if (s.domain.min.size() != n) return;  // check_sizes reports it
  std::size_t flat = 0;
  while (s.domain.max[flat] > s.domain.min[flat]) ++flat;
  out.error("domain.max",
            fmt::format("domain.max is not above domain.min in {}; the domain needs a width{} "
                        "a height{}",
                        axis_names[flat], n == 2 ? " and" : ",", n == 2 ? "" : " and a depth"));
}

void check_sizes(const Scene& s, Findings& out) {
  const auto check = [&](const std::string& name, std::size_t n) {
    if (n != 0 && n != s.domain.max.size())
      out.error(name, fmt::format("{} has {} numbers; it must have {}, like domain.max", name, n,
                                  s.domain.max.size()));
  };
  const auto check_region = [&](const std::string& at, const Scene::Region& r) {
    check(at + "min", r.min.size());
    check(at + "max", r.max.size());
    check(at + "from", r.from.size());
    check(at + "count", r.count.size());
    check(at + "center", r.center.size());
    check(at + "axis", r.axis.size());
    check(at + "point", r.point.size());
    check(at + "normal", r.normal.size());
    if (const std::size_t n = r.rotation.size(); n != 0 && n != (s.dimension() == 2 ? 1u : 3u))
      out.error(at + "rotation", fmt::format("{}rotation has {} numbers; it must have {}", at, n,
                                             s.dimension() == 2 ? "1 in 2D" : "3 in 3D"));
    for (const Vector& p : r.points) check(at + "points", p.size());
    check(at + "translation", r.translation.size());
  };
  check("domain.min", s.domain.min.size());
  check("domain.gravity", s.domain.gravity.size());
  check("air.velocity", s.air.velocity.size());
  for (std::size_t k = 0; k < s.fluid.size(); ++k) {
    check_region(fmt::format("fluid[{}].", k), s.fluid[k]);
    check(fmt::format("fluid[{}].velocity", k), s.fluid[k].velocity.size());
  }
  for (std::size_t k = 0; k < s.wall.size(); ++k) {
    check_region(fmt::format("wall[{}].", k), s.wall[k]);
    check(fmt::format("wall[{}].velocity", k), s.wall[k].velocity.size());
  }
  const auto check_opening = [&](const std::string& at, const Scene::Opening& o) {
    check(at + "center", o.center.size());
    check(at + "direction", o.direction.size());
    check(at + "up", o.up.size());
  };
  for (std::size_t k = 0; k < s.inlet.size(); ++k)
    check_opening(fmt::format("inlet[{}].", k), s.inlet[k]);
  for (std::size_t k = 0; k < s.outlet.size(); ++k)
    check_region(fmt::format("outlet[{}].", k), s.outlet[k]);
  for (std::size_t k = 0; k < s.counter.size(); ++k)
    check_opening(fmt::format("counter[{}].", k), s.counter[k]);
  for (std::size_t k = 0; k < s.body.size(); ++k) {
    const Scene::Body& b = s.body[k];
    const std::string at = fmt::format("body[{}].", k);
    check_region(at, b);
    check(at + "pivot", b.pivot.size());
    check(at + "turn_axis", b.turn_axis.size());
    check(at + "velocity", b.velocity.size());
    check(at + "center_of_mass", b.center_of_mass.size());
    for (std::size_t j = 0; j < b.key.size(); ++j)
      check(fmt::format("{}key[{}].translation", at, j), b.key[j].translation.size());
  }
  for (std::size_t k = 0; k < s.joint.size(); ++k) {
    check(fmt::format("joint[{}].point", k), s.joint[k].point.size());
    check(fmt::format("joint[{}].axis", k), s.joint[k].axis.size());
  }
  for (std::size_t k = 0; k < s.camera.size(); ++k) {
    check(fmt::format("camera[{}].position", k), s.camera[k].position.size());
    check(fmt::format("camera[{}].target", k), s.camera[k].target.size());
  }
}

void check_periodic(const Scene& s, Findings& out) {
  for (int k = 0; k < 3; ++k) {
    if (!s.periodic(k)) continue;
    if (k >= s.dimension()) {
      out.error("domain.periodic",
                fmt::format("domain.periodic is \"{0}\", and the domain has no {1}; remove {1}, or "
                            "add a third number to domain.max",
                            axes_words[int(s.domain.periodic)], axis_names[k]));
      continue;
    }
    const auto j = std::size_t(k);
    const double length = s.domain.max[j] - s.domain.min[j];
    if (length < 2 * support_radius(s))
      out.error("domain.periodic",
                fmt::format("the domain is {:.6g} m long in {}, less than twice the support radius "
                            "of {:.6g} m: a particle would interact with two images of another; "
                            "make it longer, or the spacing smaller",
                            length, axis_names[k], support_radius(s)));
  }
}

bool check_particles(const Scene& s, Findings& out) {
  const auto& p = s.particles;
  const double support = support_radius(s);
  const bool neighbors = support > p.spacing, few = support <= widest_support * p.spacing;
  if (!neighbors)
    out.error("particles.support_radius",
              fmt::format("particles.support_radius is {}, not above the spacing {}: no particle "
                          "would have a neighbour; 2 × spacing is usual",
                          support, p.spacing));
  if (!few)
    out.error("particles.support_radius",
              fmt::format("particles.support_radius is {:.4g} times the spacing; at most {} times "
                          "are allowed, 2 are usual",
                          support / p.spacing, widest_support));
  if (p.jitter > p.spacing / 2)
    out.error("particles.jitter",
              fmt::format("particles.jitter is {}; at most half the spacing, {:.6g}, is allowed",
                          p.jitter, p.spacing / 2));
  const bool normal =
      s.dimension() == 3 ? kernels_are_normal<3>(s, support) : kernels_are_normal<2>(s, support);
  if (!normal)
    out.error(
        p.support_radius ? "particles.support_radius" : "particles.spacing",
        fmt::format("a spacing of {:.4g} m with a support radius of {:.4g} m is out of range for "
                    "{} in {}D: {}-bit numbers cannot hold its kernels; make both {} and scale the "
                    "scene with them{}{}",
                    p.spacing, support, s.method().name, s.dimension(), 8 * sizeof(Real),
                    support < 1 ? "larger" : "smaller",
                    s.method().has_own_kernels() ? ", choose another solver" : "", or_in_double));
  return neighbors && few && normal;
}

/// The resolution of positions decreases with the distance from origin_of() the scene.
bool check_resolution(const Scene& s, Findings& out) {
  const double far = farthest_position(s), coarse = rounding_of_positions(s);
  if (far > most_distance) {
    out.error("domain.max", fmt::format("the domain extends {:.3g} m; at most {:g} m are allowed; "
                                        "make it smaller",
                                        far, most_distance));
    return false;
  }
  if (s.particles.spacing >= 100 * coarse) return true;
  out.error("particles.spacing",
            fmt::format("particles.spacing is {}, too fine for a domain that extends {:.3g} m, "
                        "where {}-bit numbers are {:.2g} m apart; make it larger, or the domain "
                        "smaller",
                        s.particles.spacing, far, 8 * sizeof(Real), coarse));
  return false;
}

}  // namespace freshet
