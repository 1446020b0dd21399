// SPDX-License-Identifier: MIT
/// The lists of neighbours that forces on walls need between two steps.
#pragma once
#include <cstdint>
#include <initializer_list>
#include <unordered_map>
#include <vector>

#include "boundary/wall_sets.h"
#include "core/fluid_particles.h"
#include "engine/engine_backend.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Lists neighbours anew, and sorts these sets of walls. The search sorts the kept fields; rho, p
/// and a are scratch that is read between steps, and follow their particles here. With a skin the
/// lists stay those of the step before, which a run that has not stopped still has.
template <int D, EngineBackend<D> B, class... Sets>
void search_between_steps(B& backend, Real support, FluidParticles<D>& fluid, Sets&... sets) {
  std::unordered_map<std::uint64_t, int> place;
  for (int i = 0; i < fluid.n; ++i) place[fluid.id[i]] = i;
  const auto copy = [&](auto field) { return std::vector(field.data, field.data + fluid.n); };
  const auto rho = copy(fluid.rho), p = copy(fluid.p);
  const auto a = copy(fluid.a), x = copy(fluid.x);
  for (int i = 0; i < fluid.n && fluid.x_listed.data; ++i) fluid.x[i] = fluid.x_listed[i];
  backend.find_neighbors("wall forces", support, fluid, sets...);
  for (int i = 0; i < fluid.n; ++i) {
    const auto from = std::size_t(place[fluid.id[i]]);
    if (fluid.x_listed.data) fluid.x[i] = x[from];
    fluid.rho[i] = rho[from];
    fluid.p[i] = p[from];
    fluid.a[i] = a[from];
  }
  if (fluid.x_listed.data) backend.share("wall forces", fluid, fluid.x);
  backend.share("wall forces", fluid, fluid.rho, fluid.p);
  if (fluid.kind.data) backend.share("wall forces", fluid, fluid.kind);
}

/// Lists the fluid near every boundary particle. Returns the walls as sets that do not move: they
/// are sorted already.
template <int D, EngineBackend<D> B>
Walls<D> list_fluid_near_walls(B& backend, Real support, FluidParticles<D>& fluid, Walls<D> walls) {
  walls.akinci2012.moves = walls.adami2012.moves = false;
  for (const Particles<D>* wall : std::initializer_list<const Particles<D>*>{
           &walls.akinci2012, &walls.adami2012, &walls.monaghan2009})
    if (wall->n > 0) backend.list_neighbors("wall forces", support, *wall, fluid);
  backend.share("wall forces", fluid, fluid.v);
  return walls;
}

}  // namespace FRESHET_ISA
}  // namespace freshet
