// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "freshet/checkpoint.h"
#include "freshet/derived.h"
#include "freshet/particles.h"
#include "freshet/simulation.h"
#include "sim/look.h"

namespace freshet {

class Bodies;

/// What is known about a run when its health monitor finds a problem.
struct Evidence {
  const Scene& scene;
  const Derived& derived;
  const WatchRecord& record;
  const ParticleView& fluid;
  const Look& look;
  const Bodies* bodies;  ///< null without bodies
  double time;           ///< [s]
  double
      reference_speed;  ///< the fastest that the scene itself makes its fluid or its solids [m/s]
};

/// A cause of problems. `find` returns what happens and the remedy where the cause applies.
struct Cause {
  const char* name;
  std::optional<std::string> (*find)(const Evidence&);
};

/// All causes, in the order in which they are tried. docs/when_it_goes_wrong.md lists them.
const std::vector<Cause>& causes();
/// The first cause that applies; null, and `words` as it was, if none does.
const Cause* find_cause(const Evidence& evidence, std::string& words);

/// What to do where the pressure does not hold the density of a flow of `speed` [m/s].
std::string too_soft(const Scene& scene, const Derived& derived, double speed);
/// The key that sets the time step.
const char* step_key(const Scene& scene);

}  // namespace freshet
