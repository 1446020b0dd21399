// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "scene/point_file.h"

namespace freshet {
namespace {

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t at = 0; at <= line.size();) {
    const auto end = std::min(line.find(',', at), line.size());
    fields.push_back(trimmed(line.substr(at, end - at)));
    at = end + 1;
  }
  return fields;
}

}  // namespace

PointCloud read_csv(std::string_view bytes, PointColumns& columns) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  columns.line = 1;
  const auto names = fields_of(take_line(bytes));
  for (std::size_t k = 0; k < names.size(); ++k) columns.name(std::string(names[k]), k);
  columns.check();
  PointCloud cloud;
  std::vector<double> values(names.size());
  while (!bytes.empty()) {
    const std::string_view line = take_line(bytes);
    ++columns.line;
    if (trimmed(line).empty()) continue;
    const auto fields = fields_of(line);
    if (fields.size() != names.size())
      columns.fail(fmt::format("{} value{}, and the first line names {}; give every point all",
                               fields.size(), fields.size() == 1 ? "" : "s", names.size()));
    for (std::size_t k = 0; k < fields.size(); ++k) {
      const auto value = number_in(fields[k]);
      values[k] = value.value_or(NAN);
      if (!value && columns.reads(k))
        columns.fail(
            fmt::format("value {} is no number; write numbers like 0.5 or 1e-3, with "
                        "commas between them",
                        k + 1));
    }
    columns.add(values, cloud);
  }
  return cloud;
}

}  // namespace freshet
