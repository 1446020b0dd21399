// SPDX-License-Identifier: MIT
#include "window/context.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#if __has_include(<imgui_impl_glfw.h>)
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>
#else
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#endif

#include <algorithm>
#include <array>

#include "draw/program.h"
#include "freshet/error.h"

namespace freshet::window {
namespace {

[[noreturn]] void fail(const std::string& why) {
  throw Error(Error::Kind::run, "",
              why + "; start it on a desktop, or draw without one by `xvfb-run freshet view ...`");
}

/// The reason that GLFW gives for its last error.
std::string reason() {
  const char* words = nullptr;
  glfwGetError(&words);
  return words ? words : "unknown reason";
}

/// Latin and Greek letters, and the signs of units.
void load_font(float scale) {
  ImGuiIO& io = ImGui::GetIO();
  static const std::array<ImWchar, 13> letters{
      0x20, 0xff, 0x370, 0x3ff, 0x2010, 0x2027, 0x2070, 0x209f, 0x2190, 0x21ff, 0x2200, 0x22ff, 0};
  for (const char* file : {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"}) {
    std::error_code ec;
    if (!std::filesystem::is_regular_file(file, ec)) continue;
    io.Fonts->AddFontFromFileTTF(file, 14 * scale, nullptr, letters.data());
    return;
  }
}

void style_panels(float scale) {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 4;
  style.FrameRounding = 3;
  style.Colors[ImGuiCol_WindowBg].w = 0.92f;
  style.ScaleAllSizes(scale);
}

void note_event(GLFWwindow* window) {
  static_cast<Context*>(glfwGetWindowUserPointer(window))->wake();
}

}  // namespace

Context::Context(int width, int height, bool visible) {
  glfwSetErrorCallback(nullptr);
  if (!glfwInit()) fail("there is no display to open a window on (" + reason() + ")");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, visible ? GLFW_TRUE : GLFW_FALSE);
  window_ = glfwCreateWindow(width, height, "Freshet", nullptr, nullptr);
  if (!window_) {
    const std::string why = reason();
    glfwTerminate();
    fail("there is no OpenGL 3.3 to draw with (" + why + ")");
  }
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(visible ? 1 : 0);
  const char* missing = gl::load_gl(
      [](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); });
  if (missing) {
    glfwDestroyWindow(window_);
    glfwTerminate();
    fail(std::string("the graphics driver has no ") + missing);
  }
  glfwSetWindowUserPointer(window_, this);
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
    auto& dropped = static_cast<Context*>(glfwGetWindowUserPointer(w))->dropped_;
    dropped.assign(paths, paths + count);
  });
  watch_events();
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  float scale = 1, other = 1;
  if (visible) glfwGetWindowContentScale(window_, &scale, &other);
  style_panels(scale);
  load_font(scale);
  ImGui_ImplGlfw_InitForOpenGL(window_, true);
  ImGui_ImplOpenGL3_Init(std::string(gl::shader_prefix()).c_str());
}

Context::~Context() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

/// Dear ImGui calls these after its own.
void Context::watch_events() {
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int) {
    note_event(w);
    if (action == GLFW_PRESS) static_cast<Context*>(glfwGetWindowUserPointer(w))->press(key);
  });
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned) { note_event(w); });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double) { note_event(w); });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int, int, int) { note_event(w); });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { note_event(w); });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int) { note_event(w); });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { note_event(w); });
}

/// Dear ImGui sees keys at pictures only, before version 1.87. One that was pressed and released
/// between two of them stays down for a picture.
void Context::hold_short_keys() {
  [[maybe_unused]] const std::vector<int> pressed = std::exchange(pressed_, {});
#if IMGUI_VERSION_NUM < 18700
  auto& down = ImGui::GetIO().KeysDown;
  for (const int key : std::exchange(held_, {})) down[key] = false;
  for (const int key : pressed) {
    if (key < 0 || key >= int(std::size(down)) || down[key]) continue;
    down[key] = true;
    held_.push_back(key);
  }
#endif
}

bool Context::take_event() {
  double x = 0, y = 0;
  glfwGetCursorPos(window_, &x, &y);
  bool event = std::exchange(event_, false) || x != cursor_[0] || y != cursor_[1];
  cursor_[0] = x;
  cursor_[1] = y;
  for (int button = GLFW_MOUSE_BUTTON_1; button <= GLFW_MOUSE_BUTTON_3; ++button)
    event |= glfwGetMouseButton(window_, button) == GLFW_PRESS;
  return event;
}

bool Context::closed() const { return glfwWindowShouldClose(window_); }
void Context::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }
void Context::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }
void Context::resize(int width, int height) { glfwSetWindowSize(window_, width, height); }
bool Context::minimized() const { return glfwGetWindowAttrib(window_, GLFW_ICONIFIED); }

void Context::poll(double seconds) {
  if (seconds > 0) glfwWaitEventsTimeout(seconds);
  else glfwPollEvents();
}

std::vector<std::filesystem::path> Context::take_dropped() { return std::exchange(dropped_, {}); }

void Context::begin_picture() {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  width_ = std::max(1, width);
  height_ = std::max(1, height);
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  hold_short_keys();
  ImGui::NewFrame();
}

void Context::draw_panels() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Context::swap() { glfwSwapBuffers(window_); }

void Context::finish() const { gl::glFinish(); }

Image Context::read(int left) const {
  using namespace gl;
  const int width = width_ - left;
  Image image(width, height_, {0, 0, 0});
  const auto w = std::size_t(width);
  std::vector<std::uint8_t> rgba(4 * w * std::size_t(height_));
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(left, 0, width, height_, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width; ++x) {
      const std::uint8_t* p = rgba.data() + 4 * (std::size_t(height_ - 1 - y) * w + std::size_t(x));
      image.at(x, y) = {p[0], p[1], p[2]};
    }
  return image;
}

std::string Context::renderer() const {
  const auto* name = gl::glGetString(GL_RENDERER);
  return name ? reinterpret_cast<const char*>(name) : "";
}

bool Context::is_software() const {
  const std::string name = renderer();
  return name.find("llvmpipe") != std::string::npos || name.find("softpipe") != std::string::npos ||
         name.find("SwiftShader") != std::string::npos;
}

}  // namespace freshet::window
