// SPDX-License-Identifier: MIT
/// The one table of scene keys. The parser, the JSON Schema and docs/scene.md all walk it.
#pragma once
#include <functional>
#include <limits>
#include <span>
#include <string_view>

#include "freshet/scene.h"

namespace freshet {

/// Documentation and range of a key. A number must be in [min, max], or (min, max] with `above`.
struct KeyDoc {
  std::string_view unit;  ///< "" for a dimensionless number or a name
  std::string_view text;
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool above = false;  ///< min itself is not allowed
  bool required = false;
  std::string_view fallback = {};  ///< the default in words, if it is not a fixed value
};

using Words = std::span<const char* const>;

// The names of each choice, in the order of its enum.
inline constexpr const char* axes_words[] = {"none", "x", "y", "xy", "z", "xz", "yz", "xyz"};
// Only a fluid has the last one, a lattice.
inline constexpr const char* shape_words[] = {"box",    "sphere", "cylinder", "plane",
                                              "points", "mesh",   "polygon",  "lattice"};
inline constexpr const char* side_words[] = {"inside", "outside"};
inline constexpr const char* outside_words[] = {"error", "clamp"};
inline constexpr const char* pressure_words[] = {"zero", "hydrostatic"};
inline constexpr const char* scheme_words[] = {"paper", "article"};
inline constexpr const char* kernel_words[] = {"cubic_spline", "wendland_c2", "wendland_c4",
                                               "wendland_c6"};
inline constexpr const char* diffusion_words[] = {"none", "fourtakas2019", "antuono2010"};
inline constexpr const char* backend_words[] = {"cpu", "reference"};
inline constexpr const char* search_words[] = {"grid", "all_pairs"};
inline constexpr const char* order_words[] = {"cell", "id"};
inline constexpr const char* iteration_words[] = {"jacobi", "nesterov"};
inline constexpr const char* correction_words[] = {"gradual", "at_once"};
inline constexpr const char* wrong_words[] = {"stop", "warn"};
inline constexpr const char* method_words[] = {"open",  "reflection", "monaghan2009",
                                               "ghost", "akinci2012", "adami2012"};
inline constexpr const char* slip_words[] = {"free_slip", "no_slip"};
inline constexpr const char* data_words[] = {"vtp", "ply", "csv", "hdf5", "bgeo"};
inline constexpr const char* field_words[] = {"velocity", "density", "pressure", "id"};
inline constexpr const char* precision_words[] = {"float32", "float16"};
inline constexpr const char* dots_words[] = {"glow", "solid"};
inline constexpr const char* style_words[] = {"balls", "water"};
inline constexpr const char* probe_words[] = {"point", "line", "plane", "surface", "wall"};
inline constexpr const char* color_by_words[] = {
    "speed",         "velocity_x", "velocity_y", "velocity_z", "density",
    "density_error", "pressure",   "height",     "id",         "liquid"};
inline constexpr const char* color_scale_words[] = {"run", "picture"};
inline constexpr const char* color_map_words[] = {"article", "water", "viridis", "inferno",
                                                  "coolwarm"};
inline constexpr const char* motion_words[] = {"fixed", "moved", "free"};
inline constexpr const char* freedom_words[] = {"x",          "y",          "z",
                                                "rotation_x", "rotation_y", "rotation_z"};
inline constexpr const char* interpolation_words[] = {"smooth", "linear"};
inline constexpr const char* integrator_words[] = {"symplectic_euler", "leapfrog", "verlet"};

/// Visitor of the table: each call passes a key and the member of the scene that it sets.
class KeyVisitor {
 public:
  virtual ~KeyVisitor() = default;
  virtual void section(std::string_view name, std::string_view text,
                       const std::function<void()>& keys) = 0;
  /// A section that means something even if it is empty: `keys` is called if it is set.
  virtual void section_if_set(std::string_view name, std::string_view text,
                              const std::function<void()>& keys) {
    section(name, text, keys);
  }
  /// A section that may occur several times: `resize(n)` makes room for n, `keys(k)` visits the
  /// k-th.
  virtual void sections(std::string_view name, std::string_view text,
                        const std::function<void(std::size_t)>& resize,
                        const std::function<void(std::size_t)>& keys) = 0;
  virtual void text(std::string_view name, std::string& value, const KeyDoc& doc) = 0;
  /// One text per axis; `value` is empty if the key is not set.
  virtual void texts(std::string_view name, std::vector<std::string>& value, const KeyDoc& doc) = 0;
  virtual void number(std::string_view name, double& value, const KeyDoc& doc) = 0;
  virtual void number(std::string_view name, std::optional<double>& value, const KeyDoc& doc) = 0;
  virtual void integer(std::string_view name, std::int64_t& value, const KeyDoc& doc) = 0;
  virtual void integer(std::string_view name, std::optional<std::int64_t>& value,
                       const KeyDoc& doc) = 0;
  virtual void vector(std::string_view name, Vector& value, const KeyDoc& doc) = 0;
  /// `count` numbers, in 2D and 3D; `value` is empty if the key is not set.
  virtual void numbers(std::string_view name, Vector& value, std::size_t count,
                       const KeyDoc& doc) = 0;
  /// One number in 2D, one of `counts` in 3D; `value` is empty if the key is not set.
  virtual void components(std::string_view name, Vector& value, std::span<const std::size_t> counts,
                          const KeyDoc& doc) = 0;
  /// A list of vectors; `value` is empty if the key is not set.
  virtual void vectors(std::string_view name, std::vector<Vector>& value, const KeyDoc& doc) = 0;
  virtual void boolean(std::string_view name, bool& value, const KeyDoc& doc) = 0;
  virtual void counts(std::string_view name, Counts& value, const KeyDoc& doc) = 0;
  /// A number, or `word`, which sets `is_word`.
  virtual void number_or_word(std::string_view name, double& value, bool& is_word, const char* word,
                              const KeyDoc& doc) = 0;
  /// The index of a word in `words`; -1 if the key is not set and has no default.
  virtual void word(std::string_view name, int& value, Words words, const KeyDoc& doc) = 0;
  /// The indices of several words in `words`, each at most once.
  virtual void word_list(std::string_view name, std::vector<int>& value, Words words,
                         const KeyDoc& doc) = 0;

