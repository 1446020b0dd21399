// SPDX-License-Identifier: MIT
#include "freshet/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/select.h"
#include "scene/keys/keys.h"
#include "sim/plan_of_scene.h"
#include "sim/simulation_impl.h"

namespace freshet {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Fails if a force of the caller is NaN or infinite: what follows would blame the time step.
void check_finite(const ParticleView& fluid, double time, std::span<const double> acceleration) {
  const auto bad = std::find_if(acceleration.begin(), acceleration.end(),
                                [](double a) { return !std::isfinite(a); });
  if (bad == acceleration.end()) return;
  const auto D = std::size_t(fluid.dimension);
  const std::size_t i = std::size_t(bad - acceleration.begin()) / D;
  std::string place;
  for (std::size_t k = 0; k < D; ++k)
    place += fmt::format("{}{:.4g}", k == 0 ? "" : ", ", fluid.position(i, k));
  throw Error(Error::Kind::run, "set_force",
              fmt::format("the acceleration of particle {} at ({}), t = {:.6g} s is {}; return "
                          "finite numbers",
                          fluid.id[i], place, time, *bad));
}

}  // namespace

std::unique_ptr<Engine> Simulation::Impl::make_engine_of(const Execution& execution) const {
  const bool reference = scene.solver.backend == BackendName::reference;
  if (!has_solver(scene.solver.name, scene.solver.backend, scene.dimension()))
    throw Error(
        Error::Kind::scene, "solver.name",
        fmt::format("this build has no {} in {}D{}; compile with it in FRESHET_{}SOLVERS",
                    scene.method().name, scene.dimension(),
                    reference ? " on the reference backend" : "", reference ? "REFERENCE_" : ""));
  return make_engine(plan_of(scene, derived, bodies.get(), threads),
                     {scene.solver.backend, execution.isa});
}

