// SPDX-License-Identifier: MIT
#include "validate/report_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "freshet/version.h"
#include "scene/keys/keys.h"
#include "validate/repeats.h"

namespace freshet {
namespace {

/// "2/3": so many bounds are met, by each resolution that has some, from the coarsest on; "fails"
/// for a run that came to no result. A star: it misses what it is not expected to miss.
std::string bounds_met(const std::vector<ValidationRun>& of_case, const std::string& solver) {
  std::vector<std::string> all;
  for (const ValidationRun& r : of_case) {
    if (r.solver != solver) continue;
    const auto bounds = std::count_if(r.results.begin(), r.results.end(),
                                      [](auto& v) { return v.bound.has_value(); });
    const auto met = std::count_if(r.results.begin(), r.results.end(),
                                   [](auto& v) { return v.bound && v.passed; });
    if (r.error.empty() && bounds == 0) continue;
    all.push_back((r.error.empty() ? fmt::format("{}/{}", met, bounds) : "fails") +
                  (r.as_expected() ? "" : "*"));
  }
  return fmt::format("{}", fmt::join(all, ", "));
}

ReportCell cell_of(const ValidationRun& r, const std::string& measure) {
  for (const ValidationResult& v : r.results)
    if (v.name == measure) {
      const std::string range = v.repeats.empty() ? "" : fmt::format(" ({})", range_of(v));
      return {"", fmt::format("{:.3g}{}", v.value, range), "", !v.passed};
    }
  return {"", r.error.empty() ? "" : "failed", "", false};
}

std::string in_markdown(const ReportCell& c) {
  std::string text = c.word.empty() ? "" : fmt::format("`{}`{}", c.word, c.text.empty() ? "" : " ");
  text += c.missed ? "**" + c.text + "**" : c.text;
  return c.link.empty() ? text : fmt::format("[{}](#{})", text, c.link);
}

std::string in_html(const ReportCell& c) {
  std::string text = c.word.empty() ? "" : fmt::format("<code>{}</code> ", escaped(c.word));
  text +=
      c.missed ? fmt::format("<span class=\"bad\">{}</span>", escaped(c.text)) : escaped(c.text);
  return c.link.empty() ? text : fmt::format("<a href=\"#{}\">{}</a>", escaped(c.link), text);
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<') out += "&lt;";
    else if (c == '>') out += "&gt;";
    else if (c == '&') out += "&amp;";
    else if (c == '"') out += "&quot;";
    else out += c;
  }
  return out;
}

std::string resolution_of(const ValidationRun& r) {
  return fmt::format("{:g} {}", r.resolution, r.unit);
}
std::string bound_of(const ValidationResult& v) {
  return v.bound ? fmt::format("{}{:g}", v.at_least ? "at least " : "", *v.bound) : "";
}

std::string summary_of(const std::vector<ValidationRun>& runs) {
  double seconds = 0;
  std::set<std::string> commits;
  for (const ValidationRun& r : runs) {
    seconds += r.seconds;
    if (!r.commit.empty()) commits.insert(r.commit);
  }
  return fmt::format("{} Their steps took {:.0f} minutes. Version {} ({}).",
                     validation_summary(runs), seconds / 60, FRESHET_VERSION,
                     fmt::join(commits, ", "));
}

std::string validation_summary(const std::vector<ValidationRun>& runs) {
  std::size_t met = 0, bounds = 0, expected = 0;
  for (const ValidationRun& r : runs) {
    expected += r.as_expected();
    for (const ValidationResult& v : r.results) {
      bounds += v.bound.has_value();
      met += v.bound && v.passed && r.error.empty();
    }
  }
  return fmt::format(
      "{} of {} bounds are met ({:.0f} %). {} of {} runs meet or miss each bound as their case "
      "expects.",
      met, bounds, bounds ? 100.0 * double(met) / double(bounds) : 0.0, expected, runs.size());
}

std::vector<ValidationRun> runs_of(const std::vector<ValidationRun>& runs,
                                   const std::string& the_case) {
  std::vector<ValidationRun> of_case;
  for (const ValidationRun& r : runs)
    if (r.case_name == the_case) of_case.push_back(r);
  return of_case;
}

ReportTable overview_table(const std::vector<ValidationCase>& cases,
                           const std::vector<ValidationRun>& runs) {
  ReportTable table{{{"", "case", "", false}}};
  for (const char* solver : solver_words())
    if (std::any_of(runs.begin(), runs.end(), [&](auto& r) { return r.solver == solver; }))
      table[0].push_back({solver, "", "", false});
  for (const ValidationCase& c : cases) {
    const auto of_case = runs_of(runs, c.name);
    auto& row = table.emplace_back();
    row.push_back({"", c.name, c.name, false});
    for (std::size_t k = 1; k < table[0].size(); ++k)
      row.push_back({"", bounds_met(of_case, table[0][k].word), "", false});
  }
  return table;
}

ReportTable case_table(const std::vector<ValidationRun>& of_case) {
  ReportTable table{
      {{"", "run", "", false}, {"", "particles", "", false}, {"", "seconds", "", false}}};
  std::vector<std::string> names;
  for (const ValidationRun& r : of_case)
    for (const ValidationResult& v : r.results)
      if (std::find(names.begin(), names.end(), v.name) == names.end()) {
        names.push_back(v.name);
        table[0].push_back({"", v.name + (v.bound ? " (" + bound_of(v) + ")" : ""), "", false});
      }
  for (const ValidationRun& r : of_case) {
    auto& row = table.emplace_back();
    row.push_back({r.solver, resolution_of(r), "", false});
    row.push_back({"", fmt::format("{}", r.particles), "", false});
    row.push_back({"", fmt::format("{:.3g}", r.seconds), "", false});
    for (const std::string& name : names) row.push_back(cell_of(r, name));
  }
  return table;
}

std::set<std::string> reasons_of(const std::vector<ValidationRun>& of_case) {
  std::set<std::string> reasons;
  for (const ValidationRun& r : of_case) {
    reasons.insert(r.expected_failure);
    for (const ValidationResult& v : r.results) reasons.insert(v.expected_miss);
  }
  reasons.erase("");
  return reasons;
}

std::string markdown(const ReportTable& table) {
  std::string text;
  for (const auto& row : table) {
    text += '|';
    for (const ReportCell& c : row) {
      const std::string cell = in_markdown(c);
      text += (cell.empty() ? "" : " " + cell) + " |";
    }
    text += '\n';
    if (&row != &table.front()) continue;
    text += '|';
    for (std::size_t k = 0; k < row.size(); ++k) text += "---|";
    text += '\n';
  }
  return text;
}

std::string html(const ReportTable& table) {
  std::string text = "<table>\n";
  for (const auto& row : table) {
    const char* kind = &row == &table.front() ? "th" : "td";
    text += "<tr>";
    for (const ReportCell& c : row) text += fmt::format("<{0}>{1}</{0}>", kind, in_html(c));
    text += "</tr>\n";
  }
  return text + "</table>\n";
}

}  // namespace freshet
