// SPDX-License-Identifier: MIT
#pragma once
#include <set>
#include <string>
#include <string_view>

namespace freshet {

/// The word nearest to `typed` (insert, delete, replace, swap: at most a third of its letters, and
/// at least one), or "" where none is near: the "did you mean" of every message.
std::string nearest(std::string_view typed, const std::set<std::string, std::less<>>& words);

}  // namespace freshet
