// SPDX-License-Identifier: MIT
#include "scene/keys/reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "freshet/suggest.h"
#include "scene/keys/value_words.h"

namespace freshet {
namespace {

/// The size of domain.max; 0 if it is not a vector.
std::size_t dimension_of(const toml::table& root) {
  const toml::array* max = root["domain"]["max"].as_array();
  return max && (max->size() == 2 || max->size() == 3) ? max->size() : 0;
}

}  // namespace

SceneReader::SceneReader(const toml::table& root, std::string file,
                         std::map<std::string, std::string> overridden, std::size_t dimension)
    : file_(std::move(file)),
      dimension_(dimension > 0 ? dimension : dimension_of(root)),
      overridden_(std::move(overridden)),
      scope_{&root, "", "", {}} {
  places_[""] = file_;
}

toml::source_position SceneReader::position(const std::string& place) const {
  const auto it = positions_.find(place);
  return it == positions_.end() ? toml::source_position{} : it->second;
}

std::string SceneReader::place_of(const toml::source_region& where, const std::string& path) {
  for (std::string p = path; !p.empty(); p.erase(std::min(p.find_last_of(".["), p.size()))) {
    if (const auto it = overridden_.find(p); it != overridden_.end()) return it->second;
    if (p.find_last_of(".[") == std::string::npos) break;
  }
  if (!where.begin) {  // a table that overrides have made has the place of its first key
    const auto inside = overridden_.lower_bound(path + ".");
    const bool found = inside != overridden_.end() && inside->first.starts_with(path + ".");
    return found ? inside->second : file_;
  }
  const std::string place = fmt::format("{}:{}:{}", file_, where.begin.line, where.begin.column);
  positions_[place] = where.begin;
  return place;
}

void SceneReader::complain(const toml::source_region& where, const std::string& path,
                           std::string message) {
  diagnostics_.push_back({Diagnostic::Severity::error, place_of(where, path), std::move(message)});
}

void SceneReader::reject(const toml::source_region& where, const std::string& path,
                         std::string message) {
  unread_.insert(path.substr(0, path.find_first_of(".[")));
  complain(where, path, std::move(message));
}

const toml::node* SceneReader::take(std::string_view name, const KeyDoc& doc) {
  scope_.known.insert(std::string(name));
  const toml::node* node = scope_.table->get(name);
  const std::string path = fmt::format("{}{}", scope_.path, name);
  if (node) {
    places_[path] = place_of(node->source(), path);
  } else if (doc.required) {
    const auto& table = scope_.table->source();
    const std::string unit = doc.unit.empty() ? "" : fmt::format(" ({})", doc.unit);
    reject(table, path,
           fmt::format("{} is missing: {}{}; add it{}", scope_.name + std::string(name),
                       doc.text.substr(0, doc.text.find(';')), unit,
                       table.begin ? "" : " under [" + path.substr(0, path.find('.')) + "]"));
  }
  return node;
}

void SceneReader::report_unknown() {
  for (const auto& [key, node] : *scope_.table) {
    if (scope_.known.contains(key.str())) continue;
    const std::string guess = nearest(key.str(), scope_.known);
    const std::string remedy = guess.empty()
                                   ? fmt::format("known here: {}", fmt::join(scope_.known, ", "))
                                   : fmt::format("did you mean {}{}?", scope_.name, guess);
    complain(key.source(), scope_.path + std::string(key.str()),
             fmt::format("unknown {} {}{}; {}", node.is_table() ? "table" : "key", scope_.name,
                         printable(key.str()), remedy));
  }
}

void SceneReader::read_table(const toml::table& table, std::string path, std::string name,
                             const std::function<void()>& keys) {
  const Scope outer = std::exchange(scope_, {&table, std::move(path), std::move(name), {}});
  keys();
  report_unknown();
  scope_ = outer;
}

void SceneReader::section(std::string_view name, std::string_view,
                          const std::function<void()>& keys) {
  static const toml::table empty;
  const toml::node* node = take(name, {});
  if (node && !node->is_table()) {
    reject(node->source(), std::string(name),
           fmt::format("{} is {}; it must be a table: [{}]", name, found(*node), name));
    return;
  }
  const std::string prefix = fmt::format("{}.", name);
  read_table(node ? *node->as_table() : empty, prefix, prefix, keys);
}

void SceneReader::section_if_set(std::string_view name, std::string_view text,
                                 const std::function<void()>& keys) {
  if (scope_.table->contains(name)) section(name, text, keys);
  else scope_.known.insert(std::string(name));
}

void SceneReader::sections(std::string_view name, std::string_view,
                           const std::function<void(std::size_t)>& resize,
                           const std::function<void(std::size_t)>& keys) {
  const toml::node* node = take(name, {});
  std::vector<const toml::table*> tables;
  if (!node) return;
  if (const auto* one = node->as_table()) tables.push_back(one);
  else if (const auto* many = node->as_array(); many && many->is_homogeneous<toml::table>())
    for (const toml::node& t : *many) tables.push_back(t.as_table());
  else
    reject(node->source(), scope_.path + std::string(name),
           fmt::format("{0}{1} is {2}; it must be a table, [{0}{1}], or several, [[{0}{1}]]",
                       scope_.name, name, found(*node)));
  resize(tables.size());
  for (std::size_t k = 0; k < tables.size(); ++k) {
    const std::string path = fmt::format("{}{}[{}]", scope_.path, name, k);
    places_[path] = place_of(tables[k]->source(), path);
    read_table(*tables[k], path + ".", fmt::format("{}{}.", scope_.name, name), [&] { keys(k); });
  }
}

void SceneReader::text(std::string_view name, std::string& value, const KeyDoc& doc) {
  const toml::node* node = take(name, doc);
  if (!node) return;
  if (const auto* s = node->as_string()) value = s->get();
  else
    reject(node->source(), fmt::format("{}{}", scope_.path, name),
           fmt::format("{}{} is {}; it must be a string", scope_.name, name, found(*node)));
}

void SceneReader::texts(std::string_view name, std::vector<std::string>& value, const KeyDoc& doc) {
  const toml::node* node = take(name, doc);
  if (!node) return;
  const toml::array* list = node->as_array();
  const bool all = list && std::all_of(list->begin(), list->end(),
                                       [](const toml::node& e) { return e.is_string(); });
  if (!all)
    return reject(node->source(), fmt::format("{}{}", scope_.path, name),
                  fmt::format("{}{} is {}; it must be a list of strings, one per axis: "
                              "[\"0\", \"-9.81\"]",
                              scope_.name, name,
                              list ? "a list with values that are not strings" : found(*node)));
  for (const toml::node& e : *list) value.push_back(e.as_string()->get());
}

std::optional<double> SceneReader::in_range(const std::string& name, const toml::node& node,
                                            const KeyDoc& doc, bool whole) {
  const double value = number_of(node);
  const Range range(doc, whole);
  if (value >= range.low && value <= range.high && !(doc.above && value == doc.min) &&
      !(whole && value != std::floor(value)))
    return value;
  reject(node.source(), scope_.path + name,
         fmt::format("{}{} is {}; it must be {}", scope_.name, name, found(node),
                     limits(node, doc, whole)));
  return {};
}

std::optional<double> SceneReader::read_number(std::string_view name, const KeyDoc& doc,
                                               bool whole) {
  const toml::node* node = take(name, doc);
  return node ? in_range(std::string(name), *node, doc, whole) : std::nullopt;
}

void SceneReader::number(std::string_view name, double& value, const KeyDoc& doc) {
  value = read_number(name, doc, false).value_or(value);
}
void SceneReader::number(std::string_view name, std::optional<double>& value, const KeyDoc& doc) {
  if (const auto v = read_number(name, doc, false)) value = *v;
}
void SceneReader::integer(std::string_view name, std::int64_t& value, const KeyDoc& doc) {
  if (const auto v = read_number(name, doc, true)) value = std::int64_t(*v);
}
void SceneReader::integer(std::string_view name, std::optional<std::int64_t>& value,
                          const KeyDoc& doc) {
  if (const auto v = read_number(name, doc, true)) value = std::int64_t(*v);
}

Vector SceneReader::read_array(std::string_view name, const KeyDoc& doc, bool whole,
                               std::size_t count) {
  const toml::node* node = take(name, doc);
  if (!node) return {};
  const auto* a = node->as_array();
  const std::size_t n = a ? a->size() : 0;
  const bool good = count ? n == count : dimension_ ? n == dimension_ : n == 2 || n == 3;
  if (!good) {
    const std::string words = count ? fmt::format("{} numbers in brackets", count)
                                    : vector_words(dimension_, whole ? "whole numbers" : "numbers");
    reject(node->source(), fmt::format("{}{}", scope_.path, name),
           fmt::format("{}{} is {}; it must be {}", scope_.name, name, found(*node), words));
    return {};
  }
  return read_elements(name, *a, doc, whole);
}

Vector SceneReader::read_elements(std::string_view name, const toml::array& array,
                                  const KeyDoc& doc, bool whole) {
  Vector read;
  for (std::size_t k = 0; k < array.size(); ++k)
    if (const auto v = in_range(fmt::format("{}[{}]", name, k), *array.get(k), doc, whole))
      read.push_back(*v);
  return read.size() == array.size() ? read : Vector();
}

void SceneReader::vector(std::string_view name, Vector& value, const KeyDoc& doc) {
  if (Vector read = read_array(name, doc, false); !read.empty()) value = std::move(read);
}

void SceneReader::numbers(std::string_view name, Vector& value, std::size_t count,
                          const KeyDoc& doc) {
  if (Vector read = read_array(name, doc, false, count); !read.empty()) value = std::move(read);
}

void SceneReader::components(std::string_view name, Vector& value,
                             std::span<const std::size_t> counts, const KeyDoc& doc) {
  const toml::node* node = take(name, doc);
  if (!node) return;
  const toml::array* list = node->as_array();
  const bool number = node->is_number() && dimension_ != 3;
  const bool fits = list && dimension_ != 2 &&
                    std::find(counts.begin(), counts.end(), list->size()) != counts.end();
  Vector read;
  if (number) {
    if (const auto v = in_range(std::string(name), *node, doc, false)) read = {*v};
  } else if (fits) {
    read = read_elements(name, *list, doc, false);
  } else {
    const std::string in_3d =
        fmt::format("{} numbers in brackets in 3D", fmt::join(counts, " or "));
    reject(node->source(), fmt::format("{}{}", scope_.path, name),
           fmt::format("{}{} is {}; it must be {}", scope_.name, name, found(*node),
                       dimension_ == 2   ? "a number in 2D"
                       : dimension_ == 3 ? in_3d
                                         : "a number in 2D, " + in_3d));
  }
  if (!read.empty()) value = std::move(read);
}

void SceneReader::vectors(std::string_view name, std::vector<Vector>& value, const KeyDoc& doc) {
  const toml::node* node = take(name, doc);
  if (!node) return;
  const toml::array* list = node->as_array();
  if (!list || list->empty())
    return reject(node->source(), fmt::format("{}{}", scope_.path, name),
                  fmt::format("{}{} is {}; it must be a list of points, [[x, y], [x, y], ...]",
                              scope_.name, name, found(*node)));
  std::vector<Vector> read;
  for (std::size_t k = 0; k < list->size(); ++k) {
    const toml::node& element = *list->get(k);
    const std::string path = fmt::format("{}[{}]", name, k);
    const toml::array* point = element.as_array();
    if (!point || point->size() != (dimension_ ? dimension_ : 2))
      return reject(element.source(), scope_.path + path,
                    fmt::format("{}{} is {}; it must be {}", scope_.name, path, found(element),
                                vector_words(dimension_, "numbers")));
    read.push_back(read_elements(path, *point, doc, false));
    if (read.back().empty()) return;
  }
  value = std::move(read);
}

void SceneReader::boolean(std::string_view name, bool& value, const KeyDoc& doc) {
  const toml::node* node = take(name, doc);
  if (!node) return;
  if (const auto* b = node->as_boolean()) value = b->get();
  else
    reject(node->source(), fmt::format("{}{}", scope_.path, name),
           fmt::format("{}{} is {}; it must be true or false", scope_.name, name, found(*node)));
}

void SceneReader::counts(std::string_view name, Counts& value, const KeyDoc& doc) {
  if (const Vector read = read_array(name, doc, true); !read.empty())
    value.assign(read.begin(), read.end());
}

void SceneReader::number_or_word(std::string_view name, double& value, bool& is_word,
                                 const char* word, const KeyDoc& doc) {
  const toml::node* node = take(name, doc);
  if (!node) return;
  const auto* s = node->as_string();
  is_word = s && s->get() == word;
  if (is_word) return;
  if (!s) {
    value = in_range(std::string(name), *node, doc, false).value_or(value);
    return;
  }
  reject(node->source(), fmt::format("{}{}", scope_.path, name),
         fmt::format("{}{} is {}; it must be {} or \"{}\"", scope_.name, name, found(*node),
                     limits(*node, doc, false), word));
}

int SceneReader::read_word(const std::string& name, const toml::node& node, Words words) {
  const auto* s = node.as_string();
  const auto it = std::find(words.begin(), words.end(), s ? s->get() : std::string());
  if (it != words.end()) return int(it - words.begin());
  const std::string guess =
      s && words.size() > 1
          ? nearest(s->get(), std::set<std::string, std::less<>>(words.begin(), words.end()))
          : "";
  reject(node.source(), scope_.path + name,
         fmt::format("{}{} is {}; it must be {}{}", scope_.name, name, found(node), one_of(words),
                     guess.empty() ? "" : fmt::format("; did you mean \"{}\"?", guess)));
  return -1;
}

void SceneReader::word(std::string_view name, int& value, Words words, const KeyDoc& doc) {
  const toml::node* node = take(name, doc);
  const int place = node ? read_word(std::string(name), *node, words) : -1;
  if (place >= 0) value = place;
}

void SceneReader::word_list(std::string_view name, std::vector<int>& value, Words words,
                            const KeyDoc& doc) {
  const toml::node* node = take(name, doc);
  if (!node) return;
  const toml::array* list = node->as_array();
  if (!list)
    return reject(node->source(), fmt::format("{}{}", scope_.path, name),
                  fmt::format("{}{} is {}; it must be a list of {}", scope_.name, name,
                              found(*node), one_of(words)));
  value.clear();
  for (std::size_t k = 0; k < list->size(); ++k) {
    const std::string path = fmt::format("{}[{}]", name, k);
    const int place = read_word(path, *list->get(k), words);
    if (place < 0) return;  // the first error lists all allowed names
    if (std::find(value.begin(), value.end(), place) != value.end())
      return reject(list->get(k)->source(), scope_.path + path,
                    fmt::format("{}{} has \"{}\" twice; name it once", scope_.name, name,
                                words[std::size_t(place)]));
    value.push_back(place);
  }
}

}  // namespace freshet
