// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace freshet {

/// An array of an engine's state: `components` numbers for each of `count` particles. It is a view
/// of the engine's memory; writing through `data` restores the state.
struct StateArray {
  enum class Number { int32, uint64, float32, float64 };
  /// kept: a field of the fluid that counts in kept_sha256. fixed: a field of walls, which a
  /// restart samples again from the scene. other: any other state.
  enum class Role { kept, other, fixed };
  std::string name;  ///< "SET/FIELD"
  std::byte* data;
  std::int64_t count;
  int components;
  Number number;
  Role role;

  std::size_t bytes_per_particle() const {
    const bool narrow = number == Number::int32 || number == Number::float32;
    return std::size_t(components) * (narrow ? 4 : 8);
  }
  std::size_t bytes() const { return std::size_t(count) * bytes_per_particle(); }
};

}  // namespace freshet
