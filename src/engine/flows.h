// SPDX-License-Identifier: MIT
/// Inlets, outlets, counters and open sides of a fluid. They act between steps.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "boundary/open_sides.h"
#include "boundary/opening.h"
#include "engine/inlet_clock.h"
#include "engine/parameters.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The flows of a scene. They add kept fields to the fluid where a scene needs them:
///
///   held        0: free; else 1 + the index of the target (inlet, layer, place) that moves the
///               particle in place of the solver
///   x_counted   position at the last count [m]
template <int D> class Flows {
 public:
  explicit Flows(const EnginePlan& p) {
    for (const InletPlan& plan : p.inlets) {
      inlets_.emplace_back(plan);
      first_target_.push_back(int(targets_.size()));
      const InletClock& inlet = inlets_.back();
      targets_.resize(targets_.size() + std::size_t(inlet.slots()) * inlet.plan().particles());
    }
    for (const SolidPlan& outlet : p.outlets) outlets_.push_back(solid_of<D, double>(outlet));
    for (const OpeningPlan& o : p.counters)
      counters_.push_back({vec_of<D>(o.center), vec_of<D>(o.direction), vec_of<D>(o.across),
                           vec_of<D>(o.up), o.half_width, o.half_height, o.radius});
    unsigned closed = (1u << 2 * D) - 1;
    for (int k = 0; k < D; ++k)
      if (p.periodic[std::size_t(k)]) closed &= ~(3u << 2 * k);
    open_ = {vec_of<D>(p.min), vec_of<D>(p.max), p.support, p.open_sides, closed & ~p.open_sides};
    for (int side = 0; side < 2 * D; ++side)
      if (open_.open >> side & 1) open_list_.push_back(side);
    counts_.resize(outlets_.size() + counters_.size() + open_list_.size());
    for (int k = 0; k < D; ++k)
      if (p.periodic[std::size_t(k)])
        component(period_, k) = p.max[std::size_t(k)] - p.min[std::size_t(k)];
  }
  bool remove_particles() const { return !outlets_.empty() || open_.open; }
  bool any() const { return !inlets_.empty() || remove_particles() || !counters_.empty(); }

  /// Calls visit(name, keep, field) for the fields that this scene needs.
  template <class Visit> void fields(Visit visit) {
    if (!inlets_.empty()) visit("held", Keep::kept, held_);
    if (!counters_.empty()) visit("x_counted", Keep::kept, x_counted_);
    if (remove_particles() || !counters_.empty()) visit("mark", Keep::scratch, mark_);
  }
  /// Calls visit(name, data, count) for the other state, arrays of 64-bit numbers.
  template <class Visit> void numbers(Visit visit) {
    visit("flows/next_id", &next_id_, std::size_t(1));
    if (inlets_.empty() && counts_.empty()) return;
    visit("flows/counts", counts_.data(), counts_.size());
    for (std::size_t k = 0; k < inlets_.size(); ++k) {
      const std::string at = "flows/inlet_" + std::to_string(k);
      visit(at + "_layers", &inlets_[k].state.born, std::size_t(3));
      visit(at + "_crossings", inlets_[k].crossings().data(), inlets_[k].crossings().size());
    }
  }
  /// The number of particles through each inlet, outlet, counter and open side since the start,
  /// then the number of particles that wait at each inlet.
  std::vector<std::int64_t> counts() const {
    std::vector<std::int64_t> all;
    for (const InletClock& inlet : inlets_)
      all.push_back(std::int64_t(inlet.state.through * inlet.plan().particles()));
    all.insert(all.end(), counts_.begin(), counts_.end());
    for (const InletClock& inlet : inlets_) all.push_back(std::int64_t(inlet.state.waiting));
    return all;
  }

  /// Call before the first step with the initial fluid.
  void begin(const Particles<D>& f) {
    next_id_ = std::uint64_t(f.n);
    for (int i = 0; i < f.n && !counters_.empty(); ++i) x_counted_[i] = f.x[i];
  }
  /// The first of n ids that no particle has had.
  std::uint64_t take_ids(std::uint64_t n) { return std::exchange(next_id_, next_id_ + n); }
  /// A particle at this place is new, and free.
  void enter(const Particles<D>& f, int i) {
    if (held_.data) held_[i] = 0;
    if (x_counted_.data) x_counted_[i] = f.x[i];
  }
  /// Advances to `time`, dt after the last call. pull(i) is the acceleration of a particle outside
  /// of the domain without forces of the fluid. Returns the index of the first new particle, which
  /// has its id, x, v and kind, and zeros; -1 if no particle was added or removed.
  template <class B, class Pull>
  int advance(B& backend, Particles<D>& f, Field<int>& kind, double time, double dt,
              const Pull& pull) {
    hold(backend, f, time);
    count(backend, f);
    find_gone(backend, f, pull);
    std::size_t births = 0;
    for (InletClock& inlet : inlets_) {
      inlet.advance(time, dt);
      births += inlet.fresh().size() * inlet.plan().particles();
    }
    if (gone_.empty() && births == 0) return -1;
    const int first = f.n - int(gone_.size());
    backend.edit("flows", f, gone_, int(births));
    int i = first;
    for (std::size_t k = 0; k < inlets_.size(); ++k) bring(k, f, kind, time, dt, i);
    return first;
  }

 private:
  static constexpr int inside = -1, perhaps = -2;  // marks: see mark_outside
  struct Target {
    Vec<D> x, v;
    bool through;
  };

  /// The position of a place of an opening, moved by `ahead` [m] along the direction.
  static Vec<D> moved(const InletPlan& plan, std::size_t place, double ahead) {
    Vec<D> x{};
    for (std::size_t k = 0; k < D; ++k)
      component(x, int(k)) = Real(plan.places[place * D + k] + ahead * plan.direction[k]);
    return x;
  }
  static Vec<D> velocity(const InletPlan& plan) {
    Vec<D> v{};
    for (std::size_t k = 0; k < D; ++k) component(v, int(k)) = Real(plan.speed * plan.direction[k]);
    return v;
  }

  /// Moves the particles that inlets hold, and frees those past the opening.
  template <class B> void hold(B& backend, const Particles<D>& f, double time) {
    if (inlets_.empty()) return;
    for (std::size_t k = 0; k < inlets_.size(); ++k) {
      const InletPlan& plan = inlets_[k].plan();
      Target* target = targets_.data() + first_target_[k];
      for (std::size_t slot = 0; slot < std::size_t(inlets_[k].slots()); ++slot) {
        const double ahead = inlets_[k].ahead(slot, time);
        for (std::size_t place = 0; place < plan.particles(); ++place)
          *target++ = {moved(plan, place, ahead), velocity(plan), ahead >= 0};
      }
    }
    const Target* targets = targets_.data();
    const auto held = held_;
    backend.for_each("flows", f, [=](int i) {
      if (held[i] == 0) return;
      const Target& target = targets[held[i] - 1];
      f.x[i] = target.x;
      f.v[i] = target.v;
      if (target.through) held[i] = 0;
    });
  }

  template <class B> void count(B& backend, const Particles<D>& f) {
    if (counters_.empty()) return;
    const auto before = x_counted_;
    const auto mark = mark_;
    const auto period = period_;
    for (std::size_t c = 0; c < counters_.size(); ++c) {
      const Opening<D> piece = counters_[c];
      backend.for_each("flows", f, [=](int i) {
        mark[i] = crossings(piece, to_double(before[i]), to_double(f.x[i]), period);
      });
      counts_[outlets_.size() + c] +=
          std::llround(backend.sum("flows", f, [=](int i) { return double(mark[i]); }));
    }
    backend.for_each("flows", f, [=](int i) { before[i] = f.x[i]; });
  }

  /// Finds the free particles that are inside an outlet or have left through an open side.
  template <class B, class Pull>
  void find_gone(B& backend, const Particles<D>& f, const Pull& pull) {
    gone_.clear();
    if (!remove_particles()) return;
    mark_outside(backend, f);
    for (int i = 0; i < f.n; ++i) {
      if (mark_[i] == inside) continue;
      const std::ptrdiff_t way =
          mark_[i] == perhaps ? way_out(to_double(f.x[i]), pull(i)) : mark_[i];
      if (way < 0) continue;
      gone_.push_back(i);
      ++counts_[std::size_t(way)];
      for (InletClock& inlet : inlets_) inlet.state.waiting += inlet.plan().outlet == way;
    }
  }
  /// Marks each particle by the index of its outlet, by `inside` or by `perhaps`.
  template <class B> void mark_outside(B& backend, const Particles<D>& f) {
    const auto *outlets = outlets_.data(), *last = outlets + outlets_.size();
    const auto mark = mark_;
    const auto held = held_;
    const OpenSides<D> open = open_;
    backend.for_each("flows", f, [=](int i) {
      mark[i] = inside;
      if (held.data && held[i] != 0) return;
      const auto x = to_double(f.x[i]);
      for (const auto* o = outlets; o != last && mark[i] == inside; ++o)
        if (o->distance(x) > 0) mark[i] = int(o - outlets);
      if (mark[i] == inside && open.may_have_left(x)) mark[i] = perhaps;
    });
  }
  /// The index in counts_ of the open side through which a particle has left; -1: none.
  std::ptrdiff_t way_out(Vec<D, double> x, Vec<D, double> a) const {
    const int side = open_.left_through(x, a);
    if (side < 0) return -1;
    const auto first = std::ptrdiff_t(outlets_.size() + counters_.size());
    return first + (std::find(open_list_.begin(), open_list_.end(), side) - open_list_.begin());
  }

  /// Writes the new layers of an inlet from particle i on.
  void bring(std::size_t k, const Particles<D>& f, Field<int> kind, double time, double dt,
             int& i) {
    const InletClock& inlet = inlets_[k];
    const InletPlan& plan = inlet.plan();
    for (const InletClock::Layer& layer : inlet.fresh()) {
      const double ahead = plan.speed * (time - layer.crossing);
      const double came = std::min(std::max(ahead - inlet.birth(), 0.0), plan.speed * dt);
      const int slot = int(layer.number % std::uint64_t(inlet.slots()));
      for (std::size_t place = 0; place < plan.particles(); ++place, ++i) {
        f.id[i] = next_id_++;
        f.x[i] = moved(plan, place, ahead);
        f.v[i] = velocity(plan);
        if (kind.data) kind[i] = plan.liquid;
        if (ahead < 0) held_[i] = 1 + first_target_[k] + slot * int(plan.particles()) + int(place);
        if (!counters_.empty()) x_counted_[i] = moved(plan, place, ahead - came);
      }
    }
  }

  std::vector<InletClock> inlets_;
  std::vector<Solid<D, double>> outlets_;
  std::vector<Opening<D>> counters_;
  OpenSides<D> open_{};
  std::vector<int> open_list_;  // the sides that are open
  Vec<D, double> period_{};
  std::vector<int> first_target_;  // by inlet
  std::vector<Target> targets_;    // of every place of every held layer
  std::vector<int> gone_;
  std::vector<std::int64_t> counts_;  // of the outlets, then the counters and the open sides
  std::uint64_t next_id_ = 0;
  Field<int> held_, mark_;
  Field<Vec<D>> x_counted_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
