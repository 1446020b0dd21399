// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "freshet/vector.h"

namespace freshet {

class Simulation;

/// What a probe of a scene measures at one time.
struct ProbeReading {
  struct Quantity {
    std::string name, unit;
  };
  std::string name;  ///< Scene::Probe::name, or "probe_k"
  std::vector<Quantity> quantities;
  std::vector<Vector> places;               ///< [m]; empty vectors for surface and wall probes
  std::vector<std::vector<double>> values;  ///< by place, then by quantity; NaN outside the fluid
};

/// The present readings of all probes of the simulation's scene, in its order. They have the values
/// of a run's tables for the same state. docs/tables.md lists the quantities.
std::vector<ProbeReading> read_probes(const Simulation& simulation);

}  // namespace freshet
