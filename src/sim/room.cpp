// SPDX-License-Identifier: MIT
#include "sim/room.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/model/openings.h"
#include "sim/solids.h"

namespace freshet {
namespace {

constexpr double most_distances = 1 << 26;  // about a second

template <int D> Vec<D, double> place_of(const ParticleView& f, std::size_t i) {
  Vec<D, double> x{};
  for (int k = 0; k < D; ++k) component(x, k) = double(f.x[D * i + std::size_t(k)]);
  return x;
}

/// The solid nearest to x, of those whose normal there is opposite to `normal`.
template <int D>
std::pair<double, std::size_t> nearest_opposite(const Solids<D>& solids, Vec<D, double> x,
                                                Vec<D, double> normal, double reach) {
  std::pair<double, std::size_t> nearest{reach, solids.size()};
  for (std::size_t k = 0; k < solids.size(); ++k) {
    const double distance = solids.distance(k, x);
    if (distance < nearest.first && dot(solids.normal(k, x, reach / 100), normal) < -0.5)
      nearest = {distance, k};
  }
  return nearest;
}

template <int D>
std::optional<Pinch> pinch_in(const Scene& scene, const Bodies* bodies, const ParticleView& f) {
  const Solids<D> solids(scene, bodies);
  const double spacing = scene.particles.spacing;
  std::optional<Pinch> worst;
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t k = solids.first_body(); k < solids.size(); ++k) {
      const auto x = place_of<D>(f, i);
      if (!solids.is_moved(k) || !(std::abs(solids.distance(k, x)) < spacing)) continue;
      const auto normal = solids.normal(k, x, spacing / 100);
      const double speed = solids.approach(k, x, normal);
      if (!(speed > 0)) continue;
      const auto [beyond, other] = nearest_opposite<D>(solids, x, normal, spacing);
      const double gap = solids.distance(k, x) + beyond;
      if (other == solids.size() || gap > 0.95 * spacing || (worst && gap > worst->gap)) continue;
      worst = Pinch{f.id[i], {}, solids.name(k), solids.name(other), gap, speed};
      for (int d = 0; d < D; ++d) worst->x[std::size_t(d)] = double(f.x[D * i + std::size_t(d)]);
    }
  return worst;
}

/// The space between the solids, in cells of about a spacing that fill the domain.
template <int D> class Space {
 public:
  using Point = Vec<D, double>;

  Space(const Scene& scene, const Bodies* bodies) : s_(scene), solids_(scene, bodies) {
    double cells = 1;
    for (std::size_t k = 0; k < D; ++k) {
      const double length = s_.domain.max[k] - s_.domain.min[k];
      const double n = std::max(1.0, std::round(length / s_.particles.spacing));
      cells *= n;
      count_[k] = std::int64_t(n);
      cell_[k] = length / n;
    }
    if (cells * double(solids_.size() + 1) > most_distances) return;
    measure(std::size_t(cells));
    for (std::size_t c = 0; c < free_.size(); ++c)
      if (free_[c] >= 0.5 && volume_of_[c] < 0) flood(c);
    share_cut_cells();
  }

  std::optional<ClosedVolume> fullest(const ParticleView& fluid, double time) const {
    std::vector<double> particles(volumes_.size());
    for (std::size_t i = 0; i < fluid.size(); ++i)
      if (const int v = volume_at(place_of<D>(fluid, i)); v >= 0) ++particles[std::size_t(v)];
    int fullest = -1;
    double share = 0;
    for (std::size_t v = 0; v < volumes_.size(); ++v)
      if (!volumes_[v].open && particles[v] > share * volumes_[v].room) {
        fullest = int(v);
        share = particles[v] / volumes_[v].room;
      }
    if (fullest < 0) return {};
    ClosedVolume found{particles[std::size_t(fullest)], volumes_[std::size_t(fullest)].room,
                       inlet_into(fullest, time), "", 0};
    find_body_into(fullest, found);
    return found;
  }

 private:
  struct Volume {
    bool open = false;
    double room = 0;
  };

  std::array<std::int64_t, D> place_of_cell(std::size_t cell) const {
    std::array<std::int64_t, D> at{};
    for (std::size_t k = 0; k < D; ++k) {
      at[k] = std::int64_t(cell) % count_[k];
      cell /= std::size_t(count_[k]);
    }
    return at;
  }
  std::size_t cell_of(const std::array<std::int64_t, D>& at) const {
    std::size_t cell = 0;
    for (std::size_t k = D; k-- > 0;) cell = cell * std::size_t(count_[k]) + std::size_t(at[k]);
    return cell;
  }
  Point center(std::size_t cell) const {
    const auto at = place_of_cell(cell);
    Point x{};
    for (std::size_t k = 0; k < D; ++k)
      component(x, int(k)) = s_.domain.min[k] + (double(at[k]) + 0.5) * cell_[k];
    return x;
  }
  /// The cell beyond a side of this one: -1 is a wall, -2 the outside of the domain.
  std::int64_t neighbor(std::size_t cell, int side) const {
    auto at = place_of_cell(cell);
    const auto k = std::size_t(side / 2);
    at[k] += side % 2 ? 1 : -1;
    if (at[k] < 0 || at[k] >= count_[k]) {
      if (!s_.periodic(int(k))) return s_.side_method(side) == WallMethod::open ? -2 : -1;
      at[k] = (at[k] + count_[k]) % count_[k];
    }
    return std::int64_t(cell_of(at));
  }
  int volume_at(Point x) const {
    std::array<std::int64_t, D> at{};
    for (std::size_t k = 0; k < D; ++k) {
      const double cells = std::floor((component(x, int(k)) - s_.domain.min[k]) / cell_[k]);
      if (!(cells >= 0 && cells < double(count_[k]))) return -1;
      at[k] = std::int64_t(cells);
    }
    return volume_of_.empty() ? -1 : volume_of_[cell_of(at)];
  }

  /// The free share of each cell, as if the surface of the nearest solid were flat.
  void measure(std::size_t cells) {
    const double width = *std::max_element(cell_.begin(), cell_.end());
    free_.assign(cells, 1);
    volume_of_.assign(cells, -1);
    for (std::size_t c = 0; c < cells; ++c)
      for (std::size_t k = solids_.first_wall(); k < solids_.size(); ++k)
        free_[c] = std::min(
            free_[c], float(std::clamp(solids_.distance(k, center(c)) / width + 0.5, 0.0, 1.0)));
  }
  bool is_in_outlet(Point x) const {
    return std::any_of(s_.outlet.begin(), s_.outlet.end(), [&](const Scene::Outlet& outlet) {
      return RegionSurface<D>(outlet, s_.particles.spacing).distance(x) > 0;
    });
  }
  /// Numbers the volume that a cell belongs to.
  void flood(std::size_t first) {
    const int number = int(volumes_.size());
    Volume volume;
    std::vector<std::size_t> open{first};
    volume_of_[first] = number;
    while (!open.empty()) {
      const std::size_t c = open.back();
      open.pop_back();
      volume.room += double(free_[c]);
      volume.open |= is_in_outlet(center(c));
      for (int side = 0; side < 2 * D; ++side) {
        const std::int64_t next = neighbor(c, side);
        volume.open |= next == -2;
        if (next < 0 || free_[std::size_t(next)] < 0.5 || volume_of_[std::size_t(next)] >= 0)
          continue;
        volume_of_[std::size_t(next)] = number;
        open.push_back(std::size_t(next));
      }
    }
    volumes_.push_back(volume);
  }
  /// Cells that are less than half free belong to a volume beside them. Then `room` is in
  /// particles.
  void share_cut_cells() {
    for (std::size_t c = 0; c < free_.size(); ++c)
      for (int side = 0; side < 2 * D && volume_of_[c] < 0 && free_[c] > 0.01F; ++side) {
        const std::int64_t next = neighbor(c, side);
        if (next < 0 || free_[std::size_t(next)] < 0.5) continue;
        volume_of_[c] = volume_of_[std::size_t(next)];
        volumes_[std::size_t(volume_of_[c])].room += double(free_[c]);
      }
    double particles = 1;
    for (const double width : cell_) particles *= width / s_.particles.spacing;
    for (Volume& volume : volumes_) volume.room *= particles;
  }

  std::string inlet_into(int volume, double time) const {
    for (std::size_t k = 0; k < s_.inlet.size(); ++k) {
      const Opening<D> opening = opening_of<D>(s_.inlet[k]);
      if (s_.inlet[k].start <= time &&
          volume_at(opening.center + s_.particles.spacing * opening.direction) == volume)
        return s_.flow_names()[k];
    }
    return "";
  }
  /// The moved body of which more moves into a volume than out of it. A body that turns or drifts
  /// in the fluid takes no room away.
  void find_body_into(int volume, ClosedVolume& found) const {
    std::vector<double> inflow(solids_.size()), gross(inflow), faces(inflow);
    for (std::size_t c = 0; c < free_.size(); ++c)
      for (int side = 0; side < 2 * D && volume_of_[c] == volume && free_[c] >= 0.5; ++side) {
        const std::int64_t beyond = neighbor(c, side);
        if (beyond < 0 || free_[std::size_t(beyond)] >= 0.5) continue;
        const std::size_t k = nearest_solid(center(std::size_t(beyond)));
        if (!solids_.is_moved(k)) continue;
        Point normal{}, face = center(c);
        const double sign = side % 2 ? 1 : -1;
        component(normal, side / 2) = -sign;
        component(face, side / 2) += sign * cell_[std::size_t(side / 2)] / 2;
        const double speed = solids_.approach(k, face, normal);
        inflow[k] += speed;
        gross[k] += std::abs(speed);
        ++faces[k];
      }
    for (std::size_t k = 0; k < inflow.size(); ++k)
      if (inflow[k] > 0.01 * gross[k] && inflow[k] / faces[k] > found.speed) {
        found.speed = inflow[k] / faces[k];
        found.body = solids_.name(k);
      }
  }
  std::size_t nearest_solid(Point x) const {
    std::size_t nearest = solids_.first_wall();
    for (std::size_t k = nearest; k < solids_.size(); ++k)
      if (solids_.distance(k, x) < solids_.distance(nearest, x)) nearest = k;
    return nearest;
  }

  const Scene& s_;
  Solids<D> solids_;
  std::array<std::int64_t, D> count_{};
  std::array<double, D> cell_{};
  std::vector<float> free_;     // share of each cell
  std::vector<int> volume_of_;  // of each cell; -1: none
  std::vector<Volume> volumes_;
};

template <int D>
std::optional<CrowdedInlet> crowded_inlet_in(const Scene& scene, const ParticleView& f,
                                             double time) {
  std::optional<CrowdedInlet> worst;
  for (std::size_t k = 0; k < scene.inlet.size(); ++k) {
    if (scene.inlet[k].start > time) continue;
    const Opening<D> opening = opening_of<D>(scene.inlet[k]);
    const InletPlan plan = inlet_plan(scene, scene.inlet[k]);
    const double beside = 0.75 * plan.spacing;  // closer than a particle behind a wall
    CrowdedInlet now{scene.flow_names()[k], 0, double(plan.particles()) * plan.layers};
    for (std::size_t i = 0; i < f.size(); ++i) {
      const auto x = place_of<D>(f, i);
      const double ahead = opening.ahead(x);
      now.particles += ahead < 0 && ahead > -plan.depth() - beside && opening.covers(x, beside);
    }
    if (now.crowding() > (worst ? worst->crowding() : 0)) worst = now;
  }
  return worst;
}

}  // namespace

std::optional<Pinch> find_pinch(const Scene& scene, const Bodies* bodies,
                                const ParticleView& fluid) {
  if (!bodies) return {};
  return scene.dimension() == 2 ? pinch_in<2>(scene, bodies, fluid)
                                : pinch_in<3>(scene, bodies, fluid);
}

std::optional<ClosedVolume> fullest_closed_volume(const Scene& scene, const Bodies* bodies,
                                                  const ParticleView& fluid, double time) {
  if (scene.dimension() == 2) return Space<2>(scene, bodies).fullest(fluid, time);
  return Space<3>(scene, bodies).fullest(fluid, time);
}

std::optional<CrowdedInlet> most_crowded_inlet(const Scene& scene, const ParticleView& fluid,
                                               double time) {
  return scene.dimension() == 2 ? crowded_inlet_in<2>(scene, fluid, time)
                                : crowded_inlet_in<3>(scene, fluid, time);
}

}  // namespace freshet
