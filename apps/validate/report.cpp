// SPDX-License-Identifier: MIT
/// What a validation came to, for programs and for people.
#include <fmt/format.h>

#include <openssl/evp.h>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "freshet/version.h"
#include "validate/repeats.h"
#include "validate/report_tables.h"
#include "validate/validate.h"

namespace freshet {
namespace {

std::string base64(const std::string& bytes) {
  std::string out(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  EVP_EncodeBlock(reinterpret_cast<unsigned char*>(out.data()),
                  reinterpret_cast<const unsigned char*>(bytes.data()), int(bytes.size()));
  out.pop_back();
  return out;
}

bool has_bounds(const ValidationRun& r) {
  return !r.error.empty() || !r.expected_failure.empty() ||
         std::any_of(r.results.begin(), r.results.end(), [](auto& v) { return v.bound; });
}

const char* word_of(const ValidationRun& r) {
  if (!has_bounds(r)) return "no bounds";
  if (r.as_expected()) return r.passed() ? "passed" : "misses, as expected";
  const bool after_all = (r.passed() && !r.expected_failure.empty()) ||
                         std::none_of(r.results.begin(), r.results.end(),
                                      [](auto& v) { return !v.passed && v.expected_miss.empty(); });
  return r.error.empty() && after_all ? "passes, though expected to miss" : "missed";
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

/// What may be opened of a run: its measures with their bounds, its curves and its picture.
void add_run(std::string& page, const std::vector<ValidationRun>& of_case, const ValidationRun& r) {
  page += fmt::format(
      "<details{}><summary>{}, {}: <span class=\"{}\">{}</span></summary>\n<p>{} particles, {} "
      "steps, {:.1f} s.{}{}</p>\n",
      &r == &of_case.front() ? " open" : "", escaped(r.solver), resolution_of(r),
      !has_bounds(r)    ? ""
      : r.as_expected() ? "good"
                        : "bad",
      word_of(r), r.particles, r.steps, r.seconds,
      r.expected_failure.empty() ? "" : " " + escaped(r.expected_failure),
      r.error.empty() ? "" : " " + escaped(r.error));
  page +=
      "<table><tr><th>measure</th><th>measured</th><th>difference or value</th><th>bound</th>"
      "<th>order</th><th>why this bound</th></tr>\n";
  for (const ValidationResult& v : r.results)
    page += fmt::format(
        "<tr><td>{}</td><td>{}</td><td "
        "class=\"{}\">{:.4g}{}</td><td>{}</td><td>{}</td><td>{}{}</td>"
        "</tr>\n",
        escaped(v.name), v.measured ? fmt::format("{:.5g}", *v.measured) : "",
        !v.bound   ? ""
        : v.passed ? "good"
                   : "bad",
        v.value, v.repeats.empty() ? "" : fmt::format(" ({})", range_of(v)),
        v.bound ? bound_of(v) : "none", order_from(of_case, r, v), escaped(v.reason),
        v.expected_miss.empty() ? "" : "; missed, as expected: " + escaped(v.expected_miss));
  page += "</table>\n<div class=\"plots\">\n";
  for (const ValidationResult& v : r.results)
    if (!v.plot.empty())
      page += fmt::format("<img alt=\"{}\" src=\"data:image/svg+xml;base64,{}\">\n",
                          escaped(v.name), base64(v.plot));
  page +=
      fmt::format("<img alt=\"final state\" src=\"data:image/png;base64,{}\">\n</div></details>\n",
                  base64(r.picture));
}

constexpr const char* page_head =
    "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Freshet: validation"
    "</title><style>body{font-family:sans-serif;max-width:70em;margin:2em auto;padding:0 1em}"
    "table{border-collapse:collapse}td,th{border:1px solid #bbb;padding:.25em .6em;text-align:left}"
    ".good{color:#176b2c}.bad{color:#b00020;font-weight:bold}.plots img{max-width:34em;margin:.5em}"
    "summary{cursor:pointer;margin:.4em 0}</style></head><body>\n";

constexpr const char* overview_text =
    "A fraction counts the bounds that a run meets: one fraction per resolution, the coarsest "
    "first. "
    "A star marks a run that does not meet or miss each bound as its case expects.";

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
      if (!v.repeats.empty()) m["repeats"] = v.repeats;
      if (v.bound) m[v.at_least ? "least" : "bound"] = *v.bound;
      if (!v.expected_miss.empty()) m["expected_miss"] = v.expected_miss;
      run["measures"].push_back(std::move(m));
    }
    all["runs"].push_back(std::move(run));
  }
  return all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string validation_html(const std::vector<ValidationCase>& cases,
                            const std::vector<ValidationRun>& runs) {
  std::string page = page_head;
  page += fmt::format("<h1>Freshet: validation</h1>\n<p>{}</p>\n<p>{}</p>\n",
                      escaped(summary_of(runs)), overview_text);
  page += html(overview_table(cases, runs));
  for (const ValidationCase& c : cases) {
    const auto of_case = runs_of(runs, c.name);
    page += fmt::format("<h2 id=\"{0}\">{1}</h2>\n<p>{2}</p>\n<p>Source: {3}</p>\n",
                        escaped(c.name), escaped(c.title), escaped(c.text), escaped(c.source));
    page += html(case_table(of_case));
    for (const std::string& reason : reasons_of(of_case))
      page += fmt::format("<p>Missed: {}.</p>\n", escaped(reason));
    for (const ValidationRun& r : of_case) add_run(page, of_case, r);
  }
  return page + "</body></html>\n";
}

std::string validation_markdown(const std::vector<ValidationCase>& cases,
                                const std::vector<ValidationRun>& runs) {
  std::string text = summary_of(runs) + "\n\n" + markdown(overview_table(cases, runs));
  for (const ValidationCase& c : cases) {
    const auto of_case = runs_of(runs, c.name);
    if (of_case.empty()) continue;
    text += fmt::format("\n### {}\n\n{}. {} Source: {}.\n\n", c.name, c.title, c.text, c.source);
    text += markdown(case_table(of_case));
    const auto reasons = reasons_of(of_case);
    for (const std::string& reason : reasons) text += fmt::format("\n- Missed: {}.", reason);
    if (!reasons.empty()) text += "\n";
  }
  return text;
}

}  // namespace freshet
