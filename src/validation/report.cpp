// SPDX-License-Identifier: MIT
/// What a validation came to, for programs and for people.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <openssl/evp.h>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "freshet/validate.h"
#include "freshet/version.h"
#include "scene/keys.h"

namespace freshet {
namespace {

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

std::string base64(const std::string& bytes) {
  std::string out(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  EVP_EncodeBlock(reinterpret_cast<unsigned char*>(out.data()),
                  reinterpret_cast<const unsigned char*>(bytes.data()), int(bytes.size()));
  out.pop_back();
  return out;
}

const char* word_of(const ValidationRun& r) {
  if (r.as_expected()) return r.passed() ? "passed" : "misses, as expected";
  const bool after_all = (r.passed() && !r.expected_failure.empty()) ||
                         std::none_of(r.results.begin(), r.results.end(),
                                      [](auto& v) { return !v.passed && v.expected_miss.empty(); });
  return r.error.empty() && after_all ? "passes what it was expected to miss" : "missed";
}

std::string resolution_of(const ValidationRun& r) {
  return fmt::format("{:g} {}", r.resolution, r.unit);
}
std::string bound_of(const ValidationResult& v) {
  return v.bound ? fmt::format("{}{:g}", v.at_least ? "at least " : "", *v.bound) : "";
}

/// Between a run and the next coarser one, of a measure that both have.
std::string order_from(const std::vector<ValidationRun>& runs, const ValidationRun& r,
                       const ValidationResult& v) {
  const ValidationRun* coarser = nullptr;
  for (const ValidationRun& other : runs)
    if (other.case_name == r.case_name && other.solver == r.solver &&
        other.resolution > r.resolution && (!coarser || other.resolution < coarser->resolution))
      coarser = &other;
  if (!coarser || v.at_least) return "";
  for (const ValidationResult& before : coarser->results)
    if (before.name == v.name)
      return fmt::format(
          "{:.2f}", convergence_order(before.value, coarser->resolution, v.value, r.resolution));
  return "";
}

void add_run(std::string& html, const std::vector<ValidationRun>& runs, const ValidationRun& r) {
  html += fmt::format(
      "<h3>{}, {}: <span class=\"{}\">{}</span></h3>\n<p>{} particles, {} steps, {:.1f} "
      "s.{}{}</p>\n",
      escaped(r.solver), resolution_of(r), r.as_expected() ? "good" : "bad", word_of(r),
      r.particles, r.steps, r.seconds,
      r.expected_failure.empty() ? "" : " " + escaped(r.expected_failure),
      r.error.empty() ? "" : " " + escaped(r.error));
  if (r.results.empty()) return;
  html +=
      "<table><tr><th>measure</th><th>measured</th><th>difference or value</th><th>bound</th>"
      "<th>order</th><th>why this bound</th></tr>\n";
  for (const ValidationResult& v : r.results)
    html += fmt::format(
        "<tr><td>{}</td><td>{}</td><td class=\"{}\">{:.4g}</td><td>{}</td><td>{}</td><td>{}{}</td>"
        "</tr>\n",
        escaped(v.name), v.measured ? fmt::format("{:.5g}", *v.measured) : "",
        v.passed ? "good" : "bad", v.value, v.bound ? bound_of(v) : "none", order_from(runs, r, v),
        escaped(v.reason),
        v.expected_miss.empty() ? "" : "; missed, as expected: " + escaped(v.expected_miss));
  html += "</table>\n<div class=\"plots\">\n";
  for (const ValidationResult& v : r.results)
    if (!v.plot.empty())
      html += fmt::format("<img alt=\"{}\" src=\"data:image/svg+xml;base64,{}\">\n",
                          escaped(v.name), base64(v.plot));
  html += fmt::format("<img alt=\"the end\" src=\"data:image/png;base64,{}\">\n</div>\n",
                      base64(r.picture));
}

/// What has been run: how long that takes, and which sources it was made from.
std::string summary_of(const std::vector<ValidationRun>& runs) {
  double seconds = 0;
  std::set<std::string> commits;
  for (const ValidationRun& r : runs) {
    seconds += r.seconds;
    if (!r.commit.empty()) commits.insert(r.commit);
  }
  const auto good =
      std::count_if(runs.begin(), runs.end(), [](auto& r) { return r.as_expected(); });
  return fmt::format(
      "{} of {} runs are as they should be. Their steps took {:.0f} minutes. Version {} "
      "({}).",
      good, runs.size(), seconds / 60, FRESHET_VERSION, fmt::join(commits, ", "));
}

/// "2/3": so many bounds are met, by each resolution that has some, from the coarsest on; "fails"
/// for a run that came to no result. A star: it misses what it is not expected to miss.
std::string cell_of(const std::vector<ValidationRun>& runs, const std::string& the_case,
                    const std::string& solver) {
  std::vector<std::string> all;
  for (const ValidationRun& r : runs) {
    if (r.case_name != the_case || r.solver != solver) continue;
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

/// A line for each measure: what each run has come to.
void add_case(std::string& text, const ValidationCase& c, const std::vector<ValidationRun>& runs) {
  std::vector<const ValidationRun*> of_case;
  for (const ValidationRun& r : runs)
    if (r.case_name == c.name) of_case.push_back(&r);
  if (of_case.empty()) return;
  text += fmt::format("\n### {}\n\n{} {} Source: {}.\n\n| run | particles | seconds |", c.name,
                      c.title + ".", c.text, c.source);
  std::vector<std::string> names;
  for (const ValidationRun* r : of_case)
    for (const ValidationResult& v : r->results)
      if (std::find(names.begin(), names.end(), v.name) == names.end()) {
        names.push_back(v.name);
        text += fmt::format(" {}{} |", v.name, v.bound ? " (" + bound_of(v) + ")" : "");
      }
  text += "\n|---|---|---|";
  for (std::size_t k = 0; k < names.size(); ++k) text += "---|";
  std::set<std::string> reasons;
  for (const ValidationRun* r : of_case) {
    text += fmt::format("\n| `{}` {} | {} | {:.3g} |", r->solver, resolution_of(*r), r->particles,
                        r->seconds);
    if (!r->expected_failure.empty()) reasons.insert(r->expected_failure);
    for (const std::string& name : names) {
      const auto v = std::find_if(r->results.begin(), r->results.end(),
                                  [&](const ValidationResult& one) { return one.name == name; });
      if (v == r->results.end()) text += r->error.empty() ? " |" : " failed |";
      else text += fmt::format(" {0}{1:.3g}{0} |", v->passed ? "" : "**", v->value);
      if (v != r->results.end() && !v->expected_miss.empty()) reasons.insert(v->expected_miss);
    }
  }
  text += "\n";
  for (const std::string& reason : reasons) text += fmt::format("\n- Missed: {}.", reason);
  if (!reasons.empty()) text += "\n";
}

constexpr const char* page_head =
    "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Freshet: validation"
    "</title><style>body{font-family:sans-serif;max-width:70em;margin:2em auto;padding:0 1em}"
    "table{border-collapse:collapse}td,th{border:1px solid #bbb;padding:.25em .6em;text-align:left}"
    ".good{color:#176b2c}.bad{color:#b00020;font-weight:bold}.plots img{max-width:34em;margin:.5em}"
    "</style></head><body>\n";

}  // namespace

std::string validation_json(const std::vector<ValidationRun>& runs) {
  nlohmann::ordered_json all;
  all["version"] = FRESHET_VERSION;
  all["runs"] = nlohmann::ordered_json::array();
  for (const ValidationRun& r : runs) {
    nlohmann::ordered_json run{
        {"case", r.case_name},      {"solver", r.solver},   {r.varies, r.resolution},
        {"particles", r.particles}, {"steps", r.steps},     {"seconds", r.seconds},
        {"commit", r.commit},       {"passed", r.passed()}, {"as_expected", r.as_expected()}};
    if (!r.expected_failure.empty()) run["expected_failure"] = r.expected_failure;
    if (!r.error.empty()) run["error"] = r.error;
    run["measures"] = nlohmann::ordered_json::array();
    for (const ValidationResult& v : r.results) {
      nlohmann::ordered_json m{{"name", v.name}, {"value", v.value}, {"passed", v.passed}};
      if (v.measured) m["measured"] = *v.measured;
      if (v.bound) m[v.at_least ? "least" : "bound"] = *v.bound;
      if (!v.expected_miss.empty()) m["expected_miss"] = v.expected_miss;
      run["measures"].push_back(std::move(m));
    }
    all["runs"].push_back(std::move(run));
  }
  return all.dump(2) + "\n";
}

std::string validation_html(const std::vector<ValidationCase>& cases,
                            const std::vector<ValidationRun>& runs) {
  std::string html = page_head;
  html += fmt::format("<h1>Freshet: validation</h1>\n<p>{}</p>\n", escaped(summary_of(runs)));
  for (const ValidationCase& c : cases) {
    html += fmt::format("<h2 id=\"{0}\">{1}</h2>\n<p>{2}</p>\n<p>Source: {3}</p>\n",
                        escaped(c.name), escaped(c.title), escaped(c.text), escaped(c.source));
    for (const ValidationRun& r : runs)
      if (r.case_name == c.name) add_run(html, runs, r);
  }
  return html + "</body></html>\n";
}

std::string validation_markdown(const std::vector<ValidationCase>& cases,
                                const std::vector<ValidationRun>& runs) {
  std::string text = summary_of(runs) + "\n\n| case |";
  std::vector<const char*> solvers;
  for (const char* solver : solver_words)
    if (std::any_of(runs.begin(), runs.end(), [&](auto& r) { return r.solver == solver; }))
      solvers.push_back(solver);
  for (const char* solver : solvers) text += fmt::format(" `{}` |", solver);
  text += "\n|---|";
  for (std::size_t k = 0; k < solvers.size(); ++k) text += "---|";
  for (const ValidationCase& c : cases) {
    text += fmt::format("\n| [{0}](#{0}) |", c.name);
    for (const char* solver : solvers) text += fmt::format(" {} |", cell_of(runs, c.name, solver));
  }
  text += "\n";
  for (const ValidationCase& c : cases) add_case(text, c, runs);
  return text;
}

}  // namespace freshet
