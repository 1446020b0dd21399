// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "core/table_text.h"
#include "formats/column_names.h"
#include "formats/point_sink.h"

namespace freshet {
namespace {

/// Shortens the names of components: "Points:0" to "x", "Vel.y [m/s]" to "vy". Other names are
/// unchanged.
std::string short_name(std::string_view name) {
  static constexpr const char* components[] = {"x", "y", "z", "vx", "vy", "vz"};
  const auto column = point_column(name);
  if (column && column->certain) return components[column->component];
  return std::string(name);
}

}  // namespace

void read_csv(std::string_view bytes, PointSink& sink) {
  TableText table(bytes);
  sink.line = table.line();
  const auto& names = table.names();
  auto fields = table.next();
  if (names.empty() && !fields.empty())
    sink.fail(
        fmt::format("the first line has {} number{} and no names; write a line of names such "
                    "as x,y,z before it",
                    fields.size(), fields.size() == 1 ? "" : "s"));
  for (std::size_t k = 0; k < names.size(); ++k) sink.name(short_name(names[k]), k);
  sink.check();
  std::vector<double> values(names.size());
  for (; !fields.empty(); fields = table.next()) {
    sink.line = table.line();
    if (fields.size() != names.size())
      sink.fail(fmt::format("{} value{}, and the first line names {}; give every point all",
                            fields.size(), fields.size() == 1 ? "" : "s", names.size()));
    for (std::size_t k = 0; k < fields.size(); ++k) {
      const auto value = table.number(fields[k]);
      values[k] = value.value_or(NAN);
      if (!value && sink.reads(k))
        sink.fail(
            fmt::format("value {} is no number; write numbers like 0.5 or 1e-3, with "
                        "commas between them",
                        k + 1));
    }
    sink.add(values);
  }
}

}  // namespace freshet
