// SPDX-License-Identifier: MIT
#include "io/check_record.h"

#include <fmt/format.h>

#include <cmath>

#include "core/check_checkpoint.h"

namespace freshet {
namespace {

bool is_past(double seconds) { return seconds >= 0 && std::isfinite(seconds); }

/// A run changes this file, so it must be a table in the run folder.
bool is_table(const std::string& name) {
  const std::filesystem::path path(name);
  if (!path.is_relative() || path.lexically_normal() != path || path.extension() != ".csv" ||
      name.find('\0') != std::string::npos)
    return false;
  return *path.begin() != "..";
}

void check_table(const std::string& name, const TableRecord& table) {
  if (!is_table(name))
    fail_for_checkpoint(fmt::format("\"{}\" is not the name of a table in the run folder", name));
  if (table.scheduled > table.bytes || table.bytes > std::size_t(most_counted))
    fail_for_checkpoint(fmt::format("the table {} has {} scheduled bytes of {}", name,
                                    table.scheduled, table.bytes));
}

void check_series(const std::string& name, const SeriesRecord& series) {
  if (series.scheduled > series.times.size())
    fail_for_checkpoint(fmt::format("the series \"{}\" has {} scheduled files of {}", name,
                                    series.scheduled, series.times.size()));
  for (const double time : series.times)
    if (!is_past(time))
      fail_for_checkpoint(fmt::format("the series \"{}\" has a file of the time {}", name, time));
}

}  // namespace

void check_record(const RunRecord& r) {
  if (!is_past(r.seconds) || !is_past(r.observed.time))
    fail_for_checkpoint(
        fmt::format("its run took {} s, and was observed at {} s", r.seconds, r.observed.time));
  const auto is_rate = [](double x) { return x > 0 && std::isfinite(x); };
  if (r.video && !(is_rate(r.video->fps) && is_rate(r.video->speed) && r.video->file.is_absolute()))
    fail_for_checkpoint(fmt::format("its video {} has {} pictures per second and the speed {}",
                                    r.video->file.string(), r.video->fps, r.video->speed));
  for (const auto& [name, table] : r.tables) check_table(name, table);
  for (const auto& [name, series] : r.series) check_series(name, series);
  for (const auto& [output, step] : r.written)
    if (step < 0 || step > most_counted)
      fail_for_checkpoint(fmt::format("the output \"{}\" was written after step {}", output, step));
  for (const Flow& flow : r.flows)
    if ((flow.kind != "counter" && flow.particles < 0) || flow.waiting < 0)
      fail_for_checkpoint(fmt::format("the {} \"{}\" has {} particles, and {} wait", flow.kind,
                                      flow.name, flow.particles, flow.waiting));
}

}  // namespace freshet
