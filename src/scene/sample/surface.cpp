// SPDX-License-Identifier: MIT
#include "scene/sample/surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace freshet {
namespace {

constexpr double half_turn = std::numbers::pi;
constexpr double closest = 0.7;  // spacings: minimum distance of two points of a ring

template <int D> Vec<D, double> axis_of(int k) {
  Vec<D, double> e{};
  component(e, k) = 1;
  return e;
}

/// D - 1 unit vectors perpendicular to n and to each other; along axes if n is along an axis.
template <int D> std::vector<Vec<D, double>> across(Vec<D, double> n) {
  if constexpr (D == 2) {
    return {std::abs(n.x) > std::abs(n.y) ? Vec<2, double>{-n.y, n.x} : Vec<2, double>{n.y, -n.x}};
  } else {
    int least = 0;
    for (int k = 1; k < D; ++k)
      if (std::abs(component(n, k)) < std::abs(component(n, least))) least = k;
    auto u = cross(axis_of<3>(least), n);
    u = u / norm(u);
    return {u, cross(n, u)};
  }
}

}  // namespace

template <int D> std::vector<Vec<D, double>> Surface<D>::points(Point low, Point high, Point cell) {
  all_.clear();
  if (solid_.kind == SolidKind::box) box();
  for (int k = 0; k < layers_; ++k) {
    const double behind = (k + 0.5) * spacing_, outward = solid_.fluid_inside ? behind : -behind;
    if (solid_.kind == SolidKind::ball) ball(solid_.radius + outward);
    if (solid_.kind == SolidKind::cylinder)
      cylinder(solid_.radius + outward, solid_.half_length + outward);
    if (solid_.kind == SolidKind::plane) plane(outward, low, high, cell);
  }
  return std::move(all_);
}

/// Layers of a lattice that fits the box: the outermost ones in it, or those around it.
template <int D> void Surface<D>::box() {
  Counts n, beyond(D, layers_);
  Point corner = solid_.center - solid_.half, cell{}, half = solid_.half;
  for (int k = 0; k < D; ++k) {
    const double side = 2 * component(half, k);
    n.push_back(std::max<std::int64_t>(1, std::llround(side / spacing_)));
    component(cell, k) = side / double(n.back());
  }
  if (!solid_.fluid_inside) {  // the layers are around the inner part of the lattice
    for (int k = 0; k < D; ++k) {
      const std::int64_t layers = std::min<std::int64_t>(layers_, (n[std::size_t(k)] + 1) / 2);
      component(corner, k) += double(layers) * component(cell, k);
      beyond[std::size_t(k)] = layers;
      n[std::size_t(k)] = n[std::size_t(k)] - 2 * layers;
    }
  }
  around_lattice<D>(n, beyond, [&](const Counts& c) {
    Point x = corner;
    for (int k = 0; k < D; ++k)
      component(x, k) += (double(c[std::size_t(k)]) + 0.5) * component(cell, k);
    all_.push_back(x);
  });
}

template <int D> bool Surface<D>::ring(Point center, Point u, Point v, double radius) {
  const double r = radius / spacing_;
  if (r < -0.3) return false;
  if (2 * r < closest) {
    all_.push_back(center);
    return false;
  }
  const int n = 2 * r < 0.9 ? 2 : std::max(3, int(std::lround(2 * half_turn * r)));
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * half_turn * (k + 0.5) / n;
    all_.push_back(center + radius * std::cos(angle) * u + radius * std::sin(angle) * v);
  }
  return true;
}

template <int D> void Surface<D>::disc(Point center, Point u, Point v, double radius) {
  while (ring(center, u, v, radius)) radius -= spacing_;
}

template <int D> void Surface<D>::ball(double radius) {
  if constexpr (D == 2) {
    ring(solid_.center, axis_of<2>(0), axis_of<2>(1), radius);
  } else {
    if (2 * radius < closest * spacing_) {
      ring(solid_.center, axis_of<3>(0), axis_of<3>(2), radius);
      return;
    }
    const int rings = std::max(2, int(std::lround(half_turn * radius / spacing_)));
    for (int k = 0; k < rings; ++k) {  // from pole to pole
      const double angle = half_turn * (k + 0.5) / rings;
      ring(solid_.center + radius * std::cos(angle) * axis_of<3>(1), axis_of<3>(0), axis_of<3>(2),
           radius * std::sin(angle));
    }
  }
}

/// Rings on the lateral surface, and discs on the two caps.
template <int D> void Surface<D>::cylinder(double radius, double half_length) {
  if constexpr (D == 3) {
    const auto sides = across<3>(solid_.axis);
    const auto center = [&](double along) { return solid_.center + along * solid_.axis; };
    if (radius < -0.3 * spacing_ || half_length < -0.3 * spacing_) return;
    if (2 * half_length < closest * spacing_)
      return disc(solid_.center, sides[0], sides[1], radius);
    const int gaps = std::max(1, int(std::lround(2 * half_length / spacing_)));
    for (int k = 0; k <= gaps; ++k) {
      const Point middle = center(half_length * (2.0 * k / gaps - 1));
      if (k == 0 || k == gaps) disc(middle, sides[0], sides[1], radius);
      else ring(middle, sides[0], sides[1], radius);
    }
  }
}

template <int D> void Surface<D>::plane(double outward, Point low, Point high, Point cell) {
  const auto sides = across<D>(solid_.axis);
  const Point middle = 0.5 * (low + high);
  // the middle, projected onto the layer
  const Point foot = middle + (dot(solid_.center - middle, solid_.axis) + outward) * solid_.axis;
  std::int64_t reach[2] = {0, 0};
  Point step[2] = {};
  for (int s = 0; s < D - 1; ++s) {
    double length = 0, apart = spacing_;
    for (int k = 0; k < D; ++k) {
      auto side = sides[std::size_t(s)], diagonal = high - low;
      length += std::abs(component(side, k) * component(diagonal, k));
      if (std::abs(component(side, k)) == 1) apart = component(cell, k);
    }
    reach[s] = std::int64_t(length / 2 / apart) + 1;
    step[s] = apart * sides[std::size_t(s)];
  }
  for (std::int64_t b = -reach[1]; b <= (D == 3 ? reach[1] : 0); ++b)
    for (std::int64_t a = -reach[0]; a <= reach[0]; ++a) {
      Point x = foot + (double(a) + 0.5) * step[0];
      if (D == 3) x += (double(b) + 0.5) * step[1];
      bool inside = true;
      for (int k = 0; k < D; ++k)
        inside &= component(x, k) >= component(low, k) && component(x, k) <= component(high, k);
      if (inside) all_.push_back(x);
    }
}

template class Surface<2>;
template class Surface<3>;

}  // namespace freshet
