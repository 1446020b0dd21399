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
  /// "FILE:LINE:COLUMN", a path, "override KEY" (of an Override), "option NAME VALUE" (a member
  /// of the options of the call), or empty.
  std::string place;
  std::string message;  ///< what is wrong, what is allowed, the remedy
  /// The members of the call's options, and the keys to override, that the message names in back
  /// quotes. A program can print its own words for them.
  std::vector<std::string> options = {};

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
  Error(Kind kind, std::string place, std::string message, std::vector<std::string> options = {});

  Kind kind() const { return kind_; }
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  Kind kind_;
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace freshet
