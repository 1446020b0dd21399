// SPDX-License-Identifier: MIT
#include "import/findings.h"

#include <fmt/format.h>

#include "import/toml_text.h"

namespace freshet {
namespace {

constexpr std::size_t most_import_errors = 20;

}  // namespace

std::string ImportNote::text() const {
  return fmt::format("{}: note: {}: {}", place, key, message);
}

void ImportFindings::error(const std::string& path, const std::string& message) {
  const std::string at = place(path);
  for (const Diagnostic& d : errors_)  // two parts may read a key
    if (d.place == at && d.message == message) return;
  errors_.push_back({Diagnostic::Severity::error, at, message});
}

void ImportFindings::note(ImportNote::Kind kind, const std::string& path,
                          const std::string& message) {
  notes.push_back({kind, place(path), path, message});
}

void ImportFindings::throw_errors() {
  if (errors_.empty()) return;
  if (errors_.size() > most_import_errors) {
    const std::size_t more = errors_.size() - most_import_errors;
    errors_.resize(most_import_errors);
    errors_.push_back({Diagnostic::Severity::error, file_, fmt::format("and {} more", more)});
  }
  throw Error(Error::Kind::scene, std::move(errors_));
}

std::string comments_of(const std::string& file, const std::string& program,
                        const std::vector<ImportNote>& notes) {
  std::string text = "# Converted from " + in_one_line(file) + " of " + program + ".\n", shown;
  for (const ImportNote& note : notes)
    if (note.kind == ImportNote::Kind::display) shown += (shown.empty() ? "" : ", ") + note.key;
    else text += "# " + in_one_line(note.key + ": " + note.message) + "\n";
  if (!shown.empty()) text += "# Only for its window and its files: " + in_one_line(shown) + "\n";
  return text;
}

}  // namespace freshet
