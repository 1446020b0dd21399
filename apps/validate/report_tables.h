// SPDX-License-Identifier: MIT
/// The tables of a validation's report, for the page and for the documentation alike.
#pragma once
#include <set>
#include <string>
#include <vector>

#include "validate/validate.h"

namespace freshet {

struct ReportCell {
  std::string word;  ///< a name as scenes and commands write it, before the text
  std::string text;
  std::string link;     ///< a case of the same page
  bool missed = false;  ///< a bound
};
/// Rows; the first heads the columns.
using ReportTable = std::vector<std::vector<ReportCell>>;

/// What has been run: how long that took, and which sources it was made from.
std::string summary_of(const std::vector<ValidationRun>& runs);

/// "0.01 m"
std::string resolution_of(const ValidationRun& r);
/// "at least 1.5"; nothing where there is no bound
std::string bound_of(const ValidationResult& v);

/// Cases by solvers: how many of its bounds each run has met.
ReportTable overview_table(const std::vector<ValidationCase>& cases,
                           const std::vector<ValidationRun>& runs);

/// Runs by measures: what each has come to.
ReportTable case_table(const std::vector<ValidationRun>& of_case);

/// Why runs miss what they are expected to miss.
std::set<std::string> reasons_of(const std::vector<ValidationRun>& of_case);

std::vector<ValidationRun> runs_of(const std::vector<ValidationRun>& runs,
                                   const std::string& the_case);

std::string markdown(const ReportTable& table);
std::string html(const ReportTable& table);
/// Text with <, >, & and quotes as a page writes them.
std::string escaped(const std::string& text);

}  // namespace freshet
