// SPDX-License-Identifier: MIT
#include "render/balls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "render/dots.h"

namespace freshet {
namespace {

using Point = std::array<double, 3>;

constexpr Color background{8, 10, 28}, edge{80, 80, 120};
constexpr double margin = 0.04;             // of the picture
constexpr float dimmest_full_speed = 0.1f;  // m/s that at least stand for red

/// Turned about y, then tipped towards the eye: x to the right, y up, z towards the eye.
struct View {
  static constexpr double turn = -0.5, tip = 0.42;  // radians
  double scale, left, top;

  static Point turned(const Point& p) {
    const double x = p[0] * std::cos(turn) + p[2] * std::sin(turn);
    const double z = p[2] * std::cos(turn) - p[0] * std::sin(turn);
    return {x, p[1] * std::cos(tip) - z * std::sin(tip), z * std::cos(tip) + p[1] * std::sin(tip)};
  }
  /// In pixels, and the depth in pixels too.
  Point operator()(const Point& p) const {
    const Point t = turned(p);
    return {left + scale * t[0], top - scale * t[1], scale * t[2]};
  }
};

std::array<Point, 8> corners(const Scene& s) {
  std::array<Point, 8> all;
  for (std::size_t k = 0; k < 8; ++k)
    for (std::size_t d = 0; d < 3; ++d) all[k][d] = k >> d & 1 ? s.domain.max[d] : s.domain.min[d];
  return all;
}

View fit(const Scene& s) {
  Point low{1e300, 1e300, 0}, high{-1e300, -1e300, 0};
  for (const Point& corner : corners(s)) {
    const Point t = View::turned(corner);
    for (std::size_t d = 0; d < 2; ++d) {
      low[d] = std::min(low[d], t[d]);
      high[d] = std::max(high[d], t[d]);
    }
  }
  const double width = double(s.picture.width), height = double(s.picture.height);
  const double scale =
      (1 - 2 * margin) * std::min(width / (high[0] - low[0]), height / (high[1] - low[1]));
  return {scale, width / 2 - scale * (low[0] + high[0]) / 2,
          height / 2 + scale * (low[1] + high[1]) / 2};
}

/// The edges of the domain, those in front drawn dotted over what is behind them.
void draw_edges(Image& image, const Scene& s, const View& view) {
  const auto all = corners(s);
  for (unsigned k = 0; k < 8; ++k)
    for (unsigned d = 0; d < 3; ++d) {
      if (k >> d & 1) continue;
      const Point a = view(all[k]), b = view(all[k | 1u << d]);
      const int steps = int(std::hypot(b[0] - a[0], b[1] - a[1])) + 1;
      for (int t = 0; t <= steps; ++t) {
        const double f = double(t) / steps;
        const int x = int(a[0] + f * (b[0] - a[0])), y = int(a[1] + f * (b[1] - a[1]));
        if (image.holds(x, y)) image.at(x, y) = edge;
      }
    }
}

Color lit(Color c, double light) {
  const auto part = [&](std::uint8_t v) {
    return std::uint8_t(std::clamp(double(v) * light, 0.0, 255.0));
  };
  return {part(c.r), part(c.g), part(c.b)};
}

class Canvas {
 public:
  explicit Canvas(Image& image)
      : image_(image), depth_(image.pixels.size(), -std::numeric_limits<double>::infinity()) {}

  void ball(const Point& p, double radius, Color color) {
    const int reach = int(radius) + 1;
    for (int y = int(p[1]) - reach; y <= int(p[1]) + reach; ++y)
      for (int x = int(p[0]) - reach; x <= int(p[0]) + reach; ++x) {
        if (!image_.holds(x, y)) continue;
        const double dx = (x + 0.5 - p[0]) / radius, dy = (y + 0.5 - p[1]) / radius;
        const double d2 = dx * dx + dy * dy;
        if (d2 > 1) continue;
        const double dz = std::sqrt(1 - d2), z = p[2] + radius * dz;
        double& deepest = depth_[std::size_t(y) * std::size_t(image_.width) + std::size_t(x)];
        if (z <= deepest) continue;
        deepest = z;
        const double lambert = std::max(0.0, -0.45 * dx - 0.65 * dy + 0.61 * dz);
        image_.at(x, y) = lit(color, 0.35 + 0.75 * lambert);
      }
  }

 private:
  Image& image_;
  std::vector<double> depth_;
};

}  // namespace

Image draw_balls(const Scene& scene, const Frame& fluid) {
  Image image(int(scene.picture.width), int(scene.picture.height), background);
  const View view = fit(scene);
  draw_edges(image, scene, view);
  std::vector<float> speeds;
  float fastest = dimmest_full_speed;
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const auto* v = &fluid.v[3 * i];
    speeds.push_back(std::sqrt(float(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])));
    fastest = std::max(fastest, speeds.back());
  }
  Canvas canvas(image);
  const double radius = std::max(1.0, view.scale * scene.particles.spacing / 2);
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const auto* x = &fluid.x[3 * i];
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2])) continue;
    Point p = view({double(x[0]), double(x[1]), double(x[2])});
    for (double& c : p) c = std::clamp(c, -1e6, 1e6);
    const Color c = speed_color(0.05f + 0.95f * speeds[i] / fastest);
    canvas.ball(p, radius, {c.r, std::uint8_t(std::max<int>(c.g, 60)), c.b});
  }
  return image;
}

}  // namespace freshet
