// SPDX-License-Identifier: MIT
#include "scene/model/surface_bytes.h"

#include <gtest/gtest.h>

#include "freshet/derived.h"
#include "freshet/simulation.h"
#include "io/surface_vdb.h"
#include "scene/scene_text.h"

namespace freshet::test {
namespace {

Scene fluid_in_3d(const std::string& fluid, const std::string& surface) {
  return scene_with("[1, 1, 1]", 0.03,
                    "fluid = { " + fluid + " }\noutput.frame_every_steps = 50\n" + surface);
}

TEST(SurfaceBytes, PredictTheSizeOfMeshes) {
  for (const std::string fluid : {"min = [0.1, 0, 0], max = [0.5, 0.8, 0.8]",
                                  "shape = 'sphere', center = [0.5, 0.5, 0.5], radius = 0.4"})
    for (const std::string cell : {"0.5", "0.3"}) {
      const Simulation sim(fluid_in_3d(fluid, ""));
      const double spacing = sim.scene().particles.spacing;
      for (int k = 0; k < 5; ++k) {
        const std::string format = surface_format_names[k];
        const Scene scene =
            fluid_in_3d(fluid, "surface = { format = '" + format + "', cell = " + cell + " }");
        const SurfaceSettings& settings = scene.surface->settings;
        const std::string bytes =
            SurfaceFormat(k) == SurfaceFormat::vdb
                ? encode_fluid_vdb(grids_of(sim.frame(), spacing, {0, 0, 0}, settings), {})
                : encode_surface(SurfaceFormat(k),
                                 surface_of(sim.frame(), spacing, {0, 0, 0}, settings), {});
        const double size = double(bytes.size());
        EXPECT_NEAR(derive(scene).surface_bytes / 3 / size, 1, 0.15)
            << fluid << " " << format << " " << size;
      }
    }
}

TEST(SurfaceBytes, AreThoseOfAllFrames) {
  const std::string box = "min = [0, 0, 0], max = [0.3, 0.3, 0.3]";
  EXPECT_EQ(derive(fluid_in_3d(box, "")).surface_frames, 0);
  EXPECT_EQ(derive(fluid_in_3d(box, "")).surface_bytes, 0);
  EXPECT_EQ(derive(fluid_in_3d(box, "surface = {}")).surface_frames, 3);
  EXPECT_EQ(derive(fluid_in_3d(box, "surface = { every_steps = 10 }")).surface_frames, 11);
}

}  // namespace
}  // namespace freshet::test
