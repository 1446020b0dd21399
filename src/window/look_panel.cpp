// SPDX-License-Identifier: MIT
/// Panels of what is shown: colours, slices, the camera, plots, a particle.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "scene/keys/keys.h"
#include "window/viewer.h"

namespace freshet::window {
namespace {

constexpr std::size_t most_plots = 6;

void line(const std::string& text) { ImGui::TextUnformatted(text.c_str()); }

/// A list of words; index -1 is `none`. True if another one was chosen.
bool choose(const char* label, int& index, Words words, const char* none) {
  bool chosen = false;
  if (!ImGui::BeginCombo(label, index < 0 ? none : words[std::size_t(index)])) return false;
  for (int k = none ? -1 : 0; k < int(words.size()); ++k)
    if (ImGui::Selectable(k < 0 ? none : words[std::size_t(k)], k == index)) {
      index = k;
      chosen = true;
    }
  ImGui::EndCombo();
  return chosen;
}

}  // namespace

void Viewer::look_panel() {
  const bool solid = scene_->dimension() == 3;
  if (solid) {
    int style = int(look.style);
    ImGui::RadioButton("balls", &style, 0);
    ImGui::SameLine();
    ImGui::RadioButton("water", &style, 1);
    look.style = gl::Style(style);
  }
  int by = color_by_ ? int(*color_by_) : -1;
  if (choose("colour", by, color_by_words, "of the scene"))
    choose_color(by < 0 ? std::optional<ColorBy>() : ColorBy(by));
  int map = map_.value_or(-1);
  if (choose("colour map", map, color_map_words, "of the field")) {
    map_ = map < 0 ? std::optional<int>() : map;
    colors_changed_ = true;
  }
  if (ImGui::Checkbox("range", &fixed_range_)) {
    range_[0] = coloring_.low;
    range_[1] = coloring_.high;
    colors_changed_ = true;
  }
  if (fixed_range_) {
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    colors_changed_ |= ImGui::DragFloat2("##range", range_, 0.01f * (range_[1] - range_[0]));
  }
  ImGui::SliderFloat("size", &look.size, 0.2f, 2, "%.2f spacings");
  ImGui::Checkbox("walls", &look.walls);
  ImGui::SameLine();
  ImGui::Checkbox("bodies", &look.bodies);
  ImGui::SameLine();
  ImGui::Checkbox("probes", &look.probes);
  ImGui::SameLine();
  ImGui::Checkbox("foam", &look.foam);
  if (solid) {
    ImGui::Checkbox("floor", &look.floor);
    ImGui::SameLine();
  }
  bool light = !background_of_scene_;
  if (ImGui::Checkbox("light background", &light)) background_of_scene_ = !light;
  if (solid) slice_controls();
  camera_controls();
}

void Viewer::slice_controls() {
  constexpr const char* axes[] = {"x", "y", "z"};
  if (choose("slice across", look.slice.axis, axes, "none") && look.slice.axis >= 0) {
    const auto d = std::size_t(look.slice.axis);
    look.slice.middle = (scene_->domain.min[d] + scene_->domain.max[d]) / 2;
    look.slice.thickness = 2 * scene_->particles.spacing;
  }
  if (look.slice.axis < 0) return;
  const auto d = std::size_t(look.slice.axis);
  const auto low = float(scene_->domain.min[d]), high = float(scene_->domain.max[d]);
  float middle = float(look.slice.middle), thickness = float(look.slice.thickness);
  if (ImGui::SliderFloat("at [m]", &middle, low, high)) look.slice.middle = double(middle);
  if (ImGui::SliderFloat("thickness [m]", &thickness, float(scene_->particles.spacing), high - low))
    look.slice.thickness = double(thickness);
}

void Viewer::camera_controls() {
  if (camera_.flat()) return;
  float angle = float(camera_.field_of_view);
  if (ImGui::SliderFloat("field of view", &angle, 10, 100, "%.0f\u00b0"))
    camera_.field_of_view = double(angle);
}

void Viewer::plots_panel() {
  const view::SeriesOverTime& all = shown_->recorded ? *shown_->recorded : history_.all();
  const auto& series = all.series;
  const auto is_plotted = [&](const std::string& name) {
    return std::find(plotted_.begin(), plotted_.end(), name) != plotted_.end();
  };
  if (plotted_.empty())
    for (const view::History::Series& s : series)
      if (s.name.starts_with("kinetic energy") || s.name == "speed max [m/s]" ||
          s.name == "density error mean [%]")
        plotted_.push_back(s.name);
  ImGui::SetNextItemWidth(-1);
  if (ImGui::BeginCombo("##plots", "choose what is plotted", ImGuiComboFlags_HeightLarge)) {
    for (const view::History::Series& s : series) {
      bool on = is_plotted(s.name);
      if (!ImGui::Checkbox(s.name.c_str(), &on)) continue;
      if (!on) std::erase(plotted_, s.name);
      else if (plotted_.size() < most_plots) plotted_.push_back(s.name);
    }
    ImGui::EndCombo();
  }
  for (const view::History::Series& s : series)
    if (!s.values.empty() && is_plotted(s.name)) plot(s.name, all.times, s.values);
}

/// A curve over time, with a mark at the time that is shown.
void Viewer::plot(const std::string& name, const std::vector<float>& times,
                  const std::vector<float>& values) const {
  const float font = ImGui::GetFontSize(), wide = ImGui::GetContentRegionAvail().x,
              tall = 3.6f * font;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const auto now = std::size_t(
      std::upper_bound(times.begin(), times.end(), float(shown_->frame.time) * 1.000001f) -
      times.begin());
  line(fmt::format("{}: {:.4g}", name, values[now > 0 ? now - 1 : 0]));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + wide, at.y + tall}, ImGui::GetColorU32(ImGuiCol_FrameBg), 3);
  const float span = std::max(times.back() - times.front(), 1e-12f),
              range = std::max(*high - *low, 1e-30f);
  const auto x_of = [&](float t) { return at.x + 3 + (wide - 6) * (t - times.front()) / span; };
  std::vector<ImVec2> points;
  for (std::size_t k = 0; k < values.size() && k < times.size(); ++k)
    if (std::isfinite(values[k]))
      points.push_back({x_of(times[k]), at.y + tall - 3 - (tall - 6) * (values[k] - *low) / range});
  list.AddPolyline(points.data(), int(points.size()), ImGui::GetColorU32(ImGuiCol_PlotLines),
                   ImDrawFlags_None, 1.5f);
  if (shown_->finished_run) {
    const float x = x_of(float(shown_->frame.time));
    list.AddLine({x, at.y}, {x, at.y + tall}, IM_COL32(255, 190, 90, 255));
  }
  ImGui::Dummy({wide, tall});
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip("%s", fmt::format("{:.4g} to {:.4g}\n{:.4g} s to {:.4g} s", *low, *high,
                                        times.front(), times.back())
                                .c_str());
}

