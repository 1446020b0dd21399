// SPDX-License-Identifier: MIT
#include "freshet/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "io/checkpoint.h"
#include "io/sha256.h"
#include "scene/setup.h"
#include "sim/engines/select.h"
#include "sim/health.h"

namespace freshet {
namespace {

/// The places of particles in the order of their ids, which mostly are 0 to n - 1.
std::vector<std::size_t> order_by_id(std::span<const std::uint64_t> id) {
  const std::size_t n = id.size();
  std::vector<std::size_t> order(n);
  if (std::all_of(id.begin(), id.end(), [=](std::uint64_t k) { return k < n; })) {
    for (std::size_t i = 0; i < n; ++i) order[id[i]] = i;
    return order;
  }
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return id[a] < id[b]; });
  return order;
}

std::span<const std::uint64_t> ids_of(const StateArray& id) {
  return {reinterpret_cast<const std::uint64_t*>(id.data), std::size_t(id.count)};
}

constexpr double infinity = std::numeric_limits<double>::infinity();

static_assert(std::endian::native == std::endian::little, "digests are over little-endian numbers");

}  // namespace

struct Simulation::Impl {
  Impl(Scene s, const Execution& execution) : scene(with_defaults(std::move(s))) {
    derived = derive(scene);
    engine = make_engine(scene, derived, execution);
    health.emplace(scene, derived, engine->fluid());
  }
  std::vector<StateArray> state() const;
  std::string state_digest(StateArray::Role role) const;
  class Resized;
  double next_step();
  double advance(double from, double dt, int halvings, double whole);
  void note(const std::vector<Solve>& solves);

  Scene scene;
  Derived derived{};
  std::unique_ptr<Engine> engine;
  std::int64_t steps = 0;
  double time = 0, forces_asked = 0;
  double flows_asked = 0;  // when, and the counts then
  std::vector<std::int64_t> flowed;
  TimeSteps time_steps;
  std::vector<SolveStatistics> solves;
  bool retries_help = true;
  std::optional<Health> health;  // refers to the scene
};

