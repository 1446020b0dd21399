// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "freshet/simulation.h"

namespace freshet {

/// Reads the fluid where the scene's probes stand, or bodies have carried them, and never changes
/// it.
///
/// At a place r, with the cubic spline W of the particles' support and their volume V at rest:
///
///   fraction   sum_j V W(r - x_j) over the kernel's lattice sum: 1 inside, about 1/2 at a surface
///   a field q  sum_j q_j W / sum_j W  [Shepard 1968], no number where the fraction is below 0.05
///   surface    how far from `from` towards `to` the furthest place with a fraction of 1/2 is
///   wall       Simulation::tractions of the rectangle; what a body carries along the body's axes
///
/// A place's sum runs in the order of the particles' ids: the same bits on every backend.
class Probes {
 public:
  /// Keeps a reference to the scene.
  explicit Probes(const Scene& scene);
  ~Probes();
  Probes(Probes&&) noexcept;

  std::size_t size() const;
  /// The line of names of the k-th probe's table.
  std::string header(std::size_t k) const;
  /// What each probe tells of the simulation now, as lines of its table.
  std::vector<std::string> look(const Simulation& sim);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// "probes/NAME.csv": the k-th probe's table, in the folder of a run.
std::string probe_file(const Scene& scene, std::size_t k);

}  // namespace freshet
