// SPDX-License-Identifier: MIT
#include "scene/model/inputs.h"

#include <fmt/format.h>

#include <filesystem>
#include <sstream>

#include "core/input_file.h"
#include "scene/keys/overrides.h"

namespace freshet {

Inputs inputs_of(const Scene& scene) {
  Inputs inputs{scene.source, {}};
  std::vector<Override> names;
  const auto add = [&](const char* table, std::size_t k, const std::filesystem::path& file,
                       const char* key = "file") {
    if (file.empty()) return;
    // not a TOML value, so that apply_overrides takes it as a string
    const std::string name = fmt::format("inputs/{}_{}_{}", table, k, file.filename().string());
    inputs.files.emplace_back(name, read_input(file));
    names.emplace_back(fmt::format("{}[{}].{}", table, k, key), name);
  };
  for (std::size_t k = 0; k < scene.fluid.size(); ++k) {
    const Scene::Fluid& f = scene.fluid[k];
    add("fluid", k, f.file, f.from_run.empty() ? "file" : "from_run");
    if (f.from_run.empty()) continue;
    if (f.time) names.emplace_back(fmt::format("fluid[{}].time", k), std::nullopt);
    if (f.frame) names.emplace_back(fmt::format("fluid[{}].frame", k), std::nullopt);
  }
  for (std::size_t k = 0; k < scene.wall.size(); ++k) add("wall", k, scene.wall[k].file);
  for (std::size_t k = 0; k < scene.body.size(); ++k) {
    add("body", k, scene.body[k].file);
    add("body", k, scene.body[k].path, "path");
  }
  if (names.empty() || scene.source.empty()) return inputs;
  toml::table table = toml::parse(scene.source);
  apply_overrides(table, names);
  std::ostringstream text;
  text << "# as run; the files that it reads are copies\n" << table << "\n";
  inputs.source = text.str();
  return inputs;
}

}  // namespace freshet
