// SPDX-License-Identifier: MIT
#include "freshet/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "io/sha256.h"
#include "sim/engines/select.h"

namespace freshet {
namespace {

constexpr std::int64_t steps_between_looks = 100;

std::vector<std::size_t> order_by_id(const ParticleView& fluid) {
  std::vector<std::size_t> order(fluid.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return fluid.id[a] < fluid.id[b]; });
  return order;
}

static_assert(std::endian::native == std::endian::little, "digests are over little-endian numbers");

}  // namespace

struct Simulation::Impl {
  Impl(Scene s, const Execution& execution) : scene(std::move(s)) {
    derived = derive(scene);
    engine = make_engine(scene, derived, execution);
  }
  void look_for_failure() const;
  [[noreturn]] void fail(std::uint64_t id, double x, double y) const;

  Scene scene;
  Derived derived{};
  std::unique_ptr<Engine> engine;
  std::int64_t steps = 0;
};

Simulation::Simulation(Scene scene, const Execution& execution)
    : impl_(std::make_unique<Impl>(std::move(scene), execution)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

const Scene& Simulation::scene() const { return impl_->scene; }
std::int64_t Simulation::steps_done() const { return impl_->steps; }
double Simulation::time() const { return double(impl_->steps) * impl_->scene.time.step; }
ParticleView Simulation::fluid() const { return impl_->engine->fluid(); }
const std::vector<VerbTiming>& Simulation::timings() const { return impl_->engine->timings(); }

void Simulation::step() {
  impl_->engine->step();
  ++impl_->steps;
  if (impl_->steps % steps_between_looks == 0 || impl_->steps == impl_->scene.steps())
    impl_->look_for_failure();
}

/// A particle that is nowhere, or so far out that it cannot come back, is the end of the run.
void Simulation::Impl::look_for_failure() const {
  const ParticleView f = engine->fluid();
  const Vector &min = scene.domain.min, &max = scene.domain.max;
  const double far = 10 * std::hypot(max[0] - min[0], max[1] - min[1]);
  for (std::size_t i = 0; i < f.size(); ++i) {
    const double x = f.x[2 * i], y = f.x[2 * i + 1];
    const bool near = x > min[0] - far && x < max[0] + far && y > min[1] - far && y < max[1] + far;
    if (!near) fail(f.id[i], x, y);  // a NaN is not near either
  }
}

void Simulation::Impl::fail(std::uint64_t id, double x, double y) const {
  const double bound = derived.step_bound();
  const std::string cause =
      scene.time.step > bound
          ? fmt::format("time.step, {:.4g} s, is over its bound, {:.4g} s; make it smaller",
                        scene.time.step, bound)
          : "particles came too close; look at the start of the scene, or make time.step smaller";
  throw Error(Error::Kind::run, "",
              fmt::format("particle {} is lost, at ({:.4g}, {:.4g}) at step {}, {:.6g} s; {}", id,
                          x, y, steps, double(steps) * scene.time.step, cause));
}

Statistics Simulation::statistics() const {
  const ParticleView f = fluid();
  const Scene& s = scene();
  const double margin = impl_->derived.support_radius, m = impl_->derived.mass;
  Statistics out;
  out.particles = std::int64_t(f.size());
  out.density_min = out.density_max = double(f.density[0]);
  for (std::size_t i = 0; i < f.size(); ++i) {
    const double x = f.x[2 * i], y = f.x[2 * i + 1], u = f.v[2 * i], w = f.v[2 * i + 1];
    const double speed = std::hypot(u, w), density = f.density[i];
    const bool inside = x >= s.domain.min[0] - margin && x <= s.domain.max[0] + margin &&
                        y >= s.domain.min[1] - margin && y <= s.domain.max[1] + margin;
    out.out_of_bounds += !inside;
    out.density_mean += density;
    out.density_min = std::min(out.density_min, density);
    out.density_max = std::max(out.density_max, density);
    out.speed_mean += speed;
    out.speed_max = std::max(out.speed_max, speed);
    out.height_mean += y;
    out.kinetic_energy += m / 2 * speed * speed;
    out.potential_energy -= m * (s.domain.gravity[0] * x + s.domain.gravity[1] * y);
    out.momentum_x += m * u;
    out.momentum_y += m * w;
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
  auto fields = impl_->engine->kept();
  std::sort(fields.begin(), fields.end(), [](auto& a, auto& b) { return a.name < b.name; });
  const auto order = order_by_id(fluid());
  Sha256 sha;
  for (const auto& field : fields)
    for (const std::size_t i : order)
      sha.add(field.data + i * field.bytes_per_particle, field.bytes_per_particle);
  return sha.hex();
}

}  // namespace freshet
