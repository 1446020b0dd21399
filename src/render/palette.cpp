// SPDX-License-Identifier: MIT
#include "render/palette.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace freshet {
namespace {

constexpr std::size_t palette_size = 256;

/// The pixels whose channels agree in their upper five bits.
struct Bin {
  std::uint64_t count = 0;
  std::array<std::uint64_t, 3> sum{};  // of the channels
  int index = 0;                       // in the histogram
  double mean(int channel) const { return double(sum[std::size_t(channel)]) / double(count); }
};

int bin_of(Color c) { return c.r >> 3 << 10 | c.g >> 3 << 5 | c.b >> 3; }

/// Consecutive bins that get one colour.
struct ColorBox {
  std::size_t first, last;  // last is excluded
  int channel = 0;          // of the greatest span
  double weight = 0;        // span² times the number of pixels; 0 for a single bin

  ColorBox(std::size_t first, std::size_t last, const std::vector<Bin>& bins)
      : first(first), last(last) {
    std::uint64_t pixels = 0;
    for (std::size_t k = first; k < last; ++k) pixels += bins[k].count;
    double widest = 0;
    for (int c = 0; c < 3; ++c) {
      const auto [low, high] = std::minmax_element(
          bins.begin() + std::ptrdiff_t(first), bins.begin() + std::ptrdiff_t(last),
          [c](const Bin& a, const Bin& b) { return a.mean(c) < b.mean(c); });
      const double span = high->mean(c) - low->mean(c);
      if (span <= widest) continue;
      widest = span;
      channel = c;
    }
    weight = last - first > 1 ? widest * widest * double(pixels) : 0;
  }
};

/// Sorts the bins of a box along its channel and returns the first bin of the upper half.
std::size_t split(const ColorBox& box, std::vector<Bin>& bins) {
  const auto first = bins.begin() + std::ptrdiff_t(box.first),
             last = bins.begin() + std::ptrdiff_t(box.last);
  std::sort(first, last, [c = box.channel](const Bin& a, const Bin& b) {
    return a.mean(c) != b.mean(c) ? a.mean(c) < b.mean(c) : a.index < b.index;
  });
  std::uint64_t all = 0, below = 0;
  for (auto bin = first; bin != last; ++bin) all += bin->count;
  std::size_t middle = box.first;
  while (middle + 1 < box.last && 2 * (below += bins[middle].count) < all) ++middle;
  return std::clamp(middle + (middle == box.first), box.first + 1, box.last - 1);
}

std::vector<Bin> histogram_of(const Image& image) {
  std::vector<Bin> all(1 << 15), used;
  for (const Color c : image.pixels) {
    Bin& bin = all[std::size_t(bin_of(c))];
    ++bin.count;
    bin.sum[0] += c.r;
    bin.sum[1] += c.g;
    bin.sum[2] += c.b;
  }
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k].index = int(k);
    if (all[k].count > 0) used.push_back(all[k]);
  }
  return used;
}

}  // namespace

PalettedImage reduce_colors(const Image& image) {
  std::vector<Bin> bins = histogram_of(image);
  PalettedImage out{image.width, image.height, {}, {}};
  if (bins.empty()) return out;
  std::vector<ColorBox> boxes{ColorBox(0, bins.size(), bins)};
  while (boxes.size() < palette_size) {
    const auto widest =
        std::max_element(boxes.begin(), boxes.end(),
                         [](const ColorBox& a, const ColorBox& b) { return a.weight < b.weight; });
    if (!(widest->weight > 0)) break;
    const ColorBox box = *widest;
    const std::size_t middle = split(box, bins);
    *widest = ColorBox(box.first, middle, bins);
    boxes.emplace_back(middle, box.last, bins);
  }
  std::vector<std::uint8_t> place(1 << 15);
  for (const ColorBox& box : boxes) {
    Bin sum;
    for (std::size_t k = box.first; k < box.last; ++k) {
      sum.count += bins[k].count;
      for (std::size_t c = 0; c < 3; ++c) sum.sum[c] += bins[k].sum[c];
      place[std::size_t(bins[k].index)] = std::uint8_t(out.colors.size());
    }
    const auto channel = [&](int c) { return std::uint8_t(sum.mean(c) + 0.5); };
    out.colors.push_back({channel(0), channel(1), channel(2)});
  }
  out.pixels.reserve(image.pixels.size());
  for (const Color c : image.pixels) out.pixels.push_back(place[std::size_t(bin_of(c))]);
  return out;
}

}  // namespace freshet
