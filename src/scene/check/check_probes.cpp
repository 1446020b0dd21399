// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include "scene/check/findings.h"
#include "scene/check/names.h"
#include "scene/keys/keys.h"
#include "scene/model/probe_patch.h"
#include "scene/model/probe_plane.h"
#include "scene/model/setup.h"
#include "scene/sample/sample_walls.h"

namespace freshet {
namespace {

constexpr std::size_t most_probes = 1000;
constexpr std::int64_t most_places = 100000;

/// The keys that the kind reads must be set, and no others.
void check_vectors(const Scene& s, const Scene::Probe& p, const std::string& at, Findings& out) {
  const bool point = p.kind == ProbeKind::point;
  const char* kind = probe_words[int(p.kind)];
  const auto needs = [&](const char* key, const Vector& x) {
    if (x.empty())
      out.error(at + key, fmt::format("probe.{} is missing; a probe of kind \"{}\" needs it, as {} "
                                      "numbers",
                                      key, kind, s.dimension()));
    else if (x.size() != std::size_t(s.dimension()))
      out.error(at + key,
                fmt::format("probe.{} has {} numbers, and the domain is in {}D; it must have {}",
                            key, x.size(), s.dimension(), s.dimension()));
  };
  if (point) {
    needs("at", p.at);
    for (const char* key : {"from", "to"})
      out.unused(at + key, fmt::format("probe.{}", key),
                 "a point has probe.at; remove it, or choose kind = \"line\"");
  } else {
    needs("from", p.from);
    needs("to", p.to);
    out.unused(at + "at", "probe.at",
               fmt::format("a {} goes from probe.from to probe.to; remove it", kind));
    if (!p.from.empty() && p.from == p.to)
      out.error(at + "to", "probe.to equals probe.from; a line needs a length; move one of them");
  }
  if (p.kind != ProbeKind::line)
    out.unused(at + "count", "probe.count",
               fmt::format("a {} has no count; remove it, or choose kind = \"line\"", kind));
  if (p.kind != ProbeKind::wall || s.dimension() == 2)
    out.unused(at + "along", "probe.along",
               p.kind == ProbeKind::wall
                   ? "in 2D a piece of wall is the segment from probe.from to probe.to; remove it"
                   : fmt::format("a {} has no edges; remove it, or choose kind = \"wall\"", kind));
  if (p.kind != ProbeKind::plane)
    out.unused(at + "apart", "probe.apart",
               fmt::format("a {} is not a plane; remove it, or choose kind = \"plane\"", kind));
}

/// The corners must differ along `wanted` axes.
bool check_corners(const Scene& s, const Scene::Probe& p, std::size_t wanted, const std::string& at,
                   Findings& out) {
  const auto n = std::size_t(s.dimension());
  if (p.from.size() != n || p.to.size() != n || p.from == p.to) return false;  // reported already
  std::size_t axes = 0;
  for (std::size_t d = 0; d < n; ++d) axes += p.from[d] != p.to[d];
  if (axes == wanted) return true;
  out.error(at + "to",
            fmt::format("probe.to differs from probe.from along {} {}; {} must differ along "
                        "{}",
                        axes, axes == 1 ? "axis" : "axes",
                        p.kind == ProbeKind::plane ? "opposite corners of a plane"
                                                   : "opposite corners of a wall rectangle",
                        wanted == 1 ? "one" : "two"));
  return false;
}

/// A plane must be a rectangle with at most `most_places` points.
void check_plane(const Scene& s, const Scene::Probe& p, const std::string& at, Findings& out) {
  if (!check_corners(s, p, 2, at, out)) return;
  double places = 1;
  for (std::size_t d = 0; d < p.from.size(); ++d) places *= 1 + double(steps_of_plane(s, p, d));
  if (places > most_places)
    out.error(at + "to", fmt::format("the plane has {:.3g} points; at most {} are allowed; make "
                                     "probe.apart larger",
                                     places, most_places));
}

/// A line of not too many places.
void check_surface(const Scene& s, const Scene::Probe& p, const std::string& at, Findings& out) {
  const auto n = std::size_t(s.dimension());
  if (p.from.size() != n || p.to.size() != n) return;  // reported already
  const double places = 1 + steps_of_surface(s, p);
  if (places > most_places)
    out.error(at + "to", fmt::format("the line of the surface probe has {:.3g} places, four in a "
                                     "spacing; at most {} are allowed; move probe.from and "
                                     "probe.to closer together",
                                     places, most_places));
}

bool has_samples(const Scene& s) {
  const auto sampled = [&](WallMethod m) { return wall_layers(s, m) > 0; };
  bool any = !s.body.empty();
  for (int side = 0; side < 2 * s.dimension(); ++side) any = any || sampled(s.side_method(side));
  for (std::size_t k = 0; k < s.wall.size(); ++k) any = any || sampled(s.wall_method(k));
  return any;
}

/// The edges of a rectangle on a wall in 3D: parallel to the axes, or one of them to probe.along.
bool check_rectangle(const Scene& s, const Scene::Probe& p, const std::string& at, Findings& out) {
  if (p.from.size() != 3 || p.to.size() != 3 || p.from == p.to) return false;  // reported already
  if (p.along.empty()) {
    if (p.from[0] == p.to[0] || p.from[1] == p.to[1] || p.from[2] == p.to[2])
      return check_corners(s, p, 2, at, out);
    out.error(at + "along",
              "probe.from and probe.to differ along all three axes, and the edges of a rectangle "
              "between them have no direction; set probe.along to the direction of one edge");
    return false;
  }
  if (p.along.size() != 3 || p.along == Vector(3, 0.0)) {
    out.error(at + "along", "probe.along must be 3 numbers that are not all 0");
    return false;
  }
  const WallPatch patch = patch_of(p);
  const double shortest = 1e-6 * std::max(patch.half[0], patch.half[1]);
  if (patch.half[0] > shortest && patch.half[1] > shortest) return true;
  out.error(at + "along",
            "probe.to differs from probe.from only along probe.along or only across it; a "
            "rectangle on a wall needs opposite corners; move one of them");
  return false;
}

/// A wall probe must be a rectangle (in 2D a segment), and needs walls with boundary particles.
void check_wall(const Scene& s, const Scene::Probe& p, const std::string& at, Findings& out) {
  if (s.dimension() == 3 && !check_rectangle(s, p, at, out)) return;
  if (!has_samples(s))
    out.error(at + "kind",
              fmt::format("probe.kind is \"wall\", which needs boundary particles, and no wall has "
                          "any; choose {}, or another kind",
                          s.method().has_boundary_particles()
                              ? "walls.method = \"akinci2012\""
                              : fmt::format("another solver.name than {}", s.method().name)));
}

}  // namespace

void check_probes(const Scene& s, Findings& out) {
  if (s.probe.size() > most_probes)
    return out.error("probe", fmt::format("there are {} probes; at most {} are allowed; a line of "
                                          "many points is one probe",
                                          s.probe.size(), most_probes));
  std::set<std::string> names;
  for (std::size_t k = 0; k < s.probe.size(); ++k) {
    const Scene::Probe& p = s.probe[k];
    const std::string at = fmt::format("probe[{}].", k);
    check_vectors(s, p, at, out);
    if (p.kind == ProbeKind::plane) check_plane(s, p, at, out);
    if (p.kind == ProbeKind::wall) check_wall(s, p, at, out);
    if (p.kind == ProbeKind::surface) check_surface(s, p, at, out);
    if (!p.body.empty()) find_body(s, p.body, at + "body", "probe.body", out);
    if (p.count > most_places)
      out.error(at + "count", fmt::format("probe.count is {}; at most {} points are allowed",
                                          p.count, most_places));
    if (!p.name.empty() && !names_file(p.name))
      out.error(at + "name",
                fmt::format("probe.name is \"{}\", which cannot name a file; use letters, "
                            "digits, _, - and ., in at most 200 bytes",
                            p.name));
    else if (!p.name.empty() && !names.insert(p.name).second)
      out.error(at + "name", fmt::format("two probes are named \"{}\"; rename one", p.name));
  }
}

}  // namespace freshet
