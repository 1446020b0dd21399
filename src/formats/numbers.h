// SPDX-License-Identifier: MIT
/// Numbers in binary and text files.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace freshet {

/// The type of a number in a file.
struct NumberType {
  std::size_t bytes = 0;  ///< 0: unknown type
  char kind = 0;          ///< 'i' signed, 'u' unsigned, 'f' floating
};

/// The number at `at`, which has `type.bytes` bytes. `big`: in big-endian order.
double number_at(const char* at, NumberType type, bool big);

/// All numbers in `bytes`.
std::vector<double> numbers_in(std::string_view bytes, NumberType type, bool big);

/// Removes up to `count` finite numbers, separated by white space, from the beginning of `text`.
/// Returns fewer if the text ends, or at a word that is not a finite number; `text` begins there.
std::vector<double> take_numbers(std::string_view& text, std::uint64_t count);

}  // namespace freshet
