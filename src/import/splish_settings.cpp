// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "import/splishsplash.h"

namespace freshet {
namespace {

const std::vector<const char*> splish_methods{
    "WCSPH", "PCISPH", "PBF", "IISPH", "DFSPH", "Projective Fluids", "ICSPH"};
constexpr const char* splish_solvers[] = {"wcsph", "pcisph", "pbf",  "iisph",
                                          "dfsph", "dfsph",  "iisph"};

/// A tolerance in percent as a fraction in the range of the key.
double splish_tolerance(JsonObject& block, const char* key, double fallback, double max) {
  const double percent = block.number(key, fallback, {.min = 0, .above = true});
  const double fraction = std::clamp(percent / 100, 1e-6, max);
  if (std::abs(fraction - percent / 100) > 1e-12)
    block.instead(
        key, fmt::format("{:g} % is out of range; taken instead: {:g} %", percent, 100 * fraction));
  return fraction;
}

void read_wcsph(JsonObject& block, SplishSettings& s) {
  const double stiffness = block.number("stiffness", 50, {.min = 0});
  const double exponent = block.number("exponent", 7, {.min = 0, .above = true});
  s.bulk_modulus = stiffness * exponent;
  s.wcsph = block;
  if (exponent != 7)
    block.instead("exponent",
                  fmt::format("{:g}; taken instead: 7, with the same speed of sound", exponent));
}

void read_pressure_solver(JsonObject& block, int method, TomlTable& solver) {
  const long fewest = block.integer("minIterations", 2, 0, 1000000);
  const long most = block.integer("maxIterations", 100, 1, 1000000);
  solver.line("min_iterations", std::to_string(std::max(1L, fewest)));
  solver.line("max_iterations", std::to_string(std::max(most, std::max(1L, fewest))));
  if (method == 5) block.instead("maxError", "in units of its own; taken instead: 0.01 %");
  solver.set("density_tolerance",
             method == 5 ? 1e-4 : splish_tolerance(block, "maxError", 0.01, 0.1));
  if (splish_solvers[method] == std::string("dfsph"))
    solver.set("divergence_tolerance",
               method == 5 ? 1e-3 : splish_tolerance(block, "maxErrorV", 0.1, 1));
  if (method != 2) solver.set("density_correction", "at_once");
  if (method == 4) {
    if (!block.boolean("enableDivergenceSolver", true))
      block.instead("enableDivergenceSolver", "false; taken instead: both solves of dfsph");
    if (block.integer("maxIterationsV", most, 1, 1000000) != most)
      block.instead("maxIterationsV", fmt::format("taken instead: maxIterations, {}", most));
  }
  block.missing("velocityUpdateMethod", "pbf has one way to update velocities");
  block.missing("stiffness", "projective fluids have no counterpart");
  block.missing("lambda", "compressible liquids have no counterpart: the flow is incompressible");
  block.missing("pressureClamping", "iisph clamps negative pressures always");
}

/// The blocks of the methods that the scene does not use are read by nobody in SPlisHSPlasH, too.
void read_method(JsonObject& config, SplishSettings& s) {
  s.method = config.choice("simulationMethod", 4, splish_methods);
  const std::size_t method = std::size_t(s.method);
  s.solver.set("name", splish_solvers[method]);
  if (s.method == 5)
    config.instead("simulationMethod",
                   "projective fluids have no counterpart; taken instead: dfsph");
  if (s.method == 6)
    config.instead("simulationMethod",
                   "the compressible method ICSPH has no counterpart; taken instead: iisph");
  for (std::size_t k = 0; k < splish_methods.size(); ++k)
    if (k != method)
      config.missing(splish_methods[k],
                     "no effect in SPlisHSPlasH either: another method is chosen");
  JsonObject block = config.object(splish_methods[method]);
  if (s.method == 0) read_wcsph(block, s);
  else read_pressure_solver(block, s.method, s.solver);
  block.finish();
}

void read_kernel(JsonObject& config, SplishSettings& s) {
  const std::vector<const char*> kernels{"cubic spline", "Wendland C2", "poly6", "spiky",
                                         "precomputed cubic spline"};
  const int kernel = config.choice("kernel", 4, kernels);
  const int gradient = config.choice("gradKernel", kernel, kernels);
  if (kernel == 1) s.solver.set("kernel", "wendland_c2");
  if (kernel == 2 || kernel == 3)
    config.instead("kernel",
                   fmt::format("{}; taken instead: cubic_spline", kernels[std::size_t(kernel)]));
  if (gradient % 4 != kernel % 4)
    config.instead("gradKernel", "taken instead: the gradient of the kernel itself");
}

void read_time(JsonObject& config, SplishSettings& s, SplishWorld& world) {
  const double stop = config.number("stopAt", -1), pause = config.number("pauseAt", -1);
  if (stop > 0) world.duration = stop;
  else if (pause > 0) world.duration = pause;
  if (stop <= 0 && pause > 0) config.instead("pauseAt", "taken as the end of the run");
  s.time.set("end", world.duration);
  const double first = config.number("timeStepSize", 0.001, {.min = 0, .above = true});
  const double longest = config.number("cflMaxTimeStepSize", 0.005, {.min = 0, .above = true});
  const int method =
      config.choice("cflMethod", 1, {"fixed steps", "CFL", "CFL and the number of iterations"});
  s.time.set("step", "adaptive");
  s.time.set("step_max", method == 0 ? first : longest);
  if (method == 0)
    config.instead("cflMethod",
                   "fixed steps; taken instead: steps of this length, shorter only "
                   "where the flow is unstable otherwise");
  else if (first < longest) config.display({"timeStepSize"});
  if (method == 2)
    config.instead("cflMethod", "taken instead: 1, as iterations do not change steps");
  config.missing("cflFactor", "the time step has safety factors of its own (docs/solvers.md)");
  config.missing("cflMinTimeStepSize", "there is no shortest step");
}

/// The fields of data files.
std::string splish_fields(JsonObject& config) {
  std::string text = config.text("particleAttributes", "velocity"), fields;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    const std::string field = text.substr(begin, end - begin);
    begin = end + 1;
    if (field == "velocity" || field == "density" || field == "pressure" || field == "id")
      fields += (fields.empty() ? "\"" : ", \"") + field + "\"";
    else if (!field.empty())
      config.missing("particleAttributes",
                     fmt::format("data files have no field {}", in_one_line(field)));
  }
  return "[" + fields + "]";
}

void read_output(JsonObject& config, SplishSettings& s) {
  const double fps = config.number("dataExportFPS", 25, {.min = 0, .above = true});
  s.output.set("frame_every", 1 / fps);
  const bool partio = config.boolean("enablePartioExport", false);
  const bool vtk = config.boolean("enableVTKExport", false);
  s.output.line("data", partio && vtk ? "[\"bgeo\", \"vtp\"]"
                        : partio      ? "[\"bgeo\"]"
                        : vtk         ? "[\"vtp\"]"
                                      : "[]");
  if (partio || vtk) s.output.line("fields", splish_fields(config));
  if (config.boolean("enableStateExport", false))
    s.output.set("checkpoint_every",
                 1 / config.number("stateExportFPS", 1, {.min = 0, .above = true}));
  config.missing("scriptFile",
                 "scripts have no counterpart in a scene; docs/python.md steps a "
                 "simulation from Python");
  config.display({"pause", "numberOfStepsPerRenderUpdate", "renderWalls", "renderMaxVelocity",
                  "sceneScale", "enableZSort", "stepsPerZSort", "enableObjectSplitting",
                  "enableRigidBodyExport", "enableRigidBodyVTKExport", "particleAttributes",
                  "stateExportFPS", "colorMapType"});
}

void read_camera(JsonObject& config, SplishSettings& s, const SplishWorld& world) {
  if (world.flat() || !config.has("cameraPosition")) {
    config.display({"cameraPosition", "cameraLookat"});
    return;
  }
  s.camera.set("position", config.point("cameraPosition", {0, 3, 8}), 3);
  s.camera.set("target", config.point("cameraLookat", {0, 0, 0}), 3);
  s.camera.set("field_of_view", 40);
}

}  // namespace

SplishSettings read_splish_settings(JsonObject config, SplishWorld& world) {
  SplishSettings s;
  world.radius = config.number("particleRadius", 0.025, {.min = 0, .above = true});
  world.dimension = config.boolean("sim2D", false) ? 2 : 3;
  s.particles.set("spacing", world.spacing());
  if (world.only_points)
    config.assumed(
        "particleRadius",
        fmt::format("files of points are sampled for particles of 0.8 ρ0 (2r)^{0}; taken "
                    "instead: {1:.6g} m between particles, which gives them that mass",
                    world.dimension, world.spacing()));
  s.particles.set("support_radius", 4 * world.radius);
  s.gravity = config.point("gravitation", {0, -9.81, 0});
  const int walls =
      config.choice("boundaryHandlingMethod", 2, {"particles", "density maps", "volume maps"});
  world.particle_walls = walls == 0;
  if (walls != 0)
    config.instead("boundaryHandlingMethod",
                   "maps have no counterpart; taken instead: boundary particles");
  read_method(config, s);
  read_kernel(config, s);
  read_time(config, s, world);
  read_output(config, s);
  read_camera(config, s, world);
  config.finish();
  return s;
}

}  // namespace freshet
