// SPDX-License-Identifier: MIT
/// The keys of the scene, made from the table of keys: what may change while the run goes on
/// changes at once, the rest at the next restart.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "window/viewer.h"

namespace freshet::window {
namespace {

constexpr double change_interval = 0.1;  // between changes while a number is dragged [s]

/// The numbers in a value of TOML, without brackets and commas.
std::vector<float> numbers_in(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '[' || c == ']' || c == ','; }, ' ');
  std::istringstream in(text);
  std::vector<float> numbers;
  for (float x; in >> x;) numbers.push_back(x);
  return numbers;
}

/// The shortest text of a float that reads as a number of TOML.
std::string number_text(float x, bool whole) {
  if (whole) return fmt::format("{}", std::llround(double(x)));
  const std::string text = fmt::format("{}", x);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::string tooltip_of(const SceneKey& key) {
  std::string text = key.path + (key.unit.empty() ? "" : " [" + key.unit + "]") + "\n" + key.text;
  if (std::isfinite(key.min))
    text += fmt::format("\n{} {:g}", key.above ? "above" : "at least", key.min);
  if (std::isfinite(key.max)) text += fmt::format("\nat most {:g}", key.max);
  if (!key.fallback.empty()) text += "\nnot set: " + key.fallback;
  text += key.live ? "\nchanges at once" : "\nchanges when the run starts again";
  return text;
}

bool is_waiting(const std::vector<Override>& waiting, const std::string& path) {
  return std::any_of(waiting.begin(), waiting.end(),
                     [&](const Override& o) { return o.first == path; });
}

}  // namespace

void Viewer::keys_panel() {
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##filter", "find a key", &key_filter_);
  if (!shown_->waiting.empty()) {
    ImGui::TextWrapped("%s", fmt::format("{} change{} for the next start", shown_->waiting.size(),
                                         shown_->waiting.size() == 1 ? " waits" : "s wait")
                                 .c_str());
    if (ImGui::Button("Restart with changes (R)")) session_.restart();
    ImGui::SameLine();
    if (ImGui::Button("Drop changes")) session_.drop_waiting();
  }
  std::string section = "?";
  bool open = false;
  for (const SceneKey& key : keys_) {
    const bool found = key.path.find(key_filter_) != std::string::npos;
    if (!key_filter_.empty()) {
      if (found) key_row(key);
      continue;
    }
    if (key.section != section) {
      if (open) ImGui::TreePop();
      section = key.section;
      if (section == "domain" || section == "solver" || section.starts_with("fluid"))
        ImGui::SetNextItemOpen(section == "domain", ImGuiCond_FirstUseEver);
      open = ImGui::TreeNode(section.empty() ? "scene" : section.c_str());
    }
    if (open) key_row(key);
  }
  if (open) ImGui::TreePop();
}

void Viewer::key_row(const SceneKey& key) {
  ImGui::PushID(key.path.c_str());
  std::string value = edited_key_ == key.path ? edited_value_ : key.value;
  for (const Override& w : shown_->waiting)
    if (w.first == key.path && w.second && edited_key_ != key.path) value = *w.second;
  ImGui::SetNextItemWidth(11 * ImGui::GetFontSize());
  const bool changed = edit_value(key, value);
  const bool ended = ImGui::IsItemDeactivatedAfterEdit();
  const bool hovered = ImGui::IsItemHovered();
  ImGui::SameLine();
  const std::string& shown_name = key_filter_.empty() ? key.name : key.path;
  if (is_waiting(shown_->waiting, key.path))
    ImGui::TextColored(ImVec4(1, 0.8f, 0.4f, 1), "%s *", shown_name.c_str());
  else if (key.live) ImGui::Text("%s", shown_name.c_str());
  else ImGui::TextDisabled("%s", shown_name.c_str());
  if (hovered || ImGui::IsItemHovered()) {
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(30 * ImGui::GetFontSize());
    ImGui::TextUnformatted(tooltip_of(key).c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
  }
  if (changed) {
    edited_key_ = key.path;
    edited_value_ = value;
  }
  const bool mine = edited_key_ == key.path;
  const bool number = key.kind == SceneKey::Kind::number || key.kind == SceneKey::Kind::numbers ||
                      key.kind == SceneKey::Kind::integer;
  const bool at_once =
      changed && (key.kind == SceneKey::Kind::boolean || key.kind == SceneKey::Kind::word);
  const bool dragged =
      changed && number && key.live && ImGui::GetTime() - last_change_ > change_interval;
  if (mine && (ended || at_once || dragged)) {
    session_.change({key.path, edited_value_});
    last_change_ = ImGui::GetTime();
    if (!dragged || ended) edited_key_.clear();
  }
  ImGui::PopID();
}

bool Viewer::edit_value(const SceneKey& key, std::string& value) {
  using Kind = SceneKey::Kind;
  const std::vector<float> numbers =
      key.kind == Kind::number || key.kind == Kind::integer || key.kind == Kind::numbers
          ? numbers_in(value)
          : std::vector<float>();
  if (!numbers.empty() && numbers.size() <= 4) {
    std::vector<float> changed = numbers;
    const bool whole = key.kind == Kind::integer;
    float size = 0;
    for (const float x : numbers) size = std::max(size, std::abs(x));
    const float speed = whole ? 0.2f : size > 0 ? 0.01f * size : 0.01f;
    if (!ImGui::DragScalarN("##value", ImGuiDataType_Float, changed.data(), int(changed.size()),
                            speed, nullptr, nullptr, whole ? "%.0f" : "%.4g"))
      return false;
    if (key.kind != Kind::numbers) {
      changed[0] = std::clamp(changed[0], float(key.min), float(key.max));
      value = number_text(changed[0], whole);
      return true;
    }
    value = "[";
    for (std::size_t k = 0; k < changed.size(); ++k)
      value += (k ? ", " : "") + number_text(changed[k], false);
    value += "]";
    return true;
  }
  if (key.kind == Kind::boolean) {
    bool on = value == "true";
    const bool changed = ImGui::Checkbox("##value", &on);
    value = on ? "true" : "false";
    return changed;
  }
  if (key.kind == Kind::word) {
    const std::string plain = value.size() > 1 ? value.substr(1, value.size() - 2) : value;
    bool changed = false;
    if (!ImGui::BeginCombo("##value", plain.empty() ? "default" : plain.c_str())) return false;
    for (const std::string& word : key.words)
      if (ImGui::Selectable(word.c_str(), word == plain)) {
        value = "\"" + word + "\"";
        changed = true;
      }
    ImGui::EndCombo();
    return changed;
  }
  const std::string hint = key.fallback.empty() ? "not set" : key.fallback;
  return ImGui::InputTextWithHint("##value", hint.c_str(), &value);
}

}  // namespace freshet::window
