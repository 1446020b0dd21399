// SPDX-License-Identifier: MIT
// The functions of the page's painter, a module beside the simulation's: src/draw on a WebGL 2
// context that JavaScript made current. Arrays are written into the memory that the functions
// return. After a failure freshet_message() is the error.
#include <algorithm>
#include <memory>
#include <string>

#include "draw/painter.h"
#include "freshet/error.h"

#define FRESHET_EXPORT extern "C"

namespace {

namespace gl = freshet::gl;
namespace view = freshet::view;

std::unique_ptr<gl::Painter> painter;
view::Stage stage;
view::Shown shown;
view::Camera camera;
gl::Look look;
std::vector<float> packed;
std::string message;
double place[3], aspect = 1;
bool moved = false;  // the camera, by the user

template <class F> int guarded(const F& f) {
  try {
    f();
    return 1;
  } catch (const freshet::Error& e) {
    message = e.what();
  } catch (const std::exception& e) {
    message = std::string("error: ") + e.what();
  }
  return 0;
}

void fit() {
  camera = view::Camera(stage.start, aspect);
  moved = false;
}

void choose_background() {
  const bool water = look.style == gl::Style::water && !stage.flat;
  look.background = water ? gl::daylight : stage.background;
}

void take_stage() {
  painter->set_stage(stage);
  choose_background();
}

}  // namespace

/// Starts to draw, or starts again after the context was lost: 1, or 0 after an error.
FRESHET_EXPORT int freshet_begin() {
  return guarded([] {
    painter.reset();
    painter = std::make_unique<gl::Painter>();
    look.soft = true;
    take_stage();
    if (!shown.map.empty()) painter->set_frame(shown);
  });
}
FRESHET_EXPORT const char* freshet_message() { return message.c_str(); }

/// Room for an array of so many numbers: 0 the packed stage, 1 balls, 2 foam, 3 placements.
FRESHET_EXPORT float* freshet_numbers(int array, int size) {
  std::vector<float>* arrays[] = {&packed, &shown.balls, &shown.foam, &shown.placements};
  arrays[array]->resize(std::size_t(size));
  return arrays[array]->data();
}
FRESHET_EXPORT std::uint8_t* freshet_map(int size) {
  shown.map.resize(std::size_t(size));
  return shown.map.data();
}
/// Shows the packed stage; with `keep` from where the camera is.
FRESHET_EXPORT void freshet_show_stage(int keep) {
  stage = view::unpacked(packed);
  take_stage();
  look.slice = {};
  if (!keep) fit();
}
FRESHET_EXPORT void freshet_show_frame() { painter->set_frame(shown); }

/// Draws a picture of this size [px]: 1, or 0 after an error.
FRESHET_EXPORT int freshet_draw(int width, int height) {
  return guarded([&] {
    const gl::Painter::Region region{0, width, height};
    if (region.aspect() != aspect) {
      aspect = region.aspect();
      if (!moved) fit();
    }
    painter->draw(camera, look, region);
  });
}

/// Balls (0) or water (1).
FRESHET_EXPORT void freshet_style(int style) {
  look.style = gl::Style(style);
  choose_background();
}
/// A slice across an axis (0 to 2), its middle as a part of the domain; -1: everything.
FRESHET_EXPORT void freshet_slice(int axis, double part) {
  look.slice = {};
  if (axis < 0) return;
  const double low = axis == 0 ? stage.low.x : axis == 1 ? stage.low.y : stage.low.z;
  const double high = axis == 0 ? stage.high.x : axis == 1 ? stage.high.y : stage.high.z;
  look.slice = {axis, low + part * (high - low), 2 * double(stage.spacing)};
}

/// By parts of the picture's height.
FRESHET_EXPORT void freshet_orbit(double right, double up) {
  camera.orbit(right, up);
  moved = true;
}
FRESHET_EXPORT void freshet_zoom(double factor) {
  camera.zoom(factor, 0, 0, aspect);
  moved = true;
}
FRESHET_EXPORT double freshet_yaw() { return camera.yaw; }
/// The place in the scene [m] of a place in the picture: -1 to 1 from its middle to its edges.
FRESHET_EXPORT const double* freshet_place(double x, double y) {
  const freshet::Point p = camera.on_plane(x, y, aspect, camera.target);
  place[0] = p.x;
  place[1] = p.y;
  place[2] = p.z;
  return place;
}
