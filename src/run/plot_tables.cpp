// SPDX-License-Identifier: MIT
#include "run/plot_tables.h"

#include <algorithm>
#include <map>
#include <utility>

#include "freshet/error.h"
#include "freshet/units.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void reject_run(const std::string& place, const std::string& why) {
  throw Error(Error::Kind::scene, place, why);
}

/// Whether an older version wrote the observables of a 2D run.
bool has_older_units(const Table& observables) {
  const Column* density = observables.find("density mean");
  return density && density->unit == "kg/m^2";
}

/// The unit of a column that an older version wrote in 2D. The numbers are the same.
std::string present_unit(const std::string& column, const std::string& unit) {
  const Units units = units_in(2);
  const bool stress = column.starts_with("pressure") || column.starts_with("traction");
  if (unit == "kg/m^2") return units.density;
  if (unit == "N/m") return stress ? units.pressure : units.force;
  if (unit == "N/m s") return stress ? "Pa s" : "N s/m";
  if (unit == "J") return units.energy;
  if (unit == "kg m/s") return units.momentum;
  return unit == "N" ? units.torque : unit;
}

/// Adds the sum of kinetic and potential energy as a column.
void add_total_energy(Table& table) {
  const Column *kinetic = table.find("kinetic energy"), *potential = table.find("potential energy");
  if (!kinetic || !potential || kinetic->of_words() || potential->of_words()) return;
  Column total{"total energy", kinetic->unit, {}, {}};
  for (std::size_t row = 0; row < table.rows; ++row)
    total.numbers.push_back(kinetic->numbers[row] + potential->numbers[row]);
  table.columns.push_back(std::move(total));
}

Table read_observables(const fs::path& folder) {
  const fs::path file = folder / "observables.csv";
  std::error_code ec;
  if (!fs::is_directory(folder, ec))
    reject_run(folder.string(), "no such folder; name the folder of a run, such as runs/article");
  if (!fs::is_regular_file(file, ec))
    reject_run(folder.string(),
               "no observables.csv in this folder; name the folder of a run that has written its "
               "first frame");
  Table table = read_table(file);
  const Column* time = table.find("time");
  if (!time || time->of_words())
    reject_run(file.string() + ":1",
               "no column \"time [s]\", so no run wrote this table; name the folder of a run");
  if (table.rows == 0)
    reject_run(file.string(), "no row yet; wait until the run has written its first frame");
  return table;
}

/// Whether each row is later than the row before it: a probe along a line has many rows per time.
bool is_over_time(const Table& table) {
  const Column* time = table.find("time");
  return time && !time->of_words() && table.rows > 0 &&
         std::adjacent_find(time->numbers.begin(), time->numbers.end(),
                            [](double a, double b) { return !(a < b); }) == time->numbers.end();
}

/// The rows of each word of a column, which is removed.
std::map<std::string, Table> split_by(const std::string& name, const Table& table) {
  std::map<std::string, Table> parts;
  const Column* key = table.find(name);
  if (!key) return parts;
  for (std::size_t row = 0; row < table.rows; ++row) {
    // a body may be called 1: a column of such names holds numbers
    Table& part = parts[key->of_words() ? key->words[row] : std::to_string(int(key->numbers[row]))];
    if (part.columns.empty())
      for (const Column& c : table.columns)
        if (&c != key) part.columns.push_back({c.name, c.unit, {}, {}});
    ++part.rows;
    auto to = part.columns.begin();
    for (const Column& c : table.columns) {
      if (&c == key) continue;
      if (c.of_words()) to->words.push_back(c.words[row]);
      else to->numbers.push_back(c.numbers[row]);
      ++to;
    }
  }
  return parts;
}

}  // namespace

RunTables::RunTables(const fs::path& folder) : folder_(folder) {
  Table observables = read_observables(folder);
  older_units_ = has_older_units(observables);
  update_units(observables);
  add_total_energy(observables);
  tables_.push_back({"", std::move(observables)});
}

void RunTables::update_units(Table& table) const {
  if (!older_units_) return;
  for (Column& c : table.columns) c.unit = present_unit(c.name, c.unit);
}

void RunTables::read_all() {
  if (std::exchange(complete_, true)) return;
  const auto add = [&](const std::string& owner, Table table) {
    update_units(table);
    if (is_over_time(table)) tables_.push_back({owner, std::move(table)});
  };
  std::error_code ec;
  if (fs::is_regular_file(folder_ / "percentiles.csv", ec))
    add("", read_table(folder_ / "percentiles.csv"));
  if (fs::is_regular_file(folder_ / "bodies.csv", ec))
    for (auto& [body, table] : split_by("body", read_table(folder_ / "bodies.csv")))
      add(body, std::move(table));
  std::vector<fs::path> probes;
  for (const auto& entry : fs::directory_iterator(folder_ / "probes", ec))
    if (entry.path().extension() == ".csv") probes.push_back(entry.path());
  std::sort(probes.begin(), probes.end());
  for (const fs::path& file : probes) add(file.stem().string(), read_table(file));
  std::vector<fs::path> measured;
  for (const auto& entry : fs::directory_iterator(folder_, ec))
    if (entry.path().extension() == ".csv" && entry.path().stem().string().starts_with("measured"))
      measured.push_back(entry.path());
  std::sort(measured.begin(), measured.end());
  for (const fs::path& file : measured) add(file.stem().string(), read_table(file));
}

template <class F> void RunTables::each_column(F f) const {
  for (const auto& [owner, table] : tables_) {
    const Column* time = table.find("time");
    for (const Column& c : table.columns)
      if (&c != time && !c.of_words())
        f(PlotColumn{owner.empty() ? c.name : owner + ": " + c.name, time, &c}, owner);
  }
}

std::vector<PlotColumn> RunTables::find(const std::string& name) const {
  std::vector<PlotColumn> exact, all;
  each_column([&](const PlotColumn& c, const std::string&) {
    if (c.name == name && exact.empty()) exact.push_back(c);
    if (c.values->name == name) all.push_back(c);
  });
  return exact.empty() ? all : exact;
}

std::set<std::string, std::less<>> RunTables::names() const {
  std::set<std::string, std::less<>> all;
  each_column([&](const PlotColumn& c, const std::string&) { all.insert(c.name); });
  return all;
}

}  // namespace freshet
