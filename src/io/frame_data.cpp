// SPDX-License-Identifier: MIT
#include "io/frame_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <limits>

namespace freshet {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they stand");

template <class T> void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

constexpr const char* axes = "xyz";

}  // namespace

DataFields::DataFields(const Scene::Output& output) : half(output.precision == Precision::float16) {
  const auto has = [&](DataField field) {
    return std::find(output.fields.begin(), output.fields.end(), field) != output.fields.end();
  };
  velocity = has(DataField::velocity);
  density = has(DataField::density);
  pressure = has(DataField::pressure);
  id = has(DataField::id);
}

std::string encode_ply(const Frame& frame, const DataFields& fields) {
  const std::size_t n = frame.size(), dimension = std::size_t(frame.dimension);
  const bool wide = n > 0 && *std::max_element(frame.id.begin(), frame.id.end()) >
                                 std::numeric_limits<std::uint32_t>::max();
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment time {}\ncomment step {}\n"
      "comment dimension {}\nelement vertex {}\n",
      frame.time, frame.step, frame.dimension, n);
  std::string names = "x y z";
  if (fields.velocity) names += " vx vy vz";
  if (fields.density) names += " density";
  if (fields.pressure) names += " pressure";
  for (std::size_t at = 0, end; at < names.size(); at = end + 1) {
    end = std::min(names.find(' ', at), names.size());
    bytes += "property float " + names.substr(at, end - at) + "\n";
  }
  if (fields.id) bytes += wide ? "property double id\n" : "property uint id\n";
  if (!frame.liquid.empty()) bytes += "property int liquid\n";
  bytes += "end_header\n";
  bytes.reserve(bytes.size() + n * 44);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      append(bytes, k < dimension ? frame.x[i * dimension + k] : 0.0f);
    for (std::size_t k = 0; k < 3 && fields.velocity; ++k)
      append(bytes, k < dimension ? frame.v[i * dimension + k] : 0.0f);
    if (fields.density) append(bytes, frame.density[i]);
    if (fields.pressure) append(bytes, frame.pressure[i]);
    if (fields.id && wide) append(bytes, double(frame.id[i]));
    else if (fields.id) append(bytes, std::uint32_t(frame.id[i]));
    if (!frame.liquid.empty()) append(bytes, std::int32_t(frame.liquid[i]));
  }
  return bytes;
}

std::string encode_csv(const Frame& frame, const DataFields& fields) {
  const std::size_t dimension = std::size_t(frame.dimension);
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "step,time{}", fields.id ? ",id" : "");
  for (std::size_t k = 0; k < dimension; ++k) fmt::format_to(out, ",{}", axes[k]);
  for (std::size_t k = 0; k < dimension && fields.velocity; ++k)
    fmt::format_to(out, ",v{}", axes[k]);
  fmt::format_to(out, "{}{}{}\n", fields.density ? ",density" : "",
                 fields.pressure ? ",pressure" : "", frame.liquid.empty() ? "" : ",liquid");
  const std::string moment = fmt::format("{},{}", frame.step, frame.time);
  for (std::size_t i = 0; i < frame.size(); ++i) {
    text.append(moment);
    if (fields.id) fmt::format_to(out, ",{}", frame.id[i]);
    for (std::size_t k = 0; k < dimension; ++k)
      fmt::format_to(out, ",{}", frame.x[i * dimension + k]);
    for (std::size_t k = 0; k < dimension && fields.velocity; ++k)
      fmt::format_to(out, ",{}", frame.v[i * dimension + k]);
    if (fields.density) fmt::format_to(out, ",{}", frame.density[i]);
    if (fields.pressure) fmt::format_to(out, ",{}", frame.pressure[i]);
    if (!frame.liquid.empty()) fmt::format_to(out, ",{}", frame.liquid[i]);
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

std::vector<std::string> data_files(const Scene::Output& output, std::int64_t frames) {
  std::vector<std::string> files;
  for (const DataFormat format : output.data) {
    for (std::int64_t k = 0; k < frames; ++k) files.push_back(data_file(format, k));
    if (format == DataFormat::vtp && frames > 0) files.push_back(pvd_file);
  }
  return files;
}

}  // namespace freshet
