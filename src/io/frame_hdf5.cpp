// SPDX-License-Identifier: MIT
#include "io/frame_hdf5.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

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

std::string encode_hdf5(const PointTable& table) {
  Hdf5Writer file;
  file.attribute("/", "time", table.time);
  file.attribute("/", "step", table.step);
  file.attribute("/", "dimension", std::int64_t(table.dimension));
  const auto dimension = std::size_t(table.dimension);
  const auto write = [&](const PointColumn& column, const auto& values) {
    using T = typename std::remove_cvref_t<decltype(values)>::value_type;
    if constexpr (std::is_same_v<T, float>)
      file.write(column.name, values, column.vectors ? dimension : 1,
                 stored_as(values, column.half));
    else file.write(column.name, std::span<const T>(values));
    file.attribute(column.name, "unit", std::string(column.unit));
  };
  write({"position", units_in(table.dimension).length, &table.x, true}, table.x);
  for (const PointColumn& column : table.columns)
    std::visit([&](const auto* values) { write(column, *values); }, column.values);
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
  if (file.has("kind")) {
    WhitewaterFrame& w = frame.whitewater;
    file.read("kind", w.kind);
    check_list("kind", w.kind.size());
    w.age = field(file, "age", n, 1, place);
    if (std::any_of(w.kind.begin(), w.kind.end(), [](int kind) { return kind < 0 || kind > 2; }))
      fail("a number of \"kind\" is not 0, 1 or 2; the file is damaged");
    w.id = std::exchange(frame.id, {});
    w.x = std::exchange(frame.x, {});
    w.v = std::exchange(frame.v, {});
    frame.density.clear();
    frame.pressure.clear();
    return frame;
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
