// SPDX-License-Identifier: MIT
/// Reads a TOML table into a Scene by walking the table of keys.
#pragma once
#include <toml++/toml.h>

#include <set>

#include "scene/keys/keys.h"

namespace freshet {

class SceneReader final : public KeyVisitor {
 public:
  /// `overridden` maps the paths that --set sets ("fluid[0].count") to "--set KEY". `dimension` is
  /// that of vectors; 0: that of domain.max in the table.
  SceneReader(const toml::table& root, std::string file,
              std::map<std::string, std::string> overridden, std::size_t dimension = 0);

  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }
  /// The place of every key and table in the scene, by path; the file itself has the path "".
  const std::map<std::string, std::string>& places() const { return places_; }
  /// The sections with a missing or invalid key.
  const std::set<std::string, std::less<>>& unread() const { return unread_; }
  /// The position by which the messages of a place are sorted; the start of the file for a place
  /// outside it.
  toml::source_position position(const std::string& place) const;
  /// Reports unknown keys at the top level; call it last.
  void finish() { report_unknown(); }

  void section(std::string_view name, std::string_view text,
               const std::function<void()>& keys) override;
  void section_if_set(std::string_view name, std::string_view text,
                      const std::function<void()>& keys) override;
  void sections(std::string_view name, std::string_view text,
                const std::function<void(std::size_t)>& resize,
                const std::function<void(std::size_t)>& keys) override;
  void text(std::string_view name, std::string& value, const KeyDoc& doc) override;
  void texts(std::string_view name, std::vector<std::string>& value, const KeyDoc& doc) override;
  void number(std::string_view name, double& value, const KeyDoc& doc) override;
  void number(std::string_view name, std::optional<double>& value, const KeyDoc& doc) override;
  void integer(std::string_view name, std::int64_t& value, const KeyDoc& doc) override;
  void integer(std::string_view name, std::optional<std::int64_t>& value,
               const KeyDoc& doc) override;
  void vector(std::string_view name, Vector& value, const KeyDoc& doc) override;
  void numbers(std::string_view name, Vector& value, std::size_t count, const KeyDoc& doc) override;
  void components(std::string_view name, Vector& value, std::span<const std::size_t> counts,
                  const KeyDoc& doc) override;
  void vectors(std::string_view name, std::vector<Vector>& value, const KeyDoc& doc) override;
  void boolean(std::string_view name, bool& value, const KeyDoc& doc) override;
  void counts(std::string_view name, Counts& value, const KeyDoc& doc) override;
  void number_or_word(std::string_view name, double& value, bool& is_word, const char* word,
                      const KeyDoc& doc) override;
  void word(std::string_view name, int& value, Words words, const KeyDoc& doc) override;
  void word_list(std::string_view name, std::vector<int>& value, Words words,
                 const KeyDoc& doc) override;

 private:
  struct Scope {  // the table that keys are read from
    const toml::table* table;
    std::string path;  // "" or "fluid[0]."
    std::string name;  // "" or "fluid."
    std::set<std::string, std::less<>> known;
  };

  const toml::node* take(std::string_view name, const KeyDoc& doc);
  void read_table(const toml::table& table, std::string path, std::string name,
                  const std::function<void()>& keys);
  std::optional<double> read_number(std::string_view name, const KeyDoc& doc, bool whole);
  /// The number if the key allows it; otherwise an error.
  std::optional<double> in_range(const std::string& name, const toml::node& node, const KeyDoc& doc,
                                 bool whole);
  /// Reads `count` numbers, or one per axis of the domain if `count` is 0.
  Vector read_array(std::string_view name, const KeyDoc& doc, bool whole, std::size_t count = 0);
  /// The numbers of an array, if the key allows all of them; otherwise errors and nothing.
  Vector read_elements(std::string_view name, const toml::array& array, const KeyDoc& doc,
                       bool whole);
  /// The index of the node's word in `words`; -1, and an error, for anything else.
  int read_word(const std::string& name, const toml::node& node, Words words);
  void report_unknown();
  void complain(const toml::source_region& where, const std::string& path, std::string message);
  /// Adds an error and marks the section of the key as unread, which skips its checks.
  void reject(const toml::source_region& where, const std::string& path, std::string message);
  std::string place_of(const toml::source_region& where, const std::string& path);

  std::string file_;
  std::size_t dimension_;  // size of domain.max; 0 if it is neither 2 nor 3
  std::map<std::string, std::string> overridden_, places_;
  std::map<std::string, toml::source_position> positions_;
  std::set<std::string, std::less<>> unread_;
  Scope scope_;
  std::vector<Diagnostic> diagnostics_;
};

/// Throws the errors in the order of the file `name`, without those beyond the first 20.
void throw_errors(std::vector<Diagnostic> errors, const SceneReader& reader,
                  const std::string& name);

}  // namespace freshet
