// SPDX-License-Identifier: MIT
/// The grid of a surface. Its points are grouped in blocks, and particles in bins. Lengths are in
/// grid cells.
#pragma once
#include <cstdint>

namespace freshet {

inline constexpr int bin_cells = 4;    ///< edge of a bin
inline constexpr int block_bins = 2;   ///< edge of a block in bins
inline constexpr int block_cells = 8;  ///< edge of a block, and its points along an axis
inline constexpr int block_points = block_cells * block_cells * block_cells;

/// The integer coordinates of a bin or a block.
struct Place {
  int x, y, z;
  friend Place operator+(Place a, Place b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Place operator-(Place a, Place b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Place operator*(int s, Place a) { return {s * a.x, s * a.y, s * a.z}; }
};

inline constexpr int key_bits = 21;
/// The largest magnitude of a coordinate that a key holds, with room for neighbours.
inline constexpr int farthest_place = (1 << (key_bits - 1)) - 64;

/// A number that orders places by z, then y, then x.
constexpr std::uint64_t key_of(Place p) {
  const auto part = [](int k) { return std::uint64_t(k + (1 << (key_bits - 1))); };
  return part(p.z) << (2 * key_bits) | part(p.y) << key_bits | part(p.x);
}
constexpr Place place_of(std::uint64_t key) {
  const auto part = [](std::uint64_t k) {
    return int(k & ((std::uint64_t(1) << key_bits) - 1)) - (1 << (key_bits - 1));
  };
  return {part(key), part(key >> key_bits), part(key >> (2 * key_bits))};
}

/// floor(a/b) for b > 0.
constexpr int floor_div(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

/// The index of a point in its block; x is fastest.
constexpr int point_index(int x, int y, int z) { return (z * block_cells + y) * block_cells + x; }

}  // namespace freshet
