// SPDX-License-Identifier: MIT
#include "window/viewer.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "freshet/units.h"

namespace freshet::window {
namespace {

view::Tint tint_of(Color c) { return {float(c.r) / 255, float(c.g) / 255, float(c.b) / 255, 1}; }

}  // namespace

Viewer::Viewer(view::Session& session, bool software) : session_(session) {
  look.water_detail = software ? 2 : 1;
  look.soft = !software;
}

gl::Painter::Region Viewer::region(int width, int height) const {
  const ImGuiIO& io = ImGui::GetIO();
  const float left = panels ? panel_width_ * io.DisplayFramebufferScale.x : 0;
  const int from = std::clamp(int(left), 0, std::max(0, width - 64));
  return {from, width - from, height};
}

void Viewer::fit() {
  moved_ = false;
  if (scene_) camera_ = view::Camera::of(*scene_, shown_->frame.time, aspect_);
}

bool Viewer::update(const gl::Painter::Region& region) {
  if (region.aspect() != aspect_) {
    aspect_ = region.aspect();
    if (!moved_) fit();
  }
  const auto newest = session_.newest();
  const bool changed = newest != shown_;
  if (!changed && !colors_changed_) return false;
  shown_ = newest;
  if (shown_->notices != notices_) {
    notices_ = shown_->notices;
    note_ = shown_->notice;
  }
  if (!shown_->scene) return changed;
  if (shown_->scene != scene_) show_scene();
  history_.add(*shown_);
  color_frame();
  neighbors_.clear();
  if (selected_)
    if (const auto i = view::find_id(shown_->frame, *selected_))
      neighbors_ = view::neighbors_of(shown_->frame, *i, shown_->support_radius);
  return true;
}

/// Another scene, or the same one after a change: the camera stays unless the file is another.
void Viewer::show_scene() {
  scene_ = shown_->scene;
  stage_ = view::stage_of(*scene_);
  painter_.set_stage(stage_);
  coloring_scene_ = *scene_;
  keys_ = shown_->finished_run ? std::vector<SceneKey>() : keys_of(*scene_);
  if (name_ == shown_->name) return;
  if (!name_.empty()) color_by_.reset();
  name_ = shown_->name;
  fit();
  selected_.reset();
  look.slice = {};
  const Vector &low = scene_->domain.min, &high = scene_->domain.max;
  double size = 0;
  for (std::size_t d = 0; d < high.size(); ++d) size = std::max(size, high[d] - low[d]);
  push_radius_ = float(std::max(0.08 * size, 3 * scene_->particles.spacing));
  push_strength_ = 50;
  double g = 0;
  for (const double a : scene_->domain.gravity) g = std::max(g, std::abs(a));
  if (g > 0) push_strength_ = float(5 * g);
}

void Viewer::color_frame() {
  colors_changed_ = false;
  Scene::Picture& picture = coloring_scene_.picture;
  picture.color_by = color_by_.value_or(scene_->picture.color_by);
  picture.color_map = map_        ? std::optional(ColorMap(*map_))
                      : color_by_ ? std::optional<ColorMap>()
                                  : scene_->picture.color_map;
  picture.color_range.clear();
  if (fixed_range_ && range_[1] > range_[0])
    picture.color_range = {double(range_[0]), double(range_[1])};
  else if (!color_by_) picture.color_range = scene_->picture.color_range;
  if (ranges_run_ != shown_->run) ranges_ = {};
  ranges_run_ = shown_->run;
  include(ranges_, percentiles_of(*scene_, shown_->frame));
  coloring_ = color_particles(coloring_scene_, shown_->frame, ranges_);
  painter_.set_frame(view::shown_of(shown_->frame, coloring_, stage_));
}

void Viewer::draw(const gl::Painter::Region& region) {
  const bool water = look.style == gl::Style::water && scene_ && scene_->dimension() == 3;
  look.background =
      water || !background_of_scene_ || !scene_ ? gl::daylight : tint_of(ground_color(*scene_));
  look.marked.reset();
  if (selected_) look.marked = view::find_id(shown_->frame, *selected_);
  painter_.draw(camera_, look, region);
}

void Viewer::draw_color_bar() {
  if (!scene_ || shown_->frame.size() == 0 ||
      (look.style == gl::Style::water && scene_->dimension() == 3))
    return;
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float font = ImGui::GetFontSize(), wide = 0.9f * font, tall = 0.3f * size.y;
  const float x = size.x - 6.5f * font, y = 3 * font;
  const bool light = look.background.r + look.background.g + look.background.b > 1.5f;
  const ImU32 ink = light ? IM_COL32(20, 24, 30, 255) : IM_COL32(235, 238, 242, 255);
  list.AddRectFilled({x - 2 * font, y - 2 * font}, {size.x, y + tall + font},
                     light ? IM_COL32(240, 243, 246, 150) : IM_COL32(8, 10, 28, 150), 4);
  list.AddText({x - 1.5f * font, y - 1.6f * font}, ink, coloring_.label.c_str());
  if (!coloring_.liquids.empty()) {
    for (std::size_t k = 0; k < coloring_.liquids.size(); ++k) {
      const Color c = coloring_.liquids[k];
      const float at = y + 1.4f * font * float(k);
      list.AddRectFilled({x, at}, {x + wide, at + wide}, IM_COL32(c.r, c.g, c.b, 255));
      list.AddText({x + 1.3f * font, at}, ink, fmt::format("liquid {}", k).c_str());
    }
    return;
  }
  constexpr int steps = 64;
  for (int k = 0; k < steps; ++k) {
    const Color c = coloring_.at((float(k) + 0.5f) / steps);
    list.AddRectFilled({x, y + tall * float(steps - 1 - k) / steps},
                       {x + wide, y + tall * float(steps - k) / steps},
                       IM_COL32(c.r, c.g, c.b, 255));
  }
  for (int k = 0; k <= 4; ++k) {
    const float t = float(k) / 4, value = coloring_.low + t * (coloring_.high - coloring_.low);
    list.AddText({x + 1.2f * font, y + tall * (1 - t) - 0.5f * font}, ink,
                 fmt::format("{:.4g}", value).c_str());
  }
}

void Viewer::record(const Image& image) {
  if (!film_.wants(shown_->frame.time)) return;
  try {
    film_.add(image, shown_->frame.time);
  } catch (const Error& e) {
    complain(e);
  }
}

void Viewer::complain(const Error& error) { own_problems_ = error.diagnostics(); }

std::string Viewer::title() const {
  if (!shown_ || shown_->name.empty()) return "Freshet";
  return std::filesystem::path(shown_->name).filename().string() + " - Freshet";
}

}  // namespace freshet::window
