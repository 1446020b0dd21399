// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace freshet {

/// The red, green and blue of picture.background, a word or "#rrggbb"; none of anything else.
std::optional<std::array<std::uint8_t, 3>> background_color(std::string_view text);

}  // namespace freshet
