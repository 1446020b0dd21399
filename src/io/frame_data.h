// SPDX-License-Identifier: MIT
/// Frames as files of other programs. Everything is little-endian, floats are of 4 bytes.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "freshet/frame.h"
#include "freshet/scene.h"

namespace freshet {

/// What a data file holds besides the position.
struct DataFields {
  bool velocity = true, density = true, pressure = true, id = true;
  bool half = false;  ///< HDF5: velocity, density and pressure of 2 bytes

  DataFields() = default;
  explicit DataFields(const Scene::Output& output);
};

/// VTK XML PolyData: a point and a vertex a particle, 3 numbers a position and a velocity (z is 0
/// in 2D), Float32; appended raw. Field data: TimeValue [s], Step, Dimension.
std::string encode_vtp(const Frame& frame, const DataFields& fields = {});

/// PLY, binary: x, y, z, vx, vy, vz, density, pressure as float (z is 0 in 2D), id as uint, or as
/// double where one needs more than 32 bits. Comments: time [s], step, dimension.
std::string encode_ply(const Frame& frame, const DataFields& fields = {});

/// A line of names, then one a particle: step, time [s], id, x, y, ...; no z in 2D. Numbers are the
/// shortest that read as the same float.
std::string encode_csv(const Frame& frame, const DataFields& fields = {});

/// HDF5: position and velocity (N × D), density, pressure, id (u64), each with its unit; time [s],
/// step and dimension of the file. A field with a number beyond 65504 keeps 4 bytes where `half`
/// asks for 2; so does the position, always.
std::string encode_hdf5(const Frame& frame, const DataFields& fields = {});

std::string encode_frame(DataFormat format, const Frame& frame, const DataFields& fields);

/// The time series of ParaView: the k-th of `files`, beside it, is of the k-th of `times` [s].
std::string encode_pvd(std::span<const double> times, std::span<const std::string> files);

inline constexpr const char* pvd_file = "data/frames.pvd";
/// "data/frame_0000.vtp": the k-th data file of a run in this format, in the run's folder.
std::string data_file(DataFormat format, std::int64_t k);
/// All data files of a run that writes this many of each format.
std::vector<std::string> data_files(const Scene::Output& output, std::int64_t frames);

}  // namespace freshet
