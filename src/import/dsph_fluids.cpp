// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <set>

#include "import/dualsphysics.h"

namespace freshet {
namespace {

/// Velocities of "initials" by mk.
std::map<long, Vec<3, double>> velocities_of(const XmlElement& initials) {
  std::map<long, Vec<3, double>> all;
  for (const XmlElement& v : initials.children("velocity")) {
    if (!v.boolean("active", true)) {
      v.skip();
      continue;
    }
    if (v.child("onlypos") || v.child("direction")) {
      v.missing("a velocity of a part, or a profile; set fluid.velocity_field");
      continue;
    }
    for (const long mk : numbers_of_list(v.text("mkfluid", "0"))) all[mk] = from_dsph(v.point());
  }
  return all;
}

constexpr std::size_t most_blocks = 900;

/// The box around the places of a fluid, from which walls are taken.
TomlTable whole_box(std::int16_t mark, const DsphLattice& lattice, const DsphWorld& world,
                    const TomlTable& material) {
  Bounds bounds;
  const auto [nx, ny, nz] = lattice.counts();
  for (long k = 0; k < nz; ++k)
    for (long j = 0; j < ny; ++j)
      for (long i = 0; i < nx; ++i)
        if (lattice.at({i, j, k}) == mark) bounds.add(lattice.place({i, j, k}));
  const double half = lattice.spacing() / 2;
  TomlTable table;
  table.set("min", bounds.low - Vec<3, double>{half, half, half}, world.dimension);
  table.set("max", bounds.high + Vec<3, double>{half, half, half}, world.dimension);
  table.add(material);
  return table;
}

}  // namespace

std::string write_dsph_fluids(const XmlElement& initials, const XmlElement& geometry,
                              const DsphWorld& world) {
  const std::map<long, Vec<3, double>> velocities = velocities_of(initials);
  const DsphLattice& lattice = *world.lattice;
  const auto [nx, ny, nz] = lattice.counts();
  std::set<std::int16_t> marks;
  for (long k = 0; k < nz; ++k)
    for (long j = 0; j < ny; ++j)
      for (long i = 0; i < nx; ++i)
        if (const std::int16_t mark = lattice.at({i, j, k}); mark > 0) marks.insert(mark);
  std::string tables;
  for (const std::int16_t mark : marks) {
    TomlTable material;
    material.set("rest_density", world.rest_density);
    if (world.viscosity) material.set("viscosity", *world.viscosity);
    if (world.hydrostatic) material.set("pressure", "hydrostatic");
    const auto velocity = velocities.find(mark - 1);
    if (velocity != velocities.end()) material.set("velocity", velocity->second, world.dimension);
    const std::vector<DsphLattice::Block> blocks = lattice.blocks(mark);
    if (blocks.size() > most_blocks) {
      geometry.child("definition")
          .instead(fmt::format("the places of a fluid are {} boxes, too many for a scene; taken "
                               "instead: the box around them, outside of walls",
                               blocks.size()));
      tables += whole_box(mark, lattice, world, material).item("fluid");
      continue;
    }
    for (const DsphLattice::Block& block : blocks) {
      TomlTable table;
      table.set("shape", "lattice");
      table.set("from", lattice.place(block.first), world.dimension);
      table.line("count", fmt::format("[{}, {}", block.count[0], block.count[1]) +
                              (world.flat() ? "]" : fmt::format(", {}]", block.count[2])));
      table.add(material);
      tables += table.item("fluid");
    }
  }
  return tables;
}

}  // namespace freshet
