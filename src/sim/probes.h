// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "freshet/simulation.h"

namespace freshet {

/// Measures the fluid at the probes of a scene, or where bodies have carried them. Never changes
/// it.
///
/// At a place r, with the cubic spline W of the particles' support and their volume V at rest:
///
///   fraction   sum_j V W(r - x_j) over the kernel's lattice sum: 1 inside, about 1/2 at a surface
///   a field q  sum_j q_j W / sum_j W  [Shepard 1968], NaN where the fraction is below 0.05
///   surface    distance from `from` of the furthest place towards `to` with a fraction of 1/2
///   wall       Simulation::tractions of the rectangle, along the axes of the body that carries it
///
/// A place's sum runs in the order of the particles' ids: the same bits on every backend.
class Probes {
 public:
  /// Keeps a reference to the scene.
  explicit Probes(const Scene& scene);
  ~Probes();
  Probes(Probes&&) noexcept;

  /// A quantity that a probe measures.
  struct Quantity {
    std::string name, unit;
  };
  /// One place of a probe at one time. A surface or wall probe has no coordinates in its table.
  struct Reading {
    Vector place;                ///< [m]
    std::vector<double> values;  ///< one per quantity; NaN outside the fluid
  };

  std::size_t size() const;
  std::vector<Quantity> quantities(std::size_t k) const;
  /// The readings of each probe now.
  std::vector<std::vector<Reading>> measure(const Simulation& sim);

  /// The line of names of the k-th probe's table.
  std::string header(std::size_t k) const;
  /// A line of a probe's table. Lines end with '\n', also the header.
  static std::string line(double time, const Reading& reading);
  /// The readings of each probe now, as lines of its table.
  std::vector<std::string> look(const Simulation& sim);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// "probes/NAME.csv": the k-th probe's table, in the folder of a run.
std::string probe_file(const Scene& scene, std::size_t k);

}  // namespace freshet
