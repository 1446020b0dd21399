// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

#include "core/input_file.h"
#include "scene/check/check.h"
#include "scene/keys/nesting.h"
#include "scene/keys/overrides.h"
#include "scene/keys/parse_toml.h"
#include "scene/keys/reader.h"
#include "scene/model/setup.h"

namespace freshet {
namespace {

constexpr InputFile scene_file{.noun = "scene file",
                               .remedy = "name a scene file (*.toml)",
                               .may_be_empty = true,
                               .largest = 16u << 20};
constexpr std::size_t most_errors = 20;

/// Remedies for syntax errors, by a part of the parser's message.
constexpr const char* syntax_remedies[][2] = {
    {"unknown escape sequence", "write \\\\ for a backslash, or quote with '...'"},
    {"could not determine value type", "words need quotes: \"word\""},
    {"saw ','", "write decimals with a point, and several numbers in brackets: [1.0, 2.0]"},
    {"expected a comment or whitespace",
     "write one value per line, and its unit in a comment: # m"},
    {"unescaped control characters", "close the quotes on the same line, or write it as \\uXXXX"},
    {"cannot redefine existing table 'fluid'", "for several fluids, write each as [[fluid]]"},
    {"cannot redefine existing table 'body'", "for several bodies, write each as [[body]]"},
    {"cannot redefine existing table 'wall'", "for several walls, write each as [[wall]]"},
    {"cannot redefine existing table 'probe'", "for several probes, write each as [[probe]]"},
    {"cannot redefine existing table 'inlet'", "for several inlets, write each as [[inlet]]"},
    {"cannot redefine existing table 'outlet'", "for several outlets, write each as [[outlet]]"},
    {"cannot redefine existing table 'counter'", "for several counters, write each as [[counter]]"},
    {"cannot redefine existing table 'joint'", "for several joints, write each as [[joint]]"},
    {"cannot redefine existing table 'camera'", "for several key frames, write each as [[camera]]"},
    {"cannot redefine", "keep one of the two"},
    {"expected decimal digit, saw '.'", "write a zero before the point: 0.5"},
    {"expected decimal digit", "write numbers like 0.5, 2 or 1e-3"},
    {"closing ']'", "close the array with ]"},
    {"expected ']'", "close the name of the table with ]"},
    {"expected value", "write a value after the ="},
    {"expected '='", "write KEY = VALUE"},
    {"not representable", "write it with a point or an exponent: 1e20"},
    {"invalid utf-8", "save the file as UTF-8"},
    {"expected keys, tables", "write KEY = VALUE or [TABLE]; is it a {}?"}};

/// The parser's message about a syntax error, reworded, with a remedy if one is known. `noun`: what
/// the file should be.
std::string syntax_message(std::string words, const char* noun) {
  constexpr std::string_view parsing = "Error while parsing ";
  if (const auto colon = words.find(": "); words.starts_with(parsing) && colon != words.npos) {
    const std::string part = words.substr(parsing.size(), colon - parsing.size());
    const bool twice = words.find("cannot redefine") != std::string::npos;
    words = twice ? words.substr(colon + 2)
                  : fmt::format("this {} is not TOML{}", part == "root table" ? "line" : part,
                                words.substr(colon));
  } else if (!words.empty()) {
    words =
        fmt::format("this file is not TOML: {}{}", char(std::tolower(words[0])), words.substr(1));
  }
  for (const auto& [symptom, remedy] : syntax_remedies)
    if (words.find(symptom) != std::string::npos)
      return fmt::format("{}; {}", words, fmt::format(fmt::runtime(remedy), noun));
  return words;
}

/// The scene with its overrides, for the run folder.
std::string merged_source(const toml::table& table, const std::vector<Override>& overrides) {
  std::ostringstream merged;
  merged << "# as run; set on the command line:\n";
  for (const auto& [key, value] : overrides) {
    std::string line = key;  // a quoted key of TOML may hold a line end
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < ' '; }, '?');
    merged << "#   " << line << (value ? "" : " (removed)") << "\n";
  }
  merged << table << "\n";
  return merged.str();
}

/// Resolves file names, which are relative to the scene file.
void find_files(Scene& scene, const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(name).parent_path();
  const auto find = [&](Scene::Region& r) {
    if (!r.file.empty()) r.file = (folder / r.file).lexically_normal().string();
  };
  for (Scene::Fluid& f : scene.fluid) {
    find(f);
    if (!f.from_run.empty()) f.from_run = (folder / f.from_run).lexically_normal().string();
  }
  for (Scene::Wall& w : scene.wall) find(w);
  for (Scene::Body& b : scene.body) {
    find(b);
    if (!b.path.empty()) b.path = (folder / b.path).lexically_normal().string();
  }
}

