// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "freshet/checkpoint.h"
#include "freshet/derived.h"
#include "freshet/report.h"
#include "freshet/simulation.h"
#include "sim/causes.h"
#include "sim/look.h"

namespace freshet {

class Bodies;

/// When a look is taken.
struct Moment {
  std::int64_t step = 0;    ///< how many were taken
  double time = 0, dt = 0;  ///< [s]; dt is the last step
};

/// Watches over a run and never changes it. docs/when_it_goes_wrong.md tells the rules, and why
/// their bounds are where they are.
///
/// A doubt becomes a warning when it is first seen. A warning says that the run cannot be right
/// where it went beyond a second, fatal bound, or held over more than half of the steps. Beyond a
/// fatal bound most rules end the run, unless checks.when_wrong is `warn`; a particle that is lost
/// ends it always.
class Health {
 public:
  /// Keeps the references and `bodies`, which is null without bodies. `start` is the fluid before
  /// the first step.
  Health(const Scene& scene, const Derived& derived, const ParticleView& start,
         const Bodies* bodies = nullptr);

  /// Whether to look after this step: soon at first, where most goes wrong, then so seldom that it
  /// costs nothing.
  static bool due(std::int64_t step) {
    return step <= 100 ? step % 10 == 0 || step == 1 : step % 100 == 0;
  }
  /// Throws Error (kind run) where the run has to end. `solves` are those of the run so far.
  /// `bounds` is asked where the step is fixed, and for the cause of a doubt.
  void look(const Moment& now, const ParticleView& fluid,
            const std::vector<SolveStatistics>& solves,
            const std::function<TimeStepBounds()>& bounds);
  /// After a look: warns of whitewater that was not born for lack of room.
  void look_at_whitewater(const WhitewaterView& whitewater);
  /// A shorter adaptive step is none: a run of such steps would not end [s].
  double least_step() const { return 1e-9 * scene_.time.end; }
  /// The adaptive step, now.dt, fell to that.
  [[noreturn]] void fail_for_step(const Moment& now, const ParticleView& fluid,
                                  const TimeStepBounds& bounds);

  /// Throws as look does if a particle is lost; remembers nothing.
  void look_for_lost(const Moment& now, const ParticleView& fluid);

  /// The caller changed forces or particles: speed and energy are not judged any more.
  void note_intervention() { intervened_ = true; }

  const std::vector<Warning>& warnings() const { return record_.warnings; }
  const WatchRecord& record() const { return record_; }
  /// Goes on where the watch of a checkpoint ended.
  void go_on(WatchRecord record) { record_ = std::move(record); }

 private:
  static constexpr double step_reserve = 1.25;  ///< a fixed step may be so much over its bound

  struct Rule;
  template <class Message> void judge(const Rule& rule, double value, Message message) {
    judge(rule, value, steps_since_last(), message);
  }
  /// `steps`: in how many of those since the last look it was so.
  template <class Message>
  void judge(const Rule& rule, double value, std::int64_t steps, Message message);
  void see(const Moment& now, const ParticleView& fluid);
  void judge_step(const TimeStepBounds& bounds);
  void judge_walls(std::size_t particles);
  void judge_density();
  void judge_speed();
  void judge_energy();
  void judge_stillness();
  void judge_solves(const std::vector<SolveStatistics>& solves,
                    const std::function<TimeStepBounds()>& bounds);
  void expect_flows(const ParticleView& start);
  [[noreturn]] void fail_for_lost() const;
  std::int64_t steps_since_last() const;

  double energy_available() const;
  double sound_speed() const;
  double reference_speed() const;
  std::string when() const;
  std::string place(const Witness& particle) const;
  std::string fastest(const Witness& particle) const;
  std::string last_fastest() const;
  const char* reference() const;
  double times_reference(double speed) const;
  std::string not_solved(const SolveStatistics& solve, const TimeStepBounds& bounds) const;
  std::string came_too_close() const;
  /// What the first cause that applies says; else `words`.
  std::string cause(std::string words) const;

  const Scene& scene_;
  const Derived& derived_;
  const Bodies* bodies_;
  std::function<Look(const ParticleView&)> look_at_;
  double start_speed_ = 0;                         // the fastest at the start [m/s]
  double start_energy_ = 0, start_available_ = 0;  // of a mean particle [J/kg]
  double drive_speed_ = 0;                         // of moved bodies and sliding walls [m/s]
  double still_depth_ = 0;                         // of still water; 0: the fluid may move [m]
  ParticleView fluid_;                             // at the health check
  Look now_;
  Moment moment_;
  bool intervened_ = false;
  WatchRecord record_;
};

}  // namespace freshet
