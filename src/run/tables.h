// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <string>
#include <string_view>

#include "io/checkpoint.h"
#include "io/run_folder.h"
#include "run/background.h"

namespace freshet {

/// CSV tables that grow on disk: rows wait in memory until flush() appends them to their files.
class Tables {
 public:
  Tables(RunRecord& record, RunFolder& folder, Background& background)
      : record_(record), folder_(folder), background_(background) {}

  /// Begins a table of the run's folder with the line of its column names.
  void begin(const std::string& file, std::string header);
  void add(const std::string& file, std::string_view rows);
  /// Appends in the background. A table is on disk before a later job runs.
  void flush();
  /// Appends at once, where no job runs.
  void flush_now();
  /// Continues the tables of a checkpoint. Rows written after it are removed. If `prolonged`, so
  /// are those that only the end of the run had asked for. A table that is missing begins again;
  /// the warnings name it. Throws Error (kind run) for a table that was changed.
  std::vector<Diagnostic> resume(bool prolonged);

 private:
  RunRecord& record_;
  RunFolder& folder_;
  Background& background_;
  std::map<std::string, std::string> waiting_;
};

}  // namespace freshet
