// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "engine/engine.h"
#include "freshet/particles.h"

namespace freshet {

/// Positions in the scene, for callers, where an engine measures them from another origin. Without
/// such an origin callers see the engine's own memory, and this does nothing.
class FarPositions {
 public:
  /// The view with positions in the scene, which are valid until the next call.
  ParticleView in_scene(ParticleView view);
  /// The positions in the scene, to be written until end_edit().
  std::span<Real> edit(Engine& engine);
  /// Writes to the engine the positions that the caller has changed since the last call.
  void write_back(Engine& engine);
  void end_edit() { edited_ = false; }

 private:
  void convert(const ParticleView& view);

  std::vector<Real> shown_, before_;  // the caller's, and as they were at the last write_back()
  bool edited_ = false;
};

}  // namespace freshet
