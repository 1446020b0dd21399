// SPDX-License-Identifier: MIT
/// Words for values in messages: what was found, and what is allowed.
#pragma once
#include <toml++/toml.h>

#include "scene/keys/keys.h"

namespace freshet {

/// A name or a string for messages: one line, no control characters, at most 40 bytes.
std::string printable(std::string_view words);
/// The value of a key.
std::string found(const toml::node& node);
/// NaN if the node is not a number.
double number_of(const toml::node& node);

/// The smallest and largest number that a key may have.
struct Range {
  double low, high;
  Range(const KeyDoc& doc, bool whole);
};
/// The allowed values of a key. The limits of all keys are named only for values beyond them.
std::string limits(const toml::node& node, const KeyDoc& doc, bool whole);
/// The allowed values of a vector.
std::string vector_words(std::size_t dimension, const char* numbers);
/// "a", "b" or "c"
std::string one_of(Words words);

}  // namespace freshet
