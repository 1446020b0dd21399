// SPDX-License-Identifier: MIT
#include "io/frame_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "io/frame_columns.h"
#include "io/frame_hdf5.h"

namespace freshet {
namespace {

template <PointReader* read>
Frame decode_by(std::string_view bytes, const std::string& file, DataFields& stored) {
  return decode_columns(bytes, file, read, stored);
}

constexpr FrameFormat formats[] = {
    {DataFormat::hdf5, ".h5", encode_hdf5, decode_hdf5},
    {DataFormat::vtp, ".vtp", encode_vtp, decode_by<read_vtk_xml>},
    {DataFormat::ply, ".ply", encode_ply, decode_by<read_ply>},
    {DataFormat::csv, ".csv", encode_csv, decode_csv},
    {DataFormat::bgeo, ".bgeo", encode_bgeo, nullptr},
};

const FrameFormat& entry_of(DataFormat format) {
  return *std::find_if(std::begin(formats), std::end(formats),
                       [&](const FrameFormat& entry) { return entry.format == format; });
}

}  // namespace

std::span<const FrameFormat> frame_formats() { return formats; }

std::string encode_points(DataFormat format, const PointTable& table) {
  return entry_of(format).encode(table);
}

std::string data_file(DataFormat format, std::int64_t k) {
  return fmt::format("data/frame_{:04}{}", k, entry_of(format).extension);
}
std::string whitewater_file(DataFormat format, std::int64_t k) {
  return fmt::format("data/whitewater_{:04}{}", k, entry_of(format).extension);
}

}  // namespace freshet
