// SPDX-License-Identifier: MIT
#pragma once
#include <set>
#include <string>
#include <string_view>

namespace freshet {

/// The word nearest to `typed`, for "did you mean" in messages. Inserting, deleting, replacing and
/// swapping a letter are one edit each. If every word needs more edits than a third of the letters
/// of `typed` (at least one edit is allowed), returns the only word that has `typed` as its first
/// or last part, as "rest_density" has "density", or "" if no word has it.
std::string nearest(std::string_view typed, const std::set<std::string, std::less<>>& words);

}  // namespace freshet
