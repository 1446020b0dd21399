// SPDX-License-Identifier: MIT
/// Panels of the run: what it does, its files, its errors.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "window/viewer.h"

namespace freshet::window {
namespace {

void line(const std::string& text) { ImGui::TextUnformatted(text.c_str()); }
void wrapped(const std::string& text) { ImGui::TextWrapped("%s", text.c_str()); }

}  // namespace

void Viewer::draw_panels() {
  if (!shown_->problems.empty() || !own_problems_.empty()) problems_panel();
  if (!panels) return;
  const float font = ImGui::GetFontSize();
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({23 * font, size.y}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSizeConstraints({14 * font, size.y}, {0.7f * size.x, size.y});
  constexpr auto fixed = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoTitleBar;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  const bool open = ImGui::Begin("Freshet", nullptr, fixed);
  panel_width_ = ImGui::GetWindowSize().x;
  if (open) side_panel();
  ImGui::End();
  ImGui::PopStyleVar();
  if (!scene_) return;
  if (selected_) {
    ImGui::SetNextWindowPos({size.x - 28 * font, font}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize({19 * font, 0}, ImGuiCond_FirstUseEver);
    if (ImGui::Begin("Particle")) particle_panel();
    ImGui::End();
  }
  if (shown_->finished_run && !shown_->recorded) return;
  ImGui::SetNextWindowPos({size.x - 20 * font, size.y - font}, ImGuiCond_Once, {0, 1});
  ImGui::SetNextWindowSize({19 * font, 0}, ImGuiCond_FirstUseEver);
  if (ImGui::Begin("Plots")) plots_panel();
  ImGui::End();
}

void Viewer::side_panel() {
  run_panel();
  if (!ImGui::BeginTabBar("tabs")) return;
  const auto tab = [&](const char* name, void (Viewer::*draw)()) {
    if (!ImGui::BeginTabItem(name)) return;
    (this->*draw)();
    ImGui::EndTabItem();
  };
  if (scene_ && !shown_->finished_run) tab("Keys", &Viewer::keys_panel);
  if (scene_) tab("Look", &Viewer::look_panel);
  if (scene_ && !shown_->finished_run) tab("Push", &Viewer::push_controls);
  tab("Files", &Viewer::files_panel);
  ImGui::EndTabBar();
}

void Viewer::run_panel() {
  if (!scene_) {
    wrapped("Drop a scene (*.toml) or the folder of a run here.");
    return;
  }
  if (ImGui::Button(shown_->playing ? "Pause" : "Play")) session_.play(!shown_->playing);
  ImGui::SameLine();
  if (ImGui::Button("Step")) session_.step();
  ImGui::SameLine();
  if (ImGui::Button(shown_->finished_run ? "Start" : "Restart")) session_.restart();
  ImGui::SameLine();
  if (ImGui::Button("Fit")) fit();
  bool changed = ImGui::SliderFloat("speed", &pace_, 0.001f, 10, "%.3g x real time",
                                    ImGuiSliderFlags_Logarithmic);
  changed |= ImGui::Checkbox("as fast as possible", &full_speed_);
  if (changed) session_.set_pace(full_speed_ ? 0 : double(pace_));
  progress_line();
  if (shown_->finished_run) timeline();
  if (!note_.empty()) wrapped(note_);
}

void Viewer::progress_line() {
  const view::Snapshot& s = *shown_;
  line(fmt::format("t = {:.4f} s, step {}, {} particles", s.frame.time, s.frame.step,
                   s.frame.size()));
  if (s.finished_run) return;
  const double rate = s.step_seconds > 0 ? s.time_step / s.step_seconds : 0;
  wrapped(fmt::format("{}: {:.1f} ms a step, {} thread{}, {:.2g} x real time",
                      s.scene->method().name, 1e3 * s.step_seconds, s.threads,
                      s.threads == 1 ? "" : "s", rate));
  if (s.ended) line("time.end is reached; change it to go on");
  if (!s.warnings.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1, 0.8f, 0.4f, 1));
    wrapped("warning: " + s.warnings.back().message);
    ImGui::PopStyleColor();
  }
}

void Viewer::timeline() {
  int frame = int(shown_->frame_index);
  const int last = int(shown_->frame_count) - 1;
  ImGui::SetNextItemWidth(-1);
  if (ImGui::SliderInt("##frame", &frame, 0, std::max(last, 1),
                       fmt::format("frame %d of {}", last).c_str()))
    session_.seek(std::size_t(std::clamp(frame, 0, last)));
}

void Viewer::push_controls() {
  wrapped("Drag with Shift held to push the liquid, or a free body.");
  ImGui::SliderFloat("radius [m]", &push_radius_, 0.1f * push_radius_ + 1e-6f, 2 * push_radius_,
                     "%.3g");
  ImGui::DragFloat("strength [m/s\u00b2]", &push_strength_, 1, 0, 1e6f, "%.3g");
  line(fmt::format("{} actions recorded", shown_->actions));
}

void Viewer::files_panel() {
  const float button = 5 * ImGui::GetFontSize();
  const auto row = [&](const char* name, std::string& file, const char* action) {
    ImGui::PushID(name);
    ImGui::SetNextItemWidth(-2.2f * button);
    ImGui::InputText("##file", &file);
    ImGui::SameLine();
    const bool chosen = ImGui::Button(action, {button, 0});
    ImGui::SameLine();
    line(name);
    ImGui::PopID();
    return chosen && !file.empty();
  };
  if (row("a scene or run", open_file_, "Open")) session_.open(open_file_);
  if (!scene_) return;
  if (row("picture (P)", picture_file_, "Save")) picture_wanted_ = picture_file_;
  try {
    if (row("film", film_file_, film_.recording() ? "Stop" : "Record")) {
      const ImVec2 size = ImGui::GetIO().DisplaySize,
                   scale = ImGui::GetIO().DisplayFramebufferScale;
      if (film_.recording()) {
        film_.finish();
        note_ = "wrote " + film_.file().string();
      } else {
        film_.begin(film_file_, int((size.x - panel_width_) * scale.x), int(size.y * scale.y),
                    full_speed_ ? 1 : double(pace_));
      }
    }
    if (film_.recording()) line(fmt::format("recording: {} pictures", film_.pictures()));
  } catch (const Error& e) {
    complain(e);
  }
  if (shown_->finished_run) return;
  if (row("scene", scene_file_, "Save")) session_.save_scene(scene_file_);
  if (row("checkpoint", checkpoint_file_, "Save")) session_.save_checkpoint(checkpoint_file_);
  if (row("actions", log_file_, "Save")) session_.save_log(log_file_);
}

void Viewer::problems_panel() {
  const float font = ImGui::GetFontSize(), width = ImGui::GetIO().DisplaySize.x;
  ImGui::SetNextWindowPos({width / 2, font}, ImGuiCond_Always, {0.35f, 0});
  ImGui::SetNextWindowSize({std::min(46 * font, 0.62f * width), 0});
  ImGui::PushStyleColor(ImGuiCol_TitleBgActive, ImVec4(0.55f, 0.12f, 0.10f, 1));
  ImGui::PushStyleColor(ImGuiCol_TitleBg, ImVec4(0.55f, 0.12f, 0.10f, 1));
  const bool open = ImGui::Begin(shown_->failed ? "The run failed" : "Error", nullptr,
                                 ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoFocusOnAppearing);
  if (open) {
    for (const Diagnostic& d : shown_->problems) wrapped(d.text());
    for (const Diagnostic& d : own_problems_) wrapped(d.text());
    if (shown_->failed) wrapped("Restart the run, or change a key first.");
    else if (!shown_->problems.empty() && !shown_->finished_run)
      wrapped("The scene is loaded again when its file is saved.");
    if (!own_problems_.empty() && ImGui::Button("OK")) own_problems_.clear();
  }
  ImGui::End();
  ImGui::PopStyleColor(2);
}

}  // namespace freshet::window
