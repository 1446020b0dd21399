// SPDX-License-Identifier: MIT
#include "render/dots.h"

#include <algorithm>
#include <cmath>

#include "core/rotation.h"
#include "render/bodies.h"
#include "render/foam.h"
#include "scene/model/body_shape.h"
#include "scene/model/picture_layout.h"
#include "scene/sample/region_surface.h"

namespace freshet {
namespace {

constexpr Color background{8, 10, 28}, frame{80, 80, 120}, wall{128, 126, 122};
constexpr int margin = picture_margin;
constexpr int default_radius = 5;    // [px]
constexpr double disc_girth = 1.15;  // diameter of a disc in spacings, which closes the gaps
constexpr double shell_of_tank = 1;  // [spacings]: thickness at which a body is drawn
constexpr float softness = 0.7f;     // fraction of the dot's radius at which its weight is 1/e

std::uint8_t add(std::uint8_t below, std::uint8_t color, float weight) {
  return std::uint8_t(std::min(255.0f, float(below) + float(color) * weight));
}

void cover(Color& below, Color color, float share) {
  const auto part = [share](std::uint8_t a, std::uint8_t b) {
    return std::uint8_t(float(a) + share * (float(b) - float(a)) + 0.5f);
  };
  below = {part(below.r, color.r), part(below.g, color.g), part(below.b, color.b)};
}

/// The weights of a dot's pixels: exp(-d^2/(0.7 r)^2), 0 outside its radius r.
std::vector<float> dot_weights(int radius) {
  std::vector<float> weights;
  const float sigma2 = float(radius) * softness * float(radius) * softness;
  for (int dy = -radius; dy <= radius; ++dy)
    for (int dx = -radius; dx <= radius; ++dx) {
      const int d2 = dx * dx + dy * dy;
      weights.push_back(d2 > radius * radius ? 0 : std::exp(-float(d2) / sigma2));
    }
  return weights;
}

void add_dot(Image& image, int px, int py, Color color, int radius,
             const std::vector<float>& weights) {
  auto weight = weights.begin();
  for (int y = py - radius; y <= py + radius; ++y)
    for (int x = px - radius; x <= px + radius; ++x, ++weight)
      if (*weight > 0 && image.holds(x, y)) {
        Color& c = image.at(x, y);
        c = {add(c.r, color.r, *weight), add(c.g, color.g, *weight), add(c.b, color.b, *weight)};
      }
}

/// Draws the frame. In a stretched picture its lines reach the edges, as in the article.
void draw_frame(Image& image, bool stretched) {
  const int right = image.width - margin, bottom = image.height - margin;
  const int past = stretched ? 0 : margin - 1;
  for (int x = past; x < image.width - past; ++x)
    image.at(x, margin - 1) = image.at(x, bottom) = frame;
  for (int y = past; y < image.height - past; ++y)
    image.at(margin - 1, y) = image.at(right, y) = frame;
}

/// The distance from the left (or bottom) edge of the picture [px]. It is clamped to ±1e6, so that
/// the conversion to int is defined for distant particles.
int to_pixels(float x, double low, double high, int size) {
  const float p = (x - float(low)) / float(high - low) * float(size - 2 * margin);
  return int(std::clamp(p, -1e6f, 1e6f));
}

/// Maps the visible region to the view. Both axes have one scale unless picture.stretch is set: the
/// region then grows by the rounding of the view to pixels.
struct Window {
  Window(const Scene& s, const Image& view) : min(2), max(2) {
    const PictureRegion region = picture_region(s);
    const double room[] = {double(view.width - 2 * margin), double(view.height - 2 * margin)};
    for (int d = 0; d < 2; ++d) scale[d] = room[d] / region.extent(d);
    if (!s.picture.stretch) scale[0] = scale[1] = std::min(scale[0], scale[1]);
    for (std::size_t d = 0; d < 2; ++d) {
      const double more = s.picture.stretch ? 0 : room[d] / scale[d] - region.extent(int(d));
      min[d] = region.min[d] - more / 2;
      max[d] = region.max[d] + more / 2;
    }
  }
  Vector min, max;
  double scale[2];  // [px/m]
};

struct Extent {
  int left, top, right, bottom;
};

/// The rectangle of pixels that a wall may cover.
Extent extent_of(const Scene::Wall& w, const Window& window, const Image& image) {
  const double(&scale)[2] = window.scale;
  const int right = image.width - margin, bottom = image.height - margin;
  if (w.side == Side::inside || w.shape == Shape::plane) return {margin, margin, right, bottom};
  Vec<2, double> center{}, half{};
  if (is_mesh(w)) {
    const auto low = w.loaded->distance.low(), high = w.loaded->distance.high();
    center = {(low.x + high.x) / 2, (low.y + high.y) / 2};
    half = {(high.x - low.x) / 2, (high.y - low.y) / 2};
  } else {
    const auto solid = solid_of<2>(w);
    center = solid.center;
    half = w.shape == Shape::sphere ? Vec<2, double>{w.radius, w.radius} : solid.half;
  }
  const auto pixel = [](double p, int last) {
    return int(std::clamp(p, double(margin), double(last)));
  };
  const double x = margin + (center.x - window.min[0]) * scale[0];
  const double y = bottom - (center.y - window.min[1]) * scale[1];
  return {pixel(x - half.x * scale[0] - 1, right), pixel(y - half.y * scale[1] - 1, bottom),
          pixel(x + half.x * scale[0] + 2, right), pixel(y + half.y * scale[1] + 2, bottom)};
}

/// Draws walls in grey with smooth edges.
void draw_walls(Image& image, const Scene& s, const Window& window) {
  const double(&scale)[2] = window.scale;
  for (const Scene::Wall& w : s.wall) {
    if (w.shape == Shape::points || (is_mesh(w) && !w.loaded)) continue;
    const RegionSurface<2> surface(w, s.particles.spacing);
    const Extent e = extent_of(w, window, image);
    for (int y = e.top; y < e.bottom; ++y)
      for (int x = e.left; x < e.right; ++x) {
        const Vec<2, double> p{window.min[0] + (x + 0.5 - margin) / scale[0],
                               window.max[1] - (y + 0.5 - margin) / scale[1]};
        const double inside = 0.5 - surface.distance(p) * std::min(scale[0], scale[1]);
        if (inside > 0) cover(image.at(x, y), wall, std::min(1.0f, float(inside)));
      }
  }
}

/// Draws bodies like walls. Pixels are transformed back to the body's initial position, where its
/// shape is defined.
void draw_bodies(Image& image, const Scene& s, const Window& window, const Frame& frame) {
  const double(&scale)[2] = window.scale;
  for (std::size_t k = 0; k < std::min(s.body.size(), frame.bodies.size()); ++k) {
    const RegionSurface<2> surface(s.body[k], s.particles.spacing);
    const BodyShape shape = body_shape(s.body[k]);
    const BodyState& now = frame.bodies[k];
    const Rotation turn(now.orientation);
    const auto pixel = [](double p, int last) {
      return int(std::clamp(p, double(margin), double(last)));
    };
    const int right = image.width - margin, bottom = image.height - margin;
    const double x = margin + (now.position[0] - window.min[0]) * scale[0];
    const double y = bottom - (now.position[1] - window.min[1]) * scale[1];
    const bool tank = s.body[k].side == Side::inside;
    const double shell = tank ? shell_of_tank * s.particles.spacing : INFINITY;
    const double reach = shape.reach + (tank ? shell : 0);
    const double reach_x = reach * scale[0] + 2, reach_y = reach * scale[1] + 2;
    for (int py = pixel(y - reach_y, bottom); py < pixel(y + reach_y, bottom); ++py)
      for (int px = pixel(x - reach_x, right); px < pixel(x + reach_x, right); ++px) {
        const Vec<3, double> p{window.min[0] + (px + 0.5 - margin) / scale[0] - now.position[0],
                               window.max[1] - (py + 0.5 - margin) / scale[1] - now.position[1], 0};
        const Vec<3, double> q = shape.center + turn.inverse(p);
        const double away = surface.distance({q.x, q.y});
        const double inside = 0.5 + std::min(-away, shell + away) * std::min(scale[0], scale[1]);
        if (inside > 0) cover(image.at(px, py), body_color(s, k), std::min(1.0f, float(inside)));
      }
  }
}

/// Draws the article's dots, whose light adds up.
void add_dots(Image& image, const Scene& scene, const Window& window, const Frame& fluid,
              const Coloring& colors) {
  const int radius = int(scene.picture.dot_radius.value_or(default_radius));
  const std::vector<float> weights = dot_weights(radius);
  const auto &min = window.min, &max = window.max;
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const float x = fluid.x[2 * i], y = fluid.x[2 * i + 1];
    if (!std::isfinite(x) || !std::isfinite(y)) continue;
    const int px = to_pixels(x, min[0], max[0], image.width) + margin;
    const int py = image.height - margin - to_pixels(y, min[1], max[1], image.height);
    add_dot(image, px, py, colors(i), radius, weights);
  }
}

/// Covers a disc with smooth edges at a place of the scene [m]; its radius in pixels.
void cover_disc(Image& image, const Window& window, const float* place, float radius, Color color) {
  const double x = margin + (double(place[0]) - window.min[0]) * window.scale[0];
  const double y = image.height - margin - (double(place[1]) - window.min[1]) * window.scale[1];
  const int reach = int(radius) + 2;
  if (!(x > -reach && x < image.width + reach && y > -reach && y < image.height + reach)) return;
  for (int py = int(y) - reach; py <= int(y) + reach; ++py)
    for (int px = int(x) - reach; px <= int(x) + reach; ++px) {
      const float dx = float(px + 0.5 - x), dy = float(py + 0.5 - y);
      const float inside = radius + 0.5f - std::sqrt(dx * dx + dy * dy);
      if (inside > 0 && image.holds(px, py)) cover(image.at(px, py), color, std::min(1.0f, inside));
    }
}

/// Draws discs. Later particles cover earlier ones.
void cover_with_discs(Image& image, const Scene& scene, const Window& window, const Frame& fluid,
                      const Coloring& colors) {
  const double pixels = scene.particles.spacing * std::min(window.scale[0], window.scale[1]);
  const auto given = scene.picture.dot_radius;
  const float radius = given ? float(*given) : float(std::max(1.0, disc_girth / 2 * pixels));
  for (std::size_t i = 0; i < fluid.size(); ++i)
    cover_disc(image, window, &fluid.x[2 * i], radius, colors(i));
}

void draw_whitewater(Image& image, const Scene& scene, const Window& window,
                     const WhitewaterFrame& whitewater) {
  const double pixels = scene.particles.spacing * std::min(window.scale[0], window.scale[1]);
  for (std::size_t i = 0; i < whitewater.size(); ++i)
    cover_disc(image, window, &whitewater.x[2 * i], float(std::max(0.5, foam_radius * pixels)),
               foam_color);
}

}  // namespace

