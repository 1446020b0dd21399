// SPDX-License-Identifier: MIT
/// What a picture shows, and where it is seen from.
#include <charconv>

#include "scene/model/background.h"
#include "scene/check/findings.h"
#include "scene/keys/keys.h"

namespace freshet {
namespace {

constexpr double darkest_light = 100;  // of 255; a lighter ground swallows what glows

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
              "picture.dots = \"glow\" adds light to the ground, and this one is too light to show "
              "it; choose picture.dots = \"solid\" or a darker ground");
}

void check_dimension(const Scene& s, Findings& out) {
  if (s.dimension() == 3) {
    for (const char* key : {"picture.dots", "picture.dot_radius"})
      out.unused(key, key, "a picture in 3D has balls of the particles' size; remove it");
    out.unused("picture.scale_bar", "picture.scale_bar",
               "in 3D what is near looks longer; remove it");
    out.unused("picture.window", "picture.window",
               "a picture in 3D is what the camera sees; remove it, or set [camera]");
  } else if (s.picture.color_by == ColorBy::velocity_z) {
    out.error("picture.color_by",
              "picture.color_by is \"velocity_z\", and the scene is in 2D; choose \"velocity_x\" "
              "or \"velocity_y\"");
  }
}

/// Key frames follow each other and say where they are; one camera alone has no time.
void check_keyframe(const Scene& s, std::size_t k, Findings& out) {
  const std::string at = fmt::format("camera[{}].", k);
  if (s.camera.size() == 1)
    return out.unused(at + "time", "camera.time",
                      "there is one camera and nothing to move to; remove it, or add a second "
                      "[[camera]]");
  out.unused(at + "orbit", "camera.orbit",
             "there are several cameras, key frames of a path; remove it, or keep one camera");
  if (s.camera[k].position.empty())
    out.error(at + "position",
              fmt::format("camera[{}].position is missing: there are several cameras, and each "
                          "is a place on the way; add it",
                          k));
  if (k > 0 && !(s.camera[k].time > s.camera[k - 1].time))
    out.error(at + "time",
              fmt::format("camera[{}].time is {} s, not after that of the camera before, {} s; "
                          "give each its own, in order",
                          k, s.camera[k].time, s.camera[k - 1].time));
}

/// An eye in its own target would see nothing.
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
              fmt::format("camera{}.position is where the camera looks at; move it away",
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
      out.error(key, fmt::format("{} has {} numbers; give {}", key, v.size(), n));
    return v.size() == n;
  };
  if (is_size("picture.window", p.window, 4) &&
      !(p.window[2] > p.window[0] && p.window[3] > p.window[1]))
    out.error("picture.window",
              "picture.window is empty; give x_min, y_min, x_max, y_max, the greater ones last");
  if (is_size("picture.color_range", p.color_range, 2) && !(p.color_range[1] > p.color_range[0]))
    out.error("picture.color_range",
              "picture.color_range is empty; give the least value, then a greater one");
  check_background(s, out);
  check_dimension(s, out);
}

void check_camera(const Scene& s, Findings& out) {
  if (s.camera.empty()) return;
  if (s.dimension() == 2)
    return out.error(
        "camera[0]",
        "a camera is of scenes in 3D, and this one is in 2D; remove it (picture.window "
        "chooses what is seen)");
  for (std::size_t k = 0; k < s.camera.size(); ++k) {
    check_keyframe(s, k, out);
    check_distance(s, k, out);
  }
}

}  // namespace freshet
