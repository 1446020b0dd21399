// SPDX-License-Identifier: MIT
/// A solver on a backend. Compiled once per backend and dimension.
#pragma once
#include <algorithm>
#include <memory>
#include <optional>

#include "engine/body_force.h"
#include "engine/carried_bodies.h"
#include "engine/engine.h"
#include "engine/engine_backend.h"
#include "engine/search_between_steps.h"
#include "engine/stepper.h"
#include "engine/store.h"
#include "engine/wall_forces_impl.h"
#include "engine/whitewater.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D, EngineBackend<D> B> class EngineOf final : public Engine {
 public:
  EngineOf(B backend, std::unique_ptr<Stepper<D, B>> stepper, const EnginePlan& p)
      : stepper_(std::move(stepper)),
        forces_(make_forces<D, B>(p)),
        whitewater_(make_whitewater<D, B>(p)),
        fluid_(stepper_->fluid()),
        store_(std::move(backend), p, fluid_),
        walls_(store_.walls),
        body_force_(p),
        flows_(p),
        liquids_(liquids_of(p)),
        origin_(p.origin),
        gravity_(vec_of<D>(p.gravity)),
        iterates_(p.incompressible),
        h_(Real(p.h)),
        support_(Real(p.support)),
        rho0_(Real(p.rest_density)),
        m_(Real(p.mass)),
        kernel_(kernel_of<D>(p)),
        of_walls_(parameters_of(p, WeaklyCompressibleParameters<D>{})),
        wall_count_(p.walls.size()) {
    stepper_->set_forces(forces_.get());
    confine(p);
    make_fields(p);
    store_.fill_fluid(p.sample, stepper_->start_pressure());
    store_.fill_walls(p);
    for (const CopyRulePlan& rule : p.copies) ghosts_.wall_of_rule.push_back(rule.wall);
    if (!p.copies.empty()) store_.backend.allocate(fluid_, Keep::scratch, ghosts_.acceleration);
    if (!p.sample.bodies.body.empty()) make_bodies(p);
    flows_.begin(fluid_);
    if (flows_.any()) flow(0, 0);
  }

  Solves step(double time, double dt) override {
    const Tick tick{Real(dt), steps_++};
    lists_are_stale_ = false;  // the step searches
    // Second-order integrators take half of a body force before and half after [Strang 1968].
    const double before = body_force_.halved() ? dt / 2 : dt;
    if (bodies_) bodies_->begin(walls_, time, dt);
    if (iterates_) {
      store_.backend.save("save", fluid_);
      bounced_before_ = bounced_;
      if (bodies_) bodies_->bodies().save();
    }
    body_force_.push(fluid_, time, before);
    Solves solves = stepper_->step(store_.backend, walls_, tick);
    if (body_force_.halved()) body_force_.push(fluid_, time + dt, dt / 2);
    if (forces_) forces_->shift(store_.backend, fluid_, tick.dt);
    if (bodies_) bodies_->end(time, dt, iterates_);
    if (const auto solved = forces_ ? forces_->solve() : std::nullopt) solves.add(*solved);
    return solves;
  }
  void flow(double time, double dt) override {
    if (whitewater_ && dt > 0)
      whitewater_->step(store_.backend, fluid_, walls_, stepper_->confinement(), gravity_, dt);
    if (!flows_.any()) return;
    const auto pull = [&](int i) { return gravity_ + body_force_.at(fluid_, i, time); };
    const int first = flows_.advance(store_.backend, fluid_, fluid_.kind, time, dt, pull);
    if (first >= 0) fill_new(first);
  }
  std::vector<std::int64_t> flow_counts() const override { return flows_.counts(); }
  void resize(std::int64_t n) override {
    resize_set(store_.backend, "flows", fluid_, n);
    changed();
  }
  void resize_whitewater(std::int64_t n) override {
    if (whitewater_) whitewater_->resize(store_.backend, n);
  }
  void undo() override {
    store_.backend.restore("save", fluid_);
    if (bodies_) bodies_->bodies().restore();
    std::copy(bounced_before_.begin(), bounced_before_.end(), bounced_.begin());
    --steps_;
  }
  TimeStepBounds bounds(double time) override {
    TimeStepBounds b = stepper_->bounds(store_.backend);
    if (forces_) forces_->bound(b);
    const double most = body_force_.greatest(fluid_, time);
    if (most > 0) b.force = std::min(b.force, 0.25 * std::sqrt(double(h_) / most));
    const double fastest = bodies_ ? bodies_->bodies().fastest(time) : 0;
    if (fastest > 0) b.flow = std::min(b.flow, 0.4 * double(h_) / fastest);
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
    view.origin = origin_;
    if (is_far()) view.offset = view.x;
    if (!fluid_.kind.data) return view;
    density_.resize(n);
    for (int i = 0; i < fluid_.n; ++i)
      density_[std::size_t(i)] = fluid_.rho[i] / liquids_.lightness(fluid_, i);
    view.density = density_;
    view.liquid = {fluid_.kind.data, n};
    return view;
  }
  std::span<Real> positions() override {
    return {reinterpret_cast<Real*>(fluid_.x.data), std::size_t(fluid_.n) * D};
  }
  std::span<Real> velocities() override {
    return {reinterpret_cast<Real*>(fluid_.v.data), std::size_t(fluid_.n) * D};
  }
  std::span<int> kinds() override {
    return {fluid_.kind.data, fluid_.kind.data ? std::size_t(fluid_.n) : 0};
  }
  std::shared_ptr<const void> keep(const void* array) override {
    return store_.backend.keep(fluid_, array);
  }
  std::uint64_t add(std::span<const Real> x, std::span<const Real> v, int kind) override {
    const int n = int(x.size() / D), first = fluid_.n;
    store_.backend.edit("edit", fluid_, {}, n);
    const std::uint64_t id = flows_.take_ids(std::uint64_t(n));
    for (int i = first; i < fluid_.n; ++i) {
      fluid_.id[i] = id + std::uint64_t(i - first);
      const auto at = std::size_t(i - first) * D;
      for (std::size_t k = 0; k < D; ++k)
        component(fluid_.x[i], int(k)) = Real(double(x[at + k]) - origin_[k]);
      if (!v.empty()) std::copy_n(v.data() + at, D, velocities().data() + std::size_t(i) * D);
      if (fluid_.kind.data) fluid_.kind[i] = kind;
      flows_.enter(fluid_, i);
    }
    fill_new(first);
    return id;
  }
  void remove(std::span<const int> places) override {
    store_.backend.edit("edit", fluid_, places, 0);
    changed();
  }
  void set_gravity(const Triple& gravity) override {
    stepper_->set_gravity(vec_of<D, Real>(gravity));
    gravity_ = vec_of<D>(gravity);
  }
  void set_force(AddForce force) override { body_force_.set_custom(std::move(force)); }
  WhitewaterView whitewater() const override {
    return whitewater_ ? whitewater_->view(origin_) : WhitewaterView{};
  }
  std::vector<BodyState> bodies() const override {
    return bodies_ ? bodies_->bodies().states() : std::vector<BodyState>();
  }
  const std::vector<VerbTiming>& timings() const override { return store_.backend.timings(); }
  std::vector<StateArray> state() override { return store_.state.arrays(); }
  void continue_from(std::int64_t steps) override {
    steps_ = steps;
    store_.backend.edit("edit", fluid_, {}, 0);  // the lists are those of another state
    lists_are_stale_ = true;
  }

  std::vector<Vector> wall_forces() override {
    WallForces<D, B> forces(store_.backend, wall_count_, ghosts_, double(m_));
    add_wall_forces(forces);
    return forces.list();
  }
  std::vector<Vector> bounce_impulses() override {
    WallForces<D, B> impulses(store_.backend, wall_count_, ghosts_, double(m_));
    impulses.add_bounces(fluid_, stepper_->confinement(), reflector_walls_);
    return impulses.list();
  }
  std::vector<Vector> tractions(const std::vector<WallPatch>& patches, double cell) override {
    std::vector<PatchOnWall<D>> all;
    for (WallPatch patch : patches) {
      for (std::size_t k = 0; k < D; ++k) patch.center[k] -= origin_[k];
      all.emplace_back(patch, cell, double(support_));
    }
    WallForces<D, B> forces(store_.backend, std::move(all), double(m_));
    add_wall_forces(forces);
    return forces.tractions();
  }
  BoundaryForces boundary_forces() override {
    WallForces<D, B> forces(store_.backend, double(m_));
    add_wall_forces(forces);
    BoundaryForces all;
    append_boundary(walls_.akinci2012, forces, all);
    append_boundary(walls_.adami2012, forces, all);
    append_boundary(walls_.monaghan2009, forces, all);
    return all;
  }
  void show(const Frame& frame, double moment) override {
    resize(std::int64_t(frame.size()));
    for (int i = 0; i < fluid_.n; ++i) show_particle(frame, i);
    if (bodies_) bodies_->show(walls_, frame.bodies, frame.time, moment);
    search_between_steps(store_.backend, support_, fluid_, walls_.akinci2012, walls_.adami2012,
                         walls_.monaghan2009);
    lists_are_stale_ = false;
    show_bodies(store_.backend, walls_, fluid_, support_);
    extrapolate_to_walls(store_.backend, walls_, fluid_, kernel_, of_walls_);
  }

 private:
  bool is_far() const { return origin_ != Triple{}; }
  void make_fields(const EnginePlan& p) {
    store_.make_fluid(p);
    if (is_far())  // a checkpoint of a build without an origin has positions of another meaning
      store_.state.add(
          "fluid/origin", [this] { return origin_.data(); }, [] { return std::int64_t(3); },
          StateArray::Role::other);
    stepper_->fields(store_);
    if (forces_) forces_->fields(store_);
    if (whitewater_) whitewater_->fields(store_);
    flows_.fields([this](const char* name, Keep keep, auto& f) { store_.make(name, keep, f); });
    flows_.numbers([this](const std::string& name, auto* data, std::size_t count) {
      using Number =
          std::conditional_t<std::is_same_v<decltype(data), double*>, double, std::uint64_t>;
      store_.state.add(
          name, [=] { return reinterpret_cast<Number*>(data); },
          [=] { return std::int64_t(count); }, StateArray::Role::other);
    });
  }
  /// Creates the reflecting shapes and the memory of their velocity changes.
  void confine(const EnginePlan& p) {
    for (const ReflectorPlan& r : p.reflectors) {
      reflectors_.push_back({solid_of<D, Real>(r.solid), Real(r.restitution)});
      reflector_walls_.push_back(r.wall);
    }
    Confinement<D>& c = stepper_->confinement();
    c.shapes.data = reflectors_.data();
    c.shape_count = int(reflectors_.size());
    store_.state.add(
        "fluid/bounced", [this] { return bounced_.data(); },
        [this] { return std::int64_t(bounced_.size()); }, StateArray::Role::other);
    make_room_for_bounces();
  }
  /// Resizes the memory of velocity changes at reflecting walls. Only sums over particles are used:
  /// if the number of particles falls, the first particles take the values of the removed entries.
  void make_room_for_bounces() {
    Confinement<D>& c = stepper_->confinement();
    const auto walls = std::size_t(c.walls());
    const auto n = std::size_t(std::max(fluid_.n, 1));
    for (std::size_t k = walls * n; k < bounced_.size(); ++k) bounced_[k % walls] += bounced_[k];
    bounced_.resize(walls * n);
    c.bounced.data = bounced_.empty() ? nullptr : bounced_.data();
  }
  /// After particles from place `first` on have been added.
  void fill_new(int first) {
    changed();
    for (int i = first; i < fluid_.n; ++i) fluid_.rho[i] = rho0_;
  }
  /// After particles have been added or removed.
  void changed() {
    make_room_for_bounces();
    lists_are_stale_ = true;
  }

  /// Creates the second set of body particles, the targets of the fluid's forces.
  void make_bodies(const EnginePlan& p) {
    bodies_ = std::make_unique<CarriedBodies<D>>(p, walls_);
    if (p.layered_bodies) {
      fill_bodies("of_layered_bodies", walls_.of_layered_bodies, walls_.adami2012, p);
    } else {
      fill_bodies("of_bodies", walls_.of_bodies, walls_.akinci2012, p);
      fill_psi(bodies_->psi(kernel_of<D>(p), support_, rho0_, p.sample.bodies.volume_factor));
    }
    store_.backend.allocate(fluid_, Keep::scratch, walls_.rate);
    static_assert(sizeof(BodyState) == 19 * sizeof(double));
    store_.state.add_numbers("bodies/state", bodies_->bodies().states());
    store_.state.add_numbers("bodies/forces", bodies_->bodies().last_forces());
  }
  template <class Wall>
  void fill_bodies(const char* name, Wall& of_bodies, const Wall& wall, const EnginePlan& p) {
    const int n = bodies_->samples(), first = wall.n - n * bodies_->places();
    of_bodies.moves = true;
    store_.backend.add_set(of_bodies, n);
    store_.allocate(of_bodies, name, "id", Keep::kept, of_bodies.id);
    store_.allocate(of_bodies, name, "x", Keep::kept, of_bodies.x);
    store_.allocate(of_bodies, name, "v", Keep::scratch, of_bodies.v);
    of_bodies.fields([&](const char* field, Keep keep, auto& f) {
      store_.allocate(of_bodies, name, field, keep, f);
    });
    for (int k = 0; k < n; ++k) {
      of_bodies.id[k] = std::uint64_t(k);
      of_bodies.friction[k] = p.body_no_slip[std::size_t(bodies_->body_of(k))];
      for (int image = 0; image < bodies_->places(); ++image)
        wall.friction[first + image * n + k] = of_bodies.friction[k];
    }
  }
  void fill_psi(const std::vector<Real>& psi) {
    const auto &of_bodies = walls_.of_bodies, &wall = walls_.akinci2012;
    for (int k = 0, first = wall.n - of_bodies.n * bodies_->places(); first + k < wall.n; ++k)
      wall.psi[first + k] = of_bodies.psi[k % of_bodies.n] = psi[std::size_t(k % of_bodies.n)];
  }

  void show_particle(const Frame& frame, int i) {
    const auto n = std::size_t(i);
    fluid_.id[i] = frame.id[n];
    for (std::size_t k = 0; k < D; ++k) {
      component(fluid_.x[i], int(k)) = Real(double(frame.x[D * n + k]) - origin_[k]);
      component(fluid_.v[i], int(k)) = Real(frame.v[D * n + k]);
    }
    if (fluid_.x_listed.data) fluid_.x_listed[i] = fluid_.x[i];
    if (fluid_.kind.data) fluid_.kind[i] = frame.liquid[n];
    fluid_.rho[i] = Real(frame.density[n]) * liquids_.lightness(fluid_, i);
    fluid_.p[i] = Real(frame.pressure[n]);
    fluid_.a[i] = {};
    if (Field<Real>* k = stepper_->start_pressure())
      (*k)[i] = fluid_.rho[i] > 0 ? fluid_.p[i] / square(fluid_.rho[i]) : 0;
  }
  /// Appends the boundary particles of a set, without periodic images.
  void append_boundary(const WallParticles<D>& wall, WallForces<D, B>& forces,
                       BoundaryForces& all) const {
    const auto& on_particle = forces.on_particles(wall);
    if (on_particle.empty()) return;  // no term acts on this set
    for (int k = 0; k < wall.n; ++k) {
      int part = wall.wall[k];
      if (part < 0 && bodies_ && wall.set == bodies_->wall_set())
        if (const int body = bodies_->body_of_wall(wall.id[k]); body >= 0)
          part = int(wall_count_) + body;
      if (part < 0) continue;
      all.part.push_back(part);
      for (int d = 0; d < D; ++d) {
        Vec<D> x = wall.x[k];
        Vec<D, double> f = on_particle[std::size_t(k)];
        all.x.push_back(double(component(x, d)) + origin_[std::size_t(d)]);
        all.force.push_back(component(f, d));
      }
    }
  }

  /// All forces on walls but bounces.
  void add_wall_forces(WallForces<D, B>& forces) {
    B& backend = store_.backend;
    if (std::exchange(lists_are_stale_, false)) search_between_steps(backend, support_, fluid_);
    const Walls<D> walls = list_fluid_near_walls(backend, support_, fluid_, walls_);
    stepper_->add_wall_forces(backend, walls, forces);
    if (forces_) forces_->add_wall_forces(fluid_, walls, forces);
  }

  std::unique_ptr<Stepper<D, B>> stepper_;
  std::unique_ptr<NonPressureForces<D, B>> forces_;  // null: none
  std::unique_ptr<Whitewater<D, B>> whitewater_;     // null: none
  FluidParticles<D>& fluid_;                         // the stepper's
  Store<D, B> store_;
  Walls<D>& walls_;
  BodyForce<D> body_force_;
  Flows<D> flows_;
  Liquids liquids_;
  Triple origin_;           // of positions, in the scene
  Vec<D, double> gravity_;  // for particles outside of the domain
  bool iterates_;
  Real h_, support_, rho0_, m_;
  SceneKernel<D> kernel_;
  WeaklyCompressibleParameters<D> of_walls_;  // of what adami2012 extrapolates
  std::size_t wall_count_;
  GhostWalls<D> ghosts_;
  std::unique_ptr<CarriedBodies<D>> bodies_;  // null without bodies
  std::vector<Reflector<D>> reflectors_;
  std::vector<Vec<D, double>> bounced_, bounced_before_;
  std::vector<int> reflector_walls_;   // their numbers
  mutable std::vector<Real> density_;  // of several liquids
  bool lists_are_stale_ = false;       // the particles are others than at the last search
  std::int64_t steps_ = 0;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
