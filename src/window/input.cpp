// SPDX-License-Identifier: MIT
/// The mouse and the keyboard over the picture.
#define GLFW_INCLUDE_NONE  // OpenGL is declared by draw/gl.h
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "scene/model/body_shape.h"
#include "window/viewer.h"

namespace freshet::window {
namespace {

constexpr double follow_seconds = 0.12;  // how fast the push fades when the mouse rests
constexpr double click_pixels = 4;
constexpr double pick_radius = 0.75;  // [spacings]: also between the particles of a lattice

bool pressed(int key) { return ImGui::IsKeyPressed(key, false); }

}  // namespace

void Viewer::handle_input(const gl::Painter::Region& region) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!io.WantCaptureKeyboard) handle_keys();
  if (!scene_) return;
  const double aspect = region.aspect(), scale = double(io.DisplayFramebufferScale.x),
               window_height = double(io.DisplaySize.y);
  // from the middle of the picture, y upwards
  const double x = 2 * (double(io.MousePos.x) * scale - region.left) / region.width - 1,
               y = 1 - 2 * double(io.MousePos.y) / window_height;
  if (io.WantCaptureMouse && !drag_.active) return;
  if (io.MouseWheel != 0) {
    moved_ = true;
    camera_.zoom(std::pow(0.9, double(io.MouseWheel)), x, y, aspect);
  }
  if (ImGui::IsMouseClicked(0)) {
    pressed_x_ = double(io.MousePos.x);
    pressed_y_ = double(io.MousePos.y);
    if (io.KeyShift || io.KeyCtrl) begin_push(x, y, aspect);
  }
  if (drag_.active) return drag_push(x, y, aspect);
  const double dx = double(io.MouseDelta.x) / window_height,
               dy = -double(io.MouseDelta.y) / window_height;
  if ((dx != 0 || dy != 0) && ImGui::IsAnyMouseDown()) moved_ = true;
  if (ImGui::IsMouseDown(0)) camera_.orbit(dx, dy);
  else if (ImGui::IsMouseDown(1) || ImGui::IsMouseDown(2)) camera_.pan(dx, dy);
  const double moved =
      std::hypot(double(io.MousePos.x) - pressed_x_, double(io.MousePos.y) - pressed_y_);
  if (ImGui::IsMouseReleased(0) && moved < click_pixels) click(x, y, aspect);
}

void Viewer::handle_keys() {
  if (pressed(GLFW_KEY_SPACE)) session_.play(!shown_->playing);
  if (pressed(GLFW_KEY_S) || pressed(GLFW_KEY_RIGHT)) session_.step();
  if (pressed(GLFW_KEY_LEFT) && shown_->finished_run && shown_->frame_index > 0)
    session_.seek(shown_->frame_index - 1);
  if (pressed(GLFW_KEY_R)) session_.restart();
  if (pressed(GLFW_KEY_F)) fit();
  if (pressed(GLFW_KEY_W))
    look.style = look.style == gl::Style::water ? gl::Style::balls : gl::Style::water;
  if (pressed(GLFW_KEY_P)) picture_wanted_ = picture_file_;
  if (pressed(GLFW_KEY_H)) panels = !panels;
  if (pressed(GLFW_KEY_ESCAPE)) selected_.reset();
  if (pressed(GLFW_KEY_Q) && ImGui::GetIO().KeyCtrl) closing = true;
}

void Viewer::click(double x, double y, double aspect) {
  const auto hit = view::pick(
      shown_->frame, camera_.ray(x, y, aspect),
      pick_radius * std::max(1.0, double(look.size)) * scene_->particles.spacing, look.slice);
  selected_.reset();
  if (!hit) return;
  selected_ = shown_->frame.id[*hit];
  neighbors_ = view::neighbors_of(shown_->frame, *hit, shown_->support_radius);
}

void Viewer::begin_push(double x, double y, double aspect) {
  if (shown_->finished_run) return;
  const view::Camera::Ray ray = camera_.ray(x, y, aspect);
  drag_ = {};
  drag_.active = true;
  drag_.anchor = camera_.target;
  double nearest = 1e300;
  if (const auto hit = view::pick(shown_->frame, ray, scene_->particles.spacing, look.slice)) {
    drag_.anchor = view::position_of(shown_->frame, *hit);
    nearest = dot(drag_.anchor - ray.from, ray.along);
  }
  for (std::size_t k = 0; k < shown_->frame.bodies.size(); ++k) {
    if (scene_->body[k].motion != BodyMotion::free) continue;
    const auto& p = shown_->frame.bodies[k].position;
    const Point middle{p[0], p[1], p[2]}, arm = middle - ray.from;
    const double along = dot(arm, ray.along), reach = body_shape(scene_->body[k]).reach;
    const double off2 = norm2(arm) - along * along;
    if (along <= 0 || off2 > reach * reach) continue;
    if (scene_->dimension() == 3 && along - reach > nearest) continue;
    if (scene_->dimension() == 2 && off2 > 0.8 * reach * reach) continue;
    nearest = along;
    drag_.body = int(k);
    drag_.anchor = ray.from + along * ray.along;
    drag_.grabbed = drag_.anchor - middle;
  }
  drag_.lagging = camera_.on_plane(x, y, aspect, drag_.anchor);
}

void Viewer::drag_push(double x, double y, double aspect) {
  if (!ImGui::IsMouseDown(0)) return end_push();
  const Point cursor = camera_.on_plane(x, y, aspect, drag_.anchor);
  view::Push push;
  push.body = drag_.body;
  push.radius = double(push_radius_);
  const auto k = std::size_t(std::max(drag_.body, 0));
  if (drag_.body >= 0 && k < shown_->frame.bodies.size()) {
    const BodyShape shape = body_shape(scene_->body[k]);
    const auto& p = shown_->frame.bodies[k].position;
    const Point held = Point{p[0], p[1], p[2]} + drag_.grabbed, way = cursor - held;
    const Point force = double(push_strength_) * shape.mass / std::max(shape.reach, 1e-9) * way;
    push.center = {held.x, held.y, held.z};
    push.pull = {force.x, force.y, force.z};
    return session_.push(push);
  }
  const double share = 1 - std::exp(-double(ImGui::GetIO().DeltaTime) / follow_seconds);
  const Point way = cursor - drag_.lagging;
  drag_.lagging += share * way;
  const double length = norm(way), part = std::min(1.0, 2 * length / push.radius);
  if (length < 1e-3 * push.radius) return session_.push({});
  const Point pull = double(push_strength_) * part / length * way;
  push.center = {cursor.x, cursor.y, scene_->dimension() == 3 ? cursor.z : 0};
  push.pull = {pull.x, pull.y, scene_->dimension() == 3 ? pull.z : 0};
  session_.push(push);
}

void Viewer::end_push() {
  drag_ = {};
  session_.push({});
}

}  // namespace freshet::window
