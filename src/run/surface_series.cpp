// SPDX-License-Identifier: MIT
#include "run/surface_series.h"

#include <fmt/format.h>

#include "io/frame_data.h"
#include "io/surface_files.h"
#include "io/surface_vdb.h"
#include "run/frame_surface.h"
#include "surface/liquid_part.h"

namespace freshet {

SurfaceNames::SurfaceNames(const SurfaceMeshFiles& files, const Scene& scene)
    : format_(files.format),
      phases_(files.phases),
      meshes_(files.phases ? int(scene.liquids().size()) : 1) {}

std::string SurfaceNames::mesh(std::int64_t number, int liquid) const {
  const std::string phase = phases_ ? fmt::format("liquid{}_", liquid) : "";
  return fmt::format("surface_{}{:04}{}", phase, number, extension_of(format_));
}

std::string SurfaceNames::times(int liquid) const {
  return phases_ ? fmt::format("surfaces_liquid{}.pvd", liquid) : "surfaces.pvd";
}

std::vector<std::string> SurfaceNames::all(const std::vector<std::int64_t>& numbers) const {
  std::vector<std::string> names;
  for (int liquid = 0; liquid < meshes_; ++liquid) {
    for (const std::int64_t number : numbers) names.push_back(mesh(number, liquid));
    if (has_times()) names.push_back(times(liquid));
  }
  return names;
}

void write_surfaces(const Scene& scene, const SurfaceMeshFiles& files, const NumberedFrame& of,
                    int threads, const WriteFile& write) {
  const SurfaceNames names(files, scene);
  for (int liquid = 0; liquid < names.meshes(); ++liquid) {
    const Frame part = files.phases ? liquid_part(of.frame, liquid) : of.frame;
    const SurfaceTime time{of.frame.time, of.frame.step};
    const std::string bytes =
        files.format == SurfaceFormat::vdb
            ? encode_fluid_vdb(grids_of_frame(scene, part, of.place, files.settings, threads), time)
            : encode_surface(files.format,
                             surface_of_frame(scene, part, of.place, files.settings, threads),
                             time);
    write(names.mesh(of.number, liquid), bytes);
  }
}

void write_surface_times(const SurfaceNames& names, const std::vector<double>& times,
                         const std::vector<std::int64_t>& numbers, const WriteFile& write) {
  for (int liquid = 0; liquid < names.meshes() && names.has_times(); ++liquid) {
    std::vector<std::string> files;
    for (const std::int64_t number : numbers) files.push_back(names.mesh(number, liquid));
    write(names.times(liquid), encode_pvd(times, files));
  }
}

}  // namespace freshet
