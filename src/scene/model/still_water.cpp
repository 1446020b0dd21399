// SPDX-License-Identifier: MIT
#include "scene/model/still_water.h"

#include <algorithm>
#include <cmath>

#include "scene/model/setup.h"

namespace freshet {
namespace {

bool is_at_rest(const Vector& v) {
  return std::all_of(v.begin(), v.end(), [](double x) { return x == 0; });
}

/// Whether gravity points down and nothing else acts.
bool only_gravity_acts(const Scene& s) {
  if (!(s.domain.gravity[1] < 0)) return false;
  for (std::size_t k = 0; k < s.domain.gravity.size(); ++k)
    if (k != 1 && s.domain.gravity[k] != 0) return false;
  for (const Scene::Wall& wall : s.wall)
    if (!is_at_rest(wall.velocity)) return false;
  return s.body.empty() && !s.has_flows() && s.domain.body_force.empty() && !s.periodic(1) &&
         s.air.drag == Drag::none &&
         s.solver.surface_tension_method == SurfaceTensionMethod::none && !s.is_article();
}

/// A box from side to side that rests.
bool is_level_layer(const Scene& s, const Scene::Fluid& f) {
  if (f.shape != Shape::box || f.side != Side::inside || !f.surface.empty() ||
      !is_at_rest(f.velocity) || !f.velocity_field.empty() ||
      f.pressure != StartPressure::hydrostatic)
    return false;
  for (std::size_t k = 0; k < f.min.size(); ++k)
    if (k != 1 && (f.min[k] > s.domain.min[k] + 0.5 * s.particles.spacing ||
                   f.max[k] < s.domain.max[k] - 0.5 * s.particles.spacing))
      return false;
  return true;
}

}  // namespace

double still_depth(const Scene& s) {
  if (s.fluid.empty() || !only_gravity_acts(s) || s.liquids().size() > 1) return 0;
  for (int side = 0; side < 2 * s.dimension(); ++side)
    if (side != 3 && !s.periodic(side / 2) && s.side_method(side) == WallMethod::open) return 0;
  double low = s.fluid[0].min.empty() ? 0 : s.fluid[0].min[1], high = low, thickness = 0;
  for (const Scene::Fluid& f : s.fluid) {
    if (!is_level_layer(s, f)) return 0;
    low = std::min(low, f.min[1]);
    high = std::max(high, f.max[1]);
    thickness += f.max[1] - f.min[1];
  }
  const double gap = 0.5 * s.particles.spacing;
  const bool stacked = std::abs(high - low - thickness) < gap;
  return stacked && low < s.domain.min[1] + gap ? high - low : 0;
}

double churning_speed(const Scene& s, double depth) {
  if (!s.method().reads("solver.iteration") || corrects_gradually(s) || !s.solver.warm_start ||
      density_tolerance(s) < 5e-5)
    return 0;
  const double g = std::abs(s.domain.gravity[1]), spacing = s.particles.spacing;
  return 0.009 * std::pow(depth / spacing, 0.75) * std::sqrt(g * spacing);
}

const char* remedy_for_churning(const Scene& s) {
  if (!s.method().incompressible()) return "make the viscosity larger";
  if (s.method().reads("solver.density_correction") && !corrects_gradually(s))
    return "set solver.density_correction = \"gradual\"";
  return s.method().reads("solver.warm_start") && s.solver.warm_start
             ? "set solver.warm_start = false, or make solver.density_tolerance smaller"
             : "make solver.density_tolerance smaller";
}

}  // namespace freshet
