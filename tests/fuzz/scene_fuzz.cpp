// SPDX-License-Identifier: MIT
/// Any bytes give a scene or an Error. A scene with overrides is written as TOML that reads as a
/// scene again.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "freshet/derived.h"
#include "freshet/scene.h"

namespace {

using freshet::Override;

constexpr std::string_view separator = "\n#--set ";  // a comment in TOML
constexpr double few_places = 20000;

/// Removes the overrides from the end of the input and returns them: lines of "#--set KEY=VALUE", or
/// of "#--set KEY", which removes the key.
std::vector<Override> take_overrides(std::string& text) {
  std::vector<Override> all;
  while (all.size() < 4) {
    const auto at = text.rfind(separator);
    if (at == std::string::npos) break;
    const std::string pair = text.substr(at + separator.size());
    text.resize(at + 1);
    const auto equals = pair.find('=');
    if (equals == std::string::npos) all.emplace_back(pair, std::nullopt);
    else all.emplace_back(pair.substr(0, equals), pair.substr(equals + 1));
  }
  return all;
}

void require(bool good, const char* what, const std::string& text) {
  if (good) return;
  std::fprintf(stderr, "%s:\n%s\n", what, text.c_str());
  std::abort();
}

void check_error(const freshet::Error& e, bool overridden) {
  require(e.kind() == freshet::Error::Kind::scene, "the error is not of kind scene", e.what());
  require(!e.diagnostics().empty(), "the error has no diagnostic", "");
  for (const auto& d : e.diagnostics()) {
    require(d.message.size() < 2000, "the message has 2000 characters or more", d.message);
    const bool in_points =
        d.place.find(".csv") != std::string::npos || d.place.find(".ply") != std::string::npos;
    require(
        d.place.starts_with("fuzz") || in_points || (overridden &&
             (d.place.starts_with("override ") || d.place.starts_with("removal "))),
        "the diagnostic does not name a file or a key", d.text());
  }
}

/// An upper bound of the number of places that fluids and walls are sampled at.
double places_of(const freshet::Scene& scene) {
  double domain = 1, all = 0;
  for (std::size_t k = 0; k < scene.domain.max.size(); ++k)
    domain *= (scene.domain.max[k] - scene.domain.min[k]) / scene.particles.spacing + 10;
  for (const auto& f : scene.fluid) {
    double n = 1;
    for (const auto c : f.count) n *= double(c);
    all += f.shape == freshet::Shape::lattice ? n : domain;
  }
  return all + domain * double(1 + scene.wall.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string text(reinterpret_cast<const char*>(data), size);
  const auto overrides = take_overrides(text);
  freshet::Scene scene;
  try {
    scene = freshet::parse_scene(text, "fuzz", overrides);
  } catch (const freshet::Error& e) {
    check_error(e, !overrides.empty());
    return 0;
  }
  try {
    const auto again = freshet::parse_scene(scene.source, "fuzz");
    require(again.title == scene.title && again.steps() == scene.steps() &&
                again.particles.spacing == scene.particles.spacing,
            "the scene changes when its source is read again", scene.source);
  } catch (const freshet::Error& e) {
    require(false, e.what(), scene.source);
  }
  try {
    if (places_of(scene) < few_places) freshet::scene_warnings(scene);
  } catch (const freshet::Error& e) {
    check_error(e, !overrides.empty());
  }
  return 0;
}
