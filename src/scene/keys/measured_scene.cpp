// SPDX-License-Identifier: MIT
#include "scene/keys/measured_scene.h"

#include "scene/check/findings.h"
#include "scene/keys/overrides.h"
#include "scene/keys/parse_toml.h"
#include "scene/keys/reader.h"
#include "scene/model/setup.h"

namespace freshet {
namespace {

/// Probes are measured at every frame, and have no times of their own.
void check_times(const Scene& scene, Findings& out) {
  for (std::size_t k = 0; k < scene.probe.size(); ++k)
    out.unused(fmt::format("probe[{}].every", k), "probe.every",
               "a finished run is measured at each of its data files; remove it");
}

/// Removes from a scene what is not measured.
void keep_measures(toml::table& scene) {
  toml::table kept;
  for (auto&& [key, value] : scene)
    if (key == "probe" || key == "counter") kept.insert(key, std::move(value));
  scene = std::move(kept);
}

}  // namespace

Scene measured_scene(const Scene& run, const std::string& text, const std::string& name,
                     const std::vector<Override>& overrides) {
  toml::table table = parse_toml(text, name);
  if (table.contains("domain")) keep_measures(table);
  const auto overridden = apply_overrides(table, overrides);
  SceneReader reader(table, name, overridden, std::size_t(run.dimension()));
  Scene scene = run;
  scene.probe.clear();
  scene.counter.clear();
  measured_keys(reader, scene);
  reader.finish();
  scene = with_defaults(std::move(scene));
  scene.places = reader.places();
  Findings findings(scene);
  if (!reader.unread().contains("probe")) {
    check_probes(scene, findings);
    check_times(scene, findings);
  }
  if (!reader.unread().contains("counter")) check_counters(scene, findings);
  std::vector<Diagnostic> errors = reader.diagnostics();
  errors.insert(errors.end(), findings.list.begin(), findings.list.end());
  throw_errors(std::move(errors), reader, name);
  return scene;
}

}  // namespace freshet
