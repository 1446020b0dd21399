// SPDX-License-Identifier: MIT
/// Puts a solver onto a backend. Included by the instantiation files only.
#pragma once
#include <algorithm>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "sim/body_force.h"
#include "sim/enclosure.h"
#include "sim/engine.h"
#include "sim/wall_forces.h"
#include "solvers/integrators.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D, class Solver, class Backend> class EngineOf final : public Engine {
 public:
  EngineOf(Backend backend, Solver solver, const EngineInput& input)
      : backend_(std::move(backend)), solver_(std::move(solver)), body_force_(input.scene) {
    reflectors_ = reflectors<D>(input.scene, reflector_walls_);
    backend_.add_set(fluid_, int(input.sample.x.size() / D),
                     copy_rules<D>(input.scene, copy_walls_));
    confine();
    fill_fluid(input.sample);
    fill_wall("akinci2012", walls_.akinci2012, input.sample.akinci2012, input.scene);
    fill_wall("adami2012", walls_.adami2012, input.sample.adami2012, input.scene);
    fill_wall("monaghan2009", walls_.monaghan2009, input.sample.monaghan2009, input.scene);
    wall_count_ = int(input.scene.wall_names().size());
    if (!copy_walls_.empty()) backend_.allocate(fluid_, Keep::scratch, copy_force_);
    solver_.prepare(backend_, walls_);
  }

  std::vector<Solve> step(double time, double dt) override {
    const Tick tick{Real(dt), steps_++};
    // Second-order integrators take half of a body force before and half after [Strang 1968].
    const double before = body_force_.halved() ? dt / 2 : dt;
    if constexpr (iterates) {
      backend_.save("save", fluid_);
      bounced_before_ = bounced_;
      body_force_.push(fluid_, time, before);
      const auto solves = solver_.step(backend_, fluid_, walls_, tick);
      return {solves.begin(), solves.end()};
    } else {
      body_force_.push(fluid_, time, before);
      solver_.step(backend_, fluid_, walls_, tick);
      if (body_force_.halved()) body_force_.push(fluid_, time + dt, dt / 2);
      return {};
    }
  }
  void undo() override {
    if constexpr (iterates) {
      backend_.restore("save", fluid_);
      std::copy(bounced_before_.begin(), bounced_before_.end(), bounced_.begin());
      --steps_;
    }
  }
  TimeStepBounds bounds(double time) override {
    TimeStepBounds b = solver_.bounds(backend_, fluid_);
    const double most = body_force_.greatest(fluid_, time);
    if (most > 0) b.force = std::min(b.force, 0.25 * std::sqrt(double(solver_.c.h) / most));
    return b;
  }

  ParticleView fluid() const override {
    const auto n = std::size_t(fluid_.n);
    return {D,
            {fluid_.id.data, n},
            {reinterpret_cast<const Real*>(fluid_.x.data), n * D},
            {reinterpret_cast<const Real*>(fluid_.v.data), n * D},
            {fluid_.rho.data, n},
            {fluid_.p.data, n}};
  }
  const std::vector<VerbTiming>& timings() const override { return backend_.timings(); }
  std::vector<StateArray> state() override { return state_; }
  void continue_from(std::int64_t steps) override { steps_ = steps; }

  std::vector<Vector> wall_forces(double interval) override {
    WallForces<D> forces(std::size_t(wall_count_), double(solver_.c.m));
    if constexpr (requires { solver_.akinci2012_forces(fluid_, walls_); }) {
      const Real h = solver_.c.support;
      forces.add(backend_, h, walls_.akinci2012, fluid_, solver_.akinci2012_forces(fluid_, walls_));
      if constexpr (iterates)
        forces.add(backend_, h, walls_.akinci2012, fluid_,
                   solver_.akinci2012_friction(fluid_, walls_));
      else
        forces.add(backend_, h, walls_.adami2012, fluid_, solver_.adami2012_forces(fluid_, walls_));
      forces.add(backend_, h, walls_.monaghan2009, fluid_,
                 solver_.monaghan2009_forces(fluid_, walls_));
    }
    if constexpr (iterates) backend_.share("wall forces", fluid_, fluid_.k, fluid_.rho, fluid_.v);
    forces.add_ghosts(backend_, fluid_, solver_.fluid_forces(fluid_), copy_walls_, copy_force_);
    if constexpr (iterates)
      forces.add_ghosts(backend_, fluid_, solver_.fluid_friction(fluid_), copy_walls_, copy_force_);
    forces.add_bounces(backend_, fluid_, solver_.c.confine, reflector_walls_, interval);
    std::fill(bounced_.begin(), bounced_.end(), Vec<D, double>{});
    return forces.list();
  }

 private:
  template <class T>
  void allocate(Particles<D>& set, const char* set_name, const char* name, Keep keep,
                Field<T>& field) {
    backend_.allocate(set, keep, field);
    using Role = StateArray::Role;
    const bool fluid = set.set == fluid_.set, kept = keep == Keep::kept;
    if (kept || (fluid && shown_between_steps(name)))
      remember(std::string(set_name) + "/" + name, field.data, set.n,
               !fluid ? Role::fixed
               : kept ? Role::kept
                      : Role::other);
  }
  /// Scratch that is looked at between two steps: by pictures, and by the bounds of the next step.
  static bool shown_between_steps(std::string_view name) {
    return name == "rho" || name == "p" || name == "a";
  }
  template <class T>
  void remember(std::string name, T* data, std::int64_t count, StateArray::Role role) {
    using Number = StateArray::Number;
    using Scalar = decltype(scalar_of(T{}));
    constexpr Number number = std::is_same_v<Scalar, float>    ? Number::float32
                              : std::is_same_v<Scalar, double> ? Number::float64
                              : sizeof(Scalar) == 4            ? Number::int32
                                                               : Number::uint64;
    state_.push_back({std::move(name), reinterpret_cast<std::byte*>(data), count,
                      int(sizeof(T) / sizeof(Scalar)), number, role});
  }
  template <class T> static T scalar_of(T);
  template <class R> static R scalar_of(Vec<D, R>);

  /// The memory of what keeps particles in place.
  void confine() {
    Confinement<D>& c = solver_.c.confine;
    c.shapes.data = reflectors_.data();
    c.shape_count = int(reflectors_.size());
    bounced_.resize(std::size_t(c.walls()) * std::size_t(fluid_.n));
    c.bounced.data = bounced_.empty() ? nullptr : bounced_.data();
    remember("fluid/bounced", bounced_.data(), std::int64_t(bounced_.size()),
             StateArray::Role::other);
  }

  void fill_fluid(const Sample& sample) {
    allocate(fluid_, "fluid", "id", Keep::kept, fluid_.id);
    allocate(fluid_, "fluid", "x", Keep::kept, fluid_.x);
    allocate(fluid_, "fluid", "v", Keep::kept, fluid_.v);
    solver_.fields(fluid_, [this](const char* name, Keep keep, auto& f) {
      this->allocate(fluid_, "fluid", name, keep, f);
    });
    for (int i = 0; i < fluid_.n; ++i) {
      fluid_.id[i] = std::uint64_t(i);
      fluid_.rho[i] = sample.density[std::size_t(i)];
    }
    if constexpr (iterates)
      for (std::size_t i = 0; i < sample.pressure.size(); ++i)
        fluid_.k[int(i)] = sample.pressure[i] / square(sample.density[i]);
    std::memcpy(static_cast<void*>(fluid_.x.data), sample.x.data(), sample.x.size() * sizeof(Real));
    std::memcpy(static_cast<void*>(fluid_.v.data), sample.v.data(), sample.v.size() * sizeof(Real));
  }

  template <class Wall>
  void fill_wall(const char* name, Wall& wall, const WallSample& sample, const Scene& scene) {
    backend_.add_set(wall, int(sample.wall.size()));
    allocate(wall, name, "id", Keep::kept, wall.id);
    allocate(wall, name, "x", Keep::kept, wall.x);
    allocate(wall, name, "v", Keep::scratch, wall.v);
    wall.fields(
        [&](const char* field, Keep keep, auto& f) { this->allocate(wall, name, field, keep, f); });
    for (int k = 0; k < wall.n; ++k) {
      const int number = sample.wall[std::size_t(k)];
      wall.id[k] = std::uint64_t(k);
      wall.wall[k] = number;
      const Slip slip =
          number < 2 * D ? scene.walls.slip : scene.wall[std::size_t(number - 2 * D)].slip;
      wall.friction[k] = slip == Slip::no_slip;
    }
    if (wall.n)
      std::memcpy(static_cast<void*>(wall.x.data), sample.x.data(), sample.x.size() * sizeof(Real));
  }

  static constexpr bool iterates = !std::is_void_v<decltype(std::declval<Solver>().step(
      std::declval<Backend&>(), std::declval<typename Solver::Fluid&>(), std::declval<Walls<D>&>(),
      Tick{}))>;

  Backend backend_;
  Solver solver_;
  BodyForce<D> body_force_;
  typename Solver::Fluid fluid_;
  Walls<D> walls_;
  std::vector<Reflector<D>> reflectors_;
  std::vector<Vec<D, double>> bounced_, bounced_before_;
  std::vector<int> reflector_walls_, copy_walls_;  // places of their names
  Field<Vec<D>> copy_force_;
  int wall_count_ = 0;
  std::vector<StateArray> state_;
  std::int64_t steps_ = 0;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
