// SPDX-License-Identifier: MIT
#include "io/frame_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <limits>
#include <type_traits>

namespace freshet {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they stand");

template <class T> void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

constexpr const char* axes[] = {"x", "y", "z"};

bool is_id(const PointColumn& column) {
  return std::holds_alternative<const std::vector<std::uint64_t>*>(column.values);
}

/// Whether a column has numbers that need more than 32 bits.
bool is_wide(const PointColumn& column) {
  const auto* const* values = std::get_if<const std::vector<std::uint64_t>*>(&column.values);
  return values && std::any_of((*values)->begin(), (*values)->end(), [](std::uint64_t value) {
           return value > std::numeric_limits<std::uint32_t>::max();
         });
}

const char* ply_type(const PointColumn& column) {
  if (is_id(column)) return is_wide(column) ? "double" : "uint";
  return std::holds_alternative<const std::vector<float>*>(column.values) ? "float" : "int";
}

}  // namespace

std::string encode_ply(const PointTable& table) {
  const std::size_t n = table.size(), dimension = std::size_t(table.dimension);
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment time {}\ncomment step {}\n"
      "comment dimension {}\nelement vertex {}\n",
      table.time, table.step, table.dimension, n);
  for (const char* axis : axes) bytes += fmt::format("property float {}\n", axis);
  for (const PointColumn& column : table.columns)
    if (column.vectors)
      for (const char* axis : axes) bytes += fmt::format("property float v{}\n", axis);
    else bytes += fmt::format("property {} {}\n", ply_type(column), column.name);
  bytes += "end_header\n";
  bytes.reserve(bytes.size() + n * 44);
  std::vector<bool> wide;
  for (const PointColumn& column : table.columns) wide.push_back(is_wide(column));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      append(bytes, k < dimension ? table.x[i * dimension + k] : 0.0f);
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      numbers_at(table.columns[c], i, dimension, 3, [&](auto value) {
        if constexpr (!std::is_same_v<decltype(value), std::uint64_t>) append(bytes, value);
        else if (wide[c]) append(bytes, double(value));
        else append(bytes, std::uint32_t(value));
      });
  }
  return bytes;
}

std::string encode_csv(const PointTable& table) {
  const std::size_t dimension = std::size_t(table.dimension);
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  const auto id = std::find_if(table.columns.begin(), table.columns.end(), is_id);
  fmt::format_to(out, "step,time{}", id == table.columns.end() ? "" : ",id");
  for (std::size_t k = 0; k < dimension; ++k) fmt::format_to(out, ",{}", axes[k]);
  for (const PointColumn& column : table.columns)
    if (column.vectors)
      for (std::size_t k = 0; k < dimension; ++k) fmt::format_to(out, ",v{}", axes[k]);
    else if (!is_id(column)) fmt::format_to(out, ",{}", column.name);
  text.push_back('\n');
  const std::string moment = fmt::format("{},{}", table.step, table.time);
  const auto add = [&](auto value) { fmt::format_to(out, ",{}", value); };
  for (std::size_t i = 0; i < table.size(); ++i) {
    text.append(moment);
    if (id != table.columns.end()) numbers_at(*id, i, dimension, dimension, add);
    for (std::size_t k = 0; k < dimension; ++k) add(table.x[i * dimension + k]);
    for (const PointColumn& column : table.columns)
      if (!is_id(column)) numbers_at(column, i, dimension, dimension, add);
    text.push_back('\n');
  }
  return fmt::to_string(text);
}

std::string encode_pvd(std::span<const double> times, std::span<const std::string> files) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (std::size_t k = 0; k < std::min(times.size(), files.size()); ++k)
    text += fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", times[k],
                        std::filesystem::path(files[k]).filename().string());
  return text + "  </Collection>\n</VTKFile>\n";
}

std::vector<std::string> data_files(const Scene& scene, std::int64_t frames) {
  std::vector<std::string> files;
  const auto add = [&](DataFormat format, auto* name, const char* series) {
    for (std::int64_t k = 0; k < frames; ++k) files.push_back(name(format, k));
    if (format == DataFormat::vtp && frames > 0) files.push_back(series);
  };
  for (const DataFormat format : scene.output.data) {
    add(format, &data_file, pvd_file);
    if (scene.whitewater) add(format, &whitewater_file, whitewater_pvd_file);
  }
  return files;
}

}  // namespace freshet
