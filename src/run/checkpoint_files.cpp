// SPDX-License-Identifier: MIT
#include "freshet/checkpoint_file.h"
#include "io/checkpoint.h"
#include "io/files.h"

namespace freshet {

void save_checkpoint(const Simulation& simulation, const std::filesystem::path& file) {
  write_file(file, encode_checkpoint(simulation.checkpoint()));
}

void restore_checkpoint(Simulation& simulation, const std::filesystem::path& file) {
  simulation.restore(read_checkpoint(file));
}

std::size_t checkpoint_bytes(const Simulation& simulation) {
  constexpr std::size_t tables = 8192;  // of HDF5, and what is no array
  const Checkpoint c = simulation.checkpoint();
  std::size_t bytes = tables + c.scene.size();
  for (const Checkpoint::Array& a : c.arrays) bytes += a.bytes.size();
  return bytes;
}

}  // namespace freshet
