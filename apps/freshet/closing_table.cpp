// SPDX-License-Identifier: MIT
#include "closing_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <vector>

#include "freshet/units.h"
#include "progress.h"

namespace freshet::cli {
namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> all;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) all.push_back(cell);
  return all;
}

/// "pressure 2150 Pa at 0.42 s"; no words for a table without values.
struct Peak {
  double magnitude = -1;
  std::string words;
};

/// The cell of largest magnitude in the columns of a probe's table whose names begin with `name`.
Peak peak(const std::filesystem::path& table, const std::string& name) {
  std::error_code ec;
  if (!std::filesystem::is_regular_file(table, ec)) return {};  // another program put it there
  std::ifstream in(table);
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> names = cells(line);
  Peak most;
  while (std::getline(in, line)) {
    const std::vector<std::string> row = cells(line);
    for (std::size_t k = 0; k < std::min(row.size(), names.size()); ++k) {
      if (!names[k].starts_with(name)) continue;
      const double value = std::strtod(row[k].c_str(), nullptr);
      if (!(std::abs(value) > most.magnitude)) continue;
      most.magnitude = std::abs(value);
      const auto unit = names[k].find(" [");
      most.words = fmt::format("{} {:.5g} {} at {} s", names[k].substr(0, unit), value,
                               names[k].substr(unit + 2, names[k].size() - unit - 3), row[0]);
    }
  }
  return most;
}

std::string vector_words(const std::vector<double>& v) {
  std::string words;
  for (const double x : v) words += fmt::format("{}{:.5g}", words.empty() ? "" : ", ", x);
  return v.size() > 1 ? "(" + words + ")" : words;
}

class Table {
 public:
  Table(const Scene& s, const Report& r) : s_(s), r_(r) {}

  std::string text(const std::filesystem::path& output) {
    if (r_.statistics.particles > 0 || !r_.flows.empty()) fluid();  // not for bodies alone
    if (s_.is_article() || has_check("bright fraction")) picture();
    forces();
    flows();
    for (std::size_t k = 0; k < s_.probe.size(); ++k) probe(k, output);
    for (const SolveStatistics& solve : r_.solves) row(solve.name + " solve", solve_words(solve));
    if (!r_.solves.empty()) row("steps halved", std::to_string(r_.time_steps.retried));
    return std::move(text_);
  }

 private:
  const CheckResult* check(const std::string& name) const {
    for (const CheckResult& c : r_.checks)
      if (c.name == name) return &c;
    return nullptr;
  }
  bool has_check(const std::string& name) const { return check(name) != nullptr; }
  void row(const std::string& name, const std::string& value, const std::string& check = "") {
    const std::string line = fmt::format("  {:<22}{:<26}{}", name, value, check);
    text_ += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  void checked(const std::string& name, const std::string& value, double scale = 1,
               const char* unit = "") {
    const CheckResult* c = check(name == "bright pixels" ? "bright fraction" : name);
    row(name, value,
        c ? fmt::format("{} {:g}{}  {}", c->relation, scale * c->bound, unit, verdict(*c)) : "");
  }
  /// A check is a condition at the end of a run, which an interrupted one has not reached.
  const char* verdict(const CheckResult& c) const {
    return r_.state == Report::State::interrupted ? "at the end" : c.passed ? "ok" : "FAILED";
  }
  /// Rows of the article's scene and of checks appear there only.
  bool wants(const std::string& name) const { return s_.is_article() || has_check(name); }

  void fluid() {
    const Statistics& t = r_.statistics;
    if (wants("out of bounds") || t.out_of_bounds > 0)
      checked("out of bounds", fmt::format("{} of {}", t.out_of_bounds, t.particles));
    else row("particles", std::to_string(t.particles));
    if (wants("density mean"))
      checked("density mean",
              fmt::format("{:.5f} {}", t.density_mean, raised_unit(units_.density)));
    if (s_.is_article())
      row("density min, max", fmt::format("{:.5f}, {:.5f}", t.density_min, t.density_max));
    else
      row("volume error", fmt::format("{:.2g} % too dense on average, {:.2g} % at most",
                                      100 * t.density_error_mean, 100 * t.density_error_max));
    checked("speed mean", fmt::format("{:.6f} m/s", t.speed_mean));
    row("speed max", fmt::format("{:.6f} m/s", t.speed_max));
    if (wants("height mean")) checked("height mean", fmt::format("{:.6f} m", t.height_mean));
    row("energy", fmt::format("{:.5g} {} kinetic, {:.5g} {} potential", t.kinetic_energy,
                              units_.energy, t.potential_energy, units_.energy));
  }
  void picture() {
    checked("bright pixels",
            fmt::format("{} ({:.1f} %)", r_.picture.bright, 100 * r_.picture.bright_fraction()),
            100, " %");
    row("bottom third", fmt::format("{} pixels", r_.picture.bottom_third));
  }
  void forces() {
    for (const auto& [name, force] : r_.wall_forces)
      if (std::any_of(force.begin(), force.end(), [](double f) { return f != 0; }))
        row("force on " + name, fmt::format("{} {}", vector_words(force), units_.force));
    for (const auto& [name, body] : r_.bodies) {
      const auto n = std::ptrdiff_t(s_.dimension());
      row("body " + name,
          fmt::format("at {} m, force {} {}",
                      vector_words({body.position.begin(), body.position.begin() + n}),
                      vector_words({body.force.begin(), body.force.begin() + n}), units_.force));
    }
  }
  void flows() {
    for (const Flow& flow : r_.flows)
      row(flow.kind + " " + flow.name,
          fmt::format("{:.6g} {}, {} particles{}", flow.volume, raised_unit(units_.volume),
                      flow.particles,
                      flow.waiting > 0 ? fmt::format(", {} wait", flow.waiting) : ""));
  }
  void probe(std::size_t k, const std::filesystem::path& output) {
    const Scene::Probe& p = s_.probe[k];
    const std::string name = p.name.empty() ? fmt::format("probe_{}", k) : p.name;
    const char* quantity = p.kind == ProbeKind::surface ? "distance"
                           : p.kind == ProbeKind::wall  ? "traction"
                                                        : "pressure";
    const Peak most = peak(output / "probes" / (name + ".csv"), quantity);
    const bool dry = p.kind == ProbeKind::wall && most.magnitude == 0;
    row("peak at " + name, dry ? "dry" : most.words.empty() ? "no fluid" : most.words);
  }

  const Scene& s_;
  const Report& r_;
  const Units units_ = units_in(s_.dimension());
  std::string text_;
};

}  // namespace

std::string closing_table(const Scene& scene, const Report& report,
                          const std::filesystem::path& output) {
  return Table(scene, report).text(output);
}

}  // namespace freshet::cli
