// SPDX-License-Identifier: MIT
#include "render/ball_layer.h"

#include <algorithm>

#include "freshet/whitewater.h"
#include "render/foam.h"
#include "render/stage.h"
#include "scene/sample/point_cloud.h"

namespace freshet {
namespace {

constexpr float least_radius = 0.75f;  // samples; a distant ball stays visible
constexpr Color point_color{150, 148, 144};
constexpr float gloss = 0.22f;
constexpr double ball_girth =
    1.15;  // diameter of a ball in spacings, which closes the gaps to its neighbours

/// The components of d to the right, up and towards the eye.
Vec<3, float> in_picture(const View& view, Point d) {
  return {float(dot(d, view.right)), float(dot(d, view.up)), -float(dot(d, view.forward))};
}

}  // namespace

BallShader::BallShader(const View& view)
    : light_(in_picture(view, light_direction())), up_(in_picture(view, {0, 1, 0})) {
  const Point half = light_direction() - view.forward;
  half_ = in_picture(view, half / norm(half));
}

Color BallShader::operator()(const Ball& b, Color c, int x, int y) const {
  const float u = (float(x) + 0.5f - b.x) / b.radius, v = (b.y - float(y) - 0.5f) / b.radius;
  const Vec<3, float> n{u, v, std::sqrt(std::max(0.0f, 1 - u * u - v * v))};
  float shine = std::max(0.0f, dot(n, half_));
  for (int k = 0; k < 5; ++k) shine *= shine;  // 32nd power
  const float light = 1.1f * brightness(dot(n, light_), dot(n, up_)), white = 255 * gloss * shine;
  const auto part = [&](std::uint8_t p) {
    return std::uint8_t(std::min(255.0f, float(p) * light + white));
  };
  return {part(c.r), part(c.g), part(c.b)};
}

BallLayer::BallLayer(const Scene& scene, const Frame& fluid, const Coloring* colors,
                     const View& view)
    : shade_(view) {
  const float size = float(ball_girth * scene.particles.spacing / 2);
  if (colors) {
    all_.reserve(fluid.size());
    colors_.reserve(fluid.size());
    for (std::size_t i = 0; i < fluid.size(); ++i) {
      const float* x = &fluid.x[3 * i];
      add(view, {double(x[0]), double(x[1]), double(x[2])}, size, (*colors)(i));
    }
  }
  add_whitewater(fluid.whitewater, view, float(foam_radius * scene.particles.spacing), !colors);
  add_walls(scene, view, size);
  bands_ = Bands(all_.size(), int(2 * view.middle_y), [&](std::uint32_t k) {
    const Ball& b = all_[k];
    return std::pair{int(b.y - b.radius), int(b.y + b.radius)};
  });
}

void BallLayer::add_whitewater(const WhitewaterFrame& whitewater, const View& view, float size,
                               bool bubbles_only) {
  for (std::size_t i = 0; i < whitewater.size(); ++i) {
    if (bubbles_only && WhitewaterKind(whitewater.kind[i]) != WhitewaterKind::bubble) continue;
    const float* x = &whitewater.x[3 * i];
    add(view, {double(x[0]), double(x[1]), double(x[2])}, size, foam_color);
  }
}

void BallLayer::add_walls(const Scene& scene, const View& view, float size) {
  for (const Scene::Wall& w : scene.wall) {
    if (w.shape != Shape::points) continue;
    const PointCloud cloud = region_points(w, 3);
    for (std::size_t k = 0; k < cloud.x.size(); k += 3)
      add(view, {cloud.x[k], cloud.x[k + 1], cloud.x[k + 2]}, size, point_color);
  }
}

void BallLayer::add(const View& view, Point p, float size, Color color) {
  const auto s = view(p);
  if (!(s.z > view.nearest)) return;  // behind the eye, or NaN
  const float radius = std::max(least_radius, float(view.focal * double(size) / s.z));
  const double width = 2 * view.middle_x, height = 2 * view.middle_y;
  const bool inside = s.x > -double(radius) && s.x < width + double(radius) &&
                      s.y > -double(radius) && s.y < height + double(radius);
  if (!inside) return;
  all_.push_back({float(s.x), float(s.y), radius, float(s.z), size});
  colors_.push_back(color);
}

void BallLayer::draw(Band& band, int k) const {
  bands_.each_in(k, [&](std::uint32_t ball) { band.draw(all_[ball], ball); });
  for (int y = band.top; y < band.top + band.rows; ++y)
    for (int x = 0; x < band.width; ++x) {
      std::uint32_t& what = band.what[band.at(x, y)];
      if (!(what & Band::painted)) what = Band::code(shade_(all_[what], colors_[what], x, y));
    }
}

}  // namespace freshet
