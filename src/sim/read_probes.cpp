// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "freshet/probe_reading.h"
#include "sim/probes.h"

namespace freshet {

std::vector<ProbeReading> read_probes(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  if (scene.probe.empty()) return {};
  Probes probes(scene);
  std::vector<ProbeReading> all;
  for (const auto& readings : probes.measure(simulation)) {
    const std::size_t k = all.size();
    ProbeReading probe;
    probe.name = scene.probe[k].name.empty() ? fmt::format("probe_{}", k) : scene.probe[k].name;
    for (Probes::Quantity& q : probes.quantities(k)) probe.quantities.push_back({q.name, q.unit});
    for (const Probes::Reading& reading : readings) {
      probe.places.push_back(reading.place);
      probe.values.push_back(reading.values);
    }
    all.push_back(std::move(probe));
  }
  return all;
}

}  // namespace freshet
