// SPDX-License-Identifier: MIT
#include "run/film_materials.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "freshet/error.h"
#include "render/bodies.h"
#include "render/color.h"

namespace freshet {
namespace {

constexpr double thick = 1.0;            // viscosity of liquids that look like honey [Pa s]
constexpr double tinted_absorption = 8;  // of a liquid with a colour
constexpr double honey_ior = 1.49, honey_absorption = 16, honey_scattering = 0.12;

struct LiquidPreset {
  const char* name;
  LiquidMaterial material;
};
const LiquidPreset liquid_table[] = {
    {"water", {"#86cdea", 1.333, 1.8, 0, 0}}, {"sea", {"#2f9c9c", 1.34, 4, 0.04, 0}},
    {"oil", {"#e3c53a", 1.47, 3.5, 0, 0}},    {"honey", {"#e08a1e", 1.49, 16, 0.12, 0}},
    {"wine", {"#9c1230", 1.345, 2.5, 0, 0}},  {"juice", {"#f39a1f", 1.35, 6, 0.7, 0.05}},
    {"milk", {"#f6f1e4", 1.35, 6, 1, 0.08}},  {"chocolate", {"#4a2413", 1.45, 8, 1, 0.15}},
    {"mud", {"#6a4c31", 1.35, 8, 1, 0.4}},    {"paint", {"#c8342c", 1.45, 8, 1, 0.2}},
};

struct BodyPreset {
  const char* name;
  BodyMaterial material;
};
const BodyPreset body_table[] = {
    {"matte", {"matte", "", 1}},
    {"plastic", {"plastic", "", 0.3}},
    {"rubber", {"plastic", "#2b2b2e", 0.7}},
    {"metal", {"metal", "#c9ccd2", 0.25}},
    {"gold", {"metal", "#e6b653", 0.2}},
    {"wood", {"wood", "#b98046", 0.5}},
    {"glass", {"glass", "#f2f7f5", 0, 1.5}},
};

/// One choice: TARGET=PRESET,KEY=VALUE...
class Choice {
 public:
  explicit Choice(const std::string& text) : text_(text) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos)
      fail("write TARGET=PRESET, for example liquid=milk");
    target = text.substr(0, equals);
    std::size_t from = equals + 1;
    preset = text.substr(from, text.find(',', from) - from);
    while ((from = text.find(',', from)) != std::string::npos) {
      const std::size_t end = std::min(text.find(',', ++from), text.size());
      const std::string pair = text.substr(from, end - from);
      const std::size_t middle = pair.find('=');
      if (middle == std::string::npos)
        fail("write KEY=VALUE after the preset, for example ior=1.4");
      keys[pair.substr(0, middle)] = pair.substr(middle + 1);
    }
  }
  [[noreturn]] void fail(const std::string& message) const {
    throw Error(Error::Kind::scene, "option material " + text_, message);
  }

  /// Takes a number out of the keys.
  void take(const char* key, double& value, double low, double high) {
    const auto at = keys.find(key);
    if (at == keys.end()) return;
    const std::string& word = at->second;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (fault != std::errc() || end != word.data() + word.size() ||
        !(value >= low && value <= high))
      fail(fmt::format("{} must be a number from {} to {}", key, low, high));
    keys.erase(at);
  }
  void take_color(std::string& value) {
    const auto at = keys.find("color");
    if (at == keys.end()) return;
    const std::string& word = at->second;
    if (word.size() != 7 || word[0] != '#' ||
        word.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos)
      fail("color must be #rrggbb, for example #e08a1e");
    value = word;
    keys.erase(at);
  }
  void finish(const char* allowed) const {
    if (!keys.empty())
      fail(fmt::format("unknown key {}; the keys are {}", keys.begin()->first, allowed));
  }

  std::string target, preset;
  std::map<std::string, std::string> keys;

 private:
  std::string text_;
};

template <class Table>
auto material_of(const Choice& choice, const Table& table, const char* noun) {
  for (const auto& entry : table)
    if (choice.preset == entry.name) return entry.material;
  std::vector<std::string> names;
  for (const auto& entry : table) names.push_back(entry.name);
  choice.fail(fmt::format("unknown material \"{}\"; those of {} are {}", choice.preset, noun,
                          fmt::join(names, ", ")));
}

LiquidMaterial liquid_of(Choice choice) {
  LiquidMaterial m = material_of(choice, liquid_table, "liquids");
  choice.take_color(m.color);
  choice.take("ior", m.ior, 1, 3);
  choice.take("absorption", m.absorption, 0, 1000);
  choice.take("scattering", m.scattering, 0, 1);
  choice.take("roughness", m.roughness, 0, 1);
  choice.finish("color, ior, absorption, scattering and roughness");
  return m;
}

/// `color`: of a preset that has none.
BodyMaterial body_of(Choice choice, const std::string& color) {
  BodyMaterial m = material_of(choice, body_table, "bodies");
  if (m.color.empty()) m.color = color;
  choice.take_color(m.color);
  choice.take("ior", m.ior, 1, 3);
  choice.take("roughness", m.roughness, 0, 1);
  choice.finish("color, roughness and ior");
  return m;
}

std::vector<LiquidMaterial> liquids_of(const Scene& scene) {
  std::vector<LiquidMaterial> all;
  const auto liquids = scene.liquids();
  const std::vector<Color> colors = liquid_colors(scene);
  for (std::size_t k = 0; k < liquids.size(); ++k) {
    LiquidMaterial m = liquid_table[0].material;
    if (liquids.size() > 1 || !liquids[k].color.empty()) {
      m.color = hex_code(colors[k]);
      m.absorption = tinted_absorption;
      if (liquids[k].viscosity >= thick) {
        m.ior = honey_ior;
        m.absorption = honey_absorption;
        m.scattering = honey_scattering;
      }
    }
    all.push_back(m);
  }
  return all;
}

void apply(FilmMaterials& all, const Scene& scene, const Choice& choice) {
  bool found = false;
  for (std::size_t k = 0; k < all.liquids.size(); ++k)
    if (choice.target == "liquid" || choice.target == fmt::format("liquid{}", k)) {
      all.liquids[k] = liquid_of(choice);
      found = true;
    }
  for (std::size_t k = 0; k < all.bodies.size(); ++k)
    if (choice.target == "body" || choice.target == fmt::format("body{}", k) ||
        choice.target == scene.body[k].name) {
      all.bodies[k] = body_of(choice, hex_code(body_color(scene, k)));
      found = true;
    }
  if (found) return;
  std::vector<std::string> names{"liquid"};
  for (std::size_t k = 0; k < all.liquids.size(); ++k) names.push_back(fmt::format("liquid{}", k));
  if (!all.bodies.empty()) names.push_back("body");
  for (std::size_t k = 0; k < all.bodies.size(); ++k)
    names.push_back(scene.body[k].name.empty() ? fmt::format("body{}", k) : scene.body[k].name);
  choice.fail(
      fmt::format("this run has no \"{}\"; it has {}", choice.target, fmt::join(names, ", ")));
}

}  // namespace

std::string hex_code(Color c) { return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b); }

FilmMaterials film_materials(const Scene& scene, const std::vector<std::string>& choices) {
  FilmMaterials all{liquids_of(scene), {}};
  for (std::size_t k = 0; k < scene.body.size(); ++k)
    all.bodies.push_back({"matte", hex_code(body_color(scene, k)), 1});
  for (const std::string& text : choices) apply(all, scene, Choice(text));
  return all;
}

}  // namespace freshet