Simulation::Simulation(Scene scene, const Execution& execution)
    : impl_(std::make_unique<Impl>(std::move(scene), execution)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

const Scene& Simulation::scene() const { return impl_->scene; }
int Simulation::threads() const { return impl_->threads; }
std::int64_t Simulation::steps_done() const { return impl_->steps; }
double Simulation::time() const { return impl_->time; }
const TimeSteps& Simulation::time_steps() const { return impl_->time_steps; }
const std::vector<SolveStatistics>& Simulation::solves() const { return impl_->solves; }
const std::vector<Warning>& Simulation::warnings() const { return impl_->health->warnings(); }
TimeStepBounds Simulation::bounds() const { return impl_->bounds(); }
bool Simulation::finished() const {
  const Scene& s = impl_->scene;
  return s.time.adaptive ? impl_->time >= s.time.end * (1 - 1e-12) : impl_->steps >= s.steps();
}
ParticleView Simulation::fluid() const { return impl_->fluid(); }
std::shared_ptr<const void> Simulation::keep(const void* array) {
  return impl_->engine().keep(array);
}
WhitewaterView Simulation::whitewater() const { return impl_->engine().whitewater(); }
std::vector<BodyState> Simulation::bodies() const { return impl_->engine().bodies(); }
const std::vector<VerbTiming>& Simulation::timings() const { return impl_->engine().timings(); }

void Simulation::set_force(Force force) {
  Impl& i = *impl_;
  i.health->note_intervention();
  i.force = std::move(force);
  if (!i.force) return i.engine().set_force({});
  i.engine().set_force([impl = impl_.get()](double time, std::span<double> acceleration) {
    impl->force(impl->fluid(), time, acceleration);
    check_finite(impl->fluid(), time, acceleration);
  });
}

void Simulation::set_gravity(const Vector& gravity) {
  Impl& i = *impl_;
  const bool finite =
      std::all_of(gravity.begin(), gravity.end(), [](double g) { return std::isfinite(g); });
  if (gravity.size() != std::size_t(i.scene.dimension()) || !finite)
    throw Error(Error::Kind::scene, "gravity",
                fmt::format("gravity must have {} finite numbers", i.scene.dimension()));
  i.health->note_intervention();
  i.gravity = gravity;
  i.scene.domain.gravity = gravity;  // bodies read it there
  Triple g{};
  std::copy(gravity.begin(), gravity.end(), g.begin());
  i.engine().set_gravity(g);
}

Simulation::WritableParticles Simulation::edit_fluid() {
  impl_->health->note_intervention();
  return {impl_->edit_positions(), impl_->engine().velocities(), impl_->engine().kinds()};
}

std::uint64_t Simulation::add_particles(std::span<const Real> x, std::span<const Real> v,
                                        int liquid) {
  Impl& i = *impl_;
  const auto D = std::size_t(i.scene.dimension());
  const auto refuse = [](const char* what, std::string why) {
    throw Error(Error::Kind::scene, what, std::move(why));
  };
  if (x.size() % D != 0 || (!v.empty() && v.size() != x.size()))
    refuse("add_particles", fmt::format("there are {} positions and {} velocities; give {} numbers "
                                        "of each per particle, or no velocities",
                                        x.size(), v.size(), D));
  const auto finite = [](Real a) { return std::isfinite(a); };
  if (!std::all_of(x.begin(), x.end(), finite) || !std::all_of(v.begin(), v.end(), finite))
    refuse("add_particles", "a position or velocity is NaN or infinite; give finite numbers");
  if (liquid < 0 || std::size_t(liquid) >= i.scene.liquids().size())
    refuse("add_particles", fmt::format("there is no liquid {}; the scene has {}", liquid,
                                        i.scene.liquids().size()));
  i.health->note_intervention();
  i.edited = true;
  i.end_edit();
  return i.engine().add(x, v, liquid);
}

void Simulation::remove_particles(std::span<const std::uint64_t> ids) {
  Impl& i = *impl_;
  std::vector<std::uint64_t> sought(ids.begin(), ids.end());
  std::sort(sought.begin(), sought.end());
  const auto here = i.engine().fluid().id;
  std::vector<int> places;
  for (std::size_t k = 0; k < here.size(); ++k)
    if (std::binary_search(sought.begin(), sought.end(), here[k])) places.push_back(int(k));
  if (places.size() != ids.size())
    throw Error(Error::Kind::scene, "remove_particles",
                fmt::format("{} of the {} ids belong to particles; give each particle's id once",
                            places.size(), ids.size()));
  i.health->note_intervention();
  i.edited = true;
  i.end_edit();
  i.engine().remove(places);
}

void Simulation::observe(ObserverSchedule schedule,
                         std::function<void(const Simulation&)> observer) {
  const Every every = schedule.seconds > 0 ? Every({}, schedule.seconds)
                                           : Every(std::max<std::int64_t>(schedule.steps, 1), {});
  impl_->observers.emplace_back(every, std::move(observer));
}

void Simulation::step() {
  Impl& i = *impl_;
  i.refuse_shown("step");
  i.end_edit();
  const double before = i.time, dt = i.advance(i.time, i.next_step(), 0, infinity);
  ++i.steps;
  i.time = i.scene.time.adaptive ? i.time + dt : double(i.steps) * dt;
  i.time_steps.last = dt;
  i.time_steps.min = i.steps == 1 ? dt : std::min(i.time_steps.min, dt);
  i.time_steps.max = std::max(i.time_steps.max, dt);
  if (Health::due(i.steps) || finished())
    i.health->look({i.steps, i.time, dt}, i.engine().fluid(), i.solves,
                   [&i] { return i.bounds(); });
  if (i.scene.whitewater && (Health::due(i.steps) || finished()))
    i.health->look_at_whitewater(whitewater());
  for (const auto& [every, observer] : i.observers)
    if (every.due({i.steps - 1, before, i.time, false})) observer(*this);
}

/// A step of dt from a time on; where a solve does not converge, in halves: an adaptive run takes
/// the first of them for its step, a run of fixed steps takes both. Returns the time that was gone:
/// none, and the state as it was, where half a step ends little better than `whole`, the error over
/// the tolerance that the whole step ended at: what is too dense from the start is no matter of
/// steps.
double Simulation::Impl::advance(double from, double dt, int halvings, double whole) {
  constexpr int most_halvings = 3;
  if (tight_walls.any()) tight_walls.begin(engine().fluid());
  const auto solved = engine().step(from, dt);
  double worst = 0;
  bool converged = true;
  for (const Solve& s : solved) {
    worst = std::max(worst, s.error / s.tolerance);
    converged &= s.converged();
  }
  if (converged && halvings == 0) retries_help = true;
  if (converged || !scene.time.retry || !retries_help || !scene.method().incompressible()) {
    note(solved);
    if (tight_walls.any()) tight_walls.hold(engine());
    engine().flow(from + dt, dt);
    return dt;
  }
  engine().undo();
  if (halvings > 0 && worst > 0.75 * whole) return 0;
  double gone = 0;
  if (halvings < most_halvings) {
    ++time_steps.retried;
    gone = advance(from, dt / 2, halvings + 1, worst);
  }
  if (gone == 0) {  // the whole step after all
    retries_help = false;
    return advance(from, dt, halvings, whole);
  }
  if (!scene.time.adaptive) return gone + advance(from + gone, dt / 2, halvings + 1, infinity);
  if (time_steps.last_ruled != "retry") {
    --time_steps.ruled[std::exchange(time_steps.last_ruled, "retry")];
    ++time_steps.ruled["retry"];
  }
  return gone;
}

void Simulation::Impl::note(const Solves& solved) {
  solves.resize(std::size_t(solved.count));
  for (int k = 0; k < solved.count; ++k) {
    const Solve& solve = solved.result[k];
    SolveStatistics& s = solves[std::size_t(k)];
    s.name = solve.name;
    s.tolerance = solve.tolerance;
    ++s.solves;
    s.iterations += s.last_iterations = solve.iterations;
    s.most_iterations = std::max(s.most_iterations, s.last_iterations);
    s.not_converged += !solve.converged();
    s.last_error = solve.error;
    if (!(s.last_error <= s.worst_error)) s.worst_error = s.last_error;  // NaN is the worst
  }
}

/// Bodies alone have no bounds: those of an engine are of its liquid, even without a particle.
TimeStepBounds Simulation::Impl::bounds() const {
  if (!has_fluid(scene) && engine().fluid().size() == 0) return {infinity, infinity, infinity};
  return engine().bounds(time);
}

double Simulation::Impl::next_step() {
  if (!scene.time.adaptive) {
    time_steps.last_ruled = "fixed";
    return scene.time.step;
  }
  const TimeStepBounds b = bounds();
  const double most = *scene.time.step_max;
  const bool bounded = b.least() < most;
  time_steps.last_ruled = bounded ? b.ruling() : "step_max";
  ++time_steps.ruled[time_steps.last_ruled];
  const double dt = bounded ? b.least() : most;
  if (dt > health->least_step()) return dt;
  health->fail_for_step({steps, time, dt}, fluid(), b);
}

Simulation::Moment Simulation::moment() const {
  return {impl_->time, impl_->engine().bounce_impulses(), impl_->engine().flow_counts()};
}

std::vector<Vector> Simulation::wall_forces(const Moment& since) const {
  std::vector<Vector> forces = impl_->engine().wall_forces();
  const double interval = impl_->time - since.time;
  if (!(interval > 0)) return forces;
  const std::vector<Vector> impulses = impl_->engine().bounce_impulses();
  for (std::size_t w = 0; w < forces.size(); ++w)
    for (std::size_t d = 0; d < forces[w].size(); ++d) {
      const double before = w < since.impulses.size() ? since.impulses[w][d] : 0;
      forces[w][d] += (impulses[w][d] - before) / interval;
    }
  return forces;
}

std::vector<Vector> Simulation::tractions(const std::vector<WallPatch>& patches) const {
  const auto n = std::size_t(impl_->scene.dimension());
  for (const WallPatch& p : patches) {
    bool fits = p.center.size() == n && p.half.size() == n && p.axes.size() == n;
    for (const Vector& axis : p.axes) fits = fits && axis.size() == n;
    if (!fits)
      throw Error(Error::Kind::scene, "patch",
                  fmt::format("a vector of the patch has not the {} numbers of the domain; give "
                              "center, half and {} axes so many each",
                              n, n));
  }
  return impl_->engine().tractions(patches, impl_->scene.particles.spacing);
}

BoundaryForces Simulation::boundary_forces() const { return impl_->engine().boundary_forces(); }

std::vector<Flow> Simulation::flows(const Moment& since) const {
  const Impl& i = *impl_;
  const Scene& s = i.scene;
  const std::vector<std::string> names = s.flow_names();
  const std::vector<std::int64_t> counts = i.engine().flow_counts();
  const double volume = std::pow(s.particles.spacing, s.dimension());
  const double interval = i.time - since.time;
  std::vector<Flow> all;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const bool in = k < s.inlet.size();
    Flow f{s.flow_kind(k), names[k], counts[k]};
    f.volume = volume * double(f.particles);
    const std::int64_t before = k < since.passed.size() ? since.passed[k] : 0;
    if (interval > 0) f.rate = volume * double(f.particles - before) / interval;
    if (in) f.waiting = counts[names.size() + k];
    all.push_back(std::move(f));
  }
  return all;
}

