// SPDX-License-Identifier: MIT
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace freshet {

/// One error or warning: its place, its cause and the remedy.
struct Diagnostic {
  enum class Severity { error, warning };
  Severity severity = Severity::error;
  std::string place;    ///< "FILE:LINE:COLUMN", "--set KEY", a path, or empty
  std::string message;  ///< what is wrong, what is allowed, the remedy

  /// "PLACE: error: MESSAGE" or "PLACE: warning: MESSAGE"; without "PLACE: " if `place` is empty.
  std::string text() const;
};

/// The exception of every function of the library. what() holds all diagnostics, one per line.
class Error : public std::runtime_error {
 public:
  /// scene: the scene or the request is invalid (exit code 2 of the command). run: a valid request
  /// failed, for example because the disk is full (exit code 1).
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