Simulation::Simulation(Scene scene, const Execution& execution)
    : impl_(std::make_unique<Impl>(std::move(scene), execution)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

const Scene& Simulation::scene() const { return impl_->scene; }
std::int64_t Simulation::steps_done() const { return impl_->steps; }
double Simulation::time() const { return impl_->time; }
const TimeSteps& Simulation::time_steps() const { return impl_->time_steps; }
const std::vector<SolveStatistics>& Simulation::solves() const { return impl_->solves; }
const std::vector<Warning>& Simulation::warnings() const { return impl_->health->warnings(); }
TimeStepBounds Simulation::bounds() { return impl_->engine->bounds(impl_->time); }
bool Simulation::finished() const {
  const Scene& s = impl_->scene;
  return s.time.adaptive ? impl_->time >= s.time.end * (1 - 1e-12) : impl_->steps >= s.steps();
}
ParticleView Simulation::fluid() const { return impl_->engine->fluid(); }
std::vector<BodyState> Simulation::bodies() const { return impl_->engine->bodies(); }
const std::vector<VerbTiming>& Simulation::timings() const { return impl_->engine->timings(); }

/// Without the arrays of sets that nothing is in.
std::vector<StateArray> Simulation::Impl::state() const {
  auto all = engine->state();
  std::erase_if(all, [](const StateArray& a) { return a.count == 0; });
  return all;
}

/// Over the arrays of a role in the order of their names, each in the order of its set's ids.
std::string Simulation::Impl::state_digest(StateArray::Role role) const {
  auto arrays = state();
  std::sort(arrays.begin(), arrays.end(), [](auto& a, auto& b) { return a.name < b.name; });
  Sha256 sha;
  for (const StateArray& a : arrays) {
    if (a.role != role) continue;
    const std::string id = a.name.substr(0, a.name.find('/')) + "/id";
    const auto ids = std::find_if(arrays.begin(), arrays.end(),
                                  [&](const StateArray& other) { return other.name == id; });
    const std::size_t bytes = a.bytes_per_particle();
    for (const std::size_t i : order_by_id(ids_of(*ids))) sha.add(a.data + i * bytes, bytes);
  }
  return sha.hex();
}

void Simulation::step() {
  Impl& i = *impl_;
  const double dt = i.advance(i.time, i.next_step(), 0, infinity);
  ++i.steps;
  i.time = i.scene.time.adaptive ? i.time + dt : double(i.steps) * dt;
  i.time_steps.last = dt;
  i.time_steps.min = i.steps == 1 ? dt : std::min(i.time_steps.min, dt);
  i.time_steps.max = std::max(i.time_steps.max, dt);
  if (Health::due(i.steps) || finished())
    i.health->look({i.steps, i.time, dt}, i.engine->fluid(), i.solves,
                   [&i] { return i.engine->bounds(i.time); });
}

/// A step of dt from a time on; where a solve does not converge, in halves: an adaptive run takes
/// the first of them for its step, a run of fixed steps takes both. Returns the time that was gone:
/// none, and the state as it was, where half a step ends little better than `whole`, the error over
/// the tolerance that the whole step ended at: what is too dense from the start is no matter of
/// steps.
double Simulation::Impl::advance(double from, double dt, int halvings, double whole) {
  constexpr int most_halvings = 3;
  const auto solved = engine->step(from, dt);
  double worst = 0;
  bool converged = true;
  for (const Solve& s : solved) {
    worst = std::max(worst, s.error / s.tolerance);
    converged &= s.converged();
  }
  if (converged && halvings == 0) retries_help = true;
  if (converged || !scene.time.retry || !retries_help || !scene.solver.incompressible()) {
    note(solved);
    engine->flow(from + dt, dt);
    return dt;
  }
  engine->undo();
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

void Simulation::Impl::note(const std::vector<Solve>& solved) {
  solves.resize(solved.size());
  for (std::size_t k = 0; k < solved.size(); ++k) {
    SolveStatistics& s = solves[k];
    s.name = solved[k].name;
    s.tolerance = solved[k].tolerance;
    ++s.solves;
    s.iterations += s.last_iterations = solved[k].iterations;
    s.most_iterations = std::max(s.most_iterations, s.last_iterations);
    s.not_converged += !solved[k].converged();
    s.last_error = solved[k].error;
    if (!(s.last_error <= s.worst_error)) s.worst_error = s.last_error;  // no number is the worst
  }
}

double Simulation::Impl::next_step() {
  if (!scene.time.adaptive) {
    time_steps.last_ruled = "fixed";
    return scene.time.step;
  }
  const TimeStepBounds b = engine->bounds(time);
  const double most = *scene.time.step_max;
  const bool bounded = b.least() < most;
  time_steps.last_ruled = bounded ? b.ruling() : "step_max";
  ++time_steps.ruled[time_steps.last_ruled];
  const double dt = bounded ? b.least() : most;
  if (dt > health->least_step()) return dt;
  health->fail_for_step({steps, time, dt}, b);
}

std::vector<Vector> Simulation::wall_forces() {
  return impl_->engine->wall_forces(impl_->time - std::exchange(impl_->forces_asked, impl_->time));
}

std::vector<Vector> Simulation::tractions(const std::vector<WallPatch>& patches) {
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
  return impl_->engine->tractions(patches, impl_->scene.particles.spacing);
}

std::vector<Flow> Simulation::flows() {
  Impl& i = *impl_;
  const Scene& s = i.scene;
  const std::vector<std::string> names = s.flow_names();
  const std::vector<std::int64_t> counts = i.engine->flow_counts();
  i.flowed.resize(names.size());
  const double volume = std::pow(s.particles.spacing, s.dimension());
  const double interval = i.time - std::exchange(i.flows_asked, i.time);
  std::vector<Flow> all;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const bool in = k < s.inlet.size(), out = !in && k < s.inlet.size() + s.outlet.size();
    Flow f{in ? "inlet" : out ? "outlet" : "counter", names[k], counts[k]};
    f.volume = volume * double(f.particles);
    const auto since = double(f.particles - std::exchange(i.flowed[k], f.particles));
    if (interval > 0) f.rate = volume * since / interval;
    if (in) f.waiting = counts[names.size() + k];
    all.push_back(std::move(f));
  }
  return all;
}

Frame Simulation::frame() const {
  const ParticleView f = fluid();
  const auto D = std::size_t(f.dimension), n = f.size();
  Frame out{f.dimension, impl_->steps, impl_->time, {}, {}, {}, {}, {}, {}, bodies()};
  out.id.resize(n);
  out.x.resize(D * n);
  out.v.resize(D * n);
  out.density.resize(n);
  out.pressure.resize(n);
  const auto order = order_by_id(f.id);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = order[k];
    out.id[k] = f.id[i];
    for (std::size_t d = 0; d < D; ++d) {
      out.x[D * k + d] = float(f.x[D * i + d]);
      out.v[D * k + d] = float(f.v[D * i + d]);
    }
    out.density[k] = float(f.density[i]);
    out.pressure[k] = float(f.pressure[i]);
    if (!f.liquid.empty()) out.liquid.push_back(f.liquid[i]);
  }
  return out;
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
      const double x = f.x[D * i + d], v = f.v[D * i + d];
      speed2 += v * v;
      inside &= x >= s.domain.min[d] - margin && x <= s.domain.max[d] + margin;
      potential -= m * s.domain.gravity[d] * x;
      out.momentum[d] += m * v;
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
    out.height_mean += double(f.x[D * i + 1]);
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

std::string Simulation::state_sha256() const {
  const ParticleView f = fluid();
  const auto d = std::size_t(f.dimension);
  Sha256 sha;
  const auto step = std::uint64_t(impl_->steps);
  sha.add(&step, sizeof step);
  for (const std::size_t i : order_by_id(f.id)) {
    sha.add(&f.id[i], sizeof f.id[i]);
    sha.add(&f.x[i * d], d * sizeof(Real));
    sha.add(&f.v[i * d], d * sizeof(Real));
  }
  return sha.hex();
}

Checkpoint Simulation::checkpoint() const {
  Impl& i = *impl_;
  i.health->look_for_lost({i.steps, i.time, i.time_steps.last}, i.engine->fluid());
  Checkpoint c;
  c.scene = scene().source;
  c.steps = impl_->steps;
  c.time = impl_->time;
  c.watch = impl_->health->record();
  c.forces_asked = impl_->forces_asked;
  c.flows_asked = impl_->flows_asked;
  c.flowed = impl_->flowed;
  c.time_steps = impl_->time_steps;
  c.solves = impl_->solves;
  c.retries_help = impl_->retries_help;
  c.walls_sha256 = impl_->state_digest(StateArray::Role::fixed);
  for (const StateArray& a : impl_->state()) {
    if (a.role == StateArray::Role::fixed) continue;
    c.arrays.push_back({a, {a.data, a.data + a.bytes()}});
    c.arrays.back().data = nullptr;
  }
  return c;
}

/// Makes the fluid have as many particles as a checkpoint's, where they come and go; if what
/// follows throws, all is as it was.
class Simulation::Impl::Resized {
 public:
  Resized(Engine& engine, std::int64_t n) : engine_(engine), n_(engine.fluid().id.size()) {
    if (n == n_) return;
    for (const StateArray& a : engine.state()) before_.emplace_back(a.data, a.data + a.bytes());
    engine.resize(n);
  }
  ~Resized() {
    if (before_.empty()) return;
    engine_.resize(n_);
    std::size_t k = 0;
    for (const StateArray& a : engine_.state()) {
      std::copy(before_[k].begin(), before_[k].end(), a.data);
      ++k;
    }
  }
  void keep() { before_.clear(); }

 private:
  Engine& engine_;
  std::int64_t n_;
  std::vector<std::vector<std::byte>> before_;
};

void Simulation::restore(const Checkpoint& c) {
  const auto ids = std::find_if(c.arrays.begin(), c.arrays.end(),
                                [](const StateArray& a) { return a.name == "fluid/id"; });
  const auto here = std::int64_t(impl_->engine->fluid().size());
  Impl::Resized resized(*impl_->engine, !impl_->scene.has_flows() ? here
                                        : ids == c.arrays.end()   ? 0
                                                                  : ids->count);
  const auto refuse = [](const std::string& why) {
    throw Error(Error::Kind::scene, "", "this checkpoint is not of this scene: " + why);
  };
  auto state = impl_->state();
  std::erase_if(state, [](const StateArray& a) { return a.role == StateArray::Role::fixed; });
  const auto stored = [&](const StateArray& a) {
    return std::find_if(c.arrays.begin(), c.arrays.end(),
                        [&](const StateArray& b) { return b.name == a.name; });
  };
  for (const StateArray& a : state) {
    const auto it = stored(a);
    if (it == c.arrays.end())
      refuse(fmt::format("it has no {}; was it of another solver?", a.name));
    if (it->count != a.count)
      refuse(
          fmt::format("{} has {} entries there and {} here; was it of another resolution, or "
                      "has a file of points changed?",
                      a.name, it->count, a.count));
    if (it->number != a.number || it->components != a.components)
      refuse(
          fmt::format("{} has other numbers there; was it of a build with another "
                      "FRESHET_DOUBLE, or of another dimension?",
                      a.name));
  }
  if (c.walls_sha256 != impl_->state_digest(StateArray::Role::fixed))
    refuse("its walls are others; has a file of points changed?");
  for (const StateArray& a : state) {
    const auto it = stored(a);
    std::copy(it->bytes.begin(), it->bytes.end(), a.data);
  }
  resized.keep();
  impl_->engine->continue_from(c.steps);
  impl_->steps = c.steps;
  impl_->time = c.time;
  impl_->health->go_on({c.steps, c.time, c.time_steps.last}, c.watch);
  impl_->forces_asked = c.forces_asked;
  impl_->flows_asked = c.flows_asked;
  impl_->flowed = c.flowed;
  impl_->time_steps = c.time_steps;
  impl_->solves = c.solves;
  impl_->retries_help = c.retries_help;
}

std::string Simulation::kept_sha256() const { return impl_->state_digest(StateArray::Role::kept); }

}  // namespace freshet
