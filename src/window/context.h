// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "render/image.h"

struct GLFWwindow;

namespace freshet::window {

/// A window of GLFW with OpenGL 3.3 and Dear ImGui.
class Context {
 public:
  /// Throws Error (kind run) if there is no display or no OpenGL 3.3.
  Context(int width, int height, bool visible);
  ~Context();
  Context(const Context&) = delete;

  bool closed() const;
  void close();
  void set_title(const std::string& title);
  void resize(int width, int height);
  /// Handles events; waits for one for at most `seconds`.
  void poll(double seconds);
  /// Notes that something happened, or that a key was pressed.
  void wake() { event_ = true; }
  void press(int key) { pressed_.push_back(key); }
  /// Whether something happened since the last call, or a mouse button is held.
  bool take_event();
  /// The files that were dropped on the window since the last call.
  std::vector<std::filesystem::path> take_dropped();
  void begin_picture();
  /// Draws the panels over the picture.
  void draw_panels();
  void swap();
  /// Waits until everything is drawn.
  void finish() const;
  int width() const { return width_; }  ///< [px], not smaller than 1
  int height() const { return height_; }
  bool minimized() const;
  /// The picture before swap(), from this column on.
  Image read(int left = 0) const;
  std::string renderer() const;
  /// Whether pixels are computed by the processor.
  bool is_software() const;

 private:
  GLFWwindow* window_ = nullptr;
  int width_ = 1, height_ = 1;
  void watch_events();
  void hold_short_keys();

  std::vector<std::filesystem::path> dropped_;
  bool event_ = true;
  std::vector<int> pressed_, held_;  // keys: since the last picture; only for it
  double cursor_[2] = {0, 0};
};

}  // namespace freshet::window
