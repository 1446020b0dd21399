// SPDX-License-Identifier: MIT
/// Printing to standard output and standard error. A closed descriptor, a full disk or a reader
/// that went away never throws and never ends a command. Failures of standard output are remembered
/// for output_failure(); failures of standard error are ignored.
#pragma once
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

namespace freshet::cli {

/// Opens /dev/null in place of standard descriptors that are closed: a file that is opened later
/// would get their numbers, and what is printed would end in it. Writing to them fails still.
void fill_standard_descriptors();

/// The text on one line: control characters are written as escapes, such as \n and \x1b. A terminal
/// would obey them.
std::string printable(std::string_view text);

/// Writes bytes to standard output as they are, for JSON, scripts and the progress bar.
void put(std::string_view bytes);
void flush_output();
/// The errno of the first write to standard output that failed, after flushing it; else 0. A reader
/// that went away is no failure.
int output_failure();

/// Write text with its control characters escaped, but line ends and tabs.
void put_text(std::string_view text);
void put_error(std::string_view text);  // needs no memory

template <class... Args> void print_out(fmt::format_string<Args...> text, Args&&... args) {
  put_text(fmt::format(text, std::forward<Args>(args)...));
}
template <class... Args> void print_error(fmt::format_string<Args...> text, Args&&... args) {
  put_error(fmt::format(text, std::forward<Args>(args)...));
}

/// JSON text of any nlohmann value. Bytes that are not UTF-8, of a file name for example, are
/// replaced.
template <class Json> std::string json_text(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace freshet::cli
