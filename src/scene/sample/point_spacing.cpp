// SPDX-License-Identifier: MIT
#include "scene/sample/point_spacing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace freshet {
namespace {

/// Points sorted along the axis of their largest extent, beyond which a search need not look.
class SortedPoints {
 public:
  SortedPoints(const std::vector<double>& x, std::size_t dimension) : x_(x), d_(dimension) {
    Longest longest{};
    for (std::size_t k = 0; k < d_; ++k) {
      double low = x[k], high = x[k];
      for (std::size_t i = k; i < x.size(); i += d_) {
        low = std::min(low, x[i]);
        high = std::max(high, x[i]);
      }
      if (high - low >= longest.extent) longest = {high - low, k};
    }
    axis_ = longest.axis;
    for (std::size_t i = 0; i < x.size() / d_; ++i) order_.push_back(i);
    std::sort(order_.begin(), order_.end(),
              [&](std::size_t a, std::size_t b) { return along(a) < along(b); });
  }
  std::size_t size() const { return order_.size(); }

  /// The distance of the k-th point to its nearest neighbour.
  double nearest(std::size_t k) const {
    double best2 = std::numeric_limits<double>::infinity();
    const auto look = [&](std::size_t j) {
      const double ahead = along(order_[j]) - along(order_[k]);
      if (ahead * ahead >= best2) return false;
      double r2 = 0;
      for (std::size_t c = 0; c < d_; ++c) {
        const double r = x_[order_[j] * d_ + c] - x_[order_[k] * d_ + c];
        r2 += r * r;
      }
      best2 = std::min(best2, r2);
      return true;
    };
    for (std::size_t j = k + 1; j < size() && look(j);) ++j;
    for (std::size_t j = k; j > 0 && look(j - 1);) --j;
    return std::sqrt(best2);
  }

 private:
  struct Longest {
    double extent;
    std::size_t axis;
  };
  double along(std::size_t i) const { return x_[i * d_ + axis_]; }

  const std::vector<double>& x_;
  std::size_t d_, axis_ = 0;
  std::vector<std::size_t> order_;
};

}  // namespace

double median_spacing(const std::vector<double>& x, int dimension) {
  constexpr std::size_t most = 1000;
  const auto d = std::size_t(dimension);
  if (x.size() < 2 * d) return 0;
  const SortedPoints points(x, d);
  std::vector<double> nearest;
  const std::size_t stride = std::max<std::size_t>(1, points.size() / most);
  for (std::size_t k = 0; k < points.size(); k += stride) nearest.push_back(points.nearest(k));
  const auto middle = nearest.begin() + std::ptrdiff_t(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  return *middle;
}

}  // namespace freshet
