// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace freshet {

/// SHA-256 [FIPS 180-4] of bytes added in pieces. With it freshet_sim needs no cryptographic
/// library.
class Sha256 {
 public:
  void add(const void* data, std::size_t bytes);
  /// The digest as 64 hexadecimal digits. Call it once: it pads the message.
  std::string hex();

 private:
  void add_block(const unsigned char* block);

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, 64> block_{};
  std::uint64_t bytes_ = 0;
};

}  // namespace freshet
