// SPDX-License-Identifier: MIT
#include "io/frame_hdf5.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "freshet/error.h"
#include "freshet/units.h"
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

/// Refuses NaN and infinity, as the readers of the other formats do.
void check_finite(const std::vector<float>& values, const char* name, const std::string& place) {
  for (const float value : values)
    if (!(std::abs(value) <= 3e38f))  // true for NaN as well
      throw Error(Error::Kind::scene, place,
                  fmt::format("a number of \"{}\" is {}; the file is damaged", name, value));
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
  check_finite(values, name, place);
  return values;
}

}  // namespace

std::string encode_hdf5(const Frame& frame, const DataFields& fields) {
  const std::size_t dimension = std::size_t(frame.dimension);
  const Units units = units_in(frame.dimension);
  Hdf5Writer file;
  file.attribute("/", "time", frame.time);
  file.attribute("/", "step", frame.step);
  file.attribute("/", "dimension", std::int64_t(frame.dimension));
  const auto write = [&](const char* name, const std::vector<float>& values, std::size_t columns,
                         bool half, const char* unit) {
    file.write(name, values, columns, stored_as(values, half));
    file.attribute(name, "unit", std::string(unit));
  };
  write("position", frame.x, dimension, false, units.length);
  if (fields.velocity) write("velocity", frame.v, dimension, fields.half, units.speed);
  if (fields.density) write("density", frame.density, 1, fields.half, units.density);
  if (fields.pressure) write("pressure", frame.pressure, 1, fields.half, units.pressure);
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

Frame decode_hdf5(std::string_view bytes, const std::string& place, DataFields& stored) {
  const Hdf5Reader file(bytes, place);
  stored.velocity = file.has("velocity");
  stored.density = file.has("density");
  stored.pressure = file.has("pressure");
  stored.id = file.has("id");
  const auto fail = [&](const std::string& why) { throw Error(Error::Kind::scene, place, why); };
  const std::size_t columns = file.columns("position");
  if (columns != 2 && columns != 3)
    fail(fmt::format("\"position\" has {} columns; 2 or 3 are allowed, is it the right file?",
                     columns));
  Frame frame;
  frame.dimension = int(columns);
  if (file.has_attribute("/", "time")) frame.time = file.number("/", "time");
  if (file.has_attribute("/", "step")) frame.step = file.integer("/", "step");
  if (!std::isfinite(frame.time) || frame.step < 0)
    fail(
        fmt::format("its time is {} and its step {}; the file is damaged", frame.time, frame.step));
  if (file.has_attribute("/", "dimension") && file.integer("/", "dimension") != frame.dimension)
    fail(fmt::format("its dimension is {}, and \"position\" has {} columns; the file is damaged",
                     file.integer("/", "dimension"), columns));
  file.read("position", frame.x);
  check_finite(frame.x, "position", place);
  const std::size_t n = frame.x.size() / columns;
  frame.v = field(file, "velocity", n, columns, place);
  frame.density = field(file, "density", n, 1, place);
  frame.pressure = field(file, "pressure", n, 1, place);
  const auto check_list = [&](const char* name, std::size_t size) {
    if (size != n || file.columns(name) != 1)
      fail(fmt::format("\"{}\" is not one number for each of the {} particles; the file is damaged",
                       name, n));
  };
  frame.id.resize(n);
  std::iota(frame.id.begin(), frame.id.end(), std::uint64_t(0));
  if (file.has("id")) {
    file.read("id", frame.id);
    check_list("id", frame.id.size());
  }
  if (file.has("liquid")) {
    file.read("liquid", frame.liquid);
    check_list("liquid", frame.liquid.size());
  }
  if (std::any_of(frame.liquid.begin(), frame.liquid.end(), [](auto liquid) { return liquid < 0; }))
    fail("a number of \"liquid\" is negative; the file is damaged");
  return frame;
}

}  // namespace freshet
