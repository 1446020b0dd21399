// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "render/band.h"

namespace freshet {

inline constexpr int band_rows = 8 * oversampling;  ///< samples; a band fits into a cache

inline int band_count(int samples_high) { return (samples_high + band_rows - 1) / band_rows; }

/// Band k of a picture with this size in samples.
inline Band band_of(int k, int width, int height, Color ground) {
  const int top = k * band_rows;
  return {width, top, std::min(band_rows, height - top), ground};
}

/// The items that each band of rows may contain, in order.
class Bands {
 public:
  Bands() = default;
  /// rows_of(k) returns the first and the last row of item k < n [samples]; they may lie outside
  /// the picture.
  template <class F>
  Bands(std::size_t n, int samples_high, F rows_of)
      : starts_(std::size_t(band_count(samples_high)) + 2) {
    const auto each = [&](auto f) {
      for (std::uint32_t k = 0; k < n; ++k) {
        const auto [first_row, last_row] = rows_of(k);
        if (last_row < 0) continue;
        const int last = std::min(last_row, samples_high - 1) / band_rows;
        for (int band = std::max(0, first_row) / band_rows; band <= last; ++band)
          f(std::size_t(band), k);
      }
    };
    each([&](std::size_t band, std::uint32_t) { ++starts_[band + 2]; });
    for (std::size_t k = 2; k < starts_.size(); ++k) starts_[k] += starts_[k - 1];
    list_.resize(starts_.back());
    each([&](std::size_t band, std::uint32_t k) { list_[starts_[band + 1]++] = k; });
  }
  template <class F> void each_in(int band, F f) const {
    for (std::size_t k = starts_[std::size_t(band)]; k < starts_[std::size_t(band) + 1]; ++k)
      f(list_[k]);
  }

 private:
  std::vector<std::size_t> starts_;
  std::vector<std::uint32_t> list_;
};

}  // namespace freshet
