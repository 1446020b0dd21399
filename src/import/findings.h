// SPDX-License-Identifier: MIT
/// The errors and the notes of an import.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "freshet/import.h"

namespace freshet {

class ImportFindings {
 public:
  explicit ImportFindings(std::string file) : file_(std::move(file)) {}
  ImportFindings(const ImportFindings&) = delete;
  ImportFindings& operator=(const ImportFindings&) = delete;
  virtual ~ImportFindings() = default;

  void error(const std::string& path, const std::string& message);
  void note(ImportNote::Kind kind, const std::string& path, const std::string& message);
  /// Throws Error if there are errors.
  void throw_errors();

  std::vector<ImportNote> notes;

 protected:
  const std::string& file() const { return file_; }
  /// "FILE:LINE:COLUMN" of a key.
  virtual std::string place(const std::string& path) const = 0;

 private:
  std::string file_;
  std::vector<Diagnostic> errors_;
};

/// The notes as comments of a scene: what is taken instead, what is missing, and the keys that only
/// concern `program`'s window and files.
std::string comments_of(const std::string& file, const std::string& program,
                        const std::vector<ImportNote>& notes);

}  // namespace freshet