Color speed_color(float t) {
  t = std::clamp(t, 0.0f, 1.0f);
  const float r = std::min(1.0f, t * 2), g = t < 0.5f ? t * 2 : 2 - t * 2;
  const float b = std::max(0.0f, 1 - t * 2);
  return {std::uint8_t(r * 255), std::uint8_t(g * 255), std::uint8_t(b * 255)};
}

Image draw_dots(const Scene& scene, const Frame& fluid, const Coloring& colors) {
  const PictureLayout layout = picture_layout(scene);
  Image view(layout.view.width, layout.view.height, ground_color(scene));
  const Window window(scene, view);
  draw_walls(view, scene, window);
  if (scene.picture.dots == Dots::glow) add_dots(view, scene, window, fluid, colors);
  else cover_with_discs(view, scene, window, fluid, colors);
  draw_whitewater(view, scene, window, fluid.whitewater);
  draw_bodies(view, scene, window, fluid);
  draw_frame(view, scene.picture.stretch);
  Image image(layout.width, layout.height, ground_color(scene));
  image.paste(view, layout.view.left, layout.view.top);
  return image;
}

Image draw_dots(const Scene& scene, const Frame& fluid) {
  return draw_dots(scene, fluid, color_particles(scene, fluid));
}

PictureStatistics picture_statistics(const Image& image) {
  PictureStatistics s;
  s.pixels = std::int64_t(image.pixels.size());
  const std::size_t bottom = std::size_t(image.height * 2 / 3) * std::size_t(image.width);
  for (std::size_t k = 0; k < image.pixels.size(); ++k) {
    const Color c = image.pixels[k];
    s.bright += c.r > 50 || c.g > 30;
    s.bottom_third += k >= bottom && c != background;
  }
  return s;
}

}  // namespace freshet