/// The scene of a table, with its defaults. The reader keeps the errors.
Scene read_scene(SceneReader& reader, const std::string& name) {
  Scene scene;
  visit_keys(reader, scene);
  reader.finish();
  find_files(scene, name);
  scene = with_defaults(std::move(scene));
  scene.places = reader.places();
  return scene;
}

/// The keys of a scene that its solver does not use.
std::vector<UnusedKey> unused_keys_in(const std::string& text, const std::string& name,
                                      const std::vector<Override>& overrides) {
  toml::table table = parse_toml(text, name);
  const auto overridden = apply_overrides(table, overrides);
  SceneReader reader(table, name, overridden);
  const Scene scene = read_scene(reader, name);
  return unused_keys(scene, reader.unread());
}

/// Overrides may make keys of the file unused; another override can remove these.
void offer_removal(const std::vector<UnusedKey>& unused, std::vector<Diagnostic>& errors) {
  for (Diagnostic& error : errors)
    for (const UnusedKey& k : unused)
      if (error.place == k.why.place && error.message == k.why.message &&
          !error.place.starts_with("override ")) {
        error.message += "; `removal " + k.key + "` removes it for this run";
        error.options.push_back("removal " + k.key);
        break;
      }
}

}  // namespace

void throw_errors(std::vector<Diagnostic> errors, const SceneReader& reader,
                  const std::string& name) {
  if (errors.empty()) return;
  std::stable_sort(errors.begin(), errors.end(), [&](const Diagnostic& a, const Diagnostic& b) {
    return reader.position(a.place) < reader.position(b.place);
  });
  if (errors.size() > most_errors) {
    const auto rest = errors.size() - most_errors;
    errors.resize(most_errors);
    errors.push_back(
        {Diagnostic::Severity::error, name,
         fmt::format("and {} more error{}; fix these first", rest, rest == 1 ? "" : "s")});
  }
  throw Error(Error::Kind::scene, std::move(errors));
}

toml::table parse_toml(const std::string& text, const std::string& name, const char* noun) {
  if (const NestingScan scan(text); scan.too_deep())
    throw Error(Error::Kind::scene, fmt::format("{}:{}:1", name, scan.line()),
                fmt::format("keys or brackets are nested too deeply in this line; at most {} "
                            "levels are allowed; is it a {}?",
                            NestingScan::deepest, noun));
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& e) {
    const auto at = e.source().begin;
    throw Error(Error::Kind::scene, fmt::format("{}:{}:{}", name, at.line, at.column),
                syntax_message(std::string(e.description()), noun));
  }
}

Scene parse_scene(const std::string& text, const std::string& name,
                  const std::vector<Override>& overrides) {
  toml::table table = parse_toml(text, name);
  const auto overridden = apply_overrides(table, overrides);
  SceneReader reader(table, name, overridden);
  Scene scene = read_scene(reader, name);
  std::vector<Diagnostic> errors = reader.diagnostics();
  const auto more = contradictions(scene, reader.unread());
  errors.insert(errors.end(), more.begin(), more.end());
  if (!overrides.empty()) offer_removal(unused_keys(scene, reader.unread()), errors);
  throw_errors(std::move(errors), reader, name);
  scene.source = overrides.empty() ? text : merged_source(table, overrides);
  return scene;
}

Scene load_scene(const std::filesystem::path& file, const std::vector<Override>& overrides) {
  return parse_scene(read_input(file, scene_file), file.string(), overrides);
}

SceneChange change_solver(const std::filesystem::path& file, const std::string& solver,
                          const std::vector<Override>& overrides) {
  const std::string text = read_input(file, scene_file), name = file.string();
  std::set<std::string> kept;
  for (const UnusedKey& k : unused_keys_in(text, name, {})) kept.insert(k.key);
  SceneChange change{overrides, {}};
  change.overrides.emplace_back("solver.name", fmt::format("\"{}\"", solver));
  for (bool more = true; more;) {  // other keys may depend on those that are dropped
    more = false;
    for (UnusedKey& k : unused_keys_in(text, name, change.overrides)) {
      if (k.why.place.starts_with("override ") || !kept.insert(k.key).second) continue;
      change.overrides.emplace_back(k.key, std::nullopt);
      k.why.severity = Diagnostic::Severity::warning;
      k.why.message = "dropped: " + k.why.message.substr(0, k.why.message.rfind("; "));
      change.dropped.push_back(std::move(k.why));
      more = true;
    }
  }
  return change;
}

}  // namespace freshet