void Viewer::particle_panel() {
  const Frame& f = shown_->frame;
  const auto i = selected_ ? view::find_id(f, *selected_) : std::optional<std::size_t>();
  if (!i) {
    ImGui::TextWrapped("%s", selected_ ? "The particle has left the fluid."
                                       : "Click a particle to see its state.");
    return;
  }
  const auto D = std::size_t(f.dimension);
  const auto vector = [&](const std::vector<float>& a) {
    std::string text;
    for (std::size_t d = 0; d < D; ++d)
      text += fmt::format("{}{:.4g}", d ? ", " : "", a[D * *i + d]);
    return text;
  };
  line(fmt::format("id {}", f.id[*i]));
  line(fmt::format("x = ({}) m", vector(f.x)));
  line(fmt::format("v = ({}) m/s", vector(f.v)));
  line(fmt::format("\u03c1 = {:.5g} kg/m\u00b3", f.density[*i]));
  line(fmt::format("p = {:.5g} Pa", f.pressure[*i]));
  if (!f.liquid.empty()) line(fmt::format("liquid {}", f.liquid[*i]));
  line(fmt::format("{} neighbours within {:.4g} m", neighbors_.size(), shown_->support_radius));
  std::string ids;
  for (std::size_t k = 0; k < neighbors_.size() && k < 40; ++k)
    ids += fmt::format("{}{}", k ? " " : "", f.id[neighbors_[k]]);
  if (neighbors_.size() > 40) ids += " ...";
  ImGui::TextWrapped("%s", ids.c_str());
}

}  // namespace freshet::window
