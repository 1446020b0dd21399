// SPDX-License-Identifier: MIT
#include "scene/check/probe_warnings.h"

#include <algorithm>
#include <cmath>

#include "scene/check/findings.h"
#include "scene/model/probe_patch.h"
#include "scene/model/setup.h"
#include "scene/sample/akinci_layer.h"
#include "scene/sample/sample_bodies.h"
#include "scene/sample/sample_walls.h"

namespace freshet {
namespace {

/// Whether a boundary particle is close enough to act on the probe's piece of wall. x: their
/// positions relative to `origin`.
template <class R>
bool reaches(const Scene& s, const Scene::Probe& p, const std::vector<R>& x, const Triple& origin) {
  const auto n = std::size_t(s.dimension());
  const double reach = support_radius(s), half_cell = s.particles.spacing / 2;
  const WallPatch patch = patch_of(p);
  for (std::size_t i = 0; i < x.size(); i += n) {
    bool near = true;
    for (std::size_t k = 0; k < n; ++k) {
      double along = 0;
      for (std::size_t d = 0; d < n; ++d)
        along += (double(x[i + d]) + origin[d] - patch.center[d]) * patch.axes[k][d];
      near = near && std::abs(along) < patch.half[k] + (patch.half[k] > 0 ? half_cell : reach);
    }
    if (near) return true;
  }
  return false;
}

/// Whether all of a probe is beyond a side of the domain that fluid cannot pass. A body may carry a
/// probe inside.
bool is_outside(const Scene& s, const Scene::Probe& p) {
  if (!p.body.empty()) return false;
  const Vector &from = p.kind == ProbeKind::point ? p.at : p.from,
               &to = p.kind == ProbeKind::point ? p.at : p.to;
  for (int side = 0; side < 2 * s.dimension(); ++side) {
    const auto k = std::size_t(side / 2);
    if (!s.periodic(side / 2) && s.side_method(side) == WallMethod::open) continue;
    const bool beyond = side % 2 ? std::min(from[k], to[k]) > s.domain.max[k]
                                 : std::max(from[k], to[k]) < s.domain.min[k];
    if (beyond) return true;
  }
  return false;
}

/// Whether a point, or all of a line, is less than 1.5 spacings in front of boundary particles that
/// mirror the pressure. x: their positions relative to `origin`.
template <class R>
bool touches_mirrors(const Scene& s, const Scene::Probe& p, const std::vector<R>& x,
                     const Triple& origin) {
  if (x.empty()) return false;
  const auto n = std::size_t(s.dimension());
  const double reach2 = square(1.5 * s.particles.spacing + AkinciLayer(s).depth());
  const auto near = [&](const Vector& place) {
    for (std::size_t i = 0; i < x.size(); i += n) {
      double r2 = 0;
      for (std::size_t d = 0; d < n; ++d) r2 += square(double(x[i + d]) + origin[d] - place[d]);
      if (r2 < reach2) return true;
    }
    return false;
  };
  if (p.kind == ProbeKind::point) return near(p.at);
  return p.kind == ProbeKind::line && near(p.from) && near(p.to) && near(patch_of(p).center);
}

void warn_of_mirrors(const Scene& s, const Sample& all, std::vector<Diagnostic>& list) {
  const bool bodies = body_method(s) == WallMethod::akinci2012;
  const Triple origin = origin_of(s);
  for (std::size_t k = 0; k < s.probe.size(); ++k) {
    const Scene::Probe& p = s.probe[k];
    if (!touches_mirrors(s, p, all.akinci2012.x, origin) &&
        !(bodies && touches_mirrors(s, p, all.bodies.x, {})))
      continue;
    const char* key = p.kind == ProbeKind::point ? "at" : "from";
    list.push_back(
        {Diagnostic::Severity::warning, place_of(s, fmt::format("probe[{}].{}", k, key)),
         "fluid particles that touch \"akinci2012\" have up to 1.6 times the pressure of "
         "the water (docs/solvers.md), and this probe is beside them; for the pressure "
         "on the wall choose kind = \"wall\", else move the probe two spacings into "
         "the fluid"});
  }
}

}  // namespace

std::vector<Diagnostic> probe_warnings(const Scene& s) {
  std::vector<Diagnostic> list;
  for (std::size_t k = 0; k < s.probe.size(); ++k) {
    const bool point = s.probe[k].kind == ProbeKind::point;
    if (s.probe[k].kind != ProbeKind::wall && is_outside(s, s.probe[k]))
      list.push_back(
          {Diagnostic::Severity::warning,
           place_of(s, fmt::format("probe[{}].{}", k, point ? "at" : "from")),
           fmt::format("{} is outside the domain, where it finds no fluid; move it inside",
                       point ? "this point" : "all of this probe")});
  }
  if (s.probe.empty()) return list;
  Sample all;
  if (s.dimension() == 2) sample_walls<2>(s, all), sample_bodies<2>(s, all);
  else sample_walls<3>(s, all), sample_bodies<3>(s, all);
  warn_of_mirrors(s, all, list);
  const Triple origin = origin_of(s);
  for (std::size_t k = 0; k < s.probe.size(); ++k) {
    const Scene::Probe& p = s.probe[k];
    if (p.kind != ProbeKind::wall || reaches(s, p, all.akinci2012.x, origin) ||
        reaches(s, p, all.adami2012.x, origin) || reaches(s, p, all.monaghan2009.x, origin) ||
        reaches(s, p, all.bodies.x, Triple{}))
      continue;
    list.push_back({Diagnostic::Severity::warning, place_of(s, fmt::format("probe[{}].from", k)),
                    fmt::format("no boundary particle is within the support radius, {:.4g} m, of "
                                "this probe: it will report 0; move it onto a wall",
                                support_radius(s))});
  }
  return list;
}

}  // namespace freshet