Statistics Simulation::statistics() const {
  const ParticleView f = fluid();
  const Scene& s = scene();
  const Derived& derived = impl_->derived;
  const double margin = derived.support_radius;
  const auto liquids = s.liquids();
  const auto D = std::size_t(f.dimension);
  Statistics out;
  out.momentum.assign(D, 0);
  out.angular_momentum.assign(D == 2 ? 1 : 3, 0);
  out.particles = std::int64_t(f.size());
  if (f.size() == 0) return out;
  out.density_min = out.density_max = double(f.density[0]);
  out.fastest = f.id[0];
  for (std::size_t i = 0; i < f.size(); ++i) {
    const double rest_density = liquids[std::size_t(f.liquid_of(i))].rest_density;
    const double m = derived.mass * (rest_density / derived.rest_density);
    double speed2 = 0, potential = 0;
    bool inside = true;
    for (std::size_t d = 0; d < D; ++d) {
      const double x = f.position(i, d), v = f.v[D * i + d];
      speed2 += v * v;
      inside &= x >= s.domain.min[d] - margin && x <= s.domain.max[d] + margin;
      potential -= m * s.domain.gravity[d] * x;
      out.momentum[d] += m * v;
    }
    for (std::size_t k = 0; k < out.angular_momentum.size(); ++k) {
      const std::size_t a = D == 2 ? 0 : (k + 1) % 3, b = D == 2 ? 1 : (k + 2) % 3;
      const double ma = m * f.position(i, a), mb = m * f.position(i, b);
      out.angular_momentum[k] += ma * f.v[D * i + b] - mb * f.v[D * i + a];
    }
    const double speed = std::sqrt(speed2), density = f.density[i];
    out.out_of_bounds += !inside;
    out.density_mean += density;
    out.density_min = std::min(out.density_min, density);
    out.density_max = std::max(out.density_max, density);
    const double error = std::max(0.0, density / rest_density - 1);
    out.density_error_mean += error;
    out.density_error_max = std::max(out.density_error_max, error);
    out.speed_mean += speed;
    if (speed > out.speed_max || (speed == out.speed_max && f.id[i] < out.fastest)) {
      out.speed_max = speed;
      out.fastest = f.id[i];
    }
    out.height_mean += f.position(i, 1);
    out.kinetic_energy += m / 2 * speed2;
    out.potential_energy += potential;
  }
  const double n = double(f.size());
  out.density_mean /= n;
  out.density_error_mean /= n;
  out.speed_mean /= n;
  out.height_mean /= n;
  return out;
}

}  // namespace freshet
