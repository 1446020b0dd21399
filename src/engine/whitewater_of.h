// SPDX-License-Identifier: MIT
/// The memory of the whitewater, its births and its deaths. Compiled once per backend and
/// dimension.
#pragma once
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/random.h"
#include "engine/store.h"
#include "engine/whitewater.h"
#include "solvers/ihmsen2012.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D> Ihmsen2012Parameters<D> ihmsen2012_parameters(const EnginePlan& p) {
  const WhitewaterPlan& w = p.whitewater;
  const auto limits = [](const std::array<double, 2>& range) {
    return Limits{Real(range[0]), Real(range[1])};
  };
  Ihmsen2012Parameters<D> c{};
  c.support = Real(p.support);
  c.spacing = Real(p.spacing);
  c.neighbors_inside = Real(w.neighbors);
  c.trapped_air = Real(w.trapped_air);
  c.wave_crest = Real(w.wave_crest);
  c.turbulence = Real(w.turbulence);
  c.trapped_limits = limits(w.trapped_limits);
  c.crest_limits = limits(w.crest_limits);
  c.turbulence_limits = limits(w.turbulence_limits);
  c.energy_limits = limits({square(w.speed_limits[0]) / 2, square(w.speed_limits[1]) / 2});
  c.buoyancy = Real(w.buoyancy);
  c.rise_speed = Real(w.rise_speed);
  c.min = vec_of<D, Real>(p.min);
  c.max = vec_of<D, Real>(p.max);
  for (int side = 0; side < 2 * D; ++side)
    c.closed |= unsigned(!p.periodic[std::size_t(side / 2)] && !(p.open_sides >> side & 1)) << side;
  return c;
}

