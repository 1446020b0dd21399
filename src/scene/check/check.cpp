// SPDX-License-Identifier: MIT
#include "scene/check/check.h"

#include "scene/check/findings.h"
#include "scene/model/setup.h"

namespace freshet {

std::string place_of(const Scene& scene, std::string key) {
  while (!scene.places.contains(key) && !key.empty()) {
    const auto dot = key.find_last_of('.');
    key.erase(dot == std::string::npos ? 0 : dot);
  }
  const auto it = scene.places.find(key);
  return it == scene.places.end() ? "" : it->second;
}

namespace {

/// `places`: also checks that the particles have room, which samples them.
void check_all(const Scene& scene, const std::set<std::string, std::less<>>& unread, bool places,
               Findings& findings) {
  const auto read = [&](auto... sections) { return (!unread.contains(sections) && ...); };
  if (read("domain")) check_domain(scene, findings);
  if (read("domain") && findings.list.empty()) check_sizes(scene, findings);
  const bool sizes = read("domain") && findings.list.empty();
  bool sampled = read("particles") && check_particles(scene, findings);
  if (read("fluid", "inlet", "body") && scene.fluid.empty() && scene.inlet.empty() &&
      scene.body.empty())
    findings.error("fluid", "there is no fluid; add a [fluid] table, an [inlet], or bodies alone");
  if (read("time")) check_time(scene, findings);
  if (read("time", "output")) check_output(scene, findings);
  if (read("solver", "particles", "fluid")) check_method(scene, findings);
  if (!sizes) return;

  sampled = read("particles") && check_resolution(scene, findings) && sampled;
  if (read("probe")) check_probes(scene, findings);
  if (read("picture")) check_picture(scene, findings);
  if (read("whitewater")) check_whitewater(scene, findings);
  if (read("surface", "time")) check_surface_meshes(scene, findings);
  if (read("camera")) check_camera(scene, findings);
  if (read("particles")) check_periodic(scene, findings);
  if (read("solver")) check_gravity(scene, findings);
  if (read("solver")) check_body_force(scene, findings);
  if (read("solver", "fluid", "particles", "air", "walls", "wall")) check_forces(scene, findings);
  if (read("solver", "particles", "walls", "wall", "time")) check_scheme(scene, findings);
  if (read("solver", "walls")) check_sides(scene, findings);
  const bool walls = read("solver", "walls", "wall", "particles") && check_walls(scene, findings);
  const bool bodies = read("solver", "walls", "wall", "body", "joint", "particles", "time") &&
                      check_bodies(scene, findings);
  const bool flows = sampled && read("particles", "inlet", "outlet", "counter", "time") &&
                     check_flows(scene, walls, findings);
  if (!places) return;
  const FluidCount fluids =
      read("particles", "fluid") ? check_fluids(scene, findings) : FluidCount{};
  if (!sampled || !check_count(scene, fluids.places, {walls, bodies, flows}, findings)) return;
  const bool placed = bodies && (scene.body.empty() || check_body_places(scene, walls, findings));
  if ((walls || scene.wall.empty()) && (placed || scene.body.empty()) &&
      (flows || scene.inlet.empty()))
    check_room(scene, fluids, findings);
  if (findings.list.empty() && unread.empty()) check_stability(scene, fluids.places, findings);
}

}  // namespace

std::vector<Diagnostic> contradictions(const Scene& given,
                                       const std::set<std::string, std::less<>>& unread) {
  const Scene scene = with_defaults(given);
  Findings findings(scene);
  check_all(scene, unread, true, findings);
  return std::move(findings.list);
}

std::vector<UnusedKey> unused_keys(const Scene& given,
                                   const std::set<std::string, std::less<>>& unread) {
  const Scene scene = with_defaults(given);
  Findings findings(scene);
  check_all(scene, unread, false, findings);
  return std::move(findings.unused_keys);
}

void check_scene(const Scene& scene) {
  auto errors = contradictions(scene, {});
  if (!errors.empty()) throw Error(Error::Kind::scene, std::move(errors));
}

}  // namespace freshet
