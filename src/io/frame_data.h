// SPDX-License-Identifier: MIT
/// Frames in the file formats of other programs. Data is little-endian; floats have 4 bytes.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "io/point_table.h"

namespace freshet {

/// VTK XML PolyData: a point and a vertex per particle. Positions and velocities have 3 components
/// (z is 0 in 2D), Float32, in raw appended data. Field data: TimeValue [s], Step, Dimension.
std::string encode_vtp(const PointTable& table);
inline std::string encode_vtp(const Frame& frame, const DataFields& fields = {}) {
  return encode_vtp(table_of(frame, fields));
}

/// Binary PLY: x, y, z, vx, vy, vz, density, pressure as float (z is 0 in 2D), id as uint, or as
/// double if an id needs more than 32 bits. Comments: time [s], step, dimension.
std::string encode_ply(const PointTable& table);
inline std::string encode_ply(const Frame& frame, const DataFields& fields = {}) {
  return encode_ply(table_of(frame, fields));
}

/// CSV: a line of names, then one line per particle: step, time [s], id, x, y, ...; no z in 2D.
/// Numbers are the shortest decimals that read as the same float.
std::string encode_csv(const PointTable& table);
inline std::string encode_csv(const Frame& frame, const DataFields& fields = {}) {
  return encode_csv(table_of(frame, fields));
}

/// Houdini's classic bgeo of version 5, big-endian: positions, and the point attributes v, density,
/// pressure, id, pscale and liquid. It has no time. Throws Error (kind run) if an id needs more
/// than 31 bits.
std::string encode_bgeo(const PointTable& table);
inline std::string encode_bgeo(const Frame& frame, const DataFields& fields = {}) {
  return encode_bgeo(table_of(frame, fields));
}

/// HDF5: position and velocity (N × D), density, pressure, id (u64), each with its unit as
/// attribute; time [s], step and dimension as attributes of the file. With `half`, a field with a
/// magnitude above 65504 still has 4 bytes. The position always has 4 bytes.
std::string encode_hdf5(const PointTable& table);
inline std::string encode_hdf5(const Frame& frame, const DataFields& fields = {}) {
  return encode_hdf5(table_of(frame, fields));
}

std::string encode_points(DataFormat format, const PointTable& table);

/// A ParaView time series: files[k] is at times[k] [s]. The files are in the same folder.
std::string encode_pvd(std::span<const double> times, std::span<const std::string> files);

inline constexpr const char* pvd_file = "data/frames.pvd";
inline constexpr const char* whitewater_pvd_file = "data/whitewater.pvd";
/// The path of the k-th data file in the run folder, for example "data/frame_0000.vtp", and that of
/// its whitewater, "data/whitewater_0000.vtp".
std::string data_file(DataFormat format, std::int64_t k);
std::string whitewater_file(DataFormat format, std::int64_t k);
/// The paths of all data files of a run that writes `frames` files of each format.
std::vector<std::string> data_files(const Scene& scene, std::int64_t frames);

}  // namespace freshet
