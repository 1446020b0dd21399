// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "scene/sample/places.h"

namespace freshet {
namespace {

using FluidPair = std::pair<std::size_t, std::size_t>;

/// Whether the complete lattices come closer than half a spacing. True for points, which have none.
bool lattices_meet(const Lattice& a, const Lattice& b, double spacing) {
  const Vector last_a = a.last(spacing), last_b = b.last(spacing);
  for (std::size_t k = 0; k < std::min(last_a.size(), last_b.size()); ++k)
    if (a.from[k] >= last_b[k] + spacing / 2 || b.from[k] >= last_a[k] + spacing / 2) return false;
  return true;
}

template <int D, class Test> bool any(const Places<D>& places, const Test& test) {
  bool met = false;
  places.each([&](Vec<D> x, std::size_t) {
    met = test(x);
    return !met;
  });
  return met;
}

/// Compares place by place. In a lattice only one place can be near, so that no list is needed.
template <int D> bool places_meet(const Scene& s, std::size_t a, std::size_t b) {
  const Places<D> one(s, s.fluid[a]), two(s, s.fluid[b]);
  if (one.is_lattice()) return any(two, [&](Vec<D> x) { return one.comes_near(x); });
  if (two.is_lattice()) return any(one, [&](Vec<D> x) { return two.comes_near(x); });
  PointGrid<D> grid(0.499 * s.particles.spacing);
  two.each([&](Vec<D> x, std::size_t) {
    grid.add(to_double(x));
    return true;
  });
  return any(one, [&](Vec<D> x) { return grid.comes_near(to_double(x)); });
}

}  // namespace

std::vector<FluidPair> overlapping_fluids(const Scene& s, const std::vector<std::size_t>& good) {
  std::vector<Lattice> lattices;
  for (const std::size_t k : good) lattices.push_back(lattice_of(s, s.fluid[k]));
  std::vector<FluidPair> met;
  for (std::size_t b = 0; b < good.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) {
      const std::size_t j = good[a], k = good[b];
      if (!lattices_meet(lattices[a], lattices[b], s.particles.spacing)) continue;
      const bool blocks = is_block(s.fluid[j]) && is_block(s.fluid[k]);
      if (blocks || (s.dimension() == 2 ? places_meet<2>(s, j, k) : places_meet<3>(s, j, k)))
        met.emplace_back(j, k);
    }
  return met;
}

}  // namespace freshet
