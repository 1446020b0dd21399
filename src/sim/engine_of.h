// SPDX-License-Identifier: MIT
/// Puts a solver onto a backend. Included by the instantiation files only.
#pragma once
#include <cstring>

#include "sim/engine.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D, class Solver, class Backend> class EngineOf final : public Engine {
 public:
  EngineOf(Backend backend, Solver solver, const Sample& sample)
      : backend_(std::move(backend)), solver_(std::move(solver)) {
    const int n = int(sample.x.size() / D);
    backend_.add_set(fluid_, n);
    allocate("id", Keep::kept, fluid_.id);
    allocate("x", Keep::kept, fluid_.x);
    allocate("v", Keep::kept, fluid_.v);
    fluid_.fields([this](const char* name, Keep keep, auto& f) { this->allocate(name, keep, f); });
    for (int i = 0; i < n; ++i) fluid_.id[i] = std::uint64_t(i);
    std::memcpy(static_cast<void*>(fluid_.x.data), sample.x.data(), sample.x.size() * sizeof(Real));
    std::memcpy(static_cast<void*>(fluid_.v.data), sample.v.data(), sample.v.size() * sizeof(Real));
  }

  void step() override {
    solver_.step(backend_, fluid_, first_);
    first_ = false;
  }
  ParticleView fluid() const override {
    const auto n = std::size_t(fluid_.n);
    return {D,
            {fluid_.id.data, n},
            {reinterpret_cast<const Real*>(fluid_.x.data), n * D},
            {reinterpret_cast<const Real*>(fluid_.v.data), n * D},
            {fluid_.rho.data, n}};
  }
  const std::vector<VerbTiming>& timings() const override { return backend_.timings(); }
  std::vector<KeptField> kept() const override { return kept_; }

 private:
  template <class T> void allocate(const char* name, Keep keep, Field<T>& field) {
    backend_.allocate(fluid_, keep, field);
    if (keep == Keep::kept)
      kept_.push_back({name, reinterpret_cast<const std::byte*>(field.data), sizeof(T)});
  }

  Backend backend_;
  Solver solver_;
  typename Solver::Fluid fluid_;
  std::vector<KeptField> kept_;
  bool first_ = true;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
