// SPDX-License-Identifier: MIT
#include "io/frame_hdf5.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "freshet/error.h"
#include "io/frame_data.h"
#include "io/hdf5.h"

namespace freshet {
namespace {

constexpr float largest_half = 65504;

Hdf5Float stored_as(const std::vector<float>& values, bool half) {
  const bool fits = std::all_of(values.begin(), values.end(),
                                [](float a) { return !(std::abs(a) > largest_half); });
  return half && fits ? Hdf5Float::half : Hdf5Float::single;
}

/// Reads a field of `rows` × `columns`; zeros if the file does not have it.
std::vector<float> field(const Hdf5Reader& file, const char* name, std::size_t rows,
                         std::size_t columns, const std::string& place) {
  std::vector<float> values;
  if (!file.has(name)) values.resize(rows * columns);
  else if (file.columns(name) == columns) file.read(name, values);
  if (values.size() != rows * columns)
    throw Error(Error::Kind::scene, place,
                fmt::format("\"{}\" is not {} × {} numbers, as the positions ask for; the file is "
                            "damaged",
                            name, rows, columns));
  return values;
}

}  // namespace

std::string encode_hdf5(const Frame& frame, const DataFields& fields) {
  const std::size_t dimension = std::size_t(frame.dimension);
  const bool flat = dimension == 2;
  Hdf5Writer file;
  file.attribute("/", "time", frame.time);
  file.attribute("/", "step", frame.step);
  file.attribute("/", "dimension", std::int64_t(frame.dimension));
  const auto write = [&](const char* name, const std::vector<float>& values, std::size_t columns,
                         bool half, const char* unit) {
    file.write(name, values, columns, stored_as(values, half));
    file.attribute(name, "unit", std::string(unit));
  };
  write("position", frame.x, dimension, false, "m");
  if (fields.velocity) write("velocity", frame.v, dimension, fields.half, "m/s");
  if (fields.density) write("density", frame.density, 1, fields.half, flat ? "kg/m^2" : "kg/m^3");
  if (fields.pressure) write("pressure", frame.pressure, 1, fields.half, flat ? "N/m" : "Pa");
  if (fields.id) {
    file.write("id", std::span<const std::uint64_t>(frame.id));
    file.attribute("id", "unit", std::string("1"));
  }
  if (!frame.liquid.empty()) {
    file.write("liquid", std::span<const std::int32_t>(frame.liquid));
    file.attribute("liquid", "unit", std::string("1"));
  }
  return file.bytes();
}

Frame decode_hdf5(std::string_view bytes, const std::string& place) {
  const Hdf5Reader file(bytes, place);
  const std::size_t columns = file.columns("position");
  if (columns != 2 && columns != 3)
    throw Error(
        Error::Kind::scene, place,
        fmt::format("\"position\" has {} columns; 2 or 3 are allowed, is it the right file?",
                    columns));
  Frame frame;
  frame.dimension = int(columns);
  if (file.has_attribute("/", "time")) frame.time = file.number("/", "time");
  if (file.has_attribute("/", "step")) frame.step = file.integer("/", "step");
  file.read("position", frame.x);
  const std::size_t n = frame.x.size() / columns;
  frame.v = field(file, "velocity", n, columns, place);
  frame.density = field(file, "density", n, 1, place);
  frame.pressure = field(file, "pressure", n, 1, place);
  frame.id.resize(n);
  std::iota(frame.id.begin(), frame.id.end(), std::uint64_t(0));
  if (file.has("id")) file.read("id", frame.id);
  if (frame.id.size() != n)
    throw Error(
        Error::Kind::scene, place,
        fmt::format("there are {} ids and {} positions; the file is damaged", frame.id.size(), n));
  if (!file.has("liquid")) return frame;
  file.read("liquid", frame.liquid);
  if (frame.liquid.size() != n)
    throw Error(Error::Kind::scene, place,
                "\"liquid\" is not one number a particle; the file is damaged");
  return frame;
}

}  // namespace freshet
