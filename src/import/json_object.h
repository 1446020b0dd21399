// SPDX-License-Identifier: MIT
/// Reads the keys of a JSON scene. Every key is read, listed as a note, or unknown.
#pragma once
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/vec.h"
#include "import/findings.h"
#include "import/json_places.h"

namespace freshet {

/// Finds the places of keys in a JSON text.
class JsonFindings : public ImportFindings {
 public:
  JsonFindings(std::string_view json, std::string file);

 protected:
  std::string place(const std::string& path) const override;

 private:
  std::string_view json_;
  JsonPlaces places_;
};

/// The range of a number.
struct JsonRange {
  double min = -1e15, max = 1e15;
  bool above = false;  ///< min itself is excluded
};

class JsonObject {
 public:
  using Point = Vec<3, double>;

  /// `value`: null for an object that is missing; it has no keys.
  JsonObject(const nlohmann::json* value, std::string path, ImportFindings& findings);

  bool has(const std::string& key) const;
  const std::string& path() const { return path_; }
  std::string path(const std::string& key) const;

  /// Each returns `fallback` if the key is missing or null, or after it has reported an error.
  double number(const std::string& key, double fallback, JsonRange range = {});
  /// SPlisHSPlasH truncates a number with a fraction.
  long integer(const std::string& key, long fallback, long min, long max);
  /// One of `names`, by its index.
  int choice(const std::string& key, int fallback, const std::vector<const char*>& names);
  bool boolean(const std::string& key, bool fallback);
  std::string text(const std::string& key, const std::string& fallback);
  Point point(const std::string& key, Point fallback);
  std::vector<double> numbers(const std::string& key);
  JsonObject object(const std::string& key);
  std::vector<JsonObject> list(const std::string& key);

  void error(const std::string& key, const std::string& message);
  /// Notes about a key; nothing if it is not set.
  void instead(const std::string& key, const std::string& message);
  /// Notes what stands for a key that may be missing.
  void assumed(const std::string& key, const std::string& message);
  void missing(const std::string& key, const std::string& message);
  void display(const std::vector<std::string>& keys);
  /// Notes all keys that were neither read nor noted.
  void finish();

 private:
  const nlohmann::json* find(const std::string& key);

  const nlohmann::json* value_;
  std::string path_;
  ImportFindings* findings_;
  std::set<std::string, std::less<>> known_;
};

}  // namespace freshet
