// SPDX-License-Identifier: MIT
#include "freshet/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

#include "io/sha256.h"
#include "scene/setup.h"
#include "sim/engines/select.h"

namespace freshet {
namespace {

constexpr std::int64_t steps_between_looks = 100;

/// The places of the particles in the order of their ids, which mostly are 0 to n - 1.
std::vector<std::size_t> order_by_id(const ParticleView& fluid) {
  const std::size_t n = fluid.size();
  std::vector<std::size_t> order(n);
  if (std::all_of(fluid.id.begin(), fluid.id.end(), [=](std::uint64_t id) { return id < n; })) {
    for (std::size_t i = 0; i < n; ++i) order[fluid.id[i]] = i;
    return order;
  }
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return fluid.id[a] < fluid.id[b]; });
  return order;
}

static_assert(std::endian::native == std::endian::little, "digests are over little-endian numbers");

}  // namespace

struct Simulation::Impl {
  Impl(Scene s, const Execution& execution) : scene(with_defaults(std::move(s))) {
    derived = derive(scene);
    engine = make_engine(scene, derived, execution);
  }
  void look_for_failure() const;
  [[noreturn]] void fail(std::uint64_t id, const Real* x) const;
  double next_step();

  Scene scene;
  Derived derived{};
  std::unique_ptr<Engine> engine;
  std::int64_t steps = 0;
  double time = 0, forces_asked = 0;
  TimeSteps time_steps;
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
TimeStepBounds Simulation::bounds() { return impl_->engine->bounds(); }
bool Simulation::finished() const {
  const Scene& s = impl_->scene;
  return s.time.adaptive ? impl_->time >= s.time.end * (1 - 1e-12) : impl_->steps >= s.steps();
}
ParticleView Simulation::fluid() const { return impl_->engine->fluid(); }
const std::vector<VerbTiming>& Simulation::timings() const { return impl_->engine->timings(); }

void Simulation::step() {
  Impl& i = *impl_;
  const double dt = i.next_step();
  i.engine->step(dt);
  ++i.steps;
  i.time = i.scene.time.adaptive ? i.time + dt : double(i.steps) * dt;
  i.time_steps.last = dt;
  i.time_steps.min = i.steps == 1 ? dt : std::min(i.time_steps.min, dt);
  i.time_steps.max = std::max(i.time_steps.max, dt);
  if (i.steps % steps_between_looks == 0 || finished()) i.look_for_failure();
}

double Simulation::Impl::next_step() {
  if (!scene.time.adaptive) return scene.time.step;
  const TimeStepBounds b = engine->bounds();
  const double most = *scene.time.step_max;
  const bool bounded = b.least() < most;
  ++time_steps.ruled[bounded ? b.ruling() : "step_max"];
  const double dt = bounded ? b.least() : most;
  if (dt > 1e-9 * scene.time.end) return dt;
  throw Error(Error::Kind::run, "",
              fmt::format("the time step fell to {:.3g} s at step {}, {:.6g} s, by the bound of "
                          "{}: the run has blown up; look at the start of the scene, or make "
                          "time.step_max smaller",
                          dt, steps, time, b.ruling()));
}

std::vector<Vector> Simulation::wall_forces() {
  return impl_->engine->wall_forces(impl_->time - std::exchange(impl_->forces_asked, impl_->time));
}

/// A particle that is nowhere, or so far out that it cannot come back, is the end of the run.
void Simulation::Impl::look_for_failure() const {
  const ParticleView f = engine->fluid();
  const Vector &min = scene.domain.min, &max = scene.domain.max;
  const auto D = std::size_t(f.dimension);
  double diagonal2 = 0;
  for (std::size_t d = 0; d < D; ++d) diagonal2 += (max[d] - min[d]) * (max[d] - min[d]);
  const double far = 10 * std::sqrt(diagonal2);
  for (std::size_t i = 0; i < f.size(); ++i) {
    bool near = true;
    for (std::size_t d = 0; d < D; ++d) {
      const double x = double(f.x[D * i + d]);
      near &= x > min[d] - far && x < max[d] + far;
    }
    if (!near) fail(f.id[i], &f.x[D * i]);  // a NaN is not near either
  }
}

void Simulation::Impl::fail(std::uint64_t id, const Real* x) const {
  const double bound = derived.step_bound();
  const double dt = time_steps.last;
  const std::string cause =
      !scene.time.adaptive && dt > bound
          ? fmt::format("time.step, {:.4g} s, is over its bound, {:.4g} s; make it smaller", dt,
                        bound)
          : "particles came too close; look at the start of the scene, or make time.step smaller";
  std::string place = fmt::format("{:.4g}, {:.4g}", x[0], x[1]);
  if (scene.dimension() == 3) place += fmt::format(", {:.4g}", x[2]);
  throw Error(Error::Kind::run, "",
              fmt::format("particle {} is lost, at ({}) at step {}, {:.6g} s; {}", id, place, steps,
                          time, cause));
}

Frame Simulation::frame() const {
  const ParticleView f = fluid();
  const auto D = std::size_t(f.dimension), n = f.size();
  Frame out{f.dimension, impl_->steps, impl_->time, {}, {}, {}, {}, {}};
  out.id.resize(n);
  out.x.resize(D * n);
  out.v.resize(D * n);
  out.density.resize(n);
  out.pressure.resize(n);
  const auto order = order_by_id(f);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = order[k];
    out.id[k] = f.id[i];
    for (std::size_t d = 0; d < D; ++d) {
      out.x[D * k + d] = float(f.x[D * i + d]);
      out.v[D * k + d] = float(f.v[D * i + d]);
    }
    out.density[k] = float(f.density[i]);
    out.pressure[k] = float(f.pressure[i]);
  }
  return out;
}

Statistics Simulation::statistics() const {
  const ParticleView f = fluid();
  const Scene& s = scene();
  const double margin = impl_->derived.support_radius, m = impl_->derived.mass;
  const auto D = std::size_t(f.dimension);
  Statistics out;
  out.momentum.assign(D, 0);
  out.particles = std::int64_t(f.size());
  out.density_min = out.density_max = double(f.density[0]);
  for (std::size_t i = 0; i < f.size(); ++i) {
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
    out.speed_mean += speed;
    out.speed_max = std::max(out.speed_max, speed);
    out.height_mean += double(f.x[D * i + 1]);
    out.kinetic_energy += m / 2 * speed2;
    out.potential_energy += potential;
  }
  const double n = double(f.size());
  out.density_mean /= n;
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
  for (const std::size_t i : order_by_id(f)) {
    sha.add(&f.id[i], sizeof f.id[i]);
    sha.add(&f.x[i * d], d * sizeof(Real));
    sha.add(&f.v[i * d], d * sizeof(Real));
  }
  return sha.hex();
}

std::string Simulation::kept_sha256() const {
  auto fields = impl_->engine->state();
  std::sort(fields.begin(), fields.end(), [](auto& a, auto& b) { return a.name < b.name; });
  const auto order = order_by_id(fluid());
  Sha256 sha;
  for (const auto& field : fields) {
    const std::size_t bytes = field.bytes_per_particle();
    if (field.role != Engine::StateArray::Role::kept) continue;
    for (const std::size_t i : order) sha.add(field.data + i * bytes, bytes);
  }
  return sha.hex();
}

}  // namespace freshet