template <int D, class B> class WhitewaterOf final : public Whitewater<D, B> {
 public:
  explicit WhitewaterOf(const EnginePlan& p)
      : method_{ihmsen2012_parameters<D>(p), kernel_of<D>(p)}, plan_(p.whitewater) {}

  void fields(Store<D, B>& store) override {
    store.make("whitewater_normal", Keep::scratch, sources_.n);
    if (plan_.turbulence > 0) store.make("whitewater_spin", Keep::scratch, sources_.spin);
    store.make("whitewater_births", Keep::scratch, sources_.births);
    store.make("whitewater_near", Keep::scratch, sources_.near);
    store.backend.add_set(set_, 0);
    const auto add = [&](const char* name, Keep keep, auto& field) {
      store.allocate(set_, "whitewater", name, keep, field, StateArray::Role::other);
    };
    add("id", Keep::kept, set_.id);
    add("x", Keep::kept, set_.x);
    add("v", Keep::kept, set_.v);
    add("kind", Keep::kept, set_.kind);
    add("age", Keep::kept, set_.age);
    add("life", Keep::kept, set_.life);
    add("around", Keep::scratch, set_.around);
    add("near", Keep::scratch, set_.near);
    const auto keep = [&](const char* name, auto* number) {
      store.state.add(
          name, [=] { return number; }, [] { return std::int64_t(1); }, StateArray::Role::other);
    };
    keep("whitewater_clock/elapsed", &elapsed_);
    keep("whitewater_clock/advances", &advances_);
    keep("whitewater_clock/next_id", &next_id_);
    keep("whitewater_clock/refused", &refused_);
  }

  void step(B& backend, const FluidParticles<D>& f, const Walls<D>& w,
            const Confinement<D>& confine, Vec<D, double> gravity, double dt) override {
    elapsed_ += dt;
    const auto v = f.v;
    const double fastest =
        std::sqrt(std::max(0.0, backend.max("whitewater", f, [=](int i) { return norm2(v[i]); })));
    constexpr double path = 0.7;  // of the fastest, in spacings
    if (elapsed_ * std::max(fastest, plan_.rise_speed) < path * double(method_.c.spacing)) return;
    const Real due = Real(elapsed_);
    method_.find_births(backend, f, w, sources_, due);
    Vec<D> g{};
    for (int k = 0; k < D; ++k) component(g, k) = Real(component(gravity, k));
    if (set_.n > 0) method_.move(backend, set_, f, w, confine, g, due);
    find_gone();
    find_born(f);
    ++advances_;
    edit(backend, f);
    elapsed_ = 0;
  }

  WhitewaterView view(const Triple& origin) const override {
    const auto n = std::size_t(set_.n);
    return {D,
            {set_.id.data, n},
            {reinterpret_cast<const Real*>(set_.x.data), n * D},
            {reinterpret_cast<const Real*>(set_.v.data), n * D},
            {set_.kind.data, n},
            {set_.age.data, n},
            elapsed_,
            refused_,
            origin};
  }
  void resize(B& backend, std::int64_t n) override { resize_set(backend, "whitewater", set_, n); }

 private:
  /// Births at a fluid particle.
  struct Source {
    std::uint64_t id;
    int place, births;
  };

  void find_gone() {
    gone_.clear();
    for (int i = 0; i < set_.n; ++i)
      if (method_.is_gone(set_, i)) gone_.push_back(i);
  }
  /// Draws the number of births at each fluid particle, in the order of their ids: that of their
  /// places depends on the backend.
  void find_born(const FluidParticles<D>& f) {
    born_.clear();
    for (int i = 0; i < f.n; ++i) {
      if (!(sources_.births[i] > 0)) continue;
      Draws draws(plan_.seed, f.id[i], advances_);
      const int births = int(std::min(double(sources_.births[i]), 1000.0) + draws.next());
      if (births > 0) born_.push_back({f.id[i], i, births});
    }
    std::sort(born_.begin(), born_.end(), [](auto& a, auto& b) { return a.id < b.id; });
    auto room = std::int64_t(plan_.most) - (set_.n - std::int64_t(gone_.size()));
    for (Source& source : born_) {
      const auto kept = int(std::clamp<std::int64_t>(room, 0, source.births));
      refused_ += std::uint64_t(source.births - kept);
      room -= source.births = kept;
    }
  }
  void edit(B& backend, const FluidParticles<D>& f) {
    int births = 0;
    for (const Source& source : born_) births += source.births;
    if (births == 0 && gone_.empty()) return;
    int i = set_.n - int(gone_.size());
    backend.edit("whitewater", set_, gone_, births);
    for (const Source& source : born_) {
      Draws draws(plan_.seed, ~source.id, advances_);
      for (int k = 0; k < source.births; ++k) bear(f, source.place, draws, i++);
    }
  }
  /// Writes a new particle: in a cylinder along the way that its fluid particle has come, of half a
  /// spacing for a radius  [sec. 3.2].
  void bear(const FluidParticles<D>& f, int source, Draws& draws, int i) {
    const Vec<D> v = f.v[source];
    const Real speed = norm(v), radius = method_.c.spacing / 2;
    const Real back = Real(draws.next() * elapsed_);
    set_.id[i] = next_id_++;
    set_.x[i] = f.x[source] - back * v + across(v / speed, radius, draws);
    set_.v[i] = v;
    set_.kind[i] = int(method_.c.kind(sources_.near[source]));
    const Real share = method_.c.energy_limits(square(speed) / 2);
    set_.life[i] = Real(plan_.life_min) + share * Real(plan_.life_max - plan_.life_min);
  }
  /// A point of the disc, in 2D of the line, across a direction.
  static Vec<D> across(Vec<D> along, Real radius, Draws& draws) {
    Real a = 0, b = 0;
    do {
      a = Real(2 * draws.next() - 1);
      b = D == 3 ? Real(2 * draws.next() - 1) : 0;
    } while (a * a + b * b > 1);
    if constexpr (D == 2) return (radius * a) * Vec<D>{-along.y, along.x};
    else {
      const Vec<D> other = along.x * along.x < Real(0.5f) ? Vec<D>{1, 0, 0} : Vec<D>{0, 1, 0};
      const Vec<D> n = cross(along, other), e = n / norm(n);
      return (radius * a) * e + (radius * b) * cross(along, e);
    }
  }

  Ihmsen2012<D, B, SceneKernel> method_;
  WhitewaterPlan plan_;
  WhitewaterParticles<D> set_;
  WhitewaterSources<D> sources_;
  std::vector<int> gone_;
  std::vector<Source> born_;
  double elapsed_ = 0;  // since the last advance [s]
  std::uint64_t advances_ = 0, next_id_ = 0;
  std::uint64_t refused_ = 0;  // births for which there was no room
};

}  // namespace FRESHET_ISA
}  // namespace freshet
