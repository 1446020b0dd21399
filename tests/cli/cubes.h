// SPDX-License-Identifier: MIT
#pragma once
#include "cli/files.h"
#include "io/frame_data.h"

namespace freshet::test {

/// Writes a finished run of three frames: a cube of particles that rises; the last frame is empty.
inline void make_cubes(const fs::path& folder, bool in_2d = false) {
  write_text(folder / "scene.toml",
             in_2d ? "domain.max = [2, 1]\nparticles.spacing = 0.1\n"
                     "time = { end = 2, step = 1e-3 }\nfluid = { min = [0, 0], max = [1, 1] }\n"
                   : "domain.max = [2, 2, 2]\nparticles.spacing = 0.1\n"
                     "time = { end = 2, step = 1e-3 }\n[[fluid]]\nmin = [0, 0, 0]\n"
                     "max = [1, 1, 0.5]\n[[fluid]]\nmin = [0, 0, 0.5]\nmax = [1, 1, 1]\n"
                     "rest_density = 800\n[solver]\nname = \"wcsph\"\n");
  for (int k = 0; k < 3; ++k) {
    Frame frame;
    frame.dimension = in_2d ? 2 : 3;
    frame.step = 10 * k;
    frame.time = 0.1 * k;
    for (int i = 0; i < (k < 2 ? 512 : 0); ++i) {
      const int place[] = {i % 8, i / 8 % 8, i / 64};
      for (int d = 0; d < frame.dimension; ++d)
        frame.x.push_back(0.55f + 0.1f * float(place[d] + (d == 1 ? k : 0)));
      frame.id.push_back(std::uint64_t(i));
      if (!in_2d) frame.liquid.push_back(place[2] / 4);
    }
    frame.v.assign(frame.x.size(), 1);
    frame.density.assign(frame.id.size(), 1000);
    frame.pressure.assign(frame.id.size(), 0);
    write_text(folder / data_file(DataFormat::vtp, k), encode_vtp(frame));
  }
}

}  // namespace freshet::test
