// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "formats/point_sink.h"

namespace freshet {
namespace {

/// The comma-separated fields of a line. A comma inside quotes does not separate.
std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  std::size_t begin = 0;
  bool quoted = false;
  for (std::size_t at = 0; at <= line.size(); ++at) {
    if (at < line.size() && line[at] == '"') quoted = !quoted;
    if (at < line.size() && (quoted || line[at] != ',')) continue;
    std::string_view field = trimmed(line.substr(begin, at - begin));
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
      field = field.substr(1, field.size() - 2);
    fields.push_back(field);
    begin = at + 1;
  }
  return fields;
}

/// Shortens ParaView's names of components: "Points:0" to "x", "velocity_1" to "vy". Other names
/// are unchanged.
std::string short_name(std::string_view name) {
  static constexpr std::pair<std::string_view, const char*> vectors[] = {
      {"Points", ""}, {"velocity", "v"}, {"Velocity", "v"}, {"v", "v"}};
  for (const auto& [vector, prefix] : vectors)
    if (name.size() == vector.size() + 2 && name.starts_with(vector) &&
        (name[vector.size()] == ':' || name[vector.size()] == '_') && name.back() >= '0' &&
        name.back() <= '2')
      return prefix + std::string(1, char('x' + name.back() - '0'));
  return std::string(name);
}

}  // namespace

void read_csv(std::string_view bytes, PointSink& sink) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  sink.line = 1;
  const auto names = fields_of(take_line(bytes));
  for (std::size_t k = 0; k < names.size(); ++k) sink.name(short_name(names[k]), k);
  sink.check();
  std::vector<double> values(names.size());
  while (!bytes.empty()) {
    const std::string_view line = take_line(bytes);
    ++sink.line;
    if (trimmed(line).empty()) continue;
    const auto fields = fields_of(line);
    if (fields.size() != names.size())
      sink.fail(fmt::format("{} value{}, and the first line names {}; give every point all",
                            fields.size(), fields.size() == 1 ? "" : "s", names.size()));
    for (std::size_t k = 0; k < fields.size(); ++k) {
      const auto value = number_in(fields[k]);
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
