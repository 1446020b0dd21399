// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "freshet/frame.h"
#include "freshet/particles.h"
#include "freshet/report.h"
#include "freshet/scene.h"
#include "freshet/whitewater.h"

namespace freshet {

/// Threads and instruction set of the cpu backend. They do not change the bits of results.
struct Execution {
  int threads = 0;  ///< 0: by the number of particles, see thread_count(); at most thread_limit()
  std::string isa;  ///< "avx512", "avx2", "sse42" or "plain"; empty: the best that the machine has
};
/// The instruction set and the number of threads that Execution selects on this machine.
/// instruction_set throws Error (kind scene) for a set that the machine lacks, and thread_count for
/// more threads than thread_limit(): four times as many as the machine has, and 64 at least. For
/// `threads` = 0 it is as many as the machine has, and with `particles` at most one for every 2048
/// of them: more would wait for each other.
std::string instruction_set(const std::string& isa);
int thread_count(int threads);
int thread_count(int threads, double particles);
int thread_limit();

struct Checkpoint;  // freshet/checkpoint.h

/// A simulation in memory: no file is touched, nothing is printed.
class Simulation {
 public:
  /// Checks the scene and samples its fluid. Throws Error (kind scene) for an invalid scene.
  explicit Simulation(Scene scene, const Execution& execution = {});
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Takes one time step. Throws Error (kind run) if a health check finds an unphysical state.
  /// Health checks run after step 1, every tenth step up to 100, every hundredth step after that,
  /// and the last step. The message names the particle, its position, the time and the likeliest
  /// cause. docs/when_it_goes_wrong.md lists the bounds. The state stays readable after an
  /// exception.
  void step();

  /// Adds to the acceleration of each particle, D numbers per particle in the order of `fluid`
  /// [m/s²]. It starts as zeros.
  using Force =
      std::function<void(const ParticleView& fluid, double time, std::span<double> acceleration)>;
  /// Sets a force of the caller. First-order integrators and pressure solvers evaluate it once a
  /// step, the others at the start and at the end of the step. It limits adaptive time steps. The
  /// function must not change the simulation. An empty function removes the force. Checkpoints do
  /// not hold it: set it again after a restore. The health monitor stops judging speed and energy.
  void set_force(Force force);
  /// Changes gravity from the next step on, one number per dimension [m/s²]. Throws Error (kind
  /// scene) for another count or for infinity and NaN. Checkpoints do not hold it.
  void set_gravity(const Vector& gravity);
  /// Changes keys of the scene between steps and keeps the state: gravity, viscosities, stiffness,
  /// the speed of an inlet and others of may_change_while_running(). The steps that follow have the
  /// bits of a simulation of the changed scene that resumes from this state, so a run repeats if
  /// its changes are repeated at the same steps. Observers and the caller's forces stay; views of
  /// the fluid become invalid. Layers of an inlet keep their places when its speed changes. Throws
  /// Error (kind scene), and changes nothing, for another key, an invalid scene, a change that
  /// alters the number of liquids, or a scene made in code.
  void change(const std::vector<Override>& overrides);
  /// Pulls a free body from the next step on, until the next call: a force [N; N/m in 2D] and a
  /// torque about its centre of mass [N m; N m/m in 2D], added to gravity. In 2D the force has two
  /// components and the torque one, about z. Checkpoints do not hold it. Throws Error (kind scene)
  /// for an index without a free body or for infinity and NaN.
  void push_body(std::size_t body, const std::array<double, 3>& force,
                 const std::array<double, 3>& torque = {});
  /// Positions [m], velocities [m/s] and liquids (numbers of Scene::liquids(); empty for one) of
  /// the fluid, to be written between steps, in the order of fluid(), which stays valid. Valid
  /// until the next step.
  struct WritableParticles {
    std::span<Real> x, v;
    std::span<int> liquid;
  };
  WritableParticles edit_fluid();
  /// Adds particles between steps, at rest density: D numbers each of positions [m] and velocities
  /// [m/s] (at rest if empty), of a liquid of Scene::liquids(). Returns the id of the first; the
  /// others follow. Views of the fluid become invalid. Throws Error (kind scene) for other counts,
  /// a number that is NaN or infinite, or an unknown liquid.
  std::uint64_t add_particles(std::span<const Real> x, std::span<const Real> v = {},
                              int liquid = 0);
  /// Removes the particles with these ids. Ids are never used again. Views of the fluid become
  /// invalid. Throws Error (kind scene), and removes nothing, for an unknown or repeated id.
  void remove_particles(std::span<const std::uint64_t> ids);

