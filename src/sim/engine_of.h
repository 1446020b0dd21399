// SPDX-License-Identifier: MIT
/// Puts a solver onto a backend. Included by the instantiation files only.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <memory>
#include <numeric>
#include <optional>
#include <string_view>
#include <type_traits>

#include "sim/body_force.h"
#include "sim/carried_bodies.h"
#include "sim/enclosure.h"
#include "sim/engine.h"
#include "sim/engines/make_forces.h"
#include "sim/flows.h"
#include "sim/state_arrays.h"
#include "sim/wall_forces.h"
#include "solvers/integrators.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D, class Solver, class Backend> class EngineOf final : public Engine {
 public:
  EngineOf(Backend backend, Solver solver, const EngineInput& input)
      : backend_(std::move(backend)),
        solver_(std::move(solver)),
        body_force_(input.scene),
        flows_(input.scene) {
    if constexpr (requires { solver_.forces; }) {
      forces_ = make_forces<D, Backend>(input);
      solver_.forces = forces_.get();
    }
    reflectors_ = reflectors<D>(input.scene, reflector_walls_);
    backend_.add_set(fluid_, int(input.sample.x.size() / D),
                     copy_rules<D>(input.scene, copy_walls_));
    confine();
    fill_fluid(input);
    const std::size_t carried = input.sample.bodies.body.size()
                                << std::popcount(unsigned(input.scene.domain.periodic));
    const bool layered = body_method(input.scene) == WallMethod::adami2012;
    fill_wall("akinci2012", walls_.akinci2012, input.sample.akinci2012, input.scene,
              layered ? 0 : carried);
    fill_wall("adami2012", walls_.adami2012, input.sample.adami2012, input.scene,
              layered ? carried : 0);
    fill_wall("monaghan2009", walls_.monaghan2009, input.sample.monaghan2009, input.scene);
    wall_count_ = int(input.scene.wall_names().size());
    if (!copy_walls_.empty()) backend_.allocate(fluid_, Keep::scratch, copy_force_);
    prepare_walls(input);
    flows_.begin(fluid_);
    if (flows_.any()) flow(0, 0);
  }

  std::vector<Solve> step(double time, double dt) override {
    const Tick tick{Real(dt), steps_++};
    // Second-order integrators take half of a body force before and half after [Strang 1968].
    const double before = body_force_.halved() ? dt / 2 : dt;
    if (bodies_) bodies_->begin(walls_, time, dt);
    if constexpr (iterates) {
      backend_.save("save", fluid_);
      bounced_before_ = bounced_;
      body_force_.push(fluid_, time, before);
      if (bodies_) bodies_->bodies().save();
      const auto solves = solver_.step(backend_, fluid_, walls_, tick);
      if (forces_) forces_->shift(backend_, fluid_, tick.dt);
      if (bodies_) bodies_->end(time, dt, true);
      return with_forces(solves);
    } else {
      body_force_.push(fluid_, time, before);
      solver_.step(backend_, fluid_, walls_, tick);
      if (body_force_.halved()) body_force_.push(fluid_, time + dt, dt / 2);
      if (forces_) forces_->shift(backend_, fluid_, tick.dt);
      if (bodies_) bodies_->end(time, dt, false);
      return with_forces(std::array<Solve, 0>{});
    }
  }
  void flow(double time, double dt) override {
    if (!flows_.any()) return;
    const int first = flows_.advance(backend_, fluid_, fluid_.kind, time, dt);
    if (first < 0) return;
    changed();
    for (int i = first; i < fluid_.n; ++i) fluid_.rho[i] = solver_.c.rho0;
  }
  std::vector<std::int64_t> flow_counts() const override { return flows_.counts(); }
  void resize(std::int64_t n) override {
    const int before = fluid_.n;
    std::vector<int> gone(std::size_t(std::max<std::int64_t>(0, before - n)));
    std::iota(gone.begin(), gone.end(), int(n));
    backend_.edit("flows", fluid_, gone, int(std::max<std::int64_t>(0, n - before)));
    changed();
  }
  void undo() override {
    if constexpr (iterates) {
      backend_.restore("save", fluid_);
      if (bodies_) bodies_->bodies().restore();
      std::copy(bounced_before_.begin(), bounced_before_.end(), bounced_.begin());
      --steps_;
    }
  }
  TimeStepBounds bounds(double time) override {
    TimeStepBounds b = solver_.bounds(backend_, fluid_);
    if (forces_) forces_->bound(b);
    const double most = body_force_.greatest(fluid_, time);
    if (most > 0) b.force = std::min(b.force, 0.25 * std::sqrt(double(solver_.c.h) / most));
    const double fastest = bodies_ ? bodies_->bodies().fastest(time) : 0;
    if (fastest > 0) b.flow = std::min(b.flow, 0.4 * double(solver_.c.h) / fastest);
    return b;
  }

  ParticleView fluid() const override {
    const auto n = std::size_t(fluid_.n);
    ParticleView view{D,
                      {fluid_.id.data, n},
                      {reinterpret_cast<const Real*>(fluid_.x.data), n * D},
                      {reinterpret_cast<const Real*>(fluid_.v.data), n * D},
                      {fluid_.rho.data, n},
                      {fluid_.p.data, n},
                      {}};
    if (!fluid_.kind.data) return view;
    density_.resize(n);
    for (int i = 0; i < fluid_.n; ++i)
      density_[std::size_t(i)] = fluid_.rho[i] / solver_.c.liquids.lightness(fluid_, i);
    view.density = density_;
    view.liquid = {fluid_.kind.data, n};
    return view;
  }
  std::vector<BodyState> bodies() const override {
    return bodies_ ? bodies_->bodies().states() : std::vector<BodyState>();
  }
  const std::vector<VerbTiming>& timings() const override { return backend_.timings(); }
  std::vector<StateArray> state() override { return state_.arrays(); }
  void continue_from(std::int64_t steps) override { steps_ = steps; }

  std::vector<Vector> wall_forces(double interval) override {
    WallForces<D> forces(std::size_t(wall_count_), double(solver_.c.m));
    add_wall_forces(forces, copy_walls_);
    forces.add_bounces(backend_, fluid_, solver_.c.liquids, solver_.c.confine, reflector_walls_,
                       interval);
    std::fill(bounced_.begin(), bounced_.end(), Vec<D, double>{});
    return forces.list();
  }
  std::vector<Vector> tractions(const std::vector<WallPatch>& patches, double cell) override {
    std::vector<PatchOnWall<D>> all;
    for (const WallPatch& patch : patches) all.emplace_back(patch, cell, double(support()));
    WallForces<D> forces(std::move(all), double(solver_.c.m));
    add_wall_forces(forces, {});
    return forces.tractions();
  }

 private:
  /// Allots what the forces beside pressure need.
  struct FluidFields final : FieldMaker<D> {
    explicit FluidFields(EngineOf& engine) : engine(engine) {}
    void make(const char* name, Keep keep, Field<Real>& field) override {
      engine.allocate(engine.fluid_, "fluid", name, keep, field);
    }
    void make(const char* name, Keep keep, Field<Vec<D>>& field) override {
      engine.allocate(engine.fluid_, "fluid", name, keep, field);
    }
    EngineOf& engine;
  };
  /// All but bounces; on mirror images of these walls.
  void add_wall_forces(WallForces<D>& forces, const std::vector<int>& copy_walls) {
    if (std::exchange(searched_for_others_, false)) {
      backend_.find_neighbors("wall forces", support(), fluid_);
      backend_.share("wall forces", fluid_, fluid_.rho, fluid_.p);
    }
    if constexpr (requires { solver_.akinci2012_forces(fluid_, walls_.akinci2012); }) {
      const Real h = solver_.c.support;
      auto akinci2012 = walls_.akinci2012;
      auto adami2012 = walls_.adami2012;
      akinci2012.moves = adami2012.moves = false;  // as they were found
      forces.add(backend_, h, akinci2012, fluid_, solver_.akinci2012_forces(fluid_, akinci2012));
      if constexpr (iterates)
        forces.add(backend_, h, akinci2012, fluid_,
                   solver_.akinci2012_friction(fluid_, akinci2012));
      else forces.add(backend_, h, adami2012, fluid_, solver_.adami2012_forces(fluid_, adami2012));
      forces.add(backend_, h, walls_.monaghan2009, fluid_,
                 solver_.monaghan2009_forces(fluid_, walls_));
    }
    if constexpr (iterates) backend_.share("wall forces", fluid_, fluid_.k, fluid_.rho, fluid_.v);
    forces.add_ghosts(backend_, fluid_, solver_.fluid_forces(fluid_), copy_walls, copy_force_);
    if constexpr (iterates)
      forces.add_ghosts(backend_, fluid_, solver_.fluid_friction(fluid_), copy_walls, copy_force_);
    if (forces_)
      forces_->add_wall_forces(backend_, fluid_, walls_, copy_walls, copy_force_, forces);
  }
  /// The solver's solves and that of the forces, if they solve for anything. (A vector that grows
  /// would be a function that the instruction sets share.)
  template <std::size_t n>
  std::vector<Solve> with_forces(const std::array<Solve, n>& solves) const {
    std::array<Solve, n + 1> all{};
    std::copy(solves.begin(), solves.end(), all.begin());
    const auto forced = forces_ ? forces_->solve() : std::nullopt;
    if (forced) all[n] = *forced;
    return {all.begin(), all.begin() + n + (forced ? 1 : 0)};
  }

  template <class T>
  void allocate(Particles<D>& set, const char* set_name, const char* name, Keep keep,
                Field<T>& field) {
    using Role = StateArray::Role;
    const bool fluid = set.set == fluid_.set, kept = keep == Keep::kept;
    const bool shown = fluid && shown_between_steps(name);
    // Where particles come and go, forces on walls may need a search between steps, which sorts.
    backend_.allocate(set, shown && flows_.change_particles() ? Keep::kept : keep, field);
    if (set.moves && field.data == static_cast<void*>(set.x.data)) return;  // as bodies have it
    if (kept || shown)
      state_.add(
          std::string(set_name) + "/" + name, [&field] { return field.data; },
          [&set] { return std::int64_t(set.n); },
          !fluid ? Role::fixed
          : kept ? Role::kept
                 : Role::other);
  }
  /// Scratch that is looked at between two steps: by pictures, and by the bounds of the next step.
  static bool shown_between_steps(std::string_view name) {
    return name == "rho" || name == "p" || name == "a";
  }
  /// The memory of what keeps particles in place.
  void confine() {
    Confinement<D>& c = solver_.c.confine;
    c.shapes.data = reflectors_.data();
    c.shape_count = int(reflectors_.size());
    state_.add(
        "fluid/bounced", [this] { return bounced_.data(); },
        [this] { return std::int64_t(bounced_.size()); }, StateArray::Role::other);
    make_room_for_bounces();
  }
  /// Whose bounce it was does not matter: where the particles are fewer now, the first has those of
  /// the places that are no more.
  void make_room_for_bounces() {
    const auto walls = std::size_t(solver_.c.confine.walls());
    const auto n = std::size_t(flows_.change_particles() ? std::max(fluid_.n, 1) : fluid_.n);
    for (std::size_t k = walls * n; k < bounced_.size(); ++k) bounced_[k % walls] += bounced_[k];
    bounced_.resize(walls * n);
    solver_.c.confine.bounced.data = bounced_.empty() ? nullptr : bounced_.data();
  }
  /// After particles came or went.
  void changed() {
    make_room_for_bounces();
    searched_for_others_ = true;
  }
  Real support() const {
    if constexpr (requires { solver_.c.support; }) return solver_.c.support;
    else return solver_.c.h;
  }

  void fill_fluid(const EngineInput& input) {
    const Sample& sample = input.sample;
    allocate(fluid_, "fluid", "id", Keep::kept, fluid_.id);
    allocate(fluid_, "fluid", "x", Keep::kept, fluid_.x);
    allocate(fluid_, "fluid", "v", Keep::kept, fluid_.v);
    solver_.fields(fluid_, [this](const char* name, Keep keep, auto& f) {
      this->allocate(fluid_, "fluid", name, keep, f);
    });
    if (input.scene.liquids().size() > 1) {
      allocate(fluid_, "fluid", "kind", Keep::kept, fluid_.kind);
      std::copy(sample.liquid.begin(), sample.liquid.end(), fluid_.kind.data);
    }
    if (forces_) {
      FluidFields maker(*this);
      forces_->fields(maker);
    }
    flows_.fields([this](const char* name, Keep keep, auto& f) {
      this->allocate(fluid_, "fluid", name, keep, f);
    });
    flows_.numbers([this](const std::string& name, auto* data, std::size_t count) {
      using Number =
          std::conditional_t<std::is_same_v<decltype(data), double*>, double, std::uint64_t>;
      this->state_.add(
          name, [=] { return reinterpret_cast<Number*>(data); },
          [=] { return std::int64_t(count); }, StateArray::Role::other);
    });
    if (fluid_.n == 0) return;
    for (int i = 0; i < fluid_.n; ++i) {
      fluid_.id[i] = std::uint64_t(i);
      fluid_.rho[i] = sample.density[std::size_t(i)] * solver_.c.liquids.lightness(fluid_, i);
    }
    if constexpr (iterates)
      for (std::size_t i = 0; i < sample.pressure.size(); ++i)
        fluid_.k[int(i)] = sample.pressure[i] / square(fluid_.rho[int(i)]);
    std::memcpy(static_cast<void*>(fluid_.x.data), sample.x.data(), sample.x.size() * sizeof(Real));
    std::memcpy(static_cast<void*>(fluid_.v.data), sample.v.data(), sample.v.size() * sizeof(Real));
  }

  static Vec<D> slide(const Scene::Wall& wall) {
    return wall.velocity.empty() ? Vec<D>{} : vec_of<D, Real>(wall.velocity);
  }
  template <class Wall>
  void fill_wall(const char* name, Wall& wall, const WallSample& sample, const Scene& scene,
                 std::size_t moving = 0) {
    wall.moves = moving > 0;
    backend_.add_set(wall, int(sample.wall.size() + moving));
    allocate(wall, name, "id", Keep::kept, wall.id);
    allocate(wall, name, "x", Keep::kept, wall.x);
    allocate(wall, name, "v", Keep::scratch, wall.v);
    wall.fields(
        [&](const char* field, Keep keep, auto& f) { this->allocate(wall, name, field, keep, f); });
    for (int k = int(sample.wall.size()); k < wall.n; ++k) {
      wall.id[k] = std::uint64_t(k);
      wall.wall[k] = -1;
    }
    for (int k = 0; k < int(sample.wall.size()); ++k) {
      const int told = sample.wall[std::size_t(k)], number = told < 0 ? -1 - told : told;
      wall.id[k] = std::uint64_t(k);
      wall.wall[k] = std::max(told, -1);
      const Slip slip =
          number < 2 * D ? scene.walls.slip : scene.wall[std::size_t(number - 2 * D)].slip;
      wall.friction[k] = slip == Slip::no_slip;
      if constexpr (requires { wall.slide; })
        wall.slide[k] = number < 2 * D ? Vec<D>{} : slide(scene.wall[std::size_t(number - 2 * D)]);
    }
    if (!sample.wall.empty())
      std::memcpy(static_cast<void*>(wall.x.data), sample.x.data(), sample.x.size() * sizeof(Real));
  }

  /// Walls first, as if they were alone; then the samples of bodies, behind them in their set and
  /// in one of their own.
  void prepare_walls(const EngineInput& in) {
    auto& wall = walls_.akinci2012;
    const int all = std::exchange(wall.n, int(in.sample.akinci2012.wall.size()));
    solver_.prepare(backend_, walls_);
    wall.n = all;
    if (in.sample.bodies.body.empty()) return;
    if constexpr (requires { solver_.akinci2012_forces(fluid_, wall); }) {
      bodies_ = std::make_unique<CarriedBodies<D>>(in, walls_, moment_of_forces(in.scene));
      if (body_method(in.scene) == WallMethod::adami2012) {
        fill_bodies("of_layered_bodies", walls_.of_layered_bodies, walls_.adami2012, in.scene);
      } else {
        fill_bodies("of_bodies", walls_.of_bodies, wall, in.scene);
        fill_psi(bodies_->psi(solver_.W, solver_.c.support, solver_.c.rho0));
      }
      remember_bodies();
    }
  }
  static ForceMoment moment_of_forces(const Scene& s) {
    if (s.solver.incompressible()) return {s.solver.name == SolverName::pbf ? 1.0 : 0.0, false};
    const Integrator integrator = s.integrator();
    const bool leapfrog = integrator == Integrator::leapfrog;
    return {leapfrog ? 1 : integrator == Integrator::verlet ? 0.5 : 0, leapfrog};
  }
  /// The samples of bodies in a set of their own, `of_bodies`, and at the end of that of walls.
  template <class Wall>
  void fill_bodies(const char* name, Wall& of_bodies, const Wall& wall, const Scene& scene) {
    const int n = bodies_->samples(), first = wall.n - n * bodies_->places();
    of_bodies.moves = true;
    backend_.add_set(of_bodies, n);
    allocate(of_bodies, name, "id", Keep::kept, of_bodies.id);
    allocate(of_bodies, name, "x", Keep::kept, of_bodies.x);
    allocate(of_bodies, name, "v", Keep::scratch, of_bodies.v);
    of_bodies.fields([&](const char* field, Keep keep, auto& f) {
      this->allocate(of_bodies, name, field, keep, f);
    });
    for (int k = 0; k < n; ++k) {
      const auto& body = scene.body[std::size_t(bodies_->body_of(k))];
      of_bodies.id[k] = std::uint64_t(k);
      of_bodies.friction[k] = body.slip == Slip::no_slip;
      for (int image = 0; image < bodies_->places(); ++image)
        wall.friction[first + image * n + k] = of_bodies.friction[k];
    }
  }
  void fill_psi(const std::vector<Real>& psi) {
    const auto &of_bodies = walls_.of_bodies, &wall = walls_.akinci2012;
    for (int k = 0, first = wall.n - of_bodies.n * bodies_->places(); first + k < wall.n; ++k)
      wall.psi[first + k] = of_bodies.psi[k % of_bodies.n] = psi[std::size_t(k % of_bodies.n)];
  }
  void remember_bodies() {
    backend_.allocate(fluid_, Keep::scratch, walls_.rate);
    auto& states = bodies_->bodies().states();
    static_assert(sizeof(BodyState) == 19 * sizeof(double));
    state_.add_numbers("bodies/state", states);
    auto& forces = bodies_->bodies().last_forces();
    state_.add_numbers("bodies/forces", forces);
  }

  static constexpr bool iterates = !std::is_void_v<decltype(std::declval<Solver>().step(
      std::declval<Backend&>(), std::declval<typename Solver::Fluid&>(), std::declval<Walls<D>&>(),
      Tick{}))>;

  Backend backend_;
  Solver solver_;
  BodyForce<D> body_force_;
  Flows<D> flows_;
  std::unique_ptr<NonPressureForces<D, Backend>> forces_;  // null where there are none
  typename Solver::Fluid fluid_;
  Walls<D> walls_;
  std::unique_ptr<CarriedBodies<D>> bodies_;  // none of a scene without
  std::vector<Reflector<D>> reflectors_;
  std::vector<Vec<D, double>> bounced_, bounced_before_;
  std::vector<int> reflector_walls_, copy_walls_;  // places of their names
  Field<Vec<D>> copy_force_;
  int wall_count_ = 0;
  StateArrays<D> state_;
  mutable std::vector<Real> density_;  // of several liquids
  bool searched_for_others_ = false;   // particles came or went since the last search
  std::int64_t steps_ = 0;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
