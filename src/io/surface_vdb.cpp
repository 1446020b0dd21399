// SPDX-License-Identifier: MIT
#include "io/surface_vdb.h"

#include <algorithm>

#include "io/vdb_file.h"

namespace freshet {

std::string encode_fluid_vdb(const FluidGrids& grids, const SurfaceTime& time) {
  VdbGrid surface{"surface", VdbGrid::Class::level_set, 1,  LevelSet::band,
                  false,     float(grids.cell),         {}, grids.distance.inside};
  for (std::size_t k = 0; k < grids.distance.blocks.size(); ++k)
    surface.blocks.push_back({grids.distance.blocks[k], {grids.distance.values[k].data()}});
  VdbGrid density{"density", VdbGrid::Class::fog_volume, 1, 0, true, 1, {}, {}};
  VdbGrid velocity{"v", VdbGrid::Class::unknown, 3, 0, true, 1, {}, {}};
  for (std::size_t k = 0; k < grids.blocks.size(); ++k) {
    const auto is_zero = [](float d) { return d == 0; };
    const FluidGrids::Values& values = grids.density[k];
    if (std::all_of(values.begin(), values.end(), is_zero)) continue;
    density.blocks.push_back({grids.blocks[k], {values.data()}});
    if (grids.velocity.empty()) continue;
    const auto& [x, y, z] = grids.velocity[k];
    velocity.blocks.push_back({grids.blocks[k], {x.data(), y.data(), z.data()}, values.data()});
  }
  std::vector<VdbGrid> all{std::move(surface), std::move(density)};
  if (!grids.velocity.empty()) all.push_back(std::move(velocity));
  const double origin[] = {grids.origin[0], grids.origin[1], grids.origin[2]};
  return encode_vdb(all, origin, grids.cell, time.time, time.step);
}

}  // namespace freshet
