// SPDX-License-Identifier: MIT
#include "render/balls.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <system_error>

#include "render/stage.h"
#include "scene/model/picture_layout.h"
#include "scene/sample/point_cloud.h"

namespace freshet {
namespace {

constexpr int band_rows = 8;           // pixels; a band fits into a cache
constexpr float least_radius = 0.75f;  // samples; a distant ball stays visible
constexpr Color point_color{150, 148, 144};
constexpr float gloss = 0.22f;
constexpr double ball_girth =
    1.15;  // diameter of a ball in spacings, which closes the gaps to its neighbours

/// The visible balls, in the order of their particles.
struct Balls {
  std::vector<Ball> all;
  std::vector<Color> colors;

  void add(const View& view, Point p, float size, Color color, double width, double height) {
    const auto s = view(p);
    if (!(s.z > view.nearest)) return;  // behind the eye, or NaN
    const float radius = std::max(least_radius, float(view.focal * double(size) / s.z));
    const bool inside = s.x > -double(radius) && s.x < width + double(radius) &&
                        s.y > -double(radius) && s.y < height + double(radius);
    if (!inside) return;
    all.push_back({float(s.x), float(s.y), radius, float(s.z), size});
    colors.push_back(color);
  }
};

/// The balls of the fluid, then those of walls from point files.
Balls balls_of(const Scene& s, const Frame& fluid, const Coloring& colors, const View& view) {
  Balls balls;
  balls.all.reserve(fluid.size());
  balls.colors.reserve(fluid.size());
  const double width = 2 * view.middle_x, height = 2 * view.middle_y;
  const float size = float(ball_girth * s.particles.spacing / 2);
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    const float* x = &fluid.x[3 * i];
    balls.add(view, {double(x[0]), double(x[1]), double(x[2])}, size, colors(i), width, height);
  }
  for (const Scene::Wall& w : s.wall) {
    if (w.shape != Shape::points) continue;
    const PointCloud cloud = read_points(w.file, 3);
    for (std::size_t k = 0; k < cloud.x.size(); k += 3)
      balls.add(view, {cloud.x[k], cloud.x[k + 1], cloud.x[k + 2]}, size, point_color, width,
                height);
  }
  return balls;
}

/// The balls that each band of rows may contain, in order.
class Bands {
 public:
  Bands(const std::vector<Ball>& balls, int samples_high)
      : rows_(band_rows * oversampling), starts_(std::size_t(count(samples_high)) + 2) {
    const auto each = [&](auto f) {
      for (std::uint32_t k = 0; k < balls.size(); ++k) {
        const Ball& b = balls[k];
        const int last = std::min(int(b.y + b.radius), samples_high - 1) / rows_;
        for (int band = std::max(0, int(b.y - b.radius)) / rows_; band <= last; ++band)
          f(std::size_t(band), k);
      }
    };
    each([&](std::size_t band, std::uint32_t) { ++starts_[band + 2]; });
    for (std::size_t k = 2; k < starts_.size(); ++k) starts_[k] += starts_[k - 1];
    list_.resize(starts_.back());
    each([&](std::size_t band, std::uint32_t k) { list_[starts_[band + 1]++] = k; });
  }
  static int count(int samples_high) {
    const int rows = band_rows * oversampling;
    return (samples_high + rows - 1) / rows;
  }
  template <class F> void each_in(int band, F f) const {
    for (std::size_t k = starts_[std::size_t(band)]; k < starts_[std::size_t(band) + 1]; ++k)
      f(list_[k]);
  }

 private:
  int rows_;
  std::vector<std::size_t> starts_;
  std::vector<std::uint32_t> list_;
};

/// Shading of a ball: light and a highlight, by the place of the sample on the ball.
class Shader {
 public:
  explicit Shader(const View& view)
      : light_(in_picture(view, light_direction())), up_(in_picture(view, {0, 1, 0})) {
    const Point half = light_direction() - view.forward;
    half_ = in_picture(view, half / norm(half));
  }
  Color operator()(const Ball& b, Color c, int x, int y) const {
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

 private:
  /// The components of d to the right, up and towards the eye.
  static Vec<3, float> in_picture(const View& view, Point d) {
    return {float(dot(d, view.right)), float(dot(d, view.up)), -float(dot(d, view.forward))};
  }
  Vec<3, float> light_, up_, half_;
};

/// Computes each pixel as the mean of its samples, row by row.
void resolve(const Band& band, const Balls& balls, const Shader& shade, Image& image) {
  constexpr int n = oversampling * oversampling;
  for (int py = band.top / oversampling; py < (band.top + band.rows) / oversampling; ++py)
    for (int px = 0; px < image.width; ++px) {
      int r = n / 2, g = n / 2, b = n / 2;
      for (int k = 0; k < n; ++k) {
        const int x = oversampling * px + k % oversampling,
                  y = oversampling * py + k / oversampling;
        const std::uint32_t what = band.what[band.at(x, y)];
        const Color c = what & Band::painted ? Band::color(what)
                                             : shade(balls.all[what], balls.colors[what], x, y);
        r += c.r;
        g += c.g;
        b += c.b;
      }
      image.at(px, py) = {std::uint8_t(r / n), std::uint8_t(g / n), std::uint8_t(b / n)};
    }
}

/// Calls f(k) once for each k < n, on `threads` threads.
template <class F> void share_out(int n, int threads, F f) {
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int k = next++; k < n; k = next++) f(k);
  };
  std::vector<std::future<void>> others;
  try {
    for (int t = 1; t < threads; ++t) others.push_back(std::async(std::launch::async, work));
  } catch (const std::system_error&) {  // no more can start: those that run do the work
  }
  work();
  for (auto& other : others) other.get();
}

}  // namespace

Image draw_balls(const Scene& scene, const Frame& fluid, const Coloring& colors, int threads) {
  const Color ground = ground_color(scene);
  const PictureLayout layout = picture_layout(scene);
  Image image(layout.view.width, layout.view.height, ground);
  const int wide = oversampling * image.width, high = oversampling * image.height;
  const View view(pose_at(scene, fluid.time), wide, high);
  const Stage stage(scene, fluid, view, ground);
  const Balls balls = balls_of(scene, fluid, colors, view);
  const Bands bands(balls.all, high);
  const Shader shade(view);
  share_out(Bands::count(high), threads, [&](int k) {
    const int top = k * band_rows * oversampling;
    Band band(wide, top, std::min(band_rows * oversampling, high - top), ground);
    stage.draw(band);
    bands.each_in(k, [&](std::uint32_t ball) { band.draw(balls.all[ball], ball); });
    resolve(band, balls, shade, image);
  });
  Image whole(layout.width, layout.height, ground);
  whole.paste(image, layout.view.left, layout.view.top);
  return whole;
}

}  // namespace freshet
