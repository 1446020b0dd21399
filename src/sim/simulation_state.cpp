// SPDX-License-Identifier: MIT
/// A simulation's state: as frames and digests, and checkpoints out and in.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <new>
#include <numeric>
#include <span>

#include "core/check_checkpoint.h"
#include "core/sha256.h"
#include "freshet/checkpoint.h"
#include "scene/keys/same_steps.h"
#include "sim/check_restored.h"
#include "sim/simulation_impl.h"

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

static_assert(std::endian::native == std::endian::little, "digests are over little-endian numbers");

}  // namespace

/// Without the arrays of sets that nothing is in.
std::vector<StateArray> Simulation::Impl::state() const {
  auto all = engine().state();
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

Frame Simulation::frame() const {
  const ParticleView f = fluid();
  const auto D = std::size_t(f.dimension), n = f.size();
  Frame out{f.dimension, impl_->steps, impl_->time, {}, {}, {}, {}, {}, {}, bodies(), {}};
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
      out.x[D * k + d] = float(f.position(i, d));
      out.v[D * k + d] = float(f.v[D * i + d]);
    }
    out.density[k] = float(f.density[i]);
    out.pressure[k] = float(f.pressure[i]);
    if (!f.liquid.empty()) out.liquid.push_back(f.liquid[i]);
  }
  out.whitewater = impl_->whitewater_frame();
  return out;
}

namespace {
/// A coordinate on an axis that a path beyond a closed or a periodic side has led to.
double in_domain(const Scene& scene, double x, std::size_t axis) {
  const double low = scene.domain.min[axis], high = scene.domain.max[axis];
  if (scene.periodic(int(axis)))
    return x < low ? x + (high - low) : x >= high ? x - (high - low) : x;
  if (x < low && !scene.is_open(int(2 * axis))) return low;
  return x > high && !scene.is_open(int(2 * axis + 1)) ? high : x;
}
}  // namespace

WhitewaterFrame Simulation::Impl::whitewater_frame() const {
  const WhitewaterView from = engine().whitewater();
  const auto D = std::size_t(from.dimension);
  WhitewaterFrame out;
  for (const std::size_t i : order_by_id(from.id)) {
    out.id.push_back(from.id[i]);
    for (std::size_t d = 0; d < D; ++d) {
      out.x.push_back(float(in_domain(scene, from.position(i, d), d)));
      out.v.push_back(float(from.v[D * i + d]));
    }
    out.kind.push_back(from.kind[i]);
    out.age.push_back(float(double(from.age[i]) + from.elapsed));
  }
  return out;
}

std::string Simulation::state_sha256() const {
  const ParticleView f = impl_->engine().fluid();
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
  i.refuse_shown("checkpoint");
  i.health->look_for_lost({i.steps, i.time, i.time_steps.last}, i.engine().fluid());
  Checkpoint c;
  c.scene = scene().source;
  c.steps = impl_->steps;
  c.time = impl_->time;
  c.watch = impl_->health->record();
  c.edited = impl_->edited;
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
  explicit Resized(Engine& engine)
      : engine_(engine), n_(engine.fluid().size()), whitewater_(engine.whitewater().size()) {}
  void to(std::int64_t n, std::int64_t whitewater) {
    if (n == n_ && whitewater == whitewater_) return;
    for (const StateArray& a : engine_.state()) before_.emplace_back(a.data, a.data + a.bytes());
    if (n != n_) engine_.resize(n);
    engine_.resize_whitewater(whitewater);
  }
  ~Resized() {
    if (before_.empty()) return;
    try {
      engine_.resize(n_);
      engine_.resize_whitewater(whitewater_);
      std::size_t k = 0;
      for (const StateArray& a : engine_.state()) {
        std::copy(before_[k].begin(), before_[k].end(), a.data);
        ++k;
      }
    } catch (const std::bad_alloc&) {  // the error that brought us here is the one to report
    }
  }
  void keep() { before_.clear(); }

 private:
  Engine& engine_;
  std::int64_t n_, whitewater_;
  std::vector<std::vector<std::byte>> before_;
};

void Simulation::restore(const Checkpoint& c) {
  check_checkpoint(c);
  impl_->end_edit();
  const auto count = [&](std::string_view name) {
    const auto ids = std::find_if(c.arrays.begin(), c.arrays.end(),
                                  [&](const StateArray& a) { return a.name == name; });
    return ids == c.arrays.end() ? 0 : ids->count;
  };
  const auto here = std::int64_t(impl_->engine().fluid().size());
  const bool resizes = impl_->scene.has_flows() || impl_->edited || impl_->shown || c.edited;
  Impl::Resized resized(impl_->engine());
  resized.to(resizes ? count("fluid/id") : here,
             impl_->scene.whitewater ? count("whitewater/id") : 0);
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
  for (const StateArray& b : c.arrays)
    if (std::none_of(state.begin(), state.end(),
                     [&](const StateArray& a) { return a.name == b.name; }))
      refuse(fmt::format("it has {}, which this scene does not have; was it of another solver?",
                         b.name));
  if (c.walls_sha256 != impl_->state_digest(StateArray::Role::fixed))
    refuse("its walls are others; has a file of points changed?");
  check_restored(c, impl_->scene);
  if (const std::string& here_as_text = impl_->scene.source;
      !c.scene.empty() && !here_as_text.empty())
    if (const std::string key =
            differing_key(c.scene, "scene.toml of the checkpoint", here_as_text, "scene");
        !key.empty())
      refuse(fmt::format("{} differs; restore it into a simulation of its own scene", key));
  for (const StateArray& a : state) {
    const auto it = stored(a);
    std::copy(it->bytes.begin(), it->bytes.end(), a.data);
  }
  resized.keep();
  impl_->engine().continue_from(c.steps);
  impl_->steps = c.steps;
  impl_->time = c.time;
  impl_->health->go_on(c.watch);
  impl_->edited = c.edited;
  impl_->shown = false;
  impl_->time_steps = c.time_steps;
  impl_->solves = c.solves;
  impl_->retries_help = c.retries_help;
}

void Simulation::Impl::refuse_shown(const char* what) const {
  if (shown)
    throw Error(Error::Kind::scene, what,
                "the simulation shows a frame, which is not the whole state of its solver; restore "
                "a checkpoint first, or make another simulation");
}

void Simulation::show(const Frame& frame) {
  Impl& i = *impl_;
  const auto refuse = [](std::string why) {
    throw Error(Error::Kind::scene, "frame", std::move(why));
  };
  const auto D = std::size_t(i.scene.dimension()), n = frame.size();
  if (frame.dimension != i.scene.dimension())
    refuse(fmt::format("the frame is in {}D and the scene in {}D; show a frame of this scene",
                       frame.dimension, i.scene.dimension()));
  if (frame.x.size() != D * n || frame.v.size() != D * n || frame.density.size() != n ||
      frame.pressure.size() != n)
    refuse("its fields have not as many particles as it has ids; give each field a value each");
  if (frame.bodies.size() != i.scene.body.size())
    refuse(fmt::format("the frame has {} bodies and the scene {}; show a frame of this scene",
                       frame.bodies.size(), i.scene.body.size()));
  const int liquids = int(i.scene.liquids().size());
  if (liquids > 1 && frame.liquid.size() != n)
    refuse(fmt::format("the frame has no liquids and the scene {}; show a frame of this scene",
                       liquids));
  if (std::any_of(frame.liquid.begin(), frame.liquid.end(),
                  [&](int k) { return k < 0 || k >= liquids; }))
    refuse(
        fmt::format("a particle of the frame is of a liquid beyond the {} of the scene; show a "
                    "frame of this scene",
                    liquids));
  i.end_edit();
  i.shown = true;
  const Scene::Time& time = i.scene.time;
  i.engine().show(frame, 1e-3 * (time.adaptive ? time.step_max.value_or(1e-3) : time.step));
  i.steps = frame.step;
  i.time = frame.time;
}

std::string Simulation::kept_sha256() const { return impl_->state_digest(StateArray::Role::kept); }

}  // namespace freshet
