// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <cmath>
#include <limits>

#include "freshet/derived.h"
#include "freshet/units.h"
#include "scene/check/body_warnings.h"
#include "scene/check/findings.h"
#include "scene/check/point_warnings.h"
#include "scene/check/pressure_warnings.h"
#include "scene/check/probe_warnings.h"
#include "scene/check/volume_warnings.h"
#include "scene/model/loaded_mesh.h"
#include "scene/model/setup.h"
#include "scene/sample/places.h"

namespace freshet {
namespace {

constexpr double usual_support = 5;  // [spacings]

class Warnings {
 public:
  explicit Warnings(const Scene& scene) : s_(scene), d_(derive(scene)) {}

  std::vector<Diagnostic> list() {
    lattice();
    room();
    for (Diagnostic& d : volume_warnings(s_, d_)) list_.push_back(std::move(d));
    periodic();
    step();
    rounding();
    inlets();
    surface();
    for (std::size_t k = 0; k < s_.fluid.size(); ++k) mesh("fluid", k, s_.fluid[k]);
    for (std::size_t k = 0; k < s_.wall.size(); ++k) mesh("wall", k, s_.wall[k]);
    for (std::size_t k = 0; k < s_.body.size(); ++k) mesh("body", k, s_.body[k]);
    for (Diagnostic& d : body_warnings(s_, d_)) list_.push_back(std::move(d));
    for (Diagnostic& d : thin_wall_warnings(s_, d_)) list_.push_back(std::move(d));
    for (Diagnostic& d : pressure_warnings(s_, d_)) list_.push_back(std::move(d));
    for (Diagnostic& d : point_warnings(s_)) list_.push_back(std::move(d));
    for (Diagnostic& d : probe_warnings(s_)) list_.push_back(std::move(d));
    return std::move(list_);
  }

 private:
  void warn(const std::string& key, std::string message) {
    list_.push_back({Diagnostic::Severity::warning, place_of(s_, key), std::move(message)});
  }
  void lattice() {
    const char* support =
        s_.particles.support_radius ? "particles.support_radius" : "particles.spacing";
    const double spacings = d_.support_radius / d_.spacing;
    if (std::abs(d_.density_error) > 0.02 && s_.particles.mass)
      warn(support, fmt::format("with a support radius of {:.3g} spacings, the density of a "
                                "resting lattice is {:.3f} of its true value; 2 spacings or "
                                "more are accurate",
                                spacings, 1 + d_.density_error));
    if (std::abs(d_.gradient_error) > 0.15)
      warn(support, fmt::format("a support radius of {:.3g} spacings has {:.1f} neighbours: "
                                "pressure gradients are off by {:+.0f} %; {} spacings or more "
                                "are better",
                                spacings, d_.neighbors, 100 * d_.gradient_error,
                                spacings < 2.5 ? "2.5" : "3"));
    if (spacings > usual_support && s_.method().has_boundary_particles())
      warn(support,
           fmt::format("a support radius of {:.3g} spacings has {:.0f} neighbours, and the "
                       "run takes long; 2 to 4 spacings are usual; where the spacing "
                       "changes, the support radius should too",
                       spacings, d_.neighbors));
  }
  void room() {
    if (d_.outside > 0)
      warn("fluid[0].outside",
           fmt::format("{} of {:.0f} particles start outside the domain; the first "
                       "step puts them onto its walls",
                       d_.outside, d_.particles));
    double volume = 1;
    for (std::size_t k = 0; k < s_.domain.max.size(); ++k)
      volume *= s_.domain.max[k] - s_.domain.min[k];
    const double needed = d_.particles * d_.mass / d_.rest_density;
    const std::string unit = raised_unit(units_in(s_.dimension()).volume);
    if (needed > volume)
      warn("particles.mass",
           fmt::format("at rest density the fluid takes {:.4g} {}, and the domain has "
                       "{:.4g} {}; it will be compressed",
                       needed, unit, volume, unit));
  }
  void periodic() {
    for (int k = 0; k < s_.dimension(); ++k) {
      const auto j = std::size_t(k);
      const double spacings = (s_.domain.max[j] - s_.domain.min[j]) / d_.spacing;
      if (s_.periodic(k) && std::abs(spacings - std::round(spacings)) > 0.01)
        warn("domain.periodic",
             fmt::format("the domain is {:.4g} spacings long in {}, where it is periodic; a whole "
                         "number continues the particles' lattice across its ends",
                         spacings, axis_names[k]));
    }
  }
  /// Reports the defects of a mesh, because other programs may repair them differently.
  void mesh(const char* table, std::size_t k, const Scene::Region& region) {
    if (region.shape != Shape::mesh || !region.loaded) return;
    const MeshCondition& c = region.loaded->condition;
    std::vector<std::string> found;
    const auto tell = [&](std::int64_t count, const char* what) {
      if (count > 0) found.push_back(fmt::format("{} {}", what, count));
    };
    tell(c.turned, "inverted triangles turned:");
    tell(c.degenerate, "degenerate triangles removed:");
    tell(c.doubled, "duplicate triangles removed:");
    tell(c.crowded, "edges shared by more than two triangles:");
    const std::string key = fmt::format("{}[{}].file", table, k);
    if (!found.empty())
      warn(key, fmt::format("{} has defects, repaired where possible: {}", region.file,
                            fmt::join(found, ", ")));
    filled_holes(key, region.file, c);
    if (!c.closed())
      warn(key, fmt::format("{} is not closed, {}: it is a sheet without an inside, sampled on its "
                            "surface",
                            region.file, hole_words(c.widest_open())));
  }
  void filled_holes(const std::string& key, const std::string& file, const MeshCondition& c) {
    constexpr std::size_t shown = 3;
    std::vector<std::string> holes;
    for (const MeshHole& hole : c.holes)
      if (hole.filled) holes.push_back(hole_words(hole));
    if (holes.empty()) return;
    const std::size_t count = holes.size();
    holes.resize(std::min(count, shown));
    warn(key, fmt::format("{} had {} hole{} narrower than the spacing, filled with flat triangles: "
                          "{}{}",
                          file, count, count == 1 ? "" : "s", fmt::join(holes, "; "),
                          count > shown ? fmt::format("; and {} more", count - shown) : ""));
  }
  void inlets() {
    for (std::size_t k = 0; k < s_.inlet.size(); ++k) {
      const Scene::Inlet& in = s_.inlet[k];
      const DerivedInlet& d = d_.inlets[k];
      const std::string key = fmt::format("inlet[{}].{}", k, in.speed ? "speed" : "flow_rate");
      if (!s_.method().incompressible() && d.speed > 0.15 * d_.sound_speed)
        warn(key,
             fmt::format("{} flows at {:.4g} m/s, more than a tenth of the speed of sound, "
                         "{:.4g} m/s: it will be compressed; make {} larger, for example {:.3g}",
                         d.name, d.speed, d_.sound_speed,
                         s_.method().pressure == PressureFamily::linear ? "solver.stiffness"
                                                                        : "solver.sound_speed",
                         s_.method().pressure == PressureFamily::linear ? 100 * d.speed * d.speed
                                                                        : 10 * d.speed));
      if (in.start >= s_.time.end)
        warn(fmt::format("inlet[{}].start", k),
             fmt::format("{} starts at {:g} s, not before the end of the run: it adds no particles",
                         d.name, in.start));
    }
  }
  /// Warns of a viscosity below the minimum that was measured with six solvers (docs/forces.md).
  void surface() {
    if (s_.solver.surface_tension_method != SurfaceTensionMethod::morris2000 ||
        s_.viscosity_method() == ViscosityMethod::artificial)
      return;
    for (std::size_t k = 0; k < s_.fluid.size(); ++k) {
      const Scene::Fluid& f = s_.fluid[k];
      const double least =
          0.03 * std::sqrt(f.surface_tension.value_or(0) * f.rest_density * d_.spacing);
      if (f.viscosity < least)
        warn(fmt::format("fluid[{}].viscosity", k),
             fmt::format("at this spacing morris2000 needs {:.2g} Pa s or more for a calm surface, "
                         "and the viscosity is {:g}; make it larger, or the spacing smaller",
                         least, f.viscosity));
    }
  }
  void step() {
    if (has_fluid(s_) && !s_.time.adaptive && s_.time.step > d_.step_bound())
      warn("time.step",
           fmt::format("the time step {:.4g} s is over its bound, {:.4g} s ({}); the run may "
                       "blow up",
                       s_.time.step, d_.step_bound(), d_.step_bound_name()));
    const double step = s_.time.adaptive ? std::min(*s_.time.step_max, d_.step_bound()) : 0;
    const auto often = [&](const std::string& key, std::optional<double> every) {
      if (every && *every < step)
        warn(key, fmt::format("{} is {:.4g} s, shorter than the time step, about {:.4g} s: every "
                              "step writes; make it longer",
                              key, *every, step));
    };
    often("output.observables_every", s_.output.observables_every);
    often("output.frame_every", s_.output.frame_every);
    often("output.data_every", s_.output.data_every);
    often("output.checkpoint_every", s_.output.checkpoint_every);
    if (s_.surface) often("surface.every", s_.surface->every);
  }

