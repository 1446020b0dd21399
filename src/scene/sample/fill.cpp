// SPDX-License-Identifier: MIT
#include "scene/sample/fill.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "scene/sample/fluid_volume.h"
#include "scene/sample/relax.h"

namespace freshet {
namespace {

constexpr double calm = 1.06;  // density over rest from which water beside a body starts to burst

/// An excluded place of the lattice near a wall.
template <int D> struct Candidate {
  Vec<D> x;
  std::int64_t room;  ///< distance from the nearest surface in 1e-4 spacings
  std::size_t face;   ///< of the nearest wall
  /// Axis and sign of the largest component of the normal there; the column below a free surface
  std::int64_t side;
};

template <int D> class Filling {
 public:
  Filling(const Scene& s, const Scene::Fluid& f, const Places<D>& places)
      : places_(places), spacing_(s.particles.spacing), faces_(faces_around<D>(s, f)) {}

  /// Candidates that fill `missing` places, each side of each wall in proportion to the part of its
  /// candidates' cells that is in the fluid.
  std::vector<Candidate<D>> choose(double missing) const {
    const std::vector<Candidate<D>> all = candidates();
    double shares = 0, before = 0, wanted = 0;
    for (const auto& one : all) shares += share(one);
    const double scale = shares > 0 ? std::max(0.0, missing) / shares : 0;
    std::vector<Candidate<D>> chosen;
    for (std::size_t first = 0, last = 0; first < all.size(); first = last) {
      for (; last < all.size() && same_side(all[first], all[last]); ++last)
        wanted += scale * share(all[last]);
      const auto count = std::size_t(std::round(wanted) - before);
      before += double(count);
      append(chosen, {all.begin() + std::ptrdiff_t(first), all.begin() + std::ptrdiff_t(last)},
             std::min(count, last - first));
    }
    return chosen;
  }
  /// Spreads all places evenly near the walls of those that were added. Returns the density of the
  /// densest place, over that of a lattice.
  double spread(std::vector<Vec<D>>& x, const std::vector<Candidate<D>>& added) const {
    std::vector<bool> near(faces_.size());
    for (const auto& one : added) near[one.face] = true;
    std::vector<Face<D>> walls;
    for (std::size_t f = 0; f < faces_.size(); ++f)
      if (near[f]) walls.push_back(faces_[f]);
    std::vector<Vec<D, double>> all;
    for (const auto& place : x) all.push_back(places_.in_scene(place));
    const double densest = relax<D>(all, faces_, walls, spacing_, [&](Vec<D, double> at) {
      return !places_.is_barred(places_.place_at(at));
    });
    std::transform(all.begin(), all.end(), x.begin(),
                   [&](Vec<D, double> at) { return places_.place_at(at); });
    return densest;
  }

 private:
  static constexpr double deepest = -0.45;  // spacings: room of a candidate in a wall

  static double share(const Candidate<D>& c) { return 0.5 + 1e-4 * double(c.room); }
  static bool same_side(const Candidate<D>& a, const Candidate<D>& b) {
    return a.face == b.face && a.side == b.side;
  }
  static int side_of(Vec<D, double> normal) {
    int axis = 0;
    for (int k = 1; k < D; ++k)
      if (std::abs(component(normal, k)) > std::abs(component(normal, axis))) axis = k;
    return 2 * axis + (component(normal, axis) < 0);
  }
  /// All candidates, side by side, those with the most room first.
  std::vector<Candidate<D>> candidates() const {
    std::vector<Candidate<D>> all;
    std::optional<Vec<D>> first;
    places_.each_of_lattice([&](Vec<D> x, std::size_t) {
      if (!first) first = x;
      const auto at = places_.in_scene(x);
      const double clearance = places_.clearance(at), room = std::min(clearance, places_.depth(at));
      const bool near = clearance < spacing_ / 2 && room > deepest * spacing_;
      if (!near || places_.is_barred(x) || (places_.in_shape(x) && !places_.in_wall(x)))
        return true;
      const std::size_t face = nearest_wall(at);
      const std::int64_t side =
          faces_[face].is_free() ? column_of(x - *first) : side_of(faces_[face].normal(at));
      all.push_back({x, std::llround(1e4 * room / spacing_), face, side});
      return true;
    });
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
      return std::tuple(a.face, a.side, -a.room) < std::tuple(b.face, b.side, -b.room);
    });
    return all;
  }
  /// The number of the lattice's column that is at x from its corner; columns side by side follow
  /// each other. choose() passes the rounding of one on to the next, so that any few of them have
  /// the volume below a free surface that is almost level.
  std::int64_t column_of(Vec<D> x) const {
    constexpr std::int64_t row = 1 << 30;
    const std::int64_t m = std::llround(double(x.x) / spacing_),
                       n = D == 3 ? std::llround(double(component(x, D - 1)) / spacing_) : 0;
    return n * row + (n % 2 ? row - 1 - m : m);
  }
  std::size_t nearest_wall(Vec<D, double> x) const {
    std::size_t best = 0;
    double least = INFINITY;
    for (std::size_t f = 0; f < faces_.size(); ++f)
      if (faces_[f].of_wall())
        if (const double d = faces_[f].distance(x); d < least) {
          least = d;
          best = f;
        }
    return best;
  }
  /// Appends `count` candidates of one side, the first ones. Of those with the room of the last
  /// one, it takes every so many.
  static void append(std::vector<Candidate<D>>& to, const std::vector<Candidate<D>>& side,
                     std::size_t count) {
    if (count == 0) return;
    const auto less = [](const auto& a, const auto& b) { return a.room > b.room; };
    const auto same = std::equal_range(side.begin(), side.end(), side[count - 1], less);
    to.insert(to.end(), side.begin(), same.first);
    const auto size = std::size_t(same.second - same.first),
               wanted = count - std::size_t(same.first - side.begin());
    for (std::size_t k = 0; k < size; ++k)
      if ((k + 1) * wanted / size > k * wanted / size) to.push_back(same.first[std::ptrdiff_t(k)]);
  }

  const Places<D>& places_;
  double spacing_;
  std::vector<Face<D>> faces_;
};

}  // namespace

template <int D>
std::int64_t fill_to_walls(const Scene& s, const Scene::Fluid& f, const Places<D>& places,
                           std::vector<Vec<D>>& x) {
  if (f.shape == Shape::lattice || f.shape == Shape::points) return 0;
  const Filling<D> filling(s, f, places);
  const double missing = volume_asked(s, f) / std::pow(s.particles.spacing, D) - double(x.size());
  for (const double share : {1.0, 0.75, 0.5, 0.25}) {
    const auto added = filling.choose(share * missing);
    if (added.empty()) return 0;
    std::vector<Vec<D>> filled = x;
    for (const auto& one : added) filled.push_back(one.x);
    const double densest = filling.spread(filled, added);
    if (!s.body.empty() && densest > calm) continue;
    x = std::move(filled);
    return std::int64_t(added.size());
  }
  return 0;
}

template std::int64_t fill_to_walls<2>(const Scene&, const Scene::Fluid&, const Places<2>&,
                                       std::vector<Vec<2>>&);
template std::int64_t fill_to_walls<3>(const Scene&, const Scene::Fluid&, const Places<3>&,
                                       std::vector<Vec<3>>&);

}  // namespace freshet