  /// An enum whose values are the indices of its names.
  template <class E> void choice(std::string_view name, E& value, Words words, const KeyDoc& doc) {
    int index = static_cast<int>(value);
    word(name, index, words, doc);
    value = static_cast<E>(index);
  }
  template <class E>
  void choice(std::string_view name, std::optional<E>& value, Words words, const KeyDoc& doc) {
    int index = value ? static_cast<int>(*value) : -1;
    word(name, index, words, doc);
    if (index >= 0) value = static_cast<E>(index);
  }
  template <class E>
  void choices(std::string_view name, std::vector<E>& value, Words words, const KeyDoc& doc) {
    std::vector<int> places;
    for (const E e : value) places.push_back(static_cast<int>(e));
    word_list(name, places, words, doc);
    value.clear();
    for (const int place : places) value.push_back(static_cast<E>(place));
  }
  template <class T, class F>
  void optional_table(std::string_view name, std::string_view text, std::optional<T>& table,
                      F keys) {
    section_if_set(name, text, [&] { keys(table.emplace()); });
  }
  template <class T, class F>
  void tables(std::string_view name, std::string_view text, std::vector<T>& all, F keys) {
    sections(
        name, text,
        [&](std::size_t n) {
          all.clear();
          all.resize(n);
        },
        [&](std::size_t k) { keys(all[k]); });
  }
};

/// The names of the solvers, in the order of SolverName.
Words solver_words();
/// The names of the forces that a key chooses among, in the order of its enum.
Words force_words(std::string_view key);

/// The keys of what measures a finished run as well: counters and probes.
void measured_keys(KeyVisitor& visitor, Scene& scene);
void visit_keys(KeyVisitor& visitor, Scene& scene);

}  // namespace freshet
