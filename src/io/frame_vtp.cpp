// SPDX-License-Identifier: MIT
#include "io/frame_data.h"
#include "io/vtp_points.h"

namespace freshet {

std::string encode_vtp(const PointTable& table) {
  VtpPoints file(table.size(), table.time, table.step, table.dimension);
  for (const PointColumn& column : table.columns)
    std::visit(
        [&](const auto* values) {
          using Values = std::remove_cvref_t<decltype(*values)>;
          if constexpr (std::is_same_v<Values, std::vector<float>>)
            if (column.vectors) return file.add_vectors(column.name, *values);
          file.add(column.name, *values);
        },
        column.values);
  return std::move(file).bytes_at(table.x);
}

}  // namespace freshet
