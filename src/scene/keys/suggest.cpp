// SPDX-License-Identifier: MIT
#include "freshet/suggest.h"

#include <algorithm>
#include <vector>

namespace freshet {
namespace {

/// The edit distance of two words; a swap of adjacent letters is one edit (optimal string
/// alignment).
std::size_t distance(std::string_view a, std::string_view b) {
  const std::size_t row = b.size() + 1;
  std::vector<std::size_t> all((a.size() + 1) * row);
  std::size_t* const d = all.data();
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t* const at = d + i * row + j;
      if (i == 0 || j == 0) {
        *at = i + j;
        continue;
      }
      const std::size_t change = a[i - 1] != b[j - 1];
      *at = std::min(std::min(at[-1], *(at - row)) + 1, *(at - row - 1) + change);
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        *at = std::min(*at, *(at - 2 * row - 2) + 1);
    }
  return all.back();
}

/// The only word that begins or ends with `typed` as a part between underscores, else "".
std::string only_with_part(std::string_view typed,
                           const std::set<std::string, std::less<>>& words) {
  const std::string first = std::string(typed) + "_", last = "_" + std::string(typed);
  std::string found;
  for (const std::string& word : words) {
    if (!word.starts_with(first) && !word.ends_with(last)) continue;
    if (!found.empty()) return "";
    found = word;
  }
  return found;
}

}  // namespace

std::string nearest(std::string_view typed, const std::set<std::string, std::less<>>& words) {
  std::string best;
  if (typed.empty() || typed.size() > 100) return best;
  std::size_t least = std::max<std::size_t>(1, typed.size() / 3) + 1;
  for (const std::string& word : words) {
    const std::size_t shorter = std::min(typed.size(), word.size());
    if (std::max(typed.size(), word.size()) - shorter >= least)
      continue;  // their lengths differ too much
    if (const std::size_t d = distance(typed, word); d < least) least = d, best = word;
  }
  return best.empty() ? only_with_part(typed, words) : best;
}

}  // namespace freshet
