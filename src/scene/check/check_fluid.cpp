// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "scene/check/check_start.h"
#include "scene/keys/keys.h"
#include "scene/model/background.h"
#include "scene/sample/places.h"

namespace freshet {
namespace {

constexpr std::size_t most_fluids = 1000, most_liquids = 8;

/// True if the lattice of the fluid has a particle.
bool check_not_empty(const Scene& s, const Scene::Fluid& f, const std::string& at, Findings& out) {
  const double spacing = s.particles.spacing;
  for (std::size_t k = 0; f.shape == Shape::box && k < f.min.size() && is_block(f); ++k)
    if (f.max[k] - f.min[k] < spacing / 2) {
      out.error(at + "max",
                fmt::format("the fluid is empty: from {} to {} in {} no particle of spacing {} "
                            "fits; make it larger or the spacing smaller",
                            f.min[k], f.max[k], axis_names[k], spacing));
      return false;
    }
  if (lattice_of(s, f).particles() > 0) return true;
  out.error(at, fmt::format("the fluid is empty: no particle of spacing {} fits into the {}; make "
                            "it larger, move it, or make the spacing smaller",
                            spacing, shape_words[int(f.shape)]));
  return false;
}

/// The minimum and maximum coordinates of the fluid's particles, without jitter.
std::pair<Vector, Vector> reach_of(const Scene& s, const Scene::Fluid& f) {
  if (f.shape != Shape::points) {
    const Lattice lattice = lattice_of(s, f);
    return {lattice.from, lattice.last(s.particles.spacing)};
  }
  const std::vector<double> x = points_of(f, s.dimension()).x;
  const auto n = std::size_t(s.dimension());
  Vector low(x.begin(), x.begin() + s.dimension()), high = low;
  for (std::size_t i = 0; i < x.size(); ++i) {
    low[i % n] = std::min(low[i % n], x[i]);
    high[i % n] = std::max(high[i % n], x[i]);
  }
  return {low, high};
}

/// The key that moves a fluid's lower or upper end.
const char* key_of_end(const Scene::Fluid& f, bool lower) {
  switch (f.shape) {
    case Shape::box:
      return lower ? "min" : "max";
    case Shape::lattice:
      return lower ? "from" : "count";
    case Shape::points:
      return f.from_run.empty() ? "file" : "from_run";
    case Shape::mesh:
    case Shape::polygon:
      return "translation";
    default:
      return "center";
  }
}

void check_inside(const Scene& s, const Scene::Fluid& f, const std::string& at, Findings& out) {
  if (f.outside == Outside::clamp) return;
  const auto [from, last] = reach_of(s, f);
  for (std::size_t k = 0; k < from.size(); ++k) {
    const double jitter = std::min(s.particles.jitter, s.particles.spacing / 2);
    const double low = from[k] - jitter, high = last[k] + jitter;
    const double slack = 1e-6 * s.particles.spacing;
    const bool below = low < s.domain.min[k] - slack;
    if (!below && high <= s.domain.max[k] + slack) continue;
    out.error(at + key_of_end(f, below),
              fmt::format("the fluid's particles reach from {:.6g} to {:.6g} in {}{}, outside the "
                          "domain ({:.6g} to {:.6g}); move it, make it smaller, or put them onto "
                          "the walls with fluid.outside = \"clamp\"",
                          low, high, axis_names[k], jitter > 0 ? " with their jitter" : "",
                          s.domain.min[k], s.domain.max[k]));
  }
}

/// mueller2003 supports one liquid only.
void check_same_liquid(const Scene& s, std::size_t k, Findings& out) {
  const Scene::Fluid &a = s.fluid[0], &b = s.fluid[k];
  if (s.method().has_boundary_particles()) return;
  if (a.rest_density == b.rest_density && a.viscosity == b.viscosity) return;
  const char* key = a.rest_density == b.rest_density ? "viscosity" : "rest_density";
  out.error(fmt::format("fluid[{}].{}", k, key),
            fmt::format("fluid[{}] and fluid[0] differ in {}; {} supports one liquid only; make "
                        "them equal, or choose another solver.name",
                        k, key, s.method().name));
}

void check_liquids(const Scene& s, Findings& out) {
  const auto liquids = s.liquids();
  if (liquids.size() > most_liquids)
    out.error("fluid", fmt::format("there are {} liquids (fluids that differ in rest_density, "
                                   "viscosity or color); at most {} are allowed; make some equal",
                                   liquids.size(), most_liquids));
  const auto lighter = [&](const Scene::Liquid& l) {
    return l.rest_density != liquids[0].rest_density;
  };
  if (s.solver.density_diffusion == DensityDiffusion::fourtakas2019 &&
      s.method().reads("solver.density_diffusion") &&
      std::any_of(liquids.begin(), liquids.end(), lighter))
    out.error(
        "solver.density_diffusion",
        "solver.density_diffusion is \"fourtakas2019\", which supports one rest_density only, "
        "and the fluids differ in it; choose \"antuono2010\"");
}

void check_color(const Scene::Fluid& f, const std::string& at, Findings& out) {
  if (f.color.empty() || (f.color[0] == '#' && background_color(f.color))) return;
  out.error(at + "color", fmt::format("fluid.color is \"{}\", not a colour; write it as #rrggbb, "
                                      "such as \"#3070c0\"",
                                      f.color));
}

template <int D> bool is_empty(const Scene& s, const Scene::Fluid& f) {
  bool empty = true;
  Places<D>(s, f).each([&](Vec<D>, std::size_t) { return empty = false; });
  return empty;
}

/// The number of places of the fluid; empty if it is invalid, so that other checks must skip it.
std::optional<double> check_shape(const Scene& s, const Scene::Fluid& f, const std::string& at,
                                  Findings& out) {
  const bool of_run = !f.from_run.empty();
  if (!of_run && (!check_surface(s, f, at, out) || !check_region(s, {f, at, "fluid"}, out)))
    return {};
  if (f.shape != Shape::points && !check_surface_height(s, f, at, out)) return {};
  if (f.shape != Shape::points)
    return check_not_empty(s, f, at, out) ? std::optional(lattice_of(s, f).particles())
                                          : std::nullopt;
  const auto cloud = of_run ? check_run(s, f, at, out) : check_points(s, {f, at, "fluid"}, out);
  if (!cloud) return {};
  if (!cloud->v.empty())
    out.unused(at + "velocity", "fluid.velocity", "the file has velocities; remove it");
  return double(cloud->x.size()) / s.dimension();
}

}  // namespace

FluidCount check_fluids(const Scene& s, Findings& out) {
  FluidCount count;
  if (s.fluid.size() > most_fluids) {
    out.error("fluid", fmt::format("there are {} fluids; at most {} are allowed", s.fluid.size(),
                                   most_fluids));
    return count;
  }
  check_liquids(s, out);
  for (std::size_t k = 0; k < s.fluid.size(); ++k) {
    const Scene::Fluid& f = s.fluid[k];
    const std::string at = fmt::format("fluid[{}].", k);
    check_same_liquid(s, k, out);
    check_color(f, at, out);
    check_velocity_field(s, f, at, out);
    check_pressure(s, f, at, out);
    if (f.from_run.empty()) check_no_run(at, out);
    const std::optional<double> places = check_shape(s, f, at, out);
    if (!places) continue;
    count.places += *places;
    check_inside(s, f, at, out);
    count.good.push_back(k);
  }
  return count;
}

/// The walls leave room, and fluids do not share it.
void check_room(const Scene& s, const FluidCount& fluids, Findings& out) {
  for (const std::size_t k : fluids.good) {
    const Scene::Fluid& f = s.fluid[k];
    const bool empty = s.dimension() == 2 ? is_empty<2>(s, f) : is_empty<3>(s, f);
    if (empty)
      out.error(fmt::format("fluid[{}].", k),
                fmt::format("fluid[{}] is empty: no place of its lattice is inside its shape and "
                            "far enough from walls; move it, or make the spacing smaller",
                            k));
  }
  for (const auto& [j, k] : overlapping_fluids(s, fluids.good))
    out.error(fmt::format("fluid[{}].{}", k, key_of_end(s.fluid[k], true)),
              fmt::format("fluid[{}] overlaps fluid[{}]: their particles would be less than "
                          "half a spacing apart; move one of them, or make the sides where they "
                          "touch whole numbers of spacings",
                          k, j));
}

}  // namespace freshet
