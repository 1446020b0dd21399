// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/table_text.h"
#include "formats/point_sink.h"

namespace freshet {

/// Adds the rows of a table to a sink, from the row `first` on. Names the columns before.
void add_rows(TableText& table, std::vector<std::string_view> first,
              const std::vector<std::string>& names, PointSink& sink);

}  // namespace freshet
