// SPDX-License-Identifier: MIT
/// The one table of scene keys. The parser, the JSON Schema and docs/scene.md all walk it.
#pragma once
#include <functional>
#include <limits>
#include <span>
#include <string_view>

#include "freshet/scene.h"

namespace freshet {

/// What is said of a key. A number must lie in [min, max], or (min, max] where `above` is set.
struct KeyDoc {
  std::string_view unit;  ///< "" for a pure number or a word
  std::string_view text;
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool above = false;  ///< min itself is not allowed
  bool required = false;
  std::string_view fallback = {};  ///< the default in words, where no number tells it
};

using Words = std::span<const char* const>;

// The words of each choice, in the order of its enum.
inline constexpr const char* shape_words[] = {"box", "lattice"};
inline constexpr const char* outside_words[] = {"error", "clamp"};
inline constexpr const char* solver_words[] = {"mueller2003"};
inline constexpr const char* scheme_words[] = {"paper", "article"};
inline constexpr const char* backend_words[] = {"cpu", "reference"};
inline constexpr const char* search_words[] = {"grid", "all_pairs"};
inline constexpr const char* order_words[] = {"cell", "id"};

/// Someone who walks the table: each call is a key, with the member of the scene that it fills.
class KeyVisitor {
 public:
  virtual ~KeyVisitor() = default;
  virtual void section(std::string_view name, std::string_view text,
                       const std::function<void()>& keys) = 0;
  /// A section that may stand several times; `keys(k)` visits the k-th.
  virtual void sections(std::string_view name, std::string_view text,
                        std::vector<Scene::Fluid>& all,
                        const std::function<void(Scene::Fluid&)>& keys) = 0;
  virtual void text(std::string_view name, std::string& value, const KeyDoc& doc) = 0;
  virtual void number(std::string_view name, double& value, const KeyDoc& doc) = 0;
  virtual void number(std::string_view name, std::optional<double>& value, const KeyDoc& doc) = 0;
  virtual void integer(std::string_view name, std::int64_t& value, const KeyDoc& doc) = 0;
  virtual void integer(std::string_view name, std::optional<std::int64_t>& value,
                       const KeyDoc& doc) = 0;
  virtual void vector(std::string_view name, Vector& value, const KeyDoc& doc) = 0;
  virtual void counts(std::string_view name, Counts& value, const KeyDoc& doc) = 0;
  virtual void word(std::string_view name, int& value, Words words, const KeyDoc& doc) = 0;

  /// An enum whose values are the places of its words.
  template <class E> void choice(std::string_view name, E& value, Words words, const KeyDoc& doc) {
    int index = static_cast<int>(value);
    word(name, index, words, doc);
    value = static_cast<E>(index);
  }
};

void visit_keys(KeyVisitor& visitor, Scene& scene);

}  // namespace freshet
