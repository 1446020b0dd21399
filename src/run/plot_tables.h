// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "run/table.h"

namespace freshet {

/// A column of numbers over time, and its name: "speed max", "gauge: distance", "box: velocity y".
struct PlotColumn {
  std::string name;
  const Column *time, *values;
};

/// The tables of a run folder that have a row per time: observables.csv, percentiles.csv, probes at
/// one place, and bodies.csv, whose rows are sorted by body.
class RunTables {
 public:
  /// Reads observables.csv. Throws Error (kind scene) if the folder holds no run, or the table is
  /// invalid or without rows.
  explicit RunTables(const std::filesystem::path& folder);

  const Table& observables() const { return tables_.front().table; }
  /// Reads the other tables, once.
  void read_all();
  /// The columns of that name. A name without its probe or body finds those of all.
  std::vector<PlotColumn> find(const std::string& name) const;
  /// The names of all columns that can be drawn.
  std::set<std::string, std::less<>> names() const;

 private:
  struct Owned {
    std::string owner;  // a probe or a body; empty for the run
    Table table;
  };
  template <class F> void each_column(F f) const;
  void update_units(Table& table) const;

  std::filesystem::path folder_;
  std::vector<Owned> tables_;
  bool older_units_ = false;  // of a 2D run of an older version
  bool complete_ = false;
};

}  // namespace freshet
