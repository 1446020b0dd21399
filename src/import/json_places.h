// SPDX-License-Identifier: MIT
/// Places in a JSON text, which the JSON library does not keep.
#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace freshet {

/// "LINE:COLUMN" of a byte. A column is a character of UTF-8.
std::string line_and_column(std::string_view text, std::size_t byte);

/// The byte of each value's key, or of the value itself in a list, by path: "Emitters[0].width".
struct JsonPlaces {
  std::map<std::string, std::size_t, std::less<>> byte;
  std::vector<std::string> twice;  ///< paths that an object has more than once; the last counts
};

/// `json` must be valid JSON whose nesting is at most `deepest_json`.
JsonPlaces places_in(std::string_view json);

constexpr int deepest_json = 64;
/// How deep lists and objects are nested.
int depth_of_json(std::string_view json);

}  // namespace freshet
