// SPDX-License-Identifier: MIT
#include "import/json_object.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "freshet/suggest.h"
#include "import/text_of_path.h"

namespace freshet {
namespace {

/// A value as messages show it: not too long, and without control characters.
std::string shown_json(const nlohmann::json& value) {
  std::string text = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  if (text.size() > 40) text = text.substr(0, 37) + "...";
  return text;
}

std::string range_words(const JsonRange& range) {
  if (range.above) return fmt::format(" > {:g}", range.min);
  if (range.min > -1e15) return fmt::format(" ≥ {:g}", range.min);
  return "";
}

bool is_in(double value, const JsonRange& range) {
  return range.above ? value > range.min && value <= range.max
                     : value >= range.min && value <= range.max;
}

bool is_point(const nlohmann::json& value) {
  return value.is_array() && value.size() == 3 &&
         std::all_of(value.begin(), value.end(), [](const nlohmann::json& x) {
           return x.is_number() && std::abs(x.get<double>()) <= 1e15;
         });
}

}  // namespace

JsonFindings::JsonFindings(std::string_view json, std::string file)
    : ImportFindings(std::move(file)), json_(json), places_(places_in(json)) {
  for (const std::string& path : places_.twice)
    note(ImportNote::Kind::instead, path, "set twice; the last value is taken");
}

std::string JsonFindings::place(const std::string& path) const {
  const auto found = places_.byte.find(path);
  return found == places_.byte.end() ? file()
                                     : file() + ":" + line_and_column(json_, found->second);
}

JsonObject::JsonObject(const nlohmann::json* value, std::string path, ImportFindings& findings)
    : value_(value), path_(std::move(path)), findings_(&findings) {}

std::string JsonObject::path(const std::string& key) const { return path_below(path_, key); }

bool JsonObject::has(const std::string& key) const {
  if (!value_) return false;
  const auto found = value_->find(key);
  return found != value_->end() && !found->is_null();
}

const nlohmann::json* JsonObject::find(const std::string& key) {
  known_.insert(key);
  return has(key) ? &*value_->find(key) : nullptr;
}

double JsonObject::number(const std::string& key, double fallback, JsonRange range) {
  const nlohmann::json* found = find(key);
  if (!found) return fallback;
  if (found->is_number() && is_in(found->get<double>(), range)) return found->get<double>();
  error(key, fmt::format("is {}; it must be a number{}", shown_json(*found), range_words(range)));
  return fallback;
}

long JsonObject::integer(const std::string& key, long fallback, long min, long max) {
  const nlohmann::json* found = find(key);
  if (!found) return fallback;
  if (found->is_number()) {
    const double whole = std::trunc(found->get<double>());
    if (whole >= double(min) && whole <= double(max)) return long(whole);
  }
  error(key,
        fmt::format("is {}; it must be an integer from {} to {}", shown_json(*found), min, max));
  return fallback;
}

int JsonObject::choice(const std::string& key, int fallback,
                       const std::vector<const char*>& names) {
  const nlohmann::json* found = find(key);
  if (!found) return fallback;
  const int count = int(names.size());
  if (found->is_number_integer())
    if (const auto k = found->get<std::int64_t>(); k >= 0 && k < count) return int(k);
  std::string list;
  for (int k = 0; k < count; ++k)
    list += fmt::format("{}{} ({})",
                        k == 0           ? ""
                        : k + 1 == count ? " or "
                                         : ", ",
                        k, names[std::size_t(k)]);
  error(key, fmt::format("is {}; it must be {}", shown_json(*found), list));
  return fallback;
}

bool JsonObject::boolean(const std::string& key, bool fallback) {
  const nlohmann::json* found = find(key);
  if (!found) return fallback;
  if (found->is_boolean()) return found->get<bool>();
  if (found->is_number_integer()) return found->get<std::int64_t>() != 0;
  error(key, fmt::format("is {}; it must be true or false", shown_json(*found)));
  return fallback;
}

std::string JsonObject::text(const std::string& key, const std::string& fallback) {
  const nlohmann::json* found = find(key);
  if (!found) return fallback;
  if (found->is_string()) return found->get<std::string>();
  error(key, fmt::format("is {}; it must be a string in quotes", shown_json(*found)));
  return fallback;
}

JsonObject::Point JsonObject::point(const std::string& key, Point fallback) {
  const nlohmann::json* found = find(key);
  if (!found) return fallback;
  if (is_point(*found))
    return {(*found)[0].get<double>(), (*found)[1].get<double>(), (*found)[2].get<double>()};
  error(key, fmt::format("is {}; it must be three numbers, such as [0, 1, 0]", shown_json(*found)));
  return fallback;
}

std::vector<double> JsonObject::numbers(const std::string& key) {
  const nlohmann::json* found = find(key);
  std::vector<double> all;
  if (!found) return all;
  bool good = found->is_array();
  if (good)
    for (const nlohmann::json& x : *found) {
      good &= x.is_number() && std::abs(x.get<double>()) <= 1e15;
      if (good) all.push_back(x.get<double>());
    }
  if (good) return all;
  error(key, fmt::format("is {}; it must be a list of numbers", shown_json(*found)));
  return {};
}

JsonObject JsonObject::object(const std::string& key) {
  const nlohmann::json* found = find(key);
  if (found && !found->is_object()) {
    error(key, fmt::format("is {}; it must be an object in braces {{}}", shown_json(*found)));
    found = nullptr;
  }
  return {found, path(key), *findings_};
}

std::vector<JsonObject> JsonObject::list(const std::string& key) {
  std::vector<JsonObject> all;
  const nlohmann::json* found = find(key);
  if (!found) return all;
  if (!found->is_array()) {
    error(key, fmt::format("is {}; it must be a list in brackets []", shown_json(*found)));
    return all;
  }
  for (std::size_t k = 0; k < found->size(); ++k) {
    const std::string item = path_below(path(key), k);
    if ((*found)[k].is_object()) all.emplace_back(&(*found)[k], item, *findings_);
    else
      findings_->error(item, fmt::format("{} is {}; it must be an object in braces {{}}", item,
                                         shown_json((*found)[k])));
  }
  return all;
}

void JsonObject::error(const std::string& key, const std::string& message) {
  findings_->error(has(key) ? path(key) : path_, fmt::format("{} {}", path(key), message));
}

void JsonObject::instead(const std::string& key, const std::string& message) {
  if (!find(key)) return;
  findings_->note(ImportNote::Kind::instead, path(key), message);
}

void JsonObject::assumed(const std::string& key, const std::string& message) {
  findings_->note(ImportNote::Kind::instead, has(key) ? path(key) : path_, message);
}

void JsonObject::missing(const std::string& key, const std::string& message) {
  if (!find(key)) return;
  findings_->note(ImportNote::Kind::missing, path(key), message);
}

void JsonObject::display(const std::vector<std::string>& keys) {
  for (const std::string& key : keys)
    if (find(key))
      findings_->note(ImportNote::Kind::display, path(key),
                      "only for the window and the files of "
                      "SPlisHSPlasH");
}

void JsonObject::finish() {
  if (!value_) return;
  for (const auto& [key, value] : value_->items()) {
    if (known_.contains(key)) continue;
    const std::string guess = nearest(key, known_);
    findings_->note(ImportNote::Kind::missing, path(key),
                    guess.empty() ? "unknown; has no effect"
                                  : fmt::format("unknown; has no effect; did you mean {}?", guess));
  }
}

}  // namespace freshet
