// SPDX-License-Identifier: MIT
#include "sim/probes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "core/text.h"
#include "freshet/units.h"
#include "kernels/cubic_spline.h"
#include "kernels/lattice_sum.h"
#include "scene/model/probe_patch.h"
#include "scene/sample/places.h"
#include "sim/probe_places.h"

namespace freshet {

/// The fluid at a point.
struct FluidReading {
  double fraction = 0, density = 0, pressure = 0;
  std::array<double, 3> velocity{};
};

/// Interpolates the fluid at its points.
class FluidReader {
 public:
  virtual ~FluidReader() = default;
  virtual void stand_at(const std::vector<std::vector<Vector>>& places) = 0;
  virtual std::vector<FluidReading> read(const ParticleView& fluid) const = 0;
};

namespace {

constexpr double least_fraction = 0.05, surface_fraction = 0.5;

template <int D> class FluidReaderIn final : public FluidReader {
 public:
  explicit FluidReaderIn(const Scene& s)
      : support_(support_radius(s)),
        W_(Real(support_)),
        volume_(std::pow(s.particles.spacing, D) /
                lattice_sum<D>(W_, s.particles.spacing, support_)),
        shifts_(periodic_shifts<D>(s)) {}

  void stand_at(const std::vector<std::vector<Vector>>& probes) override {
    near_.clear();
    count_ = 0;
    for (const auto& places : probes)
      for (const Vector& place : places) {
        for (const Vec<D, double>& shift : shifts_) add(vec_of<D>(place) + shift, count_);
        ++count_;
      }
  }

  std::vector<FluidReading> read(const ParticleView& f) const override {
    std::vector<std::vector<Share>> shares(count_);
    for (std::size_t i = 0; i < f.size(); ++i) {
      Vec<D, double> x{};
      for (std::size_t d = 0; d < D; ++d) component(x, int(d)) = f.position(i, d);
      const auto near = near_.find(cell_of(x));
      if (near == near_.end()) continue;
      for (const Place& place : near->second) {
        Vec<D> r{};
        auto apart = place.x - x;
        for (int d = 0; d < D; ++d) component(r, d) = Real(component(apart, d));
        const double W = double(W_(Pair<D, Real>(r)));
        if (W > 0) shares[place.number].push_back({f.id[i], i, W});
      }
    }
    std::vector<FluidReading> all;
    for (auto& list : shares) all.push_back(sum(list, f));
    return all;
  }

 private:
  struct Place {
    Vec<D, double> x;
    std::size_t number;
  };
  struct Share {
    std::uint64_t id;
    std::size_t i;
    double W;
  };
  using Cell = std::array<std::int64_t, D>;

  Cell cell_of(Vec<D, double> x) const {
    Cell cell;
    for (int d = 0; d < D; ++d)
      cell[std::size_t(d)] =
          std::int64_t(std::floor(std::clamp(component(x, d) / support_, -1e18, 1e18)));
    return cell;
  }
  /// Into all cells that particles within the support of it can be in.
  void add(Vec<D, double> x, std::size_t number) {
    const Cell center = cell_of(x);
    for (int n = 0; n < (D == 3 ? 27 : 9); ++n) {
      Cell cell = center;
      cell[0] += n % 3 - 1;
      cell[1] += n / 3 % 3 - 1;
      if (D == 3) cell[D - 1] += n / 9 - 1;
      near_[cell].push_back({x, number});
    }
  }
  FluidReading sum(std::vector<Share>& shares, const ParticleView& f) const {
    std::sort(shares.begin(), shares.end(),
              [](const Share& a, const Share& b) { return a.id < b.id; });
    FluidReading r;
    double all = 0;
    for (const Share& share : shares) {
      all += share.W;
      r.density += share.W * double(f.density[share.i]);
      r.pressure += share.W * double(f.pressure[share.i]);
      for (std::size_t d = 0; d < D; ++d) r.velocity[d] += share.W * double(f.v[D * share.i + d]);
    }
    r.fraction = volume_ * all;
    const double per =
        r.fraction < least_fraction ? std::numeric_limits<double>::quiet_NaN() : 1 / all;
    r.density *= per;
    r.pressure *= per;
    for (double& v : r.velocity) v *= per;
    return r;
  }

  double support_;
  CubicSpline<D> W_;
  double volume_;
  std::vector<Vec<D, double>> shifts_;
  std::size_t count_ = 0;
  std::map<Cell, std::vector<Place>> near_;
};

std::string number(double a) { return std::isnan(a) ? "nan" : fmt::format("{:.9g}", a); }

/// The furthest place along the line with half of the fluid there, between two of them where the
/// fraction falls through it.
double reach(const Scene::Probe& p, const std::vector<FluidReading>& readings) {
  double length2 = 0;
  for (std::size_t d = 0; d < p.from.size(); ++d)
    length2 += (p.to[d] - p.from[d]) * (p.to[d] - p.from[d]);
  const double step = std::sqrt(length2) / double(readings.size() - 1);
  for (std::size_t k = readings.size(); k-- > 0;) {
    const double here = readings[k].fraction;
    if (here < surface_fraction) continue;
    if (k + 1 == readings.size()) return step * double(k);
    const double next = readings[k + 1].fraction;
    return step * (double(k) + (here - surface_fraction) / (here - next));
  }
  return 0;
}

/// A traction along the axes of the scene, or of the body at the start, from that along the axes of
/// the probe's piece of wall.
Vector along_axes(const Scene::Probe& probe, const Vector& on_patch) {
  const WallPatch patch = patch_of(probe);
  Vector all(on_patch.size(), 0.0);
  for (std::size_t k = 0; k < on_patch.size(); ++k)
    for (std::size_t d = 0; d < all.size(); ++d) all[d] += on_patch[k] * patch.axes[k][d];
  return all;
}

std::vector<Probes::Reading> field_readings(const std::vector<Vector>& at,
                                            const std::vector<FluidReading>& readings) {
  std::vector<Probes::Reading> all;
  for (std::size_t n = 0; n < readings.size(); ++n) {
    Probes::Reading reading{at[n], {readings[n].fraction}};
    for (std::size_t d = 0; d < at[n].size(); ++d)
      reading.values.push_back(readings[n].velocity[d]);
    reading.values.push_back(readings[n].density);
    reading.values.push_back(readings[n].pressure);
    all.push_back(std::move(reading));
  }
  return all;
}

}  // namespace

struct Probes::Parts {
  const Scene& scene;
  ProbePlaces places;
  std::unique_ptr<FluidReader> reader;
};

Probes::Probes(const Scene& scene)
    : parts_(std::make_unique<Parts>(Parts{scene, ProbePlaces(scene), nullptr})) {
  if (scene.dimension() == 2) parts_->reader = std::make_unique<FluidReaderIn<2>>(scene);
  else parts_->reader = std::make_unique<FluidReaderIn<3>>(scene);
  parts_->reader->stand_at(parts_->places.at_the_start());
}
Probes::~Probes() = default;
Probes::Probes(Probes&&) noexcept = default;

std::size_t Probes::size() const { return parts_->places.at_the_start().size(); }

std::vector<Probes::Quantity> Probes::quantities(std::size_t k) const {
  const Scene& s = parts_->scene;
  const Units units = units_in(s.dimension());
  if (s.probe[k].kind == ProbeKind::surface) return {{"distance", units.length}};
  std::vector<Quantity> all;
  if (s.probe[k].kind == ProbeKind::wall) {
    for (int d = 0; d < s.dimension(); ++d)
      all.push_back({fmt::format("traction {}", axis_letters[d]), units.pressure});
    return all;
  }
  all.push_back({"fraction", ""});
  for (int d = 0; d < s.dimension(); ++d)
    all.push_back({fmt::format("velocity {}", axis_letters[d]), units.speed});
  all.push_back({"density", units.density});
  all.push_back({"pressure", units.pressure});
  return all;
}

std::string Probes::header(std::size_t k) const {
  const Scene& s = parts_->scene;
  std::string line = "time [s]";
  if (s.probe[k].kind != ProbeKind::surface && s.probe[k].kind != ProbeKind::wall)
    for (int d = 0; d < s.dimension(); ++d) line += fmt::format(",{} [m]", axis_letters[d]);
  for (const Quantity& q : quantities(k))
    line += q.unit.empty() ? "," + q.name : fmt::format(",{} [{}]", q.name, q.unit);
  return line + "\n";
}

std::vector<std::vector<Probes::Reading>> Probes::measure(const Simulation& sim) {
  const auto bodies = sim.bodies();
  const auto at = parts_->places.now(bodies);
  if (parts_->places.move()) parts_->reader->stand_at(at);
  const auto readings = parts_->reader->read(sim.fluid());
  const auto patches = parts_->places.patches(bodies);
  const auto tractions = patches.empty() ? std::vector<Vector>() : sim.tractions(patches);
  std::vector<std::vector<Reading>> all;
  auto from = readings.begin();
  auto traction = tractions.begin();
  for (std::size_t k = 0; k < size(); ++k) {
    const std::vector<FluidReading> own(from, from + std::ptrdiff_t(at[k].size()));
    from += std::ptrdiff_t(at[k].size());
    const Scene::Probe& probe = parts_->scene.probe[k];
    if (probe.kind == ProbeKind::wall) all.push_back({{{}, along_axes(probe, *traction++)}});
    else if (probe.kind == ProbeKind::surface) all.push_back({{{}, {reach(probe, own)}}});
    else all.push_back(field_readings(at[k], own));
  }
  return all;
}

std::string Probes::line(double time, const Reading& reading) {
  std::string line = fmt::format("{:.9g}", time);
  for (const double x : reading.place) line += fmt::format(",{:.9g}", x);
  for (const double value : reading.values) line += "," + number(value);
  return line + "\n";
}

std::vector<std::string> Probes::look(const Simulation& sim) {
  std::vector<std::string> tables;
  for (const auto& readings : measure(sim)) {
    std::string& lines = tables.emplace_back();
    for (const Reading& reading : readings) lines += line(sim.time(), reading);
  }
  return tables;
}

std::string probe_file(const Scene& scene, std::size_t k) {
  const std::string& name = scene.probe[k].name;
  return fmt::format("probes/{}.csv", name.empty() ? fmt::format("probe_{}", k) : name);
}

}  // namespace freshet
