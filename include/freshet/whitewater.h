// SPDX-License-Identifier: MIT
/// Spray, foam and bubbles.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "freshet/real.h"

namespace freshet {

/// By the number of fluid particles around: few, about half of those inside, or nearly all.
enum class WhitewaterKind { spray, foam, bubble };

/// A read-only view of the whitewater, valid until the next step. It is advanced when the fluid has
/// moved by a share of the spacing, last `elapsed` [s] ago.
struct WhitewaterView {
  int dimension = 2;
  std::span<const std::uint64_t> id;
  std::span<const Real> x, v;  ///< relative to `origin` at the last advance [m]; [m/s]
  std::span<const int> kind;   ///< a WhitewaterKind
  std::span<const Real> age;   ///< since birth, at the last advance [s]
  double elapsed = 0;
  std::uint64_t refused = 0;  ///< births so far for which there was no room
  std::array<double, 3> origin{};
  /// Coordinate d of particle i now [m].
  double position(std::size_t i, std::size_t d) const {
    const std::size_t k = std::size_t(dimension) * i + d;
    return origin[d] + double(x[k]) + elapsed * double(v[k]);
  }
  std::size_t size() const { return id.size(); }
};

/// Spray, foam and bubbles at one time, in the order of their ids. SI units.
struct WhitewaterFrame {
  std::vector<std::uint64_t> id;
  std::vector<float> x, v;  ///< `dimension` numbers per particle: [m], [m/s]
  std::vector<int> kind;    ///< a WhitewaterKind
  std::vector<float> age;   ///< [s]
  std::size_t size() const { return id.size(); }
};

}  // namespace freshet
