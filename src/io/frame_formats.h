// SPDX-License-Identifier: MIT
/// The formats of data files.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "io/frame_data.h"

namespace freshet {

struct FrameFormat {
  DataFormat format;
  const char* extension;  ///< such as ".vtp"
  std::string (*encode)(const PointTable& table);
  /// Null for a format without times, whose files are not read. Sets `stored` to the fields that
  /// the bytes have. Throws Error (kind scene) at `file`.
  Frame (*decode)(std::string_view bytes, const std::string& file, DataFields& stored);
};

/// All formats. Of a run that wrote several, the first is read.
std::span<const FrameFormat> frame_formats();

}  // namespace freshet
