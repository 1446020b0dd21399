// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "formats/column_names.h"
#include "formats/point_formats.h"
#include "formats/text_rows.h"

namespace freshet {

void add_rows(TableText& table, std::vector<std::string_view> first,
              const std::vector<std::string>& names, PointSink& sink) {
  for (std::size_t k = 0; k < names.size(); ++k) sink.name(names[k], k);
  sink.check();
  std::vector<double> values(names.size());
  for (auto fields = std::move(first); !fields.empty(); fields = table.next()) {
    sink.line = table.line();
    if (fields.size() != names.size())
      sink.fail(fmt::format("{} value{} instead of {}; write one per column", fields.size(),
                            fields.size() == 1 ? "" : "s", names.size()));
    for (std::size_t k = 0; k < fields.size(); ++k) {
      const auto value = table.number(fields[k]);
      values[k] = value.value_or(NAN);
      if (!value && sink.reads(k))
        sink.fail(
            fmt::format("value {} is not a number; write numbers like 0.5 or 1e-3, with one "
                        "separator between them",
                        k + 1));
    }
    sink.add(values);
  }
}

void read_csv(std::string_view bytes, PointSink& sink) {
  TableText table(bytes);
  sink.line = table.line();
  std::vector<std::string> names;
  for (const std::string_view name : table.names()) names.push_back(short_name(name));
  auto first = table.next();
  if (names.empty() && !first.empty())
    sink.fail(
        fmt::format("the first line has {} number{} and no names; write a line of names such as "
                    "x,y,z before it",
                    first.size(), first.size() == 1 ? "" : "s"));
  add_rows(table, std::move(first), names, sink);
}

}  // namespace freshet
