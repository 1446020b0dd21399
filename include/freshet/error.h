// SPDX-License-Identifier: MIT
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace freshet {

/// One thing that is wrong (or doubtful), where it stands, and what to do about it.
struct Diagnostic {
  enum class Severity { error, warning };
  Severity severity = Severity::error;
  std::string place;    ///< "FILE:LINE:COLUMN", "--set KEY", a path, or empty
  std::string message;  ///< what was found, what is allowed, the remedy

  /// "PLACE: error: MESSAGE", without "PLACE: " where there is none.
  std::string text() const;
};

/// What every function of the library throws. what() holds all diagnostics, a line each.
class Error : public std::runtime_error {
 public:
  /// scene: the scene or the request is wrong (exit code 2 of the command); run: something
  /// failed while it was carried out (exit code 1), for example a full disk.
  enum class Kind { scene, run };

  Error(Kind kind, std::vector<Diagnostic> diagnostics);
  Error(Kind kind, std::string place, std::string message);

  Kind kind() const { return kind_; }
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  Kind kind_;
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace freshet
