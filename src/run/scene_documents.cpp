// SPDX-License-Identifier: MIT
/// The table of scene keys as a JSON Schema and as Markdown.
#include "freshet/scene_documents.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "scene/keys/keys.h"

namespace freshet {
namespace {

using Json = nlohmann::ordered_json;

/// Reduces every kind of key to one call: its type, its default and, of an enum, its names.
class Describer : public KeyVisitor {
 public:
  void text(std::string_view n, std::string& v, const KeyDoc& d) override {
    key(n, "string", fmt::format("\"{}\"", v), d);
  }
  void number(std::string_view n, double& v, const KeyDoc& d) override {
    key(n, "number", fmt::format("{}", v), d);
  }
  void number(std::string_view n, std::optional<double>&, const KeyDoc& d) override {
    key(n, "number", "", d);
  }
  void integer(std::string_view n, std::int64_t& v, const KeyDoc& d) override {
    key(n, "integer", fmt::format("{}", v), d);
  }
  void integer(std::string_view n, std::optional<std::int64_t>&, const KeyDoc& d) override {
    key(n, "integer", "", d);
  }
  void vector(std::string_view n, Vector& v, const KeyDoc& d) override {
    key(n, "2 or 3 numbers", fmt::format("[{}]", fmt::join(v, ", ")), d);
  }
  void numbers(std::string_view n, Vector&, std::size_t count, const KeyDoc& d) override {
    key(n, fmt::format("{} numbers", count), "", d);
  }
  void components(std::string_view n, Vector&, std::span<const std::size_t> counts,
                  const KeyDoc& d) override {
    key(n, fmt::format("number, or {} numbers", fmt::join(counts, " or ")), "", d);
  }
  void vectors(std::string_view n, std::vector<Vector>&, const KeyDoc& d) override {
    key(n, "list of points", "", d);
  }
  void boolean(std::string_view n, bool& v, const KeyDoc& d) override {
    key(n, "boolean", v ? "true" : "false", d);
  }
  void counts(std::string_view n, Counts&, const KeyDoc& d) override {
    key(n, "2 or 3 integers", "", d);
  }
  void number_or_word(std::string_view n, double&, bool&, const char* word,
                      const KeyDoc& d) override {
    words_ = {word};
    key(n, "number or name", "", d);
    words_.clear();
  }
  void word(std::string_view n, int& v, Words words, const KeyDoc& d) override {
    words_ = {words.begin(), words.end()};
    key(n, "name", v < 0 ? "" : fmt::format("\"{}\"", words_[std::size_t(v)]), d);
    words_.clear();
  }
  void texts(std::string_view n, std::vector<std::string>&, const KeyDoc& d) override {
    key(n, "list of strings", "none", d);
  }
  void word_list(std::string_view n, std::vector<int>& v, Words words, const KeyDoc& d) override {
    words_ = {words.begin(), words.end()};
    std::string list;
    for (const int place : v)
      list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", words_[std::size_t(place)]);
    key(n, "list of names", fmt::format("[{}]", list), d);
    words_.clear();
  }

 protected:
  virtual void key(std::string_view name, std::string_view type, const std::string& fallback,
                   const KeyDoc& doc) = 0;
  std::vector<std::string> words_;
};

class SchemaWriter final : public Describer {
 public:
  Json root{{"$schema", "http://json-schema.org/draft-07/schema#"},
            {"title", "Freshet scene"},
            {"type", "object"},
            {"additionalProperties", false}};

  void section(std::string_view name, std::string_view text,
               const std::function<void()>& keys) override {
    Json table = object(text);
    Json* const outer = std::exchange(at_, &table);
    keys();
    at_ = outer;
    add(name, table);
  }
  void sections(std::string_view name, std::string_view text,
                const std::function<void(std::size_t)>& resize,
                const std::function<void(std::size_t)>& keys) override {
    Json table = object(text);
    Json* const outer = std::exchange(at_, &table);
    resize(1);
    keys(0);
    at_ = outer;
    add(name, {{"oneOf", {table, {{"type", "array"}, {"items", table}}}}});
  }

