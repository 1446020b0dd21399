// SPDX-License-Identifier: MIT
/// The surfaces of frames as files, of a run or of a finished run.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "freshet/frame.h"
#include "freshet/scene.h"
#include "freshet/surface_settings.h"

namespace freshet {

/// The names of the files of surfaces within their folder.
class SurfaceNames {
 public:
  SurfaceNames(const SurfaceMeshFiles& files, const Scene& scene);
  /// The number of meshes of a frame: 1, or one for each liquid.
  int meshes() const { return meshes_; }
  /// Such as surface_0007.ply or surface_liquid1_0007.ply.
  std::string mesh(std::int64_t number, int liquid) const;
  /// All files of the frames of these numbers.
  std::vector<std::string> all(const std::vector<std::int64_t>& numbers) const;
  /// Whether a file for ParaView holds the times of the meshes, and that file.
  bool has_times() const { return format_ == SurfaceFormat::vtp; }
  std::string times(int liquid) const;

 private:
  SurfaceFormat format_;
  bool phases_;
  int meshes_;
};

/// A frame and where it comes from.
struct NumberedFrame {
  const Frame& frame;
  std::int64_t number;
  std::string place;  ///< of errors about the frame
};
/// Receives a file.
using WriteFile = std::function<void(const std::string& name, const std::string& bytes)>;

/// Makes the surfaces of a frame.
void write_surfaces(const Scene& scene, const SurfaceMeshFiles& files, const NumberedFrame& of,
                    int threads, const WriteFile& write);
/// Makes the files of times, if the format has them. `times` [s] and `numbers` are of the frames.
void write_surface_times(const SurfaceNames& names, const std::vector<double>& times,
                         const std::vector<std::int64_t>& numbers, const WriteFile& write);

}  // namespace freshet
