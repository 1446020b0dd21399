// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace freshet {

/// Random numbers without a state, so that they depend neither on threads nor on a restart: each is
/// a hash of the seed, of who draws, of when, and of how many draws came before.
class Draws {
 public:
  Draws(std::uint64_t seed, std::uint64_t who, std::uint64_t when)
      : key_(mixed(mixed(mixed(seed) ^ who) ^ when)) {}
  /// The next number, uniform in [0, 1).
  double next() { return double(mixed(key_ + ++drawn_) >> 11) * 0x1p-53; }

 private:
  /// The finalizer of SplitMix64 [Steele, Lea, Flood 2014].
  static std::uint64_t mixed(std::uint64_t z) {
    z += 0x9E3779B97F4A7C15u;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return z ^ z >> 31;
  }
  std::uint64_t key_, drawn_ = 0;
};

}  // namespace freshet
