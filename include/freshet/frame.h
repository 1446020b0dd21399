// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

namespace freshet {

/// The fluid at one moment, for pictures and data files: particles in the order of their ids,
/// 32-bit floats whatever the state is in. SI units.
struct Frame {
  int dimension = 2;
  std::int64_t step = 0;
  double time = 0;
  std::vector<std::uint64_t> id;
  std::vector<float> x, v;               ///< `dimension` numbers a particle: [m], [m/s]
  std::vector<float> density, pressure;  ///< one a particle, as computed in the last step:
                                         ///< [kg/m^D], [Pa; N/m in 2D]
  std::size_t size() const { return id.size(); }
};

}  // namespace freshet
