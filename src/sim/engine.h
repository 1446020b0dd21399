// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "freshet/report.h"
#include "freshet/scene.h"
#include "freshet/simulation.h"
#include "scene/setup.h"

namespace freshet {

/// A solver on a backend, as the simulation sees it: no template, no instruction set, no threads.
class Engine {
 public:
  /// A kept field, `bytes_per_particle` each, in the order of the particles.
  struct KeptField {
    std::string name;
    const std::byte* data;
    std::size_t bytes_per_particle;
  };
  virtual ~Engine() = default;
  virtual void step() = 0;
  virtual ParticleView fluid() const = 0;
  virtual const std::vector<VerbTiming>& timings() const = 0;
  virtual std::vector<KeptField> kept() const = 0;
};

/// One per solver, dimension and backend; each stands in a file of its own.
std::unique_ptr<Engine> make_reference_mueller2003_2d(const Scene&, const Derived&, const Sample&);

}  // namespace freshet
