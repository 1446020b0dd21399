// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>

#include "freshet/scene_keys.h"
#include "scene/keys/same_steps.h"

namespace freshet {
namespace {

// Without the numbers of sections. The constructors of engines read these keys as parameters; the
// fields of the state, the boundary particles and their number do not depend on them.
constexpr const char* live[] = {
    "domain.gravity",
    "domain.body_force",
    "fluid.viscosity",
    "fluid.surface_tension",
    "fluid.adhesion",
    "inlet.speed",
    "inlet.flow_rate",
    "inlet.stop",
    "inlet.viscosity",
    "wall.restitution",
    "walls.restitution",
    "joint.motor_speed",
    "joint.motor_torque",
    "body.friction",
    "body.restitution",
    "solver.stiffness",
    "solver.speed_limit",
    "solver.sound_speed",
    "solver.artificial_viscosity",
    "solver.delta",
    "solver.acoustic_damping",
    "solver.background_pressure",
    "solver.density_tolerance",
    "solver.divergence_tolerance",
    "solver.min_iterations",
    "solver.max_iterations",
    "solver.xsph",
    "solver.viscosity_tolerance",
    "solver.viscosity_max_iterations",
    "solver.vorticity_transfer",
    "solver.vorticity_inertia",
    "air.velocity",
    "air.density",
    "air.viscosity",
    "whitewater.trapped_air",
    "whitewater.wave_crest",
    "whitewater.trapped_air_limits",
    "whitewater.wave_crest_limits",
    "whitewater.speed_limits",
    "whitewater.lifetime",
    "whitewater.buoyancy",
    "whitewater.rise_speed",
    "time.step_max",
    "time.retry",
};

/// "fluid[0].viscosity" -> "fluid.viscosity"
std::string without_numbers(const std::string& path) {
  std::string name;
  bool inside = false;
  for (const char c : path) {
    if (c == '[') inside = true;
    if (!inside) name += c;
    if (c == ']') inside = false;
  }
  return name;
}

}  // namespace

bool may_change_while_running(const std::string& path) {
  const std::string name = without_numbers(path);
  if (!steps_depend_on(name) || name.starts_with("probe.")) return true;
  return std::find(std::begin(live), std::end(live), name) != std::end(live);
}

}  // namespace freshet
