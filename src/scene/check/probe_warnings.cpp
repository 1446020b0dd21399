// SPDX-License-Identifier: MIT
#include "scene/check/probe_warnings.h"

#include <algorithm>
#include <cmath>

#include "scene/check/findings.h"
#include "scene/model/probe_patch.h"
#include "scene/model/setup.h"
#include "scene/sample/akinci_layer.h"
#include "scene/sample/region_surface.h"
#include "scene/sample/sample_bodies.h"
#include "scene/sample/sample_walls.h"

namespace freshet {
namespace {

/// Which parts of a probe's piece of wall have a boundary particle within the support radius. The
/// parts are about two spacings wide.
class Cover {
 public:
  Cover(const Scene& s, const Scene::Probe& p)
      : patch_(patch_of(p)), reach_(support_radius(s)), half_cell_(s.particles.spacing / 2) {
    std::size_t all = 1;
    for (const double half : patch_.half) {
      parts_.push_back(std::max<std::size_t>(1, std::size_t(half / s.particles.spacing)));
      all *= parts_.back();
    }
    covered_.resize(all);
  }
  /// Adds particles at x, relative to `origin`.
  template <class R> void add(const std::vector<R>& x, const Triple& origin) {
    const std::size_t n = patch_.center.size();
    for (std::size_t i = 0; i < x.size(); i += n) {
      std::size_t part = 0;
      bool near = true;
      for (std::size_t k = 0; k < n && near; ++k) {
        double along = 0;
        for (std::size_t d = 0; d < n; ++d)
          along += (double(x[i + d]) + origin[d] - patch_.center[d]) * patch_.axes[k][d];
        const double half = patch_.half[k];
        near = std::abs(along) < half + (half > 0 ? half_cell_ : reach_);
        if (half == 0) continue;
        const double at = std::clamp((along + half) / (2 * half), 0.0, 1 - 1e-9);
        part = part * parts_[k] + std::size_t(at * double(parts_[k]));
      }
      if (near) covered_[part] = true;
    }
  }
  double share() const {
    return double(std::count(covered_.begin(), covered_.end(), true)) / double(covered_.size());
  }

 private:
  WallPatch patch_;
  double reach_, half_cell_;
  std::vector<std::size_t> parts_;
  std::vector<bool> covered_;
};

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

/// The wall or fixed body that holds all of a point or line; empty: none. Sheets are thin, and
/// moved bodies leave.
template <int D> std::string solid_around(const Scene& s, const Scene::Probe& p) {
  if (!p.body.empty() || (p.kind != ProbeKind::point && p.kind != ProbeKind::line)) return "";
  const auto from = vec_of<D>(p.kind == ProbeKind::point ? p.at : p.from),
             to = vec_of<D>(p.kind == ProbeKind::point ? p.at : p.to);
  constexpr int parts = 32;
  const auto holds = [&](const Scene::Region& region) {
    if (region.shape == Shape::points) return false;
    const RegionSurface<D> surface(region, 0);
    bool all = !surface.is_sheet();
    for (int k = 0; k <= parts && all; ++k)
      all = surface.distance(from + double(k) / parts * (to - from)) < 0;
    return all;
  };
  for (std::size_t k = 0; k < s.wall.size(); ++k)
    if (holds(s.wall[k])) return s.wall_names()[2 * D + k];
  for (std::size_t k = 0; k < s.body.size(); ++k)
    if (s.body[k].motion == BodyMotion::fixed && holds(s.body[k])) return s.body_name(k);
  return "";
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
    if (s.dimension() == 2 ? !solid_around<2>(s, p).empty() : !solid_around<3>(s, p).empty())
      continue;  // it finds no fluid
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
    const std::string solid =
        s.dimension() == 2 ? solid_around<2>(s, s.probe[k]) : solid_around<3>(s, s.probe[k]);
    if (!solid.empty())
      list.push_back(
          {Diagnostic::Severity::warning,
           place_of(s, fmt::format("probe[{}].{}", k, point ? "at" : "from")),
           fmt::format("{} is inside {}, where it finds no fluid; move it into the fluid",
                       point ? "this point" : "all of this probe", solid)});
  }
  if (s.probe.empty()) return list;
  Sample all;
  if (s.dimension() == 2) sample_walls<2>(s, all), sample_bodies<2>(s, all);
  else sample_walls<3>(s, all), sample_bodies<3>(s, all);
  warn_of_mirrors(s, all, list);
  const Triple origin = origin_of(s);
  for (std::size_t k = 0; k < s.probe.size(); ++k) {
    const Scene::Probe& p = s.probe[k];
    if (p.kind != ProbeKind::wall) continue;
    Cover cover(s, p);
    for (const WallSample* walls : {&all.akinci2012, &all.adami2012, &all.monaghan2009})
      cover.add(walls->x, origin);
    cover.add(all.bodies.x, Triple{});
    const double share = cover.share();
    if (share == 0)
      list.push_back({Diagnostic::Severity::warning, place_of(s, fmt::format("probe[{}].from", k)),
                      fmt::format("no boundary particle is within the support radius, {:.4g} m, of "
                                  "this probe: it will report 0; move it onto a wall",
                                  support_radius(s))});
    else if (share < 1)
      list.push_back(
          {Diagnostic::Severity::warning, place_of(s, fmt::format("probe[{}].from", k)),
           fmt::format("about {:.0f} % of this probe has no boundary particle within the "
                       "support radius, {:.4g} m, and bears nothing: its traction will "
                       "be too small; move its ends onto the wall",
                       100 * (1 - share), support_radius(s))});
  }
  return list;
}

}  // namespace freshet