 private:
  static Json object(std::string_view text) {
    return {{"description", text}, {"type", "object"}, {"additionalProperties", false}};
  }
  void add(std::string_view name, const Json& value) {
    (*at_)["properties"][std::string(name)] = value;
  }
  static Json number(const char* type, const KeyDoc& doc) {
    Json json{{"type", type}};
    if (std::isfinite(doc.min)) json[doc.above ? "exclusiveMinimum" : "minimum"] = doc.min;
    if (std::isfinite(doc.max)) json["maximum"] = doc.max;
    return json;
  }
  static Json numbers_of(int count, const KeyDoc& doc) {
    return {{"type", "array"},
            {"items", number("number", doc)},
            {"minItems", count},
            {"maxItems", count}};
  }
  /// The digits in `type` are the counts that are allowed.
  static Json number_or_numbers(std::string_view type, const KeyDoc& doc) {
    Json all = Json::array({number("number", doc)});
    for (const char c : type)
      if (c >= '0' && c <= '9') all.push_back(numbers_of(c - '0', doc));
    return {{"oneOf", all}};
  }
  void key(std::string_view name, std::string_view type, const std::string& fallback,
           const KeyDoc& doc) override {
    Json json;
    if (type == "name") json = {{"enum", words_}};
    else if (type == "list of names")
      json = {{"type", "array"}, {"items", {{"enum", words_}}}, {"uniqueItems", true}};
    else if (type == "number or name")
      json = {{"oneOf", {number("number", doc), {{"enum", words_}}}}};
    else if (type.starts_with("number, or")) json = number_or_numbers(type, doc);
    else if (type == "list of points") json = {{"type", "array"}, {"items", numbers_of(2, doc)}};
    else if (type == "list of strings")
      json = {{"type", "array"}, {"items", {{"type", "string"}}}, {"minItems", 2}, {"maxItems", 3}};
    else if (type == "string") json = {{"type", "string"}};
    else if (type == "number") json = number("number", doc);
    else if (type == "integer") json = number("integer", doc);
    else if (type == "boolean") json = {{"type", "boolean"}};
    else if (const auto n = type.front() - '0'; type == fmt::format("{} numbers", n))
      json = numbers_of(n, doc);
    else
      json = {{"type", "array"},
              {"items", number(type == "2 or 3 integers" ? "integer" : "number", doc)},
              {"minItems", 2},
              {"maxItems", 3}};
    json["description"] =
        fmt::format("{}{}", doc.text, doc.unit.empty() ? "" : fmt::format(" [{}]", doc.unit));
    if (doc.required) (*at_)["required"].push_back(std::string(name));
    else if (doc.fallback.empty()) json["default"] = Json::parse(fallback);
    add(name, json);
  }
  Json* at_ = &root;
};

class MarkdownWriter final : public Describer {
 public:
  std::string out;

  void section(std::string_view name, std::string_view text,
               const std::function<void()>& keys) override {
    heading(fmt::format("[{}]", name), text);
    keys();
  }
  void sections(std::string_view name, std::string_view text,
                const std::function<void(std::size_t)>& resize,
                const std::function<void(std::size_t)>& keys) override {
    heading(fmt::format("[{}{}]", outer_, name), text);
    const std::string before = std::exchange(outer_, fmt::format("{}{}.", outer_, name));
    resize(1);
    keys(0);
    outer_ = before;
  }
  void heading(std::string_view title, std::string_view text) {
    out += fmt::format(
        "\n## {}\n\n{}\n\n| key | type | unit | default | range | meaning |\n"
        "|---|---|---|---|---|---|\n",
        title, text);
  }

 private:
  std::string outer_;  // of tables in tables
  std::string range(const KeyDoc& doc) const {
    std::string text;
    if (!words_.empty()) text = fmt::format("`{}`", fmt::join(words_, "`, `"));
    if (std::isfinite(doc.min))
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", doc.above ? ">" : "≥", doc.min);
    if (std::isfinite(doc.max))
      text += fmt::format("{}≤ {:.10g}", text.empty() ? "" : ", ", doc.max);
    return text;
  }
  void key(std::string_view name, std::string_view type, const std::string& fallback,
           const KeyDoc& doc) override {
    const std::string initial = doc.required           ? "required"
                                : doc.fallback.empty() ? fmt::format("`{}`", fallback)
                                                       : std::string(doc.fallback);
    out += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", name, type, doc.unit, initial,
                       range(doc), doc.text);
  }
};

}  // namespace

std::string scene_schema() {
  SchemaWriter writer;
  Scene defaults;
  visit_keys(writer, defaults);
  return writer.root.dump(2) + "\n";
}

std::string scene_reference() {
  MarkdownWriter writer;
  writer.out = R"(# Scenes

A scene is a TOML file. This one drops a column of water, 1 m wide and 2 m high, in a tank:

```toml
title = "A column of water collapses"

[domain]
max = [4.0, 3.0]          # m; two numbers make a scene in 2D

[particles]
spacing = 0.02
support_radius = 0.06

[fluid]
min = [0.0, 0.0]
max = [1.0, 2.0]

[solver]
name = "delta_sph"
kernel = "wendland_c2"

[walls]
method = "adami2012"
slip = "free_slip"

[time]
end = 2.25
step = "adaptive"
step_max = 0.001
```

`freshet check my_scene.toml` checks it, `freshet run my_scene.toml` runs it. `freshet scenes` lists
the bundled scenes.

- All units are SI.
- A scene has as many dimensions as `domain.max` has numbers, 2 or 3. Every vector has that many.
- A 2D scene is a slice one metre deep. Masses, forces, torques and energies are per metre of depth,
  densities are in kg/m³ and pressures in Pa.
- y points up in 2D and 3D.
- Unknown keys are errors. Keys that nothing uses are errors as well.
- Paths of files are relative to the scene.

This page and the JSON Schema for editors are generated: `freshet schema --markdown` prints this
page, `freshet schema` the schema. Both come from the table in `src/scene/keys/keys.cpp`, which the
parser reads too.
)";
  writer.heading("Top level", "Keys before the first table.");
  Scene defaults;
  visit_keys(writer, defaults);
  return writer.out;
}

}  // namespace freshet
