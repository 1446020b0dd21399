// SPDX-License-Identifier: MIT
#include "scene/model/picture_layout.h"

#include <algorithm>
#include <cmath>

namespace freshet {
namespace {

constexpr double default_length = 800;                // of the view's longer side [px]
constexpr double min_length = 96, max_length = 8192;  // of a side that is not set [px]
constexpr double color_bar_width = 6.5;               // in font sizes
constexpr int rounds = 8;                             // of the iteration for the size

/// Width over height of the region that the view shows, without its margins. In 3D it is that of
/// the domain from the default direction of the eye, by a parallel projection.
double proportions(const Scene& s) {
  if (s.dimension() != 3) {
    const PictureRegion region = picture_region(s);
    return region.extent(0) / region.extent(1);
  }
  double size[3];
  for (std::size_t d = 0; d < 3; ++d) size[d] = s.domain.max[d] - s.domain.min[d];
  const double c = std::cos(camera_from_right), n = std::sin(camera_from_right);
  const double across = size[0] * c + size[2] * n, depth = size[0] * n + size[2] * c;
  return across / (size[1] * std::cos(camera_from_above) + depth * std::sin(camera_from_above));
}

double font_size_of(double width, double height) {
  return std::max(11.0, std::min(width, height) / 34);
}

double strip_of(const Scene& s, double width, double height) {
  return s.picture.color_bar ? std::round(color_bar_width * font_size_of(width, height)) : 0;
}

/// A side that follows the other one. Even sides suit video formats.
int side(double length) {
  return int(2 * std::round(std::clamp(length, min_length, max_length) / 2));
}

/// The size of the whole picture. It depends on the width of the colour bar and the other way
/// round.
void fit_size(const Scene& s, PictureLayout& layout) {
  const auto &width = s.picture.width, &height = s.picture.height;
  const double ratio = proportions(s), margins = s.dimension() == 3 ? 0 : 2 * picture_margin;
  const auto width_for = [&](double h) { return (h - margins) * ratio + margins; };
  const auto height_for = [&](double w) { return std::max(0.0, w - margins) / ratio + margins; };
  double w = 0, h = 0, strip = 0;
  for (int k = 0; k < rounds; ++k) {
    if (width) {
      w = double(*width);
      h = height ? double(*height) : height_for(w - strip);
    } else if (height) {
      h = double(*height);
      w = width_for(h) + strip;
    } else {
      h = std::clamp(height_for(default_length), min_length, default_length);
      w = std::min(width_for(h), default_length) + strip;
    }
    strip = strip_of(s, w, h);
  }
  layout.width = width ? int(*width) : side(w);
  layout.height = height ? int(*height) : side(h);
}

/// The rectangle of the region at equal scales, centred in the room for it.
PictureLayout::View fit_view(const PictureRegion& region, int width, int height) {
  const double across = width - 2 * picture_margin, up = height - 2 * picture_margin;
  const double scale = std::min(across / region.extent(0), up / region.extent(1));
  const auto length = [&](int axis, int room) {
    return std::clamp(int(std::round(scale * region.extent(axis))) + 2 * picture_margin,
                      2 * picture_margin + 1, room);
  };
  const int w = length(0, width), h = length(1, height);
  return {(width - w) / 2, (height - h) / 2, w, h};
}

}  // namespace

double PictureLayout::font_size() const { return font_size_of(width, height); }

PictureRegion picture_region(const Scene& s) {
  if (const Vector& w = s.picture.window; w.size() == 4) return {{w[0], w[1]}, {w[2], w[3]}};
  const Vector &min = s.domain.min, &max = s.domain.max;
  return {{min.empty() ? 0 : min[0], min.empty() ? 0 : min[1]}, {max[0], max[1]}};
}

PictureLayout picture_layout(const Scene& s) {
  PictureLayout layout{};
  fit_size(s, layout);
  layout.color_bar = std::min(int(strip_of(s, layout.width, layout.height)), layout.width / 2);
  const int room = layout.width - layout.color_bar;
  if (s.dimension() == 3 || s.picture.stretch) layout.view = {0, 0, room, layout.height};
  else layout.view = fit_view(picture_region(s), room, layout.height);
  return layout;
}

}  // namespace freshet
