// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <cstring>
#include <string>

#include "freshet/checkpoint.h"

namespace freshet {

/// Maximum of counters in a checkpoint: every whole number up to it is a double.
inline constexpr std::int64_t most_counted = std::int64_t(1) << 53;

/// Throws Error (kind run): this checkpoint is invalid for a reason, use another.
[[noreturn]] void fail_for_checkpoint(const std::string& why);

/// Checks what must hold for a checkpoint of any scene, as another program can write one with the
/// right digest: lengths, counters, times, and finite positions, velocities and bodies. Throws
/// Error (kind run) without a place.
void check_checkpoint(const Checkpoint& checkpoint);

/// The k-th number of an array whose length has been checked.
template <class T> T number_at(const Checkpoint::Array& a, std::size_t k) {
  T value;
  std::memcpy(&value, a.bytes.data() + k * sizeof value, sizeof value);
  return value;
}

}  // namespace freshet
