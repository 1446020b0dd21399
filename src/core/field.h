// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// One value per particle. A view: the backend owns the memory.
template <class T> struct Field {
  T* data = nullptr;
  FRESHET_HD T& operator[](int i) const { return data[i]; }
};

/// A field is kept (it survives sorting and restart and counts in kept_sha256) or scratch.
enum class Keep { kept, scratch };

/// A named set of particles (the fluid, a wall ...) and the fields that every set has. SI units.
///
/// Copies (mirror ghosts, periodic images) stand behind the particles in the same fields, at n to
/// n + copies - 1; a search makes them anew, and sums over a set include them.
template <int D> struct Particles {
  int n = 0;
  int copies = 0;
  int set = 0;              ///< the backend's number of the set
  Field<std::uint64_t> id;  ///< kept; never reused
  Field<Vec<D>> x, v;       ///< kept: position [m], velocity [m/s]
  bool moves = false;       ///< of a source: it is sorted anew in each search
};

}  // namespace FRESHET_ISA
}  // namespace freshet
