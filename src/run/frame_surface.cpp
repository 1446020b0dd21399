// SPDX-License-Identifier: MIT
#include "run/frame_surface.h"

#include <fmt/format.h>

namespace freshet {

namespace fs = std::filesystem;

Scene scene_in_3d(const fs::path& run, const std::vector<Override>& overrides,
                  const ChangeableKeys& keys, const char* noun) {
  Scene scene = scene_of_run(run, overrides, keys);
  if (scene.dimension() != 3)
    throw Error(Error::Kind::scene, (run / "scene.toml").string(),
                fmt::format("this run is in 2D; {} needs a run in 3D", noun));
  return scene;
}

namespace {

/// make(spacing, origin) of a scene. Errors without a place get that of the file.
template <class Make> auto made_of(const Scene& scene, const fs::path& file, const Make& make) {
  std::array<double, 3> origin{};
  for (std::size_t k = 0; k < 3 && k < scene.domain.min.size(); ++k)
    origin[k] = scene.domain.min[k];
  try {
    return make(scene.particles.spacing, origin);
  } catch (const Error& e) {
    std::vector<Diagnostic> all = e.diagnostics();
    for (Diagnostic& d : all)
      if (d.place.empty()) d.place = file.string();
    throw Error(e.kind(), std::move(all));
  }
}

}  // namespace

SurfaceMesh surface_of_frame(const Scene& scene, const Frame& frame, const fs::path& file,
                             const SurfaceSettings& settings, int threads) {
  return made_of(scene, file, [&](double spacing, const std::array<double, 3>& origin) {
    return surface_of(frame, spacing, origin, settings, threads);
  });
}

FluidGrids grids_of_frame(const Scene& scene, const Frame& frame, const fs::path& file,
                          const SurfaceSettings& settings, int threads) {
  return made_of(scene, file, [&](double spacing, const std::array<double, 3>& origin) {
    return grids_of(frame, spacing, origin, settings, threads);
  });
}

}  // namespace freshet
