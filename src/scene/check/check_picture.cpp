// SPDX-License-Identifier: MIT
/// Pictures and cameras.
#include <charconv>

#include "scene/check/findings.h"
#include "scene/keys/keys.h"
#include "scene/model/background.h"

namespace freshet {
namespace {

constexpr double darkest_light = 100;  // of 255; a lighter background hides glowing dots

bool is_light(const std::array<std::uint8_t, 3>& c) {
  return (c[0] + c[1] + c[2]) / 3.0 > darkest_light;
}

void check_background(const Scene& s, Findings& out) {
  const auto color = background_color(s.picture.background);
  if (!color)
    return out.error("picture.background",
                     "picture.background must be \"night\", \"black\", \"grey\", \"white\" or six "
                     "digits like \"#0a2040\" (red, green, blue); choose one");
  if (s.dimension() == 2 && s.picture.dots == Dots::glow && is_light(*color))
    out.error("picture.background",
              "picture.dots = \"glow\" adds light to the background, and this one is too light to "
              "show it; choose picture.dots = \"solid\" or a darker background");
}

/// The style `water` has the colours of the liquids only.
void check_style(const Scene& s, Findings& out) {
  const auto& p = s.picture;
  if (p.style != PictureStyle::water) return;
  if (s.dimension() == 2)
    return out.error("picture.style",
                     "picture.style = \"water\" needs a scene in 3D, and this one is in 2D; remove "
                     "it (picture.dots sets the style in 2D)");
  if (p.color_by != ColorBy::liquid)
    for (const char* key :
         {"picture.color_by", "picture.color_map", "picture.color_range", "picture.color_scale"})
      out.unused(key, key,
                 "picture.style = \"water\" shows the colours of the liquids; remove it, set "
                 "picture.color_by = \"liquid\", or choose picture.style = \"balls\"");
  if (p.color_bar)
    out.unsupported("picture.color_bar",
                    "picture.color_bar is not used; picture.style = \"water\" shows no values; set "
                    "it to false, or choose picture.style = \"balls\"");
}

void check_dimension(const Scene& s, Findings& out) {
  if (s.dimension() == 3) {
    for (const char* key : {"picture.dots", "picture.dot_radius"})
      out.unused(key, key, "in 3D particles are drawn as balls of their size; remove it");
    out.unused("picture.stretch", "picture.stretch",
               "in 3D the camera has equal scales; remove it");
    out.unused("picture.scale_bar", "picture.scale_bar",
               "in 3D lengths depend on the distance from the camera; remove it");
    out.unused("picture.window", "picture.window",
               "in 3D the camera sets the visible region; remove it, or set [camera]");
    return;
  }
  if (s.picture.color_by == ColorBy::velocity_z)
    out.error("picture.color_by",
              "picture.color_by is \"velocity_z\", and the scene is in 2D; choose \"velocity_x\" "
              "or \"velocity_y\"");
  if (s.picture.stretch && !(s.picture.width && s.picture.height))
    out.unused("picture.stretch", "picture.stretch",
               "the picture follows the domain unless its width and height are set; set both, or "
               "remove it");
}

/// Key frames need a position and ascending times; a single camera has no time.
void check_keyframe(const Scene& s, std::size_t k, Findings& out) {
  const std::string at = fmt::format("camera[{}].", k);
  if (s.camera.size() == 1)
    return out.unused(at + "time", "camera.time",
                      "a single camera is not a key frame; remove it, or add a second [[camera]]");
  out.unused(at + "orbit", "camera.orbit",
             "several cameras are key frames of a path; remove it, or keep one camera");
  if (s.camera[k].position.empty())
    out.error(at + "position",
              fmt::format("camera[{}].position is missing; each of several cameras is a key frame "
                          "with a position; add it",
                          k));
  if (k > 0 && !(s.camera[k].time > s.camera[k - 1].time))
    out.error(at + "time",
              fmt::format("camera[{}].time is {} s, not after that of the previous camera, {} s; "
                          "sort them by time",
                          k, s.camera[k].time, s.camera[k - 1].time));
}

/// The position of a camera must differ from its target.
void check_distance(const Scene& s, std::size_t k, Findings& out) {
  const Scene::Camera& c = s.camera[k];
  if (c.position.empty()) return;
  double distance2 = 0, size2 = 0;
  for (std::size_t d = 0; d < 3; ++d) {
    const double low = s.domain.min[d], high = s.domain.max[d];
    const double offset = c.position[d] - (c.target.empty() ? (low + high) / 2 : c.target[d]);
    distance2 += offset * offset;
    size2 += (high - low) * (high - low);
  }
  if (distance2 < 1e-6 * size2)
    out.error(fmt::format("camera[{}].position", k),
              fmt::format("camera{}.position is at the camera's target; move it away",
                          s.camera.size() == 1 ? "" : fmt::format("[{}]", k)));
}

}  // namespace

std::optional<std::array<std::uint8_t, 3>> background_color(std::string_view text) {
  using Color = std::array<std::uint8_t, 3>;
  if (text == "night") return Color{8, 10, 28};  // the article's
  if (text == "black") return Color{0, 0, 0};
  if (text == "grey") return Color{60, 64, 72};
  if (text == "white") return Color{255, 255, 255};
  if (text.size() != 7 || text[0] != '#') return {};
  unsigned digits = 0;
  const auto [end, ec] = std::from_chars(text.data() + 1, text.data() + 7, digits, 16);
  if (ec != std::errc() || end != text.data() + 7) return {};
  return Color{std::uint8_t(digits >> 16), std::uint8_t(digits >> 8), std::uint8_t(digits)};
}

void check_picture(const Scene& s, Findings& out) {
  const auto& p = s.picture;
  const auto is_size = [&](const char* key, const Vector& v, std::size_t n) {
    if (!v.empty() && v.size() != n)
      out.error(key, fmt::format("{} has {} numbers; it must have {}", key, v.size(), n));
    return v.size() == n;
  };
  if (is_size("picture.window", p.window, 4) &&
      !(p.window[2] > p.window[0] && p.window[3] > p.window[1]))
    out.error(
        "picture.window",
        "picture.window is empty; set x_min, y_min, x_max, y_max, the maxima greater than the "
        "minima");
  if (is_size("picture.color_range", p.color_range, 2) && !(p.color_range[1] > p.color_range[0]))
    out.error("picture.color_range",
              "picture.color_range is empty; set the minimum, then a greater maximum");
  if (!p.color_range.empty())
    out.unused("picture.color_scale", "picture.color_scale",
               "picture.color_range is set; remove one of them");
  check_background(s, out);
  check_dimension(s, out);
  check_style(s, out);
}

void check_camera(const Scene& s, Findings& out) {
  if (s.camera.empty()) return;
  if (s.dimension() == 2)
    return out.error(
        "camera[0]",
        "a camera needs a scene in 3D, and this one is in 2D; remove it (picture.window "
        "sets the visible region)");
  for (std::size_t k = 0; k < s.camera.size(); ++k) {
    check_keyframe(s, k, out);
    check_distance(s, k, out);
  }
}

}  // namespace freshet
