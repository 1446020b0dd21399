// SPDX-License-Identifier: MIT
/// Limits the number of particles, before anything is sampled.
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>

#if defined(__EMSCRIPTEN__)
#include <emscripten/heap.h>
#endif

#include "scene/check/findings.h"
#include "scene/model/loaded_mesh.h"
#include "scene/model/openings.h"
#include "scene/model/setup.h"
#include "scene/sample/sample_walls.h"

namespace freshet {
namespace {

constexpr double most_particles = 2147483647.0;
constexpr double bytes_per_particle = 400;  // fields, lists and pictures, generously
constexpr double far_larger = 100;          // than the domain: probably another unit of length

/// Memory that the process may use [bytes].
double memory_limit() {
#if defined(__EMSCRIPTEN__)  // sysconf knows the memory that is in use, which grows
  return double(emscripten_get_heap_max());
#else
  double bytes = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
  rlimit address_space{};
  if (getrlimit(RLIMIT_AS, &address_space) == 0 && address_space.rlim_cur != RLIM_INFINITY)
    bytes = std::min(bytes, double(address_space.rlim_cur));
  return bytes;
#endif
}

/// The longest extent of a region [m]; 0 of a plane.
double extent(const Scene::Region& r) {
  double longest = 0;
  if (r.shape == Shape::sphere) return 2 * r.radius;
  if (r.shape == Shape::cylinder) return std::max(2 * r.radius, r.length);
  if (is_mesh(r)) {
    const auto sides = sides_of(*r.loaded);
    return std::max({sides.x, sides.y, sides.z});
  }
  for (std::size_t k = 0; r.shape == Shape::box && k < r.min.size(); ++k)
    longest = std::max(longest, r.max[k] - r.min[k]);
  return longest;
}

/// A wall or body that alone has too many boundary particles.
bool check_region_count(const Scene& s, const RegionAt& at, double count, Findings& out) {
  const double memory = memory_limit();
  if (count <= most_particles && count * bytes_per_particle <= memory) return true;
  double domain = 0;
  for (std::size_t k = 0; k < s.domain.max.size(); ++k)
    domain = std::max(domain, s.domain.max[k] - s.domain.min[k]);
  const double longest = extent(at.region);
  const bool other_unit = longest > far_larger * domain;
  const std::string limit =
      count > most_particles
          ? fmt::format("at most {:.0f} particles are allowed", most_particles)
          : fmt::format("they need about {:.3g} GiB of memory, and there are {:.3g} GiB",
                        count * bytes_per_particle / (1u << 30), memory / (1u << 30));
  out.error(at.path.substr(0, at.path.size() - 1),
            fmt::format("{} has about {:.3g} boundary particles; {}{}; make it smaller or the "
                        "spacing larger",
                        at.name, count, limit,
                        other_unit ? fmt::format(": it is {:.4g} m long, and the domain {:.4g} m; "
                                                 "all lengths are in metres",
                                                 longest, domain)
                                   : ""));
  return false;
}

bool check_regions(const Scene& s, const Countable& parts, Findings& out) {
  bool good = true;
  const std::vector<std::string> names = s.wall_names();
  const std::size_t sides = names.size() - s.wall.size();
  for (std::size_t k = 0; parts.walls && k < s.wall.size(); ++k)
    if (const int layers = wall_layers(s, s.wall_method(k));
        layers > 0 && s.wall[k].shape != Shape::points)
      good &= check_region_count(s, {s.wall[k], fmt::format("wall[{}].", k), names[sides + k]},
                                 most_samples(s, s.wall[k], layers), out);
  for (std::size_t k = 0; parts.bodies && k < s.body.size(); ++k)
    good &= check_region_count(s, {s.body[k], fmt::format("body[{}].", k), s.body_name(k)},
                               most_samples(s, s.body[k], wall_layers(s, body_method(s))), out);
  return good;
}

}  // namespace

bool check_count(const Scene& s, double fluid_places, const Countable& parts, Findings& out) {
  if (!check_regions(s, parts, out)) return false;
  double particles = fluid_places;
  if (parts.inlets || s.inlet.empty()) {
    const InflowEstimate inflow = estimate_inflow(s);
    particles += inflow.at_start + std::min(inflow.later, room_in_domain(s));
  }
  const double samples =
      (parts.walls ? most_wall_samples(s) : 0) + (parts.bodies ? most_body_samples(s) : 0);
  const double memory = memory_limit();
  const double all = particles + samples, needed = all * bytes_per_particle;
  const bool lattice = out.given("fluid[0].count") && particles > samples;
  const char* key = lattice ? "fluid[0].count" : "particles.spacing";
  const char* remedy =
      lattice ? "make fluid.count smaller" : "make the spacing larger or the fluid smaller";
  const std::string of_walls = samples > 0 ? fmt::format(" ({:.4g} of walls)", samples) : "";
  if (all > most_particles)
    out.error(key, fmt::format("the scene has {:.4g} particles{}; at most {:.0f} are allowed; {}",
                               all, of_walls, most_particles, remedy));
  else if (needed > memory)
    out.error(key, fmt::format("{:.4g} particles{} need about {:.3g} GiB of memory, and there are "
                               "{:.3g} GiB; {}",
                               all, of_walls, needed / (1u << 30), memory / (1u << 30), remedy));
  return all <= most_particles && needed <= memory;
}

}  // namespace freshet
