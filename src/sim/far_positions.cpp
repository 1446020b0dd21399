// SPDX-License-Identifier: MIT
#include "sim/far_positions.h"

namespace freshet {

void FarPositions::convert(const ParticleView& view) {
  const auto d = std::size_t(view.dimension);
  shown_.resize(view.offset.size());
  for (std::size_t k = 0; k < shown_.size(); ++k) shown_[k] = Real(view.position(k / d, k % d));
}

ParticleView FarPositions::in_scene(ParticleView view) {
  if (view.offset.empty()) return view;
  convert(view);
  view.x = shown_;
  return view;
}

std::span<Real> FarPositions::edit(Engine& engine) {
  const ParticleView view = engine.fluid();
  if (view.offset.empty()) return engine.positions();
  convert(view);
  before_ = shown_;
  edited_ = true;
  return shown_;
}

void FarPositions::write_back(Engine& engine) {
  if (!edited_) return;
  const ParticleView view = engine.fluid();
  const auto d = std::size_t(view.dimension);
  const std::span<Real> x = engine.positions();
  for (std::size_t k = 0; k < shown_.size(); ++k)
    if (shown_[k] != before_[k]) x[k] = Real(double(shown_[k]) - view.origin[k % d]);
  convert(view);  // the engine may have sorted the particles
  before_ = shown_;
}

}  // namespace freshet
