// SPDX-License-Identifier: MIT
/// The forces beside pressure: viscosity, surface tension, vorticity, air.
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "freshet/force_method.h"
#include "scene/check/findings.h"
#include "scene/keys/keys.h"

namespace freshet {
namespace {

/// The force that a key chooses.
const ForceMethod& chosen(const Scene& s, std::string_view key) {
  const int place = key == "solver.viscosity_method"         ? int(s.viscosity_method())
                    : key == "solver.surface_tension_method" ? int(s.solver.surface_tension_method)
                    : key == "solver.shifting_method"        ? int(s.solver.shifting_method)
                    : key == "solver.vorticity_method"       ? int(s.solver.vorticity_method)
                                                             : int(s.air.drag);
  const auto first = std::find_if(force_methods().begin(), force_methods().end(),
                                  [&](const ForceMethod& m) { return m.key == key; });
  return first[place];
}

bool reads(const ForceMethod& m, std::string_view key) {
  return std::find(m.reads.begin(), m.reads.end(), key) != m.reads.end();
}

/// Keys that none of the chosen forces reads.
void check_keys_of_forces(const Scene& s, Findings& out) {
  std::map<std::string_view, std::vector<const ForceMethod*>> readers;
  for (const ForceMethod& m : force_methods())
    for (const std::string_view key : m.reads) readers[key].push_back(&m);
  for (const auto& [key, methods] : readers) {
    const auto acts = [&, k = key](const ForceMethod* m) { return reads(chosen(s, m->key), k); };
    if (std::any_of(methods.begin(), methods.end(), acts)) continue;
    std::vector<std::string> choices;
    for (const ForceMethod* m : methods)
      choices.push_back(fmt::format("{} = \"{}\"", m->key, m->name));
    const std::string remedy = fmt::format("remove it, or choose {}", fmt::join(choices, " or "));
    const std::string name(key);
    if (!key.starts_with("fluid.")) out.unused(name, name, remedy);
    else
      for (std::size_t k = 0; k < s.fluid.size(); ++k)
        out.unused(fmt::format("fluid[{}].{}", k, name.substr(6)), name, remedy);
  }
}

void check_has_none(const Scene& s, Findings& out) {
  const auto none = [&](bool asked, const char* key) {
    if (asked)
      out.unsupported(key,
                      fmt::format("{} is for the other solvers, and solver.name is \"{}\"; remove "
                                  "it, or choose another solver",
                                  key, s.method().name));
  };
  none(s.solver.viscosity_method.has_value(), "solver.viscosity_method");
  none(s.solver.surface_tension_method != SurfaceTensionMethod::none,
       "solver.surface_tension_method");
  none(s.solver.shifting_method != ShiftingMethod::none, "solver.shifting_method");
  none(s.solver.vorticity_method != VorticityMethod::none, "solver.vorticity_method");
  none(s.air.drag != Drag::none, "air.drag");
}

void check_viscosity(const Scene& s, Findings& out) {
  const ViscosityMethod method = s.viscosity_method();
  if (s.method().incompressible() && method == ViscosityMethod::artificial)
    out.unsupported(
        "solver.viscosity_method",
        fmt::format("solver.viscosity_method = \"artificial\" is for wcsph and delta_sph, and "
                    "solver.name is \"{}\"; choose \"monaghan2005\", \"morris1997\" or "
                    "\"weiler2018\"",
                    s.method().name));
}

void check_surface(const Scene& s, Findings& out) {
  const SurfaceTensionMethod method = s.solver.surface_tension_method;
  const bool acts = method != SurfaceTensionMethod::none, flattens = s.air.drag != Drag::none;
  if (s.fluid.empty() && (acts || flattens))
    out.error(acts ? "solver.surface_tension_method" : "air.drag",
              fmt::format("{} reads fluid.surface_tension, and the scene has no fluid, only what "
                          "inlets bring; add a [fluid], or remove it",
                          acts ? "solver.surface_tension_method" : "air.drag"));
  for (std::size_t k = 0; k < s.fluid.size(); ++k) {
    const std::string at = fmt::format("fluid[{}].", k);
    if (acts && !s.fluid[k].surface_tension)
      out.error(at + "surface_tension",
                fmt::format("solver.surface_tension_method = \"{}\" needs fluid.surface_tension "
                            "(N/m); water's is 0.0728",
                            force_words("solver.surface_tension_method")[std::size_t(method)]));
    else if (flattens && !s.fluid[k].surface_tension)
      out.error(at + "surface_tension",
                "air.drag = \"gissler2017\" needs fluid.surface_tension (N/m), by which drops "
                "flatten in the wind; water's is 0.0728");
    const Scene::Fluid &a = s.fluid[0], &b = s.fluid[k];
    for (const auto& [key, differs] :
         {std::pair("surface_tension", a.surface_tension != b.surface_tension),
          std::pair("adhesion", a.adhesion != b.adhesion)})
      if (differs)
        out.error(at + key,
                  fmt::format("fluid[{}] and fluid[0] differ in {}; give all the same", k, key));
  }
}

/// What has no samples does not tell where the liquid ends at a wall from where it ends at all.
void check_surface_at_walls(const Scene& s, Findings& out) {
  if (s.solver.surface_tension_method != SurfaceTensionMethod::morris2000) return;
  const auto refuse = [&](WallMethod m, const std::string& key) {
    if (m != WallMethod::monaghan2009 && m != WallMethod::reflection) return false;
    out.error(key, fmt::format("walls of \"{}\" have no volume, and morris2000 takes what lies at "
                               "them for a free surface; choose \"akinci2012\", \"adami2012\" or "
                               "\"ghost\", or surface_tension_method = \"akinci2013\"",
                               method_words[int(m)]));
    return true;
  };
  const std::vector<std::string> names = s.wall_names();
  for (int side = 0; side < 2 * s.dimension(); ++side) {
    const std::string own = "walls." + names[std::size_t(side)];
    if (!s.periodic(side / 2) && refuse(s.side_method(side), out.given(own) ? own : "walls.method"))
      return;
  }
  for (std::size_t k = 0; k < s.wall.size(); ++k)
    if (refuse(s.wall_method(k), fmt::format("wall[{}].method", k))) return;
}

/// Walls whose samples attract the liquid.
bool has_akinci_walls(const Scene& s) {
  for (int side = 0; side < 2 * s.dimension(); ++side)
    if (!s.periodic(side / 2) && s.side_method(side) == WallMethod::akinci2012) return true;
  for (std::size_t k = 0; k < s.wall.size(); ++k)
    if (s.wall_method(k) == WallMethod::akinci2012) return true;
  return false;
}

void check_adhesion(const Scene& s, Findings& out) {
  if (s.solver.surface_tension_method != SurfaceTensionMethod::akinci2013) return;
  for (std::size_t k = 0; k < s.fluid.size(); ++k)
    if (s.fluid[k].adhesion > 0 && !has_akinci_walls(s))
      out.error(fmt::format("fluid[{}].adhesion", k),
                "fluid.adhesion acts at walls of \"akinci2012\", and there are none; remove it, "
                "or give walls that method");
}

void check_vorticity(const Scene& s, Findings& out) {
  const bool spins = s.solver.vorticity_method != VorticityMethod::none;
  if (!spins) return;
  if (!s.solver.vorticity_transfer)
    out.error("solver.vorticity_method",
              "solver.vorticity_method = \"bender2017\" needs solver.vorticity_transfer (m²/s); "
              "a hundredth of the spacing times the fastest speed is a good start");
  const char* reason =
      "solver.vorticity_method = \"bender2017\" does not know how a particle's image spins; "
      "choose another method than \"ghost\" for the wall, or vorticity_method = \"none\"";
  for (int side = 0; side < 2 * s.dimension(); ++side)
    if (!s.periodic(side / 2) && s.side_method(side) == WallMethod::ghost)
      return out.error("solver.vorticity_method", reason);
  for (std::size_t k = 0; k < s.wall.size(); ++k)
    if (s.wall_method(k) == WallMethod::ghost) return out.error("solver.vorticity_method", reason);
}

void check_shifting(const Scene& s, Findings& out) {
  if (s.solver.shifting_method != ShiftingMethod::none && !s.inlet.empty())
    out.error("solver.shifting_method",
              "solver.shifting_method is for flows that fill their space, and would shift what the "
              "inlets hold; remove it, or the inlets");
}

void check_air(const Scene& s, Findings& out) {
  if (s.air.drag != Drag::none) {
    for (std::size_t k = 1; k < s.fluid.size(); ++k)
      if (s.liquid_of(k) != s.liquid_of(0))
        return out.error(
            "air.drag", fmt::format("air.drag = \"gissler2017\" takes one liquid, and fluid[{}] is "
                                    "another than fluid[0]; give all the same, or remove it",
                                    k));
    return;
  }
}

}  // namespace

void check_forces(const Scene& s, Findings& out) {
  if (!s.method().has_boundary_particles()) check_has_none(s, out);
  else check_viscosity(s, out);
  check_keys_of_forces(s, out);
  check_surface(s, out);
  check_surface_at_walls(s, out);
  check_adhesion(s, out);
  check_vorticity(s, out);
  check_shifting(s, out);
  check_air(s, out);
}

}  // namespace freshet
