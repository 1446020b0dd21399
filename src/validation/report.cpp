// SPDX-License-Identifier: MIT
/// What a validation came to, for programs and for people.
#include <fmt/format.h>

#include <openssl/evp.h>
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "freshet/validate.h"
#include "freshet/version.h"

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
  if (!r.expected_failure.empty()) return r.passed() ? "passes after all" : "fails, as expected";
  return r.passed() ? "passed" : "missed";
}

/// Of a measure that two runs of a solver have: between each spacing and the next.
std::string orders(const std::vector<ValidationRun>& runs, const ValidationRun& r, std::size_t m) {
  const ValidationRun* coarser = nullptr;
  for (const ValidationRun& other : runs)
    if (other.case_name == r.case_name && other.solver == r.solver && other.spacing > r.spacing &&
        other.results.size() > m && (!coarser || other.spacing < coarser->spacing))
      coarser = &other;
  if (!coarser) return "";
  return fmt::format("{:.2f}", convergence_order(coarser->results[m].value, coarser->spacing,
                                                 r.results[m].value, r.spacing));
}

void add_run(std::string& html, const std::vector<ValidationRun>& runs, const ValidationRun& r) {
  html += fmt::format(
      "<h3>{}, spacing {:g} m: <span class=\"{}\">{}</span></h3>\n<p>{} particles, {} steps, "
      "{:.1f} "
      "s.{}{}</p>\n",
      escaped(r.solver), r.spacing, r.as_expected() ? "good" : "bad", word_of(r), r.particles,
      r.steps, r.seconds, r.expected_failure.empty() ? "" : " " + escaped(r.expected_failure),
      r.error.empty() ? "" : " " + escaped(r.error));
  if (r.results.empty()) return;
  html +=
      "<table><tr><th>measure</th><th>measured</th><th>difference or value</th><th>bound</th>"
      "<th>order</th><th>why this bound</th></tr>\n";
  for (std::size_t m = 0; m < r.results.size(); ++m) {
    const ValidationResult& v = r.results[m];
    html += fmt::format(
        "<tr><td>{}</td><td>{}</td><td class=\"{}\">{:.4g}</td><td>{}</td><td>{}</td><td>{}</td>"
        "</tr>\n",
        escaped(v.name), v.measured ? fmt::format("{:.5g}", *v.measured) : "",
        v.passed ? "good" : "bad", v.value, v.bound ? fmt::format("{:g}", *v.bound) : "none",
        orders(runs, r, m), escaped(v.reason));
  }
  html += "</table>\n<div class=\"plots\">\n";
  for (const ValidationResult& v : r.results)
    if (!v.plot.empty())
      html += fmt::format("<img alt=\"{}\" src=\"data:image/svg+xml;base64,{}\">\n",
                          escaped(v.name), base64(v.plot));
  html += fmt::format("<img alt=\"the end\" src=\"data:image/png;base64,{}\">\n</div>\n",
                      base64(r.picture));
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
    nlohmann::ordered_json run{{"case", r.case_name},  {"solver", r.solver},
                               {"spacing", r.spacing}, {"particles", r.particles},
                               {"steps", r.steps},     {"seconds", r.seconds},
                               {"passed", r.passed()}, {"as_expected", r.as_expected()}};
    if (!r.expected_failure.empty()) run["expected_failure"] = r.expected_failure;
    if (!r.error.empty()) run["error"] = r.error;
    run["measures"] = nlohmann::ordered_json::array();
    for (const ValidationResult& v : r.results) {
      nlohmann::ordered_json m{{"name", v.name}, {"value", v.value}, {"passed", v.passed}};
      if (v.measured) m["measured"] = *v.measured;
      if (v.bound) m["bound"] = *v.bound;
      run["measures"].push_back(std::move(m));
    }
    all["runs"].push_back(std::move(run));
  }
  return all.dump(2) + "\n";
}

std::string validation_html(const std::vector<ValidationCase>& cases,
                            const std::vector<ValidationRun>& runs) {
  const auto good =
      std::count_if(runs.begin(), runs.end(), [](auto& r) { return r.as_expected(); });
  std::string html = page_head;
  html +=
      fmt::format("<h1>Freshet {}: validation</h1>\n<p>{} of {} runs are as they should be.</p>\n",
                  FRESHET_VERSION, good, runs.size());
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
  std::string text =
      "| case | solver | spacing [m] | measure | came to | bound | |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const ValidationCase& c : cases)
    for (const ValidationRun& r : runs) {
      if (r.case_name != c.name) continue;
      if (!r.error.empty())
        text += fmt::format("| {} | {} | {:g} | | {} | | {} |\n", c.name, r.solver, r.spacing,
                            r.error, word_of(r));
      for (const ValidationResult& v : r.results)
        text +=
            fmt::format("| {} | {} | {:g} | {} | {:.3g} | {} | {} |\n", c.name, r.solver, r.spacing,
                        v.name, v.value, v.bound ? fmt::format("{:g}", *v.bound) : "",
                        v.passed                     ? ""
                        : r.expected_failure.empty() ? "missed"
                                                     : "fails, as expected");
    }
  return text;
}

}  // namespace freshet