  /// When an observer is called: after every `steps` steps or every `seconds` [s] of simulated
  /// time, and after the first step; `seconds` is used if both are set.
  struct ObserverSchedule {
    std::int64_t steps = 1;
    double seconds = 0;
  };
  /// Calls the observer at the end of each step that is due. It must not step the simulation.
  void observe(ObserverSchedule schedule, std::function<void(const Simulation&)> observer);

  const Scene& scene() const;
  int threads() const;  ///< of the cpu backend; 1 on the reference backend
  std::int64_t steps_done() const;
  double time() const;  ///< the sum of the steps; steps_done · time.step where it is fixed [s]
  /// Whether time.end is reached.
  bool finished() const;
  const TimeSteps& time_steps() const;
  /// Iteration counts and errors of the implicit solves; empty for a scene without one.
  const std::vector<SolveStatistics>& solves() const;
  /// The warnings so far, in the order of their first occurrence.
  const std::vector<Warning>& warnings() const;
  /// What bounds the next step, by the present state [s].
  TimeStepBounds bounds() const;
  /// Where a mean over time begins: what reflecting walls and flows have seen by now. The default
  /// Moment is the start.
  struct Moment {
    double time;                       ///< [s]
    std::vector<Vector> impulses;      ///< of the fluid on each reflecting wall [N s; N s/m in 2D]
    std::vector<std::int64_t> passed;  ///< particles through each of Scene::flow_names()
  };
  Moment moment() const;
  /// The force of the fluid on each wall, in the order of Scene::wall_names() [N; N/m in 2D]:
  /// on reflecting walls the mean since that moment, on others the present force.
  std::vector<Vector> wall_forces(const Moment& since = Moment()) const;
  /// The force of the fluid on each patch now, over its area, along its axes [Pa]: that
  /// on samples of walls and bodies within a support, each for as much of its cell as the patch
  /// covers. Throws Error (kind scene) where a vector has not as many numbers as the domain axes.
  std::vector<Vector> tractions(const std::vector<WallPatch>& patches) const;
  /// The boundary particles with the present force of the fluid on each. They add up to
  /// wall_forces() except on walls of `reflection` and `ghost`, which have none.
  BoundaryForces boundary_forces() const;
  /// What inlets added, outlets and open sides removed and counters counted, in the order of
  /// Scene::flow_names(). Rates are the mean since that moment.
  std::vector<Flow> flows(const Moment& since = Moment()) const;
  ParticleView fluid() const;
  /// Keeps an array of fluid(), named by its first element: it stays valid and unchanged as long as
  /// the returned object lives, and the simulation continues with a copy. Call it between steps.
  /// Null for an array that is a copy already, which the next call of fluid() replaces: positions
  /// of a domain far from 0, and the density of several liquids.
  std::shared_ptr<const void> keep(const void* array);
  /// The states of the rigid bodies, in the order of Scene::body.
  std::vector<BodyState> bodies() const;
  /// Spray, foam and bubbles of a scene with [whitewater].
  WhitewaterView whitewater() const;
  /// A copy of the fluid for pictures and files.
  Frame frame() const;
  /// Replaces the fluid, the bodies, the step and the time by those of a frame of this scene, to be
  /// measured. Pressures of walls follow from the fluid; what reflecting walls and flows have seen
  /// is unknown. step() and checkpoint() then throw Error (kind scene), since a frame is not the
  /// whole state of a solver, until restore(). Throws Error (kind scene) for a frame of another
  /// dimension, or with another number of bodies or liquids.
  void show(const Frame& frame);
  Statistics statistics() const;
  const std::vector<VerbTiming>& timings() const;

  /// A copy of the complete state. Throws Error (kind run) if a particle is lost: NaN, or far
  /// outside the domain.
  Checkpoint checkpoint() const;
  /// Resumes from a checkpoint, to the same bits as the run that wrote it. Throws Error (kind
  /// scene) if the checkpoint is of another scene, and Error (kind run) if a number in it is
  /// invalid; the simulation is then unchanged.
  void restore(const Checkpoint& checkpoint);

  /// SHA-256 over steps_done (u64), then id (u64), x (relative to ParticleView::origin) and v of
  /// each particle in id order, little-endian: equal states have equal sums.
  std::string state_sha256() const;
  /// SHA-256 over the kept fields (those that a restart needs), in the order of their names.
  std::string kept_sha256() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace freshet
