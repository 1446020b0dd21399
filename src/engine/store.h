// SPDX-License-Identifier: MIT
/// The memory of a simulation on a backend: the fluid, walls and body particles, and the arrays
/// that a checkpoint holds. Compiled once per backend and dimension.
#pragma once
#include <algorithm>
#include <cstring>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/flows.h"
#include "engine/state_arrays.h"
#include "solvers/non_pressure_forces.h"
#include "solvers/wall_samples.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Resizes a set to n particles: removes the last ones, or appends new ones, zeroed.
template <int D, class B>
void resize_set(B& backend, const char* name, Particles<D>& set, std::int64_t n) {
  std::vector<int> gone(std::size_t(std::max<std::int64_t>(0, set.n - n)));
  std::iota(gone.begin(), gone.end(), int(n));
  backend.edit(name, set, gone, int(std::max<std::int64_t>(0, n - set.n)));
}

template <int D, class B> class Store final : public FieldMaker<D> {
 public:
  /// Adds the fluid as a set; make_fluid() and make() add its fields.
  Store(B b, const EnginePlan& p, FluidParticles<D>& fluid)
      : backend(std::move(b)), fluid_(fluid), liquids_(liquids_of(p)) {
    backend.add_set(fluid_, int(p.sample.x.size() / D), copy_rules(p));
  }

  B backend;
  Walls<D> walls;
  StateArrays<D> state;

  // Fields of the fluid
  void make(const char* name, Keep keep, Field<Real>& f) override {
    allocate(fluid_, "fluid", name, keep, f);
  }
  void make(const char* name, Keep keep, Field<Vec<D>>& f) override {
    allocate(fluid_, "fluid", name, keep, f);
  }
  void make(const char* name, Keep keep, Field<int>& f) override {
    allocate(fluid_, "fluid", name, keep, f);
  }
  /// Allocates the fields that every fluid has.
  void make_fluid(const EnginePlan& p) {
    allocate(fluid_, "fluid", "id", Keep::kept, fluid_.id);
    allocate(fluid_, "fluid", "x", Keep::kept, fluid_.x);
    allocate(fluid_, "fluid", "v", Keep::kept, fluid_.v);
    if (p.liquids.size() > 1) make("kind", Keep::kept, fluid_.kind);
    if (p.skin > 0) make("x_listed", Keep::kept, fluid_.x_listed);
    fluid_.skin = Real(p.skin);
  }
  /// Writes the initial state of the fluid.
  void fill_fluid(const Sample& sample, Field<Real>* start_pressure) {
    if (fluid_.kind.data) std::copy(sample.liquid.begin(), sample.liquid.end(), fluid_.kind.data);
    for (int i = 0; i < fluid_.n; ++i) {
      fluid_.id[i] = std::uint64_t(i);
      fluid_.rho[i] = sample.density[std::size_t(i)] * liquids_.lightness(fluid_, i);
    }
    if (start_pressure)
      for (std::size_t i = 0; i < sample.pressure.size(); ++i)
        (*start_pressure)[int(i)] = sample.pressure[i] / square(fluid_.rho[int(i)]);
    copy_numbers(fluid_.x, sample.x);
    copy_numbers(fluid_.v, sample.v);
  }
  /// Creates the boundary particles of all walls, with room for body particles and their images.
  void fill_walls(const EnginePlan& p) {
    int images = 1;
    for (int k = 0; k < D; ++k) images *= p.periodic[std::size_t(k)] ? 2 : 1;
    const std::size_t carried = p.sample.bodies.body.size() * std::size_t(images);
    const std::size_t single = p.layered_bodies ? 0 : carried;
    fill_wall("akinci2012", walls.akinci2012, p.sample.akinci2012, p, single);
    fill_wall("adami2012", walls.adami2012, p.sample.adami2012, p, carried - single);
    fill_wall("monaghan2009", walls.monaghan2009, p.sample.monaghan2009, p, 0);
    AkinciWall<D>& wall = walls.akinci2012;
    std::copy(p.sample.akinci2012.volume_factor.begin(), p.sample.akinci2012.volume_factor.end(),
              wall.psi.data);
    const int all = std::exchange(wall.n, int(p.sample.akinci2012.wall.size()));
    prepare_walls(backend, walls, kernel_of<D>(p), Real(p.support),
                  Real(p.rest_density));  // without body particles
    wall.n = all;
  }

  /// `role`: of the kept fields of a set other than the fluid.
  template <class T>
  void allocate(Particles<D>& set, const char* set_name, const char* name, Keep keep,
                Field<T>& field, StateArray::Role role = StateArray::Role::fixed) {
    using Role = StateArray::Role;
    const bool fluid = set.set == fluid_.set, kept = keep == Keep::kept;
    const bool shown = fluid && shown_between_steps(name);
    backend.allocate(set, keep, field);
    if (set.moves && field.data == static_cast<void*>(set.x.data)) return;  // as bodies have it
    if (kept || shown)
      state.add(
          std::string(set_name) + "/" + name, [&field] { return field.data; },
          [&set] { return std::int64_t(set.n); },
          !fluid ? role
          : kept ? Role::kept
                 : Role::other);
  }

 private:
  /// Scratch that is read between two steps: by pictures, and by the bounds of the next step.
  static bool shown_between_steps(std::string_view name) {
    return name == "rho" || name == "p" || name == "a";
  }
  static void copy_numbers(Field<Vec<D>> to, const std::vector<Real>& from) {
    if (!from.empty())
      std::memcpy(static_cast<void*>(to.data), from.data(), from.size() * sizeof(Real));
  }
  static std::vector<CopyRule<D>> copy_rules(const EnginePlan& p) {
    std::vector<CopyRule<D>> rules;
    for (const CopyRulePlan& r : p.copies)
      rules.push_back({vec_of<D, Real>(r.point), vec_of<D, Real>(r.normal),
                       vec_of<D, Real>(r.shift), r.mirror, r.no_slip, r.axis});
    return rules;
  }

  template <class Wall>
  void fill_wall(const char* name, Wall& wall, const WallSample& sample, const EnginePlan& p,
                 std::size_t moving) {
    wall.moves = moving > 0;
    wall.skin = Real(p.skin);
    backend.add_set(wall, int(sample.wall.size() + moving));
    allocate(wall, name, "id", Keep::kept, wall.id);
    allocate(wall, name, "x", Keep::kept, wall.x);
    allocate(wall, name, "v", Keep::scratch, wall.v);
    wall.fields(
        [&](const char* field, Keep keep, auto& f) { this->allocate(wall, name, field, keep, f); });
    for (int k = 0; k < wall.n; ++k) wall.id[k] = std::uint64_t(k);
    for (int k = int(sample.wall.size()); k < wall.n; ++k) wall.wall[k] = -1;
    for (int k = 0; k < int(sample.wall.size()); ++k) {
      const int reported = sample.wall[std::size_t(k)],
                number = reported < 0 ? -1 - reported : reported;
      const EnginePlan::Wall& plan = p.walls[std::size_t(number)];
      wall.wall[k] = std::max(reported, -1);
      wall.friction[k] = plan.no_slip;
      if constexpr (requires { wall.slide; }) wall.slide[k] = vec_of<D, Real>(plan.slide);
    }
    copy_numbers(wall.x, sample.x);
  }

  FluidParticles<D>& fluid_;
  Liquids liquids_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
