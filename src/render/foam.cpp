// SPDX-License-Identifier: MIT
#include "render/foam.h"

#include <algorithm>

#include "freshet/whitewater.h"
#include "render/water_light.h"

namespace freshet {
namespace {

constexpr float opacity = 0.7f;     // of the middle of a particle
constexpr float least_size = 0.6f;  // samples; a smaller particle covers less instead

/// What a particle lets through at a sample of its disc; `far2` is the square of the distance from
/// the middle over that of the radius.
float passed(const Ball& b, float far2) {
  const float shrunk = std::min(1.0f, b.size / least_size);
  return 1 - opacity * shrunk * shrunk * (1 - far2);
}

}  // namespace

FoamLayer::FoamLayer(const WhitewaterFrame& whitewater, double spacing, const View& view)
    : sinks_(float(1.5 * spacing)) {
  const double width = 2 * view.middle_x, height = 2 * view.middle_y;
  for (std::size_t i = 0; i < whitewater.size(); ++i) {
    if (WhitewaterKind(whitewater.kind[i]) == WhitewaterKind::bubble) continue;
    const float* x = &whitewater.x[3 * i];
    const auto s = view({double(x[0]), double(x[1]), double(x[2])});
    if (!(s.z > view.nearest)) continue;
    const float size = float(view.focal * foam_radius * spacing / s.z),
                radius = std::max(size, least_size);
    if (s.x > -double(radius) && s.x < width + double(radius) && s.y > -double(radius) &&
        s.y < height + double(radius))
      all_.push_back({float(s.x), float(s.y), radius, float(s.z), size});
  }
  bands_ = Bands(all_.size(), int(height), [&](std::uint32_t k) {
    return std::pair{int(all_[k].y - all_[k].radius), int(all_[k].y + all_[k].radius)};
  });
}

void FoamLayer::draw(Band& band, const WaterBand& water, int k) const {
  std::vector<float> clear(band.what.size(), 1.0f);
  bands_.each_in(k, [&](std::uint32_t number) {
    const Ball& b = all_[number];
    const int left = std::max(0, int(b.x - b.radius)),
              right = std::min(band.width - 1, int(b.x + b.radius)),
              top = std::max(band.top, int(b.y - b.radius)),
              bottom = std::min(band.top + band.rows - 1, int(b.y + b.radius));
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x) {
        const float u = float(x) + 0.5f - b.x, v = float(y) + 0.5f - b.y,
                    far2 = (u * u + v * v) / (b.radius * b.radius);
        const std::size_t at = band.at(x, y);
        if (far2 < 1 && b.z < band.depth[at] && b.z < water.front[at] + sinks_)
          clear[at] *= passed(b, far2);
      }
  });
  const Light white = light_of(foam_color);
  for (std::size_t at = 0; at < clear.size(); ++at) {
    if (clear[at] == 1) continue;
    const Light behind = light_of(Band::color(band.what[at]));
    band.what[at] = Band::code(color_of(clear[at] * behind + (1 - clear[at]) * white));
  }
}

}  // namespace freshet
