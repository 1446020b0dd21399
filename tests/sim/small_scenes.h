// SPDX-License-Identifier: MIT
/// Simulations of small scenes for tests.
#pragma once
#include <string>

#include "freshet/simulation.h"

namespace freshet::test {

inline Simulation simulation_of(const std::string& text, const std::string& backend = "cpu",
                                const Execution& execution = {}) {
  return Simulation(parse_scene(text, "test.toml", {{"solver.backend", backend}}), execution);
}

/// The instruction sets that both this build and this machine have.
inline std::vector<std::string> instruction_sets() {
  std::vector<std::string> all;
  for (const char* isa : {"plain", "sse42", "avx2", "avx512"}) {
    try {
      all.push_back(instruction_set(isa));
    } catch (const Error&) {  // not in this build, or not on this machine
    }
  }
  return all;
}

}  // namespace freshet::test
