// SPDX-License-Identifier: MIT
#include "freshet/error.h"

namespace freshet {
namespace {

std::string join(const std::vector<Diagnostic>& diagnostics) {
  std::string all;
  for (const Diagnostic& d : diagnostics) all += (all.empty() ? "" : "\n") + d.text();
  return all;
}

}  // namespace

std::string Diagnostic::text() const {
  const char* word = severity == Severity::error ? "error: " : "warning: ";
  return (place.empty() ? "" : place + ": ") + word + message;
}

Error::Error(Kind kind, std::vector<Diagnostic> diagnostics)
    : std::runtime_error(join(diagnostics)), kind_(kind), diagnostics_(std::move(diagnostics)) {}

Error::Error(Kind kind, std::string place, std::string message, std::vector<std::string> options)
    : Error(kind, {{Diagnostic::Severity::error, std::move(place), std::move(message),
                    std::move(options)}}) {}

}  // namespace freshet