  /// The speed of the flow [m/s]: of its start, its inlets or a fall that viscosity may slow.
  double speed() const {
    double height = 0, gravity2 = 0, fastest = 0;
    const Vector& g = s_.domain.gravity;
    for (std::size_t k = 0; k < g.size(); ++k) {
      gravity2 += g[k] * g[k];
      if (g[k] != 0) height = std::max(height, s_.domain.max[k] - s_.domain.min[k]);
    }
    const double gravity = std::sqrt(gravity2), nu = d_.viscosity / d_.rest_density;
    fastest = std::min(std::sqrt(2 * gravity * height), gravity * height * height / nu);
    for (const Scene::Fluid& f : s_.fluid)
      for (const double v : f.velocity) fastest = std::max(fastest, std::abs(v));
    for (const DerivedInlet& in : d_.inlets) fastest = std::max(fastest, in.speed);
    return fastest;
  }
  /// Warns if a hundredth of the flow's speed moves no particle, because a step is less than the
  /// rounding of a position.
  void rounding() {
    if (!has_fluid(s_)) return;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double dt = s_.time.adaptive
                          ? std::min(s_.time.step_max.value_or(infinity), d_.step_bound())
                          : s_.time.step;
    const double v = speed(), rounding = rounding_of_positions(s_) / 2;
    if ((v > 0 ? v / 100 * dt : 1e-4 * d_.spacing) >= rounding) return;
    const std::string slow =
        v > 0 ? fmt::format(
                    "a hundredth of the flow's speed of {:.3g} m/s moves a particle by "
                    "{:.2g} m a step",
                    v, v / 100 * dt)
              : fmt::format("1e-4 spacings are {:.2g} m", 1e-4 * d_.spacing);
    warn("domain.max", fmt::format("{}, less than the rounding of positions in this domain, "
                                   "{:.2g} m: slow flow will stop; make the domain smaller, the "
                                   "spacing larger{}",
                                   slow, rounding, or_in_double));
  }

  const Scene s_;
  Derived d_;
  std::vector<Diagnostic> list_;
};

}  // namespace

std::vector<Diagnostic> scene_warnings(const Scene& scene) {
  return Warnings(with_defaults(scene)).list();
}

}  // namespace freshet
