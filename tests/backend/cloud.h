// SPDX-License-Identifier: MIT
/// Particles at random places of a square (2D) or a cube (3D).
#pragma once
#include <cstdint>
#include <random>
#include <vector>

#include "core/field.h"

namespace freshet {

template <int D> struct Cloud {
  std::vector<Vec<D>> x;
  std::vector<std::uint64_t> id;
  Particles<D> particles;

  Cloud(int n, double size, double offset) : x(std::size_t(n)), id(std::size_t(n)) {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> at(offset, offset + size);
    for (Vec<D>& p : x)
      for (int k = 0; k < D; ++k) component(p, k) = Real(at(generator));
    particles.n = n;
    particles.x.data = x.data();
    particles.id.data = id.data();
  }

  /// The neighbours of particle i by brute force.
  std::vector<int> near(int i, Real h) const {
    std::vector<int> found;
    for (int j = 0; j < particles.n; ++j)
      if (norm2(x[i] - x[j]) < h * h) found.push_back(j);
    return found;
  }
};

}  // namespace freshet
