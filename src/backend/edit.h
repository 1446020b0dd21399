// SPDX-License-Identifier: MIT
/// Helpers of both backends for adding and removing particles between steps.
#pragma once
#include <cstddef>
#include <cstring>
#include <span>

#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// One array of a set, and the Field that points to it. The Field must not move.
struct FieldOfSet {
  std::size_t bytes;  ///< per particle
  Keep keep;
  void* field;
  void (*point)(void* field, std::byte* data);

  template <class T> static FieldOfSet of(Keep keep, Field<T>& field) {
    return {sizeof(T), keep, &field,
            [](void* f, std::byte* data) { static_cast<Field<T>*>(f)->data = (T*)data; }};
  }
};

/// Removes the values with the indices `gone` (ascending) from n values. The others keep their
/// order.
inline void close_gaps(std::byte* data, std::size_t bytes, std::span<const int> gone, int n) {
  if (gone.empty()) return;
  std::size_t to = std::size_t(gone[0]) * bytes;
  for (std::size_t k = 0; k < gone.size(); ++k) {
    const std::size_t from = std::size_t(gone[k] + 1) * bytes;
    const std::size_t end = std::size_t(k + 1 < gone.size() ? gone[k + 1] : n) * bytes;
    std::memmove(data + to, data + from, end - from);
    to += end - from;
  }
}

/// Removes the values with the indices `gone` (ascending) from n values. The last values fill the
/// gaps, so the order changes and the cost depends on the number of gaps only.
inline void fill_gaps(std::byte* data, std::size_t bytes, std::span<const int> gone, int n) {
  const int left = n - int(gone.size());
  std::size_t last = gone.size();  // values in `gone` cannot be fillers
  int filler = n;
  for (const int gap : gone) {
    if (gap >= left) return;
    for (--filler; last > 0 && gone[last - 1] == filler; --filler) --last;
    std::memcpy(data + std::size_t(gap) * bytes, data + std::size_t(filler) * bytes, bytes);
  }
}

/// The new capacity of a set. If `needed` exceeds `room` it is 1.5 times `needed`, so that a
/// growing set is reallocated seldom.
inline int roomier(int needed, int room) { return needed > room ? needed + needed / 2 : room; }

}  // namespace FRESHET_ISA
}  // namespace freshet
