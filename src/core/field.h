// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "core/vec.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// One value per particle. It is a view: the backend owns the memory.
template <class T> struct Field {
  T* data = nullptr;
  FRESHET_HD T& operator[](int i) const { return data[i]; }
};

/// kept: the field survives sorting and restart and counts in kept_sha256. scratch: it does not.
enum class Keep { kept, scratch };

/// A set of particles (the fluid, a wall ...) and the fields that every set has. SI units.
///
/// Copies (mirror ghosts, periodic images) follow the particles in the same fields, at indices n to
/// n + copies - 1. Each search creates them again. Sums over a set include them.
template <int D> struct Particles {
  int n = 0;
  int copies = 0;
  int set = 0;              ///< index of the set in the backend
  Field<std::uint64_t> id;  ///< kept; never reused
  Field<Vec<D>> x, v;       ///< kept: position [m], velocity [m/s]
  bool moves = false;       ///< a source set that each search sorts again
  /// Lists that serve several searches reach farther than the support by a skin [m], and follow
  /// from these positions [m], a kept field. Without it each search lists anew.
  Field<Vec<D>> x_listed;
  Real skin = 0;

  /// The particles where they were listed.
  Particles as_listed() const {
    Particles p = *this;
    if (x_listed.data) p.x = x_listed;
    return p;
  }
  /// Whether particle i is so far from where it was listed that a list may lack a neighbour: pairs
  /// of particles that moved less than half a skin each are complete. True for a NaN.
  FRESHET_HD bool left_its_lists(int i) const {
    return !(norm2(x[i] - x_listed[i]) < square(Real(0.499f) * skin));
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet
