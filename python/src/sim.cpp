// SPDX-License-Identifier: MIT
#include "python/src/sim.h"

#include <chrono>

namespace freshet::python {
namespace {

constexpr auto between_signals = std::chrono::milliseconds(50);

}  // namespace

Sim::Sim(Scene scene, const Execution& execution) {
  const py::gil_scoped_release release;
  simulation_ = std::make_shared<Simulation>(std::move(scene), execution);
}

Sim::Access::Access(Sim& sim) : sim_(sim) {
  if (sim.user_ == std::this_thread::get_id())
    throw Error(Error::Kind::scene, "",
                "the simulation is within a step; use the arguments of the force, or read the "
                "simulation after the step");
  while (!sim.try_lock())
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  sim.user_ = std::this_thread::get_id();
}
bool Sim::try_lock() {
  if (mutex_.try_lock()) return true;
  const py::gil_scoped_release release;  // the thread that holds the simulation may need it
  return mutex_.try_lock_for(between_signals);
}

Sim::Access::~Access() {
  sim_.user_ = std::thread::id();
  sim_.mutex_.unlock();
}

template <class T> py::array Sim::shared_array(Slot& slot, std::span<const T> numbers, int width) {
  auto hold = slot.hold.lock();
  if (!hold) {
    hold = std::make_shared<Hold>();
    hold->simulation = simulation_;
    slot.hold = hold;
    slot.array = numbers.data();
  }
  const py::capsule owner(new std::shared_ptr<Hold>(std::move(hold)),
                          [](void* held) { delete static_cast<std::shared_ptr<Hold>*>(held); });
  return array_over(numbers, width, owner);
}

py::array Sim::field(Field field) {
  const Access sim(*this);
  const ParticleView f = sim->fluid();
  Slot& slot = slots_[std::size_t(field)];
  const bool far = !f.offset.empty(), several = !f.liquid.empty();
  switch (field) {
    case Field::id:
      return shared_array(slot, f.id, 0);
    case Field::x:  // far from 0 it is a conversion, which the next call replaces
      return far ? array_of(f.x, f.dimension) : shared_array(slot, f.x, f.dimension);
    case Field::v:
      return shared_array(slot, f.v, f.dimension);
    case Field::density:  // of several liquids it is a conversion, too
      return several ? array_of(f.density) : shared_array(slot, f.density, 0);
    case Field::pressure:
      return shared_array(slot, f.pressure, 0);
    default:
      return shared_array(slot, f.liquid, 0);
  }
}

void Sim::leave_arrays() {
  for (Slot& slot : slots_) {
    if (const auto hold = slot.hold.lock()) {
      hold->memory = simulation_->keep(slot.array);
      if (hold->memory) hold->simulation.reset();  // else the simulation has no memory to free
    }
    slot = {};
  }
}

std::int64_t Sim::step_while(const std::function<bool(const Simulation&, std::int64_t)>& more) {
  using Clock = std::chrono::steady_clock;
  const Change sim(*this);
  const py::gil_scoped_release release;
  auto next = Clock::now() + between_signals;
  std::int64_t steps = 0;
  while (more(*sim, steps)) {
    sim->step();
    ++steps;
    if (Clock::now() < next) continue;
    const py::gil_scoped_acquire acquire;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    next = Clock::now() + between_signals;
  }
  return steps;
}

}  // namespace freshet::python
