// SPDX-License-Identifier: MIT
/// Inlets, outlets and counters.
#include <algorithm>
#include <cmath>
#include <set>

#include "freshet/suggest.h"
#include "scene/check/findings.h"
#include "scene/check/names.h"
#include "scene/keys/keys.h"
#include "scene/model/background.h"
#include "scene/model/openings.h"
#include "scene/model/setup.h"
#include "scene/sample/places.h"

namespace freshet {
namespace {

constexpr std::size_t most_of_a_kind = 1000;
constexpr double most_opening_places = 1e6;  // per opening
constexpr double most_layers = 100;          // per step
constexpr double hair = 1e-6;

bool is_zero(const Vector& v) {
  return std::all_of(v.begin(), v.end(), [](double x) { return x == 0; });
}

/// An inlet or a counter, and its name in messages.
struct OpeningAt {
  const Scene::Opening& opening;
  std::string path;  ///< "inlet[0]."
  std::string name;  ///< "inlet"
};

/// Checks the keys of an opening in this dimension. False if the opening is invalid.
bool check_keys(const Scene& s, const OpeningAt& at, bool bounded, Findings& out) {
  const Scene::Opening& o = at.opening;
  const bool flat = s.dimension() == 2;
  bool good = true;
  const auto error = [&](const char* key, const std::string& message) {
    out.error(at.path + key, message);
    good = false;
  };
  if (o.center.empty())
    error("center", at.name + ".center is missing: centre of the opening (m); add it");
  if (o.direction.empty() || is_zero(o.direction))
    error("direction", fmt::format("{}.direction is 0 and has no direction; set one, for example "
                                   "{}",
                                   at.name, flat ? "[1, 0]" : "[1, 0, 0]"));
  if (flat) {
    for (const auto& [key, given] :
         {std::pair("radius", o.radius.has_value()), std::pair("height", o.height.has_value()),
          std::pair("up", !o.up.empty())})
      if (given)
        error(key, fmt::format("{0}.{1} is not used; the scene is in 2D, where {2} {0} is a slit; "
                               "remove it, and set {0}.width",
                               at.name, key, at.name == "inlet" ? "an" : "a"));
    if (bounded && !o.width && good)
      error("", fmt::format("the {0} has no width; set {0}.width", at.name));
    return good;
  }
  if (o.radius && (o.width || o.height))
    error("radius", fmt::format("{0}.radius and {0}.{1} are both set; a disc has a radius, a "
                                "rectangle a width and a height; remove one",
                                at.name, o.width ? "width" : "height"));
  else if (o.width.has_value() != o.height.has_value())
    error(o.width ? "width" : "height",
          fmt::format("{0}.{1} is set without {0}.{2}; a rectangle needs both", at.name,
                      o.width ? "width" : "height", o.width ? "height" : "width"));
  else if (bounded && !o.radius && !o.width && good)
    error("", fmt::format("the {0} has no size; set {0}.radius for a disc, or {0}.width and "
                          "{0}.height for a rectangle",
                          at.name));
  if (out.given(at.path + "up") && !o.height)
    error("up", fmt::format("{0}.up is not used; only a rectangle has one; remove it", at.name));
  else if (good && is_zero(o.up))
    error("up", at.name + ".up is 0 and has no direction; set one, for example [0, 1, 0]");
  else if (good && norm(cross(unit_of<3>(o.up), unit_of<3>(o.direction))) < hair)
    error("up",
          fmt::format("{0}.up is parallel to {0}.direction, and the height of a rectangle must "
                      "be perpendicular to it; turn one of them",
                      at.name));
  return good;
}

/// An opening needs room for one particle, and must not have too many.
bool check_size(const Scene& s, const OpeningAt& at, Findings& out) {
  const Scene::Opening& o = at.opening;
  const double spacing = s.particles.spacing;
  double places = 1;
  for (const auto& [key, length] : {std::pair("width", o.width), std::pair("height", o.height),
                                    std::pair("radius", o.radius)}) {
    if (!length) continue;
    const bool disc = o.radius.has_value();
    const double across = disc ? 2 * *length : *length;
    places *= disc ? square(across / spacing) : across / spacing;
    if (across >= spacing * (1 - hair)) continue;
    out.error(at.path + key,
              fmt::format("{}.{} is {}, and one particle needs at least {:.6g} at spacing {}; make "
                          "it larger or the spacing smaller",
                          at.name, key, *length, disc ? spacing / 2 : spacing, spacing));
    return false;
  }
  if (places <= most_opening_places) return true;
  out.error(at.path + (o.radius ? "radius" : "width"),
            fmt::format("the {}'s opening has {:.3g} places for particles; at most {:.0f} are "
                        "allowed; make it smaller or the spacing larger",
                        at.name, places, most_opening_places));
  return false;
}

void check_times(const Scene::Inlet& in, const std::string& at, Findings& out) {
  if (in.stop && *in.stop <= in.start)
    out.error(at + "stop", fmt::format("inlet.stop is {} s, not after inlet.start, {} s; make it "
                                       "later, or remove it for a flow without end",
                                       *in.stop, in.start));
}

bool check_supply(const Scene& s, const Scene::Inlet& in, const std::string& at, Findings& out) {
  if (in.speed.has_value() == in.flow_rate.has_value()) {
    out.error(at + (in.speed ? "flow_rate" : ""),
              in.speed ? "inlet.speed and inlet.flow_rate are both set, and each follows from the "
                         "other; remove one"
                       : "the inlet has no flow; set inlet.speed (m/s) or inlet.flow_rate");
    return false;
  }
  const double step = s.time.adaptive ? s.time.step_max.value_or(0) : s.time.step;
  const InletPlan plan = inlet_plan(s, in);
  if (plan.speed * step <= most_layers * plan.spacing) return true;
  out.error(at + (in.speed ? "speed" : "flow_rate"),
            fmt::format("the inlet flows at {:.4g} m/s, which is {:.3g} spacings in {} = {:.4g} s; "
                        "at most {:.0f} are allowed, and a stable step has less than one; make it "
                        "slower, or the step shorter",
                        plan.speed, plan.speed * step / plan.spacing,
                        s.time.adaptive ? "time.step_max" : "time.step", step, most_layers));
  return false;
}

void check_recycle(const Scene& s, std::size_t k, Findings& out) {
  const std::string& recycle = s.inlet[k].recycle;
  if (recycle.empty()) return;
  const std::string key = fmt::format("inlet[{}].recycle", k);
  const auto names = s.flow_names();
  const auto first = names.begin() + std::ptrdiff_t(s.inlet.size());
  const std::set<std::string, std::less<>> outlets(first, first + std::ptrdiff_t(s.outlet.size()));
  if (!outlets.contains(recycle)) {
    const std::string near = nearest(recycle, outlets);
    return out.error(
        key,
        outlets.empty()
            ? fmt::format("inlet.recycle is \"{}\", and there is no outlet; add an [outlet] "
                          "of that name",
                          recycle)
            : fmt::format("inlet.recycle is \"{}\", which is not the name of an outlet; {}there "
                          "{} {}",
                          recycle, near.empty() ? "" : fmt::format("did you mean \"{}\"? ", near),
                          outlets.size() == 1 ? "is" : "are",
                          fmt::format("\"{}\"", fmt::join(outlets, "\", \""))));
  }
  for (std::size_t j = 0; j < k; ++j)
    if (s.inlet[j].recycle == recycle)
      return out.error(key, fmt::format("{} and {} both recycle \"{}\", and an outlet can supply "
                                        "one inlet only; name another outlet for one",
                                        names[j], names[k], recycle));
}

void check_liquid(const Scene& s, std::size_t k, Findings& out) {
  const Scene::Inlet& in = s.inlet[k];
  const std::string at = fmt::format("inlet[{}].", k);
  const auto liquids = s.liquids();
  if (s.viscosity_method() == ViscosityMethod::artificial && s.air.drag == Drag::none)
    out.unused(
        at + "viscosity", "inlet.viscosity",
        fmt::format("{} has solver.artificial_viscosity instead, unless solver.viscosity_method is "
                    "another; remove it",
                    s.method().name));
  const Scene::Liquid own = s.inlet_liquid(k);
  const char* key = own.rest_density != liquids[0].rest_density ? "rest_density"
                    : own.viscosity != liquids[0].viscosity     ? "viscosity"
                                                                : nullptr;
  if (key && !s.method().has_boundary_particles())
    out.error(at + key, fmt::format("inlet[{}] and {}[0] differ in {}; {} supports "
                                    "one liquid only; make them equal, or choose another "
                                    "solver.name",
                                    k, s.fluid.empty() ? "inlet" : "fluid", key, s.method().name));
  if (!in.color.empty() && (in.color[0] != '#' || !background_color(in.color)))
    out.error(at + "color", fmt::format("inlet.color is \"{}\", not a colour; write it as #rrggbb, "
                                        "such as \"#3070c0\"",
                                        in.color));
}

/// The places of an inlet's particles at its start, and one layer in front of the opening.
template <int D> std::vector<Vec<D, double>> places_of(const InletPlan& plan) {
  std::vector<Vec<D, double>> all;
  for (int layer = -1; layer < plan.layers; ++layer)
    for (std::size_t p = 0; p < plan.particles(); ++p) {
      Vec<D, double> x{};
      for (std::size_t j = 0; j < D; ++j)
        component(x, int(j)) =
            plan.places[p * D + j] - (layer + 0.5) * plan.spacing * plan.direction[j];
      all.push_back(x);
    }
  return all;
}

/// The inlet must be inside the domain, from half a spacing in front of the opening to the back of
/// its zone.
template <int D>
bool check_room(const Scene& s, std::size_t k, const InletPlan& plan, Findings& out) {
  const std::string at = fmt::format("inlet[{}].", k);
  const auto piece = opening_of<D>(s.inlet[k]);
  const auto outside = [&](Vec<D, double> x, double margin) {
    for (int j = 0; j < D; ++j)
      if (component(x, j) < s.domain.min[std::size_t(j)] + margin ||
          component(x, j) > s.domain.max[std::size_t(j)] - margin)
        return true;
    return false;
  };
  const double slack = hair * plan.spacing;
  const std::string zone =
      fmt::format("the {} layers behind its opening, {:.6g} m deep, in which it moves the liquid",
                  plan.layers, plan.depth());
  if (outside(piece.center, -slack)) {
    out.error(at + "center", fmt::format("the inlet is outside the domain; move inlet.center "
                                         "inside, together with {}",
                                         zone));
    return false;
  }
  if (outside(piece.center + plan.spacing / 2 * piece.direction, -slack)) {
    out.error(at + "direction", "the inlet points out of the domain; reverse inlet.direction");
    return false;
  }
  // half a spacing from the ends of the domain, like a fluid's lattice
  for (const auto& x : places_of<D>(plan))
    if (outside(x, 0.49 * plan.spacing)) {
      out.error(at + "center",
                fmt::format("the inlet extends beyond the domain; its whole width must be inside, "
                            "together with {}; move inlet.center further in or make it smaller",
                            zone));
      return false;
    }
  return true;
}

template <int D>
void check_neighbors(const Scene& s, std::size_t k, const std::vector<std::size_t>& good,
                     bool walls_are_good, Findings& out) {
  const InletPlan plan = inlet_plan(s, s.inlet[k]);
  const auto places = places_of<D>(plan);
  const auto names = s.flow_names();
  const std::string key = fmt::format("inlet[{}].center", k);
  const auto any = [&](const auto& bad) { return std::any_of(places.begin(), places.end(), bad); };
  for (std::size_t w = 0; walls_are_good && w < s.wall.size(); ++w) {
    if (s.wall[w].shape == Shape::points) continue;
    const RegionSurface<D> wall(s.wall[w], plan.spacing);
    if (any([&](auto x) { return wall.distance(x) < 0.49 * plan.spacing; }))
      out.error(key, fmt::format("the inlet, with the {1} layers behind its opening, is in {0} or "
                                 "closer to it than half a spacing; move it, make it smaller, or "
                                 "leave room for it in the wall",
                                 s.wall_names()[2 * D + w], plan.layers));
  }
  for (std::size_t o = 0; o < s.outlet.size(); ++o) {
    if (!is_solid(s.outlet[o])) continue;
    const auto outlet = solid_of<D>(s.outlet[o]);
    if (any([&](auto x) { return outlet.distance(x) > -hair * plan.spacing; }))
      out.error(key, fmt::format("the inlet overlaps {}, which would remove its particles; move "
                                 "one of them",
                                 names[s.inlet.size() + o]));
  }
  for (const std::size_t j : good) {
    if (j >= k) break;
    const InletZone<D> other(s, s.inlet[j]);
    if (any([&](auto x) { return other.holds(x, 0.49 * plan.spacing); }))
      out.error(key,
                fmt::format("{} overlaps {}: their particles would collide in the zones behind "
                            "their openings; move one of them",
                            names[k], names[j]));
  }
}

/// Names are headers of table columns: plain and unique.
void check_flow_names(const Scene& s, Findings& out) {
  const auto names = s.flow_names();
  const std::size_t outlets = s.inlet.size(), counters = outlets + s.outlet.size(),
                    sides = counters + s.counter.size();
  std::set<std::string> taken(names.begin() + std::ptrdiff_t(sides), names.end());
  for (std::size_t k = 0; k < sides; ++k) {
    const char* kind = s.flow_kind(k);
    const std::size_t first = k < outlets ? 0 : k < counters ? outlets : counters;
    const std::string key = fmt::format("{}[{}].name", kind, k - first);
    if (!names_column(names[k]))
      out.error(key,
                fmt::format("{}.name has a comma, a quote or an invisible character, which tables "
                            "do not allow; use letters, digits and _",
                            kind));
    else if (!taken.insert(names[k]).second)
      out.error(key, fmt::format("{}.name is \"{}\", which another inlet, outlet, counter or "
                                 "open side has; choose another name",
                                 kind, names[k]));
  }
}

bool check_inlet(const Scene& s, std::size_t k, Findings& out) {
  const Scene::Inlet& in = s.inlet[k];
  const std::string at = fmt::format("inlet[{}].", k);
  const OpeningAt opening{in, at, "inlet"};
  check_times(in, at, out);
  check_recycle(s, k, out);
  check_liquid(s, k, out);
  if (!check_keys(s, opening, true, out) || !check_size(s, opening, out) ||
      !check_supply(s, in, at, out))
    return false;
  const InletPlan plan = inlet_plan(s, in);
  return s.dimension() == 2 ? check_room<2>(s, k, plan, out) : check_room<3>(s, k, plan, out);
}

bool check_outlet(const Scene& s, std::size_t k, Findings& out) {
  const std::string at = fmt::format("outlet[{}].", k);
  if (is_solid(s.outlet[k]) && s.outlet[k].shape != Shape::lattice)
    return check_region(s, {s.outlet[k], at, "outlet"}, out);
  out.error(at + "shape",
            "outlet.shape is not allowed for an outlet; choose \"box\", \"sphere\", "
            "\"cylinder\" or \"plane\"");
  return false;
}

bool too_many(const Scene& s, Findings& out) {
  for (const auto& [kind, count] :
       {std::pair("inlet", s.inlet.size()), std::pair("outlet", s.outlet.size()),
        std::pair("counter", s.counter.size())})
    if (count > most_of_a_kind) {
      out.error(kind, fmt::format("there are {} {}s; at most {} are allowed", count, kind,
                                  most_of_a_kind));
      return true;
    }
  return false;
}

}  // namespace

void check_counters(const Scene& s, Findings& out) {
  check_flow_names(s, out);
  for (std::size_t k = 0; k < s.counter.size(); ++k)
    check_keys(s, {s.counter[k], fmt::format("counter[{}].", k), "counter"}, false, out);
}

bool check_flows(const Scene& s, bool walls_are_good, Findings& out) {
  if (s.inlet.empty() && s.outlet.empty() && s.counter.empty()) return true;
  if (too_many(s, out)) return false;
  if (s.is_article())
    out.error(!s.inlet.empty()    ? "inlet[0]"
              : !s.outlet.empty() ? "outlet[0]"
                                  : "counter[0]",
              "solver.scheme = \"article\" has one block of fluid, and no inlet, outlet or "
              "counter; remove it, or choose solver.scheme = \"paper\"");
  check_counters(s, out);
  bool outlets_are_good = true;
  for (std::size_t k = 0; k < s.outlet.size(); ++k) outlets_are_good &= check_outlet(s, k, out);
  std::vector<std::size_t> good;
  for (std::size_t k = 0; k < s.inlet.size(); ++k)
    if (check_inlet(s, k, out)) good.push_back(k);
  for (const std::size_t k : good)
    if (outlets_are_good && s.dimension() == 2) check_neighbors<2>(s, k, good, walls_are_good, out);
    else if (outlets_are_good) check_neighbors<3>(s, k, good, walls_are_good, out);
  return good.size() == s.inlet.size();
}

}  // namespace freshet
