// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "import/splishsplash.h"

namespace freshet {
namespace {

const std::vector<const char*> viscosities{"none",
                                           "Standard viscosity",
                                           "Bender and Koschier 2017",
                                           "Peer et al. 2015",
                                           "Peer et al. 2016",
                                           "Takahashi et al. 2015 (improved)",
                                           "Weiler et al. 2018"};
const std::vector<const char*> tensions{
    "none",           "Becker & Teschner 2007", "Akinci et al. 2013",
    "He et al. 2014", "Jeske et al. 2023",      "Zorilla, Ritter, et al. 2020"};
const std::vector<const char*> vorticities{"none", "Bender et al. 2017", "Vorticity confinement",
                                           "Liu et al. 2021"};
const std::vector<const char*> drags{"none", "Macklin et al. 2014", "Gissler et al. 2017"};
const std::vector<const char*> elasticities{"none", "Becker et al. 2009", "Peer et al. 2018",
                                            "Kugelstadt et al. 2021"};
constexpr const char* liquid_colors[] = {"#3a86ff", "#ffb703", "#43aa8b",
                                         "#e63946", "#8338ec", "#fb8500"};
constexpr double water_tension = 0.0728;  // [N/m]
/// What Weiler et al. 2018 need for the flows that SPlisHSPlasH's scenes show [m²/s].
constexpr double thick_viscosity = 5;

/// What the materials have chosen together: these are keys of the solver, not of a fluid.
struct SplishForces {
  bool implicit_viscosity = false, any_viscosity = false;
  std::string tension = "none";
  double xsph = 0;
  std::optional<double> vorticity, inertia, drag;
};

/// The blocks of the methods that the material does not use.
void skip_blocks(JsonObject& material, const std::vector<const char*>& names, int used) {
  for (std::size_t k = 1; k < names.size(); ++k)
    if (int(k) != used)
      material.missing(names[k], "no effect in SPlisHSPlasH either: another method is chosen");
}

/// Kinematic viscosity [m²/s].
double read_viscosity(JsonObject& material, SplishForces& forces, bool& sticks) {
  const int method = material.choice("viscosityMethod", 0, viscosities);
  skip_blocks(material, viscosities, method);
  if (method == 0) return 0;
  JsonObject block = material.object(viscosities[std::size_t(method)]);
  double nu = block.number("viscosity", 0.01, {.min = 0});
  forces.any_viscosity = true;
  forces.implicit_viscosity |= method != 1;
  if (method >= 2 && method <= 4) {
    nu = thick_viscosity;
    block.instead("viscosity", fmt::format("a share of the strain rate, without a unit; taken "
                                           "instead: {:g} m²/s",
                                           nu));
  }
  if (method >= 2 && method <= 5)
    material.instead("viscosityMethod", fmt::format("{}; taken instead: weiler2018",
                                                    viscosities[std::size_t(method)]));
  const double at_walls = block.number("viscosityBoundary", 0, {.min = 0});
  if (at_walls > 0) sticks = true;
  if (at_walls > 0 && at_walls != nu)
    block.instead("viscosityBoundary", "taken instead: the viscosity of the fluid (no_slip)");
  block.missing("viscoMaxIter", "solver.viscosity_max_iterations has its default");
  block.missing("viscoMaxError",
                "solver.viscosity_tolerance measures another error and has its default");
  block.missing("viscoMaxIterOmega", "there is no solve for the vorticity");
  block.missing("viscoMaxErrorOmega", "there is no solve for the vorticity");
  block.finish();
  return nu;
}

void read_tension(JsonObject& material, SplishLiquid& liquid, SplishForces& forces,
                  const SplishWorld& world) {
  const int method = material.choice("surfaceTensionMethod", 0, tensions);
  skip_blocks(material, tensions, method);
  if (method == 0) return;
  JsonObject block = material.object(tensions[std::size_t(method)]);
  const double set = block.number("surfaceTension", 0.05, {.min = 0});
  const bool in_newton = method == 5;
  const double sigma = in_newton && set > 0 ? set : water_tension;
  const std::string ours = method == 2 ? "akinci2013" : "morris2000";
  if (!world.has_fluid) {
    material.missing("surfaceTensionMethod",
                     "a scene whose liquid comes from emitters only has no "
                     "surface tension");
  } else {
    liquid.surface_tension = sigma;
    if (forces.tension == "none") forces.tension = ours;
    material.instead(
        "surfaceTensionMethod",
        fmt::format("{}; taken instead: {} with {:g} N/m{}", tensions[std::size_t(method)], ours,
                    sigma, in_newton ? "" : ", as the coefficient has another unit"));
  }
  const double at_walls = block.number("surfaceTensionBoundary", 0);
  if (at_walls != 0)
    block.missing("surfaceTensionBoundary", "set fluid.adhesion, which akinci2013 uses");
  for (const char* key : {"surfaceTensionViscosity",
                          "surfaceTensionViscosityBoundary",
                          "surfaceTensionMaxIter",
                          "surfaceTensionMaxError",
                          "surfaceTensionXSPH",
                          "surfaceTensionMode",
                          "surfTZRCsd",
                          "surfTZRMCSamples",
                          "surfTZRNeighLimit",
                          "surfTZRPcaMixCur",
                          "surfTZRPcaMixNrm",
                          "surfTZRd",
                          "surfTZRd-offset",
                          "surfTZRnormal-mode",
                          "surfTZRr-ratio",
                          "surfTZRsampling",
                          "surfTZRtau",
                          "surfTZRtemporalSmooth",
                          "surfTZRversion",
                          "surfTZRsmoothPasses"})
    block.missing(key, "a setting of this method only");
  block.finish();
}

void read_vorticity(JsonObject& material, SplishForces& forces) {
  const int method = material.choice("vorticityMethod", 0, vorticities);
  skip_blocks(material, vorticities, method);
  if (method > 1)
    material.missing("vorticityMethod",
                     fmt::format("{} has no counterpart; set solver.vorticity_method = "
                                 "\"bender2017\" for eddies",
                                 vorticities[std::size_t(method)]));
  if (method == 0) return;
  JsonObject block = material.object(vorticities[std::size_t(method)]);
  const double transfer = block.number("vorticity", 0.01, {.min = 0});
  const double inverse = block.number("inertiaInverse", 0.5, {.min = 0});
  if (method == 1 && transfer > 0) {
    forces.vorticity = transfer;
    if (inverse > 0) forces.inertia = 1 / inverse;
  }
  block.missing("viscosityOmega", "spin has no viscosity of its own");
  block.missing("kinetmaticViscosity", "a setting of this method only");
  block.missing("kinematicViscosity", "a setting of this method only");
  block.finish();
}

void read_drag(JsonObject& material, SplishLiquid& liquid, SplishForces& forces,
               const SplishWorld& world) {
  const int method = material.choice("dragMethod", 0, drags);
  skip_blocks(material, drags, method);
  if (method == 0) return;
  JsonObject block = material.object(drags[std::size_t(method)]);
  const double factor = block.number("drag", 0.01, {.min = 0});
  if (!world.has_fluid) {
    material.missing("dragMethod", "a scene whose liquid comes from emitters only has no drag");
  } else if (factor > 0) {
    forces.drag = method == 2 ? factor : 1;
    if (!liquid.surface_tension) liquid.surface_tension = water_tension;
  }
  if (method == 2)
    block.instead("drag", fmt::format("a factor of the drag; taken instead: air.density = {:g}",
                                      1.2 * factor));
  else material.instead("dragMethod", "Macklin et al. 2014; taken instead: gissler2017 in air");
  block.finish();
}

void read_elasticity(JsonObject& material) {
  const int method = material.choice("elasticityMethod", 0, elasticities);
  if (method != 0)
    material.missing("elasticityMethod",
                     "elastic solids have no counterpart: the material flows as a liquid");
  for (const char* block : elasticities)
    material.missing(block, "elastic solids have no counterpart");
}

void read_emission(JsonObject& material, SplishLiquid& liquid) {
  liquid.max_particles = material.integer("maxEmitterParticles", 10000, 0, 4000000000);
  liquid.reuse = material.boolean("emitterReuseParticles", false);
  const Vec<3, double> low = material.point("emitterBoxMin", {-1, -1, -1}),
                       high = material.point("emitterBoxMax", {1, 1, 1});
  liquid.reuse_box.low = low;
  liquid.reuse_box.high = high;
}

/// How a single material is coloured; pictures of several show the liquids.
void read_look(JsonObject& material, bool single, TomlTable& picture) {
  if (!single || !material.has("colorField")) {
    material.display({"colorField", "colorMapType", "renderMinValue", "renderMaxValue", "visible"});
    return;
  }
  const std::string field = material.text("colorField", "velocity");
  const bool speed = field == "velocity";
  if (field == "density" || field == "pressure") picture.set("color_by", field);
  else if (field == "position") picture.set("color_by", "height");
  else if (!speed)
    material.instead("colorField", fmt::format("{}; taken instead: speed", in_one_line(field)));
  const double low = material.number("renderMinValue", 0),
               high = material.number("renderMaxValue", 5);
  if (speed && material.has("renderMaxValue") && high > low)
    picture.line("color_range", fmt::format("[{}, {}]", toml_number(low), toml_number(high)));
  material.display({"colorMapType", "visible"});
}

}  // namespace

TomlTable SplishLiquid::of_inlet() const {
  TomlTable table;
  table.set("rest_density", rest_density);
  table.set("viscosity", viscosity);
  if (!color.empty()) table.set("color", color);
  return table;
}

TomlTable SplishLiquid::of_fluid() const {
  TomlTable table = of_inlet();
  if (surface_tension) table.set("surface_tension", *surface_tension);
  return table;
}

const SplishLiquid& SplishMaterials::liquid(const std::string& id) const {
  static const SplishLiquid water;
  const auto found = liquids.find(id);
  return found == liquids.end() ? water : found->second;
}

SplishMaterials read_splish_materials(std::vector<JsonObject> materials,
                                      const std::vector<std::string>& ids,
                                      const SplishWorld& world) {
  SplishMaterials result;
  SplishForces forces;
  for (JsonObject& m : materials) {
    const std::string id = m.text("id", "");
    const auto used = std::find(ids.begin(), ids.end(), id);
    if (used == ids.end()) {
      m.missing("id", "no block, model or emitter has this id");
      continue;
    }
    SplishLiquid& liquid = result.liquids[id];
    if (ids.size() > 1) liquid.color = liquid_colors[std::size_t(used - ids.begin()) % 6];
    liquid.rest_density = m.number("density0", 1000, {.min = 0, .above = true});
    liquid.viscosity = liquid.rest_density * read_viscosity(m, forces, result.sticks);
    read_tension(m, liquid, forces, world);
    read_vorticity(m, forces);
    read_drag(m, liquid, forces, world);
    read_elasticity(m);
    read_emission(m, liquid);
    JsonObject xsph = m.object("XSPH");
    forces.xsph = std::max(forces.xsph, xsph.number("xsph", 0, {.min = 0, .max = 1}));
    if (forces.xsph > 0)
      xsph.instead("xsph",
                   "solver.xsph keeps rotation, and counts per 0.25 sqrt(h/g), not per step");
    xsph.missing("xsphBoundary", "walls have no part in solver.xsph");
    xsph.finish();
    read_look(m, ids.size() == 1, result.picture);
    m.finish();
  }
  if (ids.size() > 1) result.picture.set("color_by", "liquid");
  for (std::size_t k = 0; k < ids.size(); ++k)  // ids without a material are water
    if (SplishLiquid& liquid = result.liquids[ids[k]]; ids.size() > 1)
      liquid.color = liquid_colors[k % 6];
  // Drag and tension read this key of every fluid.
  if (forces.tension != "none" || forces.drag)
    for (auto& [id, liquid] : result.liquids)
      if (!liquid.surface_tension) liquid.surface_tension = water_tension;
  result.xsph = forces.xsph;
  result.solver.set("viscosity_method", forces.implicit_viscosity ? "weiler2018" : "monaghan2005");
  if (forces.tension != "none") result.solver.set("surface_tension_method", forces.tension);
  if (forces.vorticity) {
    result.solver.set("vorticity_method", "bender2017");
    result.solver.set("vorticity_transfer", *forces.vorticity);
    if (forces.inertia) result.solver.set("vorticity_inertia", *forces.inertia);
  }
  if (forces.drag) {
    result.air.set("drag", "gissler2017");
    result.air.set("density", 1.2 * *forces.drag);
  }
  return result;
}

}  // namespace freshet
