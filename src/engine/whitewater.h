// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "boundary/confinement.h"
#include "boundary/wall_sets.h"
#include "engine/plan.h"
#include "freshet/whitewater.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D, class B> class Store;

/// Spray, foam and bubbles: a set of particles that the fluid moves and that does not act on it.
/// It is compiled once per backend and dimension, in a file of its own.
template <int D, class B> class Whitewater {
 public:
  virtual ~Whitewater() = default;
  /// Adds the set and the fields that it needs of the fluid.
  virtual void fields(Store<D, B>& store) = 0;
  /// After a step of dt whose neighbours of the fluid are still listed: advances the set, if the
  /// fluid has moved far enough since the last time.
  virtual void step(B& backend, const FluidParticles<D>& fluid, const Walls<D>& walls,
                    const Confinement<D>& confine, Vec<D, double> gravity, double dt) = 0;
  virtual WhitewaterView view(const Triple& origin) const = 0;
  /// Resizes the set to n particles, whose state the caller writes.
  virtual void resize(B& backend, std::int64_t n) = 0;
};

/// Makes the whitewater of a plan; null if it has none. It is defined in one file per backend and
/// dimension, made from instantiate/whitewater.cpp.in.
template <int D, class B> std::unique_ptr<Whitewater<D, B>> make_whitewater(const EnginePlan& plan);

}  // namespace FRESHET_ISA
}  // namespace freshet
