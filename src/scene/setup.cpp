// SPDX-License-Identifier: MIT
#include "scene/setup.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "kernels/lattice_sum.h"
#include "kernels/poly6.h"
#include "kernels/spiky.h"
#include "scene/check.h"
#include "scene/schedule.h"

namespace freshet {
namespace {

/// The share of a linear field's slope that the discrete Spiky gradient sees on the lattice, less
/// 1: -sum_j dx^D x_j d/dx W(x_j), which is 1 in the continuum.
double gradient_error(double spacing, double support) {
  const Spiky<2> W{Real(support)};
  const int m = int(support / spacing) + 1;
  double sum = 0;
  for (int ky = -m; ky <= m; ++ky)
    for (int kx = -m; kx <= m; ++kx) {
      const Vec<2> x{Real(kx * spacing), Real(ky * spacing)};
      sum -= double(x.x) * double(W.gradient(Pair<2, Real>(x)).x);
    }
  return sum * spacing * spacing - 1;
}

int neighbors_within(double support, double spacing) {
  const int m = int(support / spacing) + 1;
  int count = -1;  // not itself
  for (int ky = -m; ky <= m; ++ky)
    for (int kx = -m; kx <= m; ++kx) count += std::hypot(kx * spacing, ky * spacing) < support;
  return count;
}

}  // namespace

double Lattice::particles() const {
  double n = 1;
  for (const auto c : count) n *= double(c);
  return n;
}

Vector Lattice::last(double spacing) const {
  Vector end = from;
  for (std::size_t k = 0; k < end.size(); ++k) end[k] += double(count[k] - 1) * spacing;
  return end;
}

Lattice lattice_of(const Scene::Fluid& f, double spacing) {
  if (f.shape == Shape::lattice) return {f.from, f.count};
  Lattice lattice{f.min, {}};
  for (std::size_t k = 0; k < f.min.size(); ++k) {
    lattice.from[k] += spacing / 2;
    const double n = std::round((f.max[k] - f.min[k]) / spacing);
    lattice.count.push_back(std::int64_t(std::fmin(n, 9e15)));
  }
  return lattice;
}

Derived derive(const Scene& s) {
  check_scene(s);
  Derived d{};
  for (const Scene::Fluid& f : s.fluid)
    d.particles += lattice_of(f, s.particles.spacing).particles();
  for (const Scene::Fluid& f : s.fluid)
    if (f.outside == Outside::clamp) d.outside = sample(s).outside;  // elsewhere it is an error
  d.frames = Schedule(s).frames();
  d.spacing = s.particles.spacing;
  d.support_radius = s.particles.support_radius.value_or(2 * d.spacing);
  d.rest_density = s.fluid.at(0).rest_density;
  d.viscosity = s.fluid[0].viscosity;
  const double lattice =
      lattice_sum<2>(Poly6<2>(Real(d.support_radius)), d.spacing, d.support_radius);
  d.density_error = lattice - 1;
  d.gradient_error = gradient_error(d.spacing, d.support_radius);
  d.neighbors = neighbors_within(d.support_radius, d.spacing);
  d.mass = s.particles.mass.value_or(d.rest_density * d.spacing * d.spacing);
  d.lattice_sum = s.particles.mass ? 1 : lattice;

  const double gravity = std::hypot(s.domain.gravity[0], s.domain.gravity[1]);
  const double fastest2 = 2 * gravity * (s.domain.max[1] - s.domain.min[1]);
  d.stiffness = s.solver.stiffness.value_or(100 * fastest2);
  d.sound_speed = std::sqrt(d.stiffness);
  const double h = d.support_radius / 2;
  d.acoustic_step = 0.4 * h / d.sound_speed;
  d.force_step = 0.25 * std::sqrt(h / gravity);
  d.viscous_step = 0.125 * h * h * d.rest_density / d.viscosity;
  return d;
}

double Derived::step_bound() const { return std::min({acoustic_step, force_step, viscous_step}); }

const char* Derived::step_bound_name() const {
  const double bound = step_bound();
  return bound == acoustic_step ? "speed of sound" : bound == force_step ? "gravity" : "viscosity";
}

Sample sample(const Scene& scene) {
  Sample all;
  const Vector &min = scene.domain.min, &max = scene.domain.max;
  const Real spacing = Real(scene.particles.spacing);
  const float jitter = float(scene.particles.jitter);  // the same offsets in a double build
  std::mt19937 generator(static_cast<std::mt19937::result_type>(scene.particles.seed));
  std::uniform_real_distribution<float> offset(-jitter, jitter);
  for (const Scene::Fluid& f : scene.fluid) {
    const Lattice lattice = lattice_of(f, scene.particles.spacing);
    for (std::int64_t row = 0; row < lattice.count[1]; ++row)
      for (std::int64_t column = 0; column < lattice.count[0]; ++column) {
        Real x = Real(lattice.from[0]) + Real(column) * spacing;
        Real y = Real(lattice.from[1]) + Real(row) * spacing;
        if (jitter > 0) {  // y is drawn first, as g++ evaluates the article's arguments
          y += offset(generator);
          x += offset(generator);
        }
        all.outside += x < min[0] || x > max[0] || y < min[1] || y > max[1];
        all.x.insert(all.x.end(), {x, y});
        all.v.insert(all.v.end(), {Real(f.velocity[0]), Real(f.velocity[1])});
      }
  }
  return all;
}

}  // namespace freshet
