// SPDX-License-Identifier: MIT
/// What the names of a scene may hold: letters of any alphabet, in UTF-8.
#pragma once
#include <string_view>

namespace freshet {

/// Whether a name can be part of a column's: it has no comma, quote, line end, control character or
/// invisible character.
bool names_column(std::string_view name);

/// Whether a name can be a file's: letters, digits, _, - and ., not beginning with a point, of at
/// most 200 bytes.
bool names_file(std::string_view name);

}  // namespace freshet
