// SPDX-License-Identifier: MIT
#include "scene/check/check_start.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "scene/keys/keys.h"
#include "scene/model/expressions.h"
#include "scene/model/free_surface.h"
#include "scene/model/run_frame.h"
#include "scene/model/setup.h"
#include "scene/sample/places.h"

namespace freshet {
namespace {

/// The lowest and the highest place of a free surface over a box, and the first that is invalid.
struct SurfaceReach {
  double low = INFINITY, high = -INFINITY, at_high[3] = {};
  std::optional<std::string> invalid;
};

template <int D> SurfaceReach surface_reach(const Scene& s, const Scene::Fluid& f, const Box& box) {
  SurfaceReach reach;
  Expressions function({f.surface}, surface_variables(D));
  each_column(vec_of<D>(box.min), vec_of<D>(box.max), s.particles.spacing / 2,
              [&](Vec<D, double> x, Vec<D, double>) {
                const double at[3] = {x.x, 0, D == 3 ? component(x, D - 1) : 0};
                double y = 0;
                function(at, 0, &y);
                if (!reach.invalid)
                  reach.invalid =
                      not_finite({f.surface}, "fluid.surface", at, {}, &y, D == 2 ? 1 : 3);
                reach.low = std::min(reach.low, y);
                if (!(y > reach.high)) return;
                reach.high = y;
                std::copy(at, at + 3, reach.at_high);
              });
  return reach;
}

/// The remedy for a function that knows x, y and z, but no t.
std::string of_places(int dimension) { return dimension == 3 ? "x, y and z" : "x and y"; }

}  // namespace

bool check_surface(const Scene& s, const Scene::Fluid& f, const std::string& at, Findings& out) {
  if (f.surface.empty() && !out.given(at + "surface")) return true;
  if (f.shape == Shape::lattice || f.shape == Shape::points) {
    out.unused(at + "surface", "fluid.surface",
               fmt::format("fluid.shape is \"{}\"; remove it or change the shape",
                           shape_words[int(f.shape)]));
    return true;
  }
  const auto fault = fault_in({f.surface}, surface_variables(s.dimension()));
  if (fault) out.error(at + "surface", "fluid.surface " + *fault);
  return !fault;
}

bool check_surface_height(const Scene& s, const Scene::Fluid& f, const std::string& at,
                          Findings& out) {
  if (f.surface.empty() || f.shape == Shape::lattice) return true;
  Scene::Fluid whole = f;
  whole.surface.clear();
  const Box box = box_around(s, whole);
  const SurfaceReach reach =
      s.dimension() == 2 ? surface_reach<2>(s, f, box) : surface_reach<3>(s, f, box);
  const double slack = 1e-6 * s.particles.spacing;
  if (reach.invalid) {
    out.error(at + "surface", *reach.invalid);
  } else if (f.shape == Shape::box && reach.high > box.max[1] + slack) {
    out.error(at + "surface",
              fmt::format("fluid.surface reaches {:.6g} m at x = {:.4g} m, above the top of the "
                          "box, {:.6g} m; make {} larger in y, or the surface lower",
                          reach.high, reach.at_high[0], box.max[1],
                          out.given(at + "max") ? "fluid.max" : "domain.max"));
  } else if (!(reach.high > box.min[1] + s.particles.spacing / 2)) {
    out.error(at + "surface",
              fmt::format("the fluid is empty: fluid.surface is at most {:.6g} m, and the fluid's "
                          "shape begins at {:.6g} m; y points up; make the surface higher",
                          reach.high, box.min[1]));
  } else {
    return true;
  }
  return false;
}

void check_velocity_field(const Scene& s, const Scene::Fluid& f, const std::string& at,
                          Findings& out) {
  if (f.velocity_field.empty()) return;
  if (f.velocity_field.size() != std::size_t(s.dimension()))
    return out.error(at + "velocity_field",
                     fmt::format("fluid.velocity_field has {} functions, and the domain is in {}D; "
                                 "it must have {}, one per axis",
                                 f.velocity_field.size(), s.dimension(), s.dimension()));
  if (const auto fault = fault_in(f.velocity_field))
    out.error(at + "velocity_field", "fluid.velocity_field " + *fault);
  else if (Expressions(f.velocity_field).depends_on_time())
    out.error(
        at + "velocity_field",
        fmt::format("fluid.velocity_field depends on t, and it is evaluated at the start only; "
                    "make it a function of {}",
                    of_places(s.dimension())));
  else out.unused(at + "velocity", "fluid.velocity", "fluid.velocity_field sets it; remove one");
}

namespace {

void check_pressure_field(const Scene& s, const Scene::Fluid& f, const std::string& at,
                          Findings& out) {
  if (!keeps_start_pressure(s))
    return out.unused(at + "pressure_field", "fluid.pressure_field",
                      fmt::format("the pressure of {} follows from the positions of the particles; "
                                  "remove it, or choose another solver.name",
                                  s.method().name));
  out.unused(at + "pressure", "fluid.pressure", "fluid.pressure_field sets it; remove one");
  if (const auto fault = fault_in({f.pressure_field}, s.dimension() == 3 ? "xyz" : "xy"))
    out.error(at + "pressure_field", "fluid.pressure_field " + *fault);
}

void check_hydrostatic_surface(const Scene& s, const Scene::Fluid& f, const std::string& at,
                               Findings& out) {
  bool down = s.domain.gravity[1] < 0;
  for (std::size_t k = 0; k < s.domain.gravity.size(); ++k)
    down &= k == 1 || s.domain.gravity[k] == 0;
  if (!down)
    out.error(at + "pressure",
              "fluid.pressure is \"hydrostatic\" below fluid.surface, and gravity does not point "
              "along -y; set fluid.pressure_field instead");
  const auto others = std::count_if(s.fluid.begin(), s.fluid.end(), [&](const Scene::Fluid& g) {
    return &g != &f && g.pressure == StartPressure::hydrostatic;
  });
  if (others > 0)
    out.error(at + "pressure",
              "fluid.pressure is \"hydrostatic\" below fluid.surface, and another fluid is "
              "hydrostatic too; set fluid.pressure_field of both instead");
}

}  // namespace

void check_pressure(const Scene& s, const Scene::Fluid& f, const std::string& at, Findings& out) {
  if (!f.pressure_field.empty() || out.given(at + "pressure_field"))
    return check_pressure_field(s, f, at, out);
  if (f.pressure != StartPressure::hydrostatic) return;
  if (!f.surface.empty() && f.shape == Shape::box && !is_turned_box(f) && f.side == Side::inside)
    return check_hydrostatic_surface(s, f, at, out);
  if (is_block(f) || (f.shape == Shape::plane && f.side == Side::inside && f.surface.empty()))
    return;
  out.error(at + "pressure",
            fmt::format("fluid.pressure is \"hydrostatic\", and the shape is \"{}\"; only a box, a "
                        "lattice or the inside of a plane can be hydrostatic; choose one, or "
                        "\"zero\"",
                        is_turned_box(f) ? "box, turned" : shape_words[int(f.shape)]));
}

namespace {

/// Reports each error of the frame at fluid.from_run.
void report_run(const Error& e, const std::string& at, Findings& out) {
  for (const Diagnostic& d : e.diagnostics())
    out.error(at + "from_run", fmt::format("fluid.from_run: {}: {}", d.place, d.message));
}

/// Whether the run has the spacing and the dimension of the scene.
bool fits_run(const Scene& s, const Scene::Fluid& f, const std::string& at, Findings& out) {
  const RunScene run = run_scene_of(f);
  if (run.dimension && *run.dimension != s.dimension())
    out.error(at + "from_run",
              fmt::format("fluid.from_run is a run in {}D, and this scene is in {}D; choose a run "
                          "in {}D",
                          *run.dimension, s.dimension(), s.dimension()));
  else if (run.spacing && std::abs(*run.spacing / s.particles.spacing - 1) > 1e-6)
    out.error(at + "from_run",
              fmt::format("fluid.from_run is a run with particles.spacing = {}, and it is {} here: "
                          "the masses of the particles would differ; set particles.spacing = {}",
                          *run.spacing, s.particles.spacing, *run.spacing));
  else return true;
  return false;
}

/// Whether fluid.liquid names a liquid of the frame.
bool names_liquid(const Scene::Fluid& f, const PointCloud& whole, const std::string& at,
                  Findings& out) {
  std::set<int> liquids(whole.liquid.begin(), whole.liquid.end());
  if (liquids.empty()) liquids.insert(0);
  if (f.liquid ? liquids.contains(int(std::clamp<std::int64_t>(*f.liquid, -1, 1 << 30)))
               : liquids.size() == 1)
    return true;
  out.error(at + (f.liquid ? "liquid" : "from_run"),
            f.liquid ? fmt::format("fluid.liquid is {}, and the run has the liquids {}; choose one",
                                   *f.liquid, fmt::join(liquids, ", "))
                     : fmt::format("the run has the liquids {}; write a [[fluid]] for each, and "
                                   "choose its liquid by fluid.liquid",
                                   fmt::join(liquids, ", ")));
  return false;
}

}  // namespace

std::optional<PointCloud> check_run(const Scene& s, const Scene::Fluid& f, const std::string& at,
                                    Findings& out) {
  for (const char* key :
       {"shape", "side", "min", "max", "from", "count", "center", "radius", "length", "axis",
        "point", "normal", "file", "points", "base", "scale", "rotation", "translation", "surface"})
    out.unused(at + key, fmt::format("fluid.{}", key),
               "fluid.from_run sets the particles; remove one of them");
  std::error_code ec;
  if (std::filesystem::is_regular_file(f.from_run, ec)) {
    out.unused(at + "time", "fluid.time", "fluid.from_run is one data file; remove it");
    out.unused(at + "frame", "fluid.frame", "fluid.from_run is one data file; remove it");
  } else if (f.frame) {
    out.unused(at + "time", "fluid.time", "fluid.frame chooses the data file; remove one of them");
  }
  try {
    if (!fits_run(s, f, at, out)) return {};
    const PointCloud whole = read_state(run_frame_of(f), s.dimension());
    if (!names_liquid(f, whole, at, out)) return {};
    return points_of(f, s.dimension());
  } catch (const Error& e) {
    report_run(e, at, out);
    return {};
  }
}

void check_no_run(const std::string& at, Findings& out) {
  for (const char* key : {"time", "frame", "liquid"})
    out.unused(at + key, fmt::format("fluid.{}", key), "set fluid.from_run, or remove it");
}

}  // namespace freshet
