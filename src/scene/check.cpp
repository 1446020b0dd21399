// SPDX-License-Identifier: MIT
#include "scene/check.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "kernels/poly6.h"
#include "kernels/spiky.h"
#include "scene/setup.h"

namespace freshet {
namespace {

constexpr double most_particles = 2147483647.0, most_steps = 1e9, most_frames = 100000;
constexpr double widest_support = 10;
constexpr std::size_t most_fluids = 1000;
constexpr double bytes_per_particle = 400;  // fields, lists and pictures, generously

/// Where a key stands; for one that was not given, the table that it belongs to or the file.
std::string place_of(const Scene& scene, std::string key) {
  while (!scene.places.contains(key) && !key.empty()) {
    const auto dot = key.find_last_of('.');
    key.erase(dot == std::string::npos ? 0 : dot);
  }
  const auto it = scene.places.find(key);
  return it == scene.places.end() ? "" : it->second;
}

/// Collects what is wrong, each at the place of the key that the remedy changes.
class Findings {
 public:
  explicit Findings(const Scene& scene) : scene_(scene) {}
  void error(const std::string& key, std::string message) {
    list.push_back({Diagnostic::Severity::error, place_of(scene_, key), std::move(message)});
  }
  /// A key that was given although nothing reads it.
  void unused(const std::string& key, const std::string& name, const std::string& remedy) {
    if (scene_.places.contains(key)) error(key, fmt::format("{} is not used; {}", name, remedy));
  }
  std::vector<Diagnostic> list;

