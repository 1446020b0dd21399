// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace freshet {

/// Red, green and blue of picture.background, a name or "#rrggbb"; empty for any other text.
std::optional<std::array<std::uint8_t, 3>> background_color(std::string_view text);

}  // namespace freshet
