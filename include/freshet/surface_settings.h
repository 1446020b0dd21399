// SPDX-License-Identifier: MIT
/// The settings of surfaces, which a scene and `freshet surface` share.
#pragma once

namespace freshet {

/// Where a surface lies: each connected piece of liquid has the volume of its particles, or it lies
/// where the density has the level.
enum class SurfaceVolume { particles, level };
/// In the order of SurfaceVolume.
inline constexpr const char* surface_volume_names[] = {"particles", "level"};

/// Round kernels, or kernels that are stretched along the surface of the liquid [after Yu and Turk
/// 2013], which makes it flatter.
enum class SurfaceKernels { isotropic, anisotropic };
/// In the order of SurfaceKernels.
inline constexpr const char* surface_kernel_names[] = {"isotropic", "anisotropic"};

/// How a surface is computed. Lengths are in particle spacings. visit_settings() has the ranges.
struct SurfaceSettings {
  double cell = 0.5;   ///< edge length of a grid cell, at most half of `radius`
  double radius = 2;   ///< support radius of the density field
  double level = 0.6;  ///< of the density field: 1 deep in the fluid and at the centre of a lone
                       ///< particle
  int smooth = 10;     ///< smoothing steps
  SurfaceVolume volume = SurfaceVolume::particles;
  SurfaceKernels kernels = SurfaceKernels::isotropic;
  double simplify = 0;  ///< error up to which triangles are removed; 0: none
};

/// Whether this build can simplify surfaces, which needs meshoptimizer.
bool simplifies_surfaces();

enum class SurfaceFormat { ply, obj, vtp, glb, vdb };
/// In the order of SurfaceFormat. A VDB file has grids instead of a mesh: signed distance, density
/// and velocity.
inline constexpr const char* surface_format_names[] = {"ply", "obj", "vtp", "glb", "vdb"};

/// The meshes of a frame as files.
struct SurfaceMeshFiles {
  SurfaceFormat format = SurfaceFormat::ply;
  bool phases = false;  ///< a mesh for each liquid instead of one for all
  SurfaceSettings settings;
};

/// Calls `visitor` with each setting, its range and its meaning:
///
///   number(name, double&, low, high, text)
///   count(name, int&, low, high, text)
///   choice(name, enum&, names, text)
template <class Visitor, class Settings> void visit_settings(Visitor& visitor, Settings& s) {
  visitor.number("cell", s.cell, 0.1, 2.0, "edge of a grid cell in particle spacings");
  visitor.number("radius", s.radius, 1.0, 6.0,
                 "reach of a particle in particle spacings; larger is rounder");
  visitor.number("level", s.level, 0.05, 0.95,
                 "density of the surface, of 1 deep in the fluid; lower is thicker");
  visitor.count("smooth", s.smooth, 0, 100, "smoothing steps; 0 for none");
  visitor.choice("volume", s.volume, surface_volume_names,
                 "volume of each connected piece: that of its particles, or that within the level");
  visitor.choice("kernels", s.kernels, surface_kernel_names,
                 "round, or stretched along the surface, which makes it flatter");
  visitor.number("simplify", s.simplify, 0.0, 1.0,
                 "error of the mesh in particle spacings up to which triangles are removed; 0 for "
                 "none");
}

/// Calls `visitor` as visit_settings() does, and with what the files contain:
///
///   flag(name, bool&, text)
template <class Visitor, class Files> void visit_files(Visitor& visitor, Files& f) {
  visitor.choice("format", f.format, surface_format_names,
                 "format of the meshes; vdb: grids of signed distance, density and velocity");
  visitor.flag("phases", f.phases, "a mesh for each liquid instead of one for all");
  visit_settings(visitor, f.settings);
}

}  // namespace freshet