 private:
  const Scene& scene_;
};

bool good_domain(const Scene& s) {
  return s.domain.min.size() == 2 && s.domain.max.size() == 2 &&
         s.domain.max[0] > s.domain.min[0] && s.domain.max[1] > s.domain.min[1];
}

void check_domain(const Scene& s, Findings& out) {
  if (good_domain(s)) return;
  const bool vectors = s.domain.min.size() == 2 && s.domain.max.size() == 2;
  const bool narrow = vectors && !(s.domain.max[0] > s.domain.min[0]);
  out.error("domain.max", fmt::format("domain.max is not above domain.min{}; the domain needs a "
                                      "width and a height",
                                      !vectors ? ""
                                      : narrow ? " in x"
                                               : " in y"));
}

void check_gravity(const Scene& s, Findings& out) {
  if (s.domain.gravity == Vector{0, 0} && !s.solver.stiffness)
    out.error("domain.gravity",
              "without gravity there is no default of solver.stiffness; give solver.stiffness "
              "(the square of ten times the fastest speed is a good start)");
}

void check_particles(const Scene& s, Findings& out) {
  const auto& p = s.particles;
  const double support = p.support_radius.value_or(2 * p.spacing);
  if (support <= p.spacing)
    out.error("particles.support_radius",
              fmt::format("particles.support_radius is {}, not above the spacing {}: no particle "
                          "would have a neighbour; 2 × spacing is usual",
                          support, p.spacing));
  if (support > widest_support * p.spacing)
    out.error("particles.support_radius",
              fmt::format("particles.support_radius is {:.4g} times the spacing; at most {} times "
                          "are allowed, 2 are usual",
                          support / p.spacing, widest_support));
  if (p.jitter > p.spacing / 2)
    out.error("particles.jitter",
              fmt::format("particles.jitter is {}; at most half the spacing, {:.6g}, is allowed",
                          p.jitter, p.spacing / 2));
  const double poly6 = Poly6<2>(Real(support)).c, spiky = Spiky<2>(Real(support)).c;
  if (!std::isnormal(poly6) || !std::isnormal(spiky))
    out.error(p.support_radius ? "particles.support_radius" : "particles.spacing",
              fmt::format("a support radius of {:.4g} m is beyond what {}-bit numbers hold in the "
                          "kernels' constants; scale the scene {}",
                          support, 8 * sizeof(Real), support < 1 ? "up" : "down"));
}

void check_backend(const Scene& s, Findings& out) {
  if (s.solver.backend == BackendName::reference) return;
  if (s.solver.neighbor_order == NeighborOrder::id)
    out.error("solver.neighbor_order",
              "solver.neighbor_order = \"id\" is the reference's only; set "
              "solver.backend = \"reference\", or choose \"cell\"");
  if (s.solver.search == Search::all_pairs)
    out.error("solver.search",
              "solver.search = \"all_pairs\" is the reference's only; set "
              "solver.backend = \"reference\", or choose \"grid\"");
}

void check_scheme(const Scene& s, Findings& out) {
  if (s.solver.scheme == Scheme::article) {
    if (!s.particles.mass)
      out.error("solver.scheme",
                "solver.scheme = \"article\" needs particles.mass; the article has "
                "0.02 (or choose \"paper\", which derives it)");
    return;
  }
  out.unused("particles.mass", "particles.mass",
             "with solver.scheme = \"paper\" it is rest_density × spacing²; remove it");
  out.unused("solver.speed_limit", "solver.speed_limit",
             "only solver.scheme = \"article\" has one; remove it");
}

/// Positions are held as they are, so that far from the origin they are coarse.
void check_resolution(const Scene& s, Findings& out) {
  double far = 0;
  for (const Vector* corner : {&s.domain.min, &s.domain.max})
    for (const double x : *corner) far = std::max(far, std::abs(x));
  const double coarse = far * double(std::numeric_limits<Real>::epsilon());
  if (s.particles.spacing < 100 * coarse)
    out.error(
        "particles.spacing",
        fmt::format("particles.spacing is {}, too fine for a domain that reaches {:.3g} m from "
                    "the origin, where {}-bit numbers are {:.2g} m apart; make it larger, or "
                    "move the domain to the origin",
                    s.particles.spacing, far, 8 * sizeof(Real), coarse));
}

/// True if the fluid has a lattice that the other checks can look at.
bool check_shape(const Scene::Fluid& f, const std::string& at, double spacing, Findings& out) {
  const bool box = f.shape == Shape::box;
  const char* shape = box ? "box" : "lattice";
  const auto unused = [&](const char* key) {
    out.unused(at + key, fmt::format("fluid.{}", key),
               fmt::format("fluid.shape is \"{}\"; remove it or change the shape", shape));
  };
  for (const char* key : {"min", "max"})
    if (!box) unused(key);
  for (const char* key : {"from", "count"})
    if (box) unused(key);
  if (box ? f.min.size() != 2 || f.max.size() != 2 : f.from.size() != 2 || f.count.size() != 2) {
    out.error(at, fmt::format("fluid.shape is \"{}\" and needs fluid.{} and fluid.{}", shape,
                              box ? "min" : "from", box ? "max" : "count"));
    return false;
  }
  for (int k = 0; box && k < 2; ++k) {
    const char axis = k == 0 ? 'x' : 'y';
    if (!(f.max[k] > f.min[k]))
      out.error(at + "max", fmt::format("fluid.max is not above fluid.min in {}; swap them or make "
                                        "the fluid larger",
                                        axis));
    else if (f.max[k] - f.min[k] < spacing / 2)
      out.error(at + "max",
                fmt::format("the fluid is empty: from {} to {} in {} no particle of spacing {} "
                            "fits; make it larger or the spacing smaller",
                            f.min[k], f.max[k], axis, spacing));
    else continue;
    return false;
  }
  return true;
}

void check_inside(const Scene& s, const Scene::Fluid& f, const std::string& at, Findings& out) {
  if (f.outside == Outside::clamp) return;
  const Lattice lattice = lattice_of(f, s.particles.spacing);
  const Vector last = lattice.last(s.particles.spacing);
  const bool box = f.shape == Shape::box;
  for (int k = 0; k < 2; ++k) {
    const double jitter = std::min(s.particles.jitter, s.particles.spacing / 2);
    const double low = lattice.from[k] - jitter, high = last[k] + jitter;
    const double slack = 1e-6 * s.particles.spacing;
    const bool below = low < s.domain.min[k] - slack;
    if (!below && high <= s.domain.max[k] + slack) continue;
    out.error(at + (below ? box ? "min" : "from"
                    : box ? "max"
                          : "count"),
              fmt::format("the fluid's particles reach from {:.6g} to {:.6g} in {}{}, outside the "
                          "domain ({:.6g} to {:.6g}); move it, shrink it, or let the walls take "
                          "them in with fluid.outside = \"clamp\"",
                          low, high, k == 0 ? 'x' : 'y', jitter > 0 ? " with their jitter" : "",
                          s.domain.min[k], s.domain.max[k]));
  }
}

bool overlap(const Lattice& a, const Lattice& b, double spacing) {
  const Vector last_a = a.last(spacing), last_b = b.last(spacing);
  for (int k = 0; k < 2; ++k)
    if (a.from[k] >= last_b[k] + spacing / 2 || b.from[k] >= last_a[k] + spacing / 2) return false;
  return true;
}

void check_count(const Scene& s, double particles, Findings& out) {
  const double memory = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
  const double needed = particles * bytes_per_particle;
  const bool lattice = s.places.contains("fluid[0].count");
  const char* key = lattice ? "fluid[0].count" : "particles.spacing";
  const char* remedy =
      lattice ? "make fluid.count smaller" : "make the spacing larger or the fluid smaller";
  if (particles > most_particles)
    out.error(key, fmt::format("the scene has {:.4g} particles; at most {:.0f} are allowed; {}",
                               particles, most_particles, remedy));
  else if (needed > memory)
    out.error(key, fmt::format("{:.4g} particles need about {:.3g} GiB of memory, and there are "
                               "{:.3g} GiB; {}",
                               particles, needed / (1u << 30), memory / (1u << 30), remedy));
}

void check_same_liquid(const Scene& s, std::size_t k, Findings& out) {
  const Scene::Fluid &a = s.fluid[0], &b = s.fluid[k];
  if (a.rest_density == b.rest_density && a.viscosity == b.viscosity) return;
  const char* key = a.rest_density == b.rest_density ? "viscosity" : "rest_density";
  out.error(fmt::format("fluid[{}].{}", k, key),
            fmt::format("fluid[{}] and fluid[0] differ in {}; mueller2003 takes one liquid, give "
                        "all the same",
                        k, key));
}

void check_fluids(const Scene& s, bool inside, Findings& out) {
  if (s.fluid.size() > most_fluids)
    return out.error("fluid", fmt::format("there are {} fluids; at most {} are allowed",
                                          s.fluid.size(), most_fluids));
  double particles = 0;
  std::vector<std::pair<std::size_t, Lattice>> lattices;
  for (std::size_t k = 0; k < s.fluid.size(); ++k) {
    const Scene::Fluid& f = s.fluid[k];
    const std::string at = fmt::format("fluid[{}].", k);
    check_same_liquid(s, k, out);
    if (!check_shape(f, at, s.particles.spacing, out)) continue;
    const Lattice lattice = lattice_of(f, s.particles.spacing);
    particles += lattice.particles();
    if (inside) check_inside(s, f, at, out);
    for (const auto& [j, other] : lattices)
      if (overlap(other, lattice, s.particles.spacing))
        out.error(at + (f.shape == Shape::box ? "min" : "from"),
                  fmt::format("fluid[{}] overlaps fluid[{}]: their particles would lie less than "
                              "half a spacing apart; move one",
                              k, j));
    lattices.emplace_back(k, lattice);
  }
  check_count(s, particles, out);
}

void check_time(const Scene& s, Findings& out) {
  const double steps = std::round(s.time.end / s.time.step);
  if (!(steps >= 1))
    out.error("time.step", fmt::format("time.step is {} s, longer than the whole run, {} s; make "
                                       "it smaller",
                                       s.time.step, s.time.end));
  if (steps > most_steps)
    out.error("time.step", fmt::format("the run would take {:.4g} steps; at most {:.0f} are "
                                       "allowed; make time.step larger or time.end smaller",
                                       steps, most_steps));
}

void check_frames(const Scene& s, Findings& out) {
  const double steps = std::round(s.time.end / s.time.step);
  const double every = double(s.output.frame_every_steps.value_or(0));
  if (every > 0 && steps <= most_steps && steps / every > most_frames)
    out.error("output.frame_every_steps",
              fmt::format("the run would write {:.4g} frames; at most {:.0f} are allowed; make "
                          "output.frame_every_steps larger",
                          steps / every, most_frames));
}

}  // namespace

std::vector<Diagnostic> contradictions(const Scene& scene,
                                       const std::set<std::string, std::less<>>& unread) {
  Findings findings(scene);
  const auto read = [&](const char* section) { return !unread.contains(section); };
  if (read("domain")) check_domain(scene, findings);
  if (read("domain") && read("solver")) check_gravity(scene, findings);
  const bool inside = read("domain") && good_domain(scene);
  if (read("particles")) check_particles(scene, findings);
  if (read("particles") && inside) check_resolution(scene, findings);
  if (read("fluid") && scene.fluid.empty())
    findings.error("fluid", "there is no fluid; add a [fluid] table");
  if (read("particles") && read("fluid")) check_fluids(scene, inside, findings);
  if (read("particles") && read("solver")) check_scheme(scene, findings);
  if (read("solver")) check_backend(scene, findings);
  if (read("time")) check_time(scene, findings);
  if (read("time") && read("output")) check_frames(scene, findings);
  return std::move(findings.list);
}

void check_scene(const Scene& scene) {
  auto errors = contradictions(scene, {});
  if (!errors.empty()) throw Error(Error::Kind::scene, std::move(errors));
}

std::int64_t Scene::steps() const { return std::llround(time.end / time.step); }

std::vector<Diagnostic> scene_warnings(const Scene& scene) {
  std::vector<Diagnostic> warnings;
  const auto warn = [&](const std::string& key, std::string message) {
    warnings.push_back({Diagnostic::Severity::warning, place_of(scene, key), std::move(message)});
  };
  const char* support =
      scene.particles.support_radius ? "particles.support_radius" : "particles.spacing";
  const Derived d = derive(scene);
  if (std::abs(d.density_error) > 0.02 && scene.particles.mass)
    warn(support,
         fmt::format(
             "a support of {:.3g} spacings sums the density of a resting lattice to {:.3f} of "
             "its value; 2 spacings or more are accurate",
             d.support_radius / d.spacing, 1 + d.density_error));
  if (std::abs(d.gradient_error) > 0.15)
    warn(support,
         fmt::format(
             "a support of {:.3g} spacings has {:.1f} neighbours: pressure gradients are off by "
             "{:+.0f} %; 2.5 spacings or more are better",
             d.support_radius / d.spacing, d.neighbors, 100 * d.gradient_error));
  if (d.outside > 0)
    warn("fluid[0].outside",
         fmt::format("{} of {:.0f} particles start outside the domain; the first "
                     "step puts them onto its walls",
                     d.outside, d.particles));
  const double area =
      (scene.domain.max[0] - scene.domain.min[0]) * (scene.domain.max[1] - scene.domain.min[1]);
  const double needed = d.particles * d.mass / d.rest_density;
  if (needed > area)
    warn("particles.mass",
         fmt::format("at rest density the fluid takes {:.4g} m², and the domain has "
                     "{:.4g} m²; it will be compressed",
                     needed, area));
  if (scene.time.step > d.step_bound())
    warn("time.step",
         fmt::format("the time step {:.4g} s is over its bound, {:.4g} s ({}); the run may "
                     "blow up",
                     scene.time.step, d.step_bound(), d.step_bound_name()));
  return warnings;
}

}  // namespace freshet
