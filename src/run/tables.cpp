// SPDX-License-Identifier: MIT
#include "run/tables.h"

#include <fmt/format.h>

namespace freshet {
namespace {

constexpr std::size_t most_waiting = 1 << 16;  // bytes

}  // namespace

void Tables::begin(const std::string& file, std::string header) {
  TableRecord& table = record_.tables[file];
  table = {};
  add(file, header);
  table.header = std::move(header);
}

void Tables::add(const std::string& file, std::string_view rows) {
  std::string& waiting = waiting_[file];
  waiting += rows;
  record_.tables[file].bytes += rows.size();
  if (waiting.size() > most_waiting) flush();
}

void Tables::flush() {
  if (waiting_.empty()) return;
  background_.add([this, rows = std::exchange(waiting_, {})] {
    for (const auto& [file, bytes] : rows) folder_.append(file, bytes);
  });
}

void Tables::flush_now() {
  for (const auto& [file, bytes] : std::exchange(waiting_, {})) folder_.append(file, bytes);
}

std::vector<Diagnostic> Tables::resume(bool prolonged) {
  std::vector<Diagnostic> missing;
  for (auto& [file, table] : record_.tables) {
    if (!prolonged) table.scheduled = table.bytes;
    const std::string& digest = prolonged ? table.scheduled_sha256 : table.sha256;
    if (folder_.continue_file(file, table.scheduled, digest)) {
      table.bytes = table.scheduled;
      continue;
    }
    begin(file, table.header);
    missing.push_back({Diagnostic::Severity::warning, (folder_.path() / file).string(),
                       "this table is missing; it begins again, without its earlier rows"});
  }
  return missing;
}

}  // namespace freshet
