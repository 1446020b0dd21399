// SPDX-License-Identifier: MIT
#pragma once
#include <freshet/simulation.h>

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "python/src/arrays.h"

namespace freshet::python {

/// The fields of the fluid that Python sees as arrays.
enum class Field { id, x, v, density, pressure, liquid };

/// A simulation that Python threads share. One thread at a time uses it; others wait without the
/// GIL. Arrays of the fluid stay valid and unchanged: before the fluid changes, the memory of those
/// that Python still holds becomes their own (Simulation::keep).
class Sim {
 public:
  Sim(Scene scene, const Execution& execution);
  ~Sim() { leave_arrays(); }
  Sim(const Sim&) = delete;
  Sim& operator=(const Sim&) = delete;

  /// Holds the simulation for this thread; Ctrl-C ends the wait for another one. Throws Error if
  /// the thread is within a step.
  class Access {
   public:
    explicit Access(Sim& sim);
    ~Access();
    Access(const Access&) = delete;
    Access& operator=(const Access&) = delete;
    Simulation* operator->() const { return sim_.simulation_.get(); }
    Simulation& operator*() const { return *sim_.simulation_; }

   private:
    Sim& sim_;
  };

  /// A field of the fluid as it is now.
  py::array field(Field field);
  /// Access for a call that changes the fluid: gives Python its arrays first.
  class Change : public Access {
   public:
    explicit Change(Sim& sim) : Access(sim) { sim.leave_arrays(); }
  };

  /// Takes steps until `done` without the GIL, and handles signals between them. Returns the number
  /// of steps.
  std::int64_t step_while(const std::function<bool(const Simulation&, std::int64_t)>& more);

  /// Sets the caller's force; None removes it.
  void set_force(py::object force);
  py::object force;  ///< a Python function, or null; visited by the garbage collector

 private:
  /// What an array refers to: the simulation, or the memory that it left to the array.
  struct Hold {
    std::shared_ptr<Simulation> simulation;
    std::shared_ptr<const void> memory;
  };
  struct Slot {
    std::weak_ptr<Hold> hold;
    const void* array = nullptr;
  };
  template <class T> py::array shared_array(Slot& slot, std::span<const T> numbers, int width);
  void leave_arrays();
  bool try_lock();

  std::shared_ptr<Simulation> simulation_;
  std::array<Slot, 6> slots_;
  std::timed_mutex mutex_;
  std::atomic<std::thread::id> user_;
};

}  // namespace freshet::python
