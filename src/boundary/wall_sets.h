// SPDX-License-Identifier: MIT
#pragma once
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The particles of walls, one set a method; they stand still. wall is the number that a wall's
/// force is told by (-1: none), friction 1 for no slip and 0 for free slip; both kept.
template <int D> struct WallParticles : Particles<D> {
  Field<int> wall;
  Field<Real> friction;
  Field<Vec<D>> force;  ///< scratch: on the sample, over a particle's mass [m/s^2]
  template <class Visit> void fields(Visit visit) {
    visit("wall", Keep::kept, wall);
    visit("friction", Keep::kept, friction);
    visit("force", Keep::scratch, force);
  }
};
/// [Akinci 2012]
template <int D> struct AkinciWall : WallParticles<D> {
  Field<Real> psi;  ///< kept: rho0 V_k [kg]
  template <class Visit> void fields(Visit visit) {
    WallParticles<D>::fields(visit);
    visit("psi", Keep::kept, psi);
  }
};
/// [Adami 2012]
template <int D> struct AdamiWall : WallParticles<D> {
  Field<Real> p;  ///< scratch: pressure [Pa]; v, its velocity, is scratch as well
  template <class Visit> void fields(Visit visit) {
    WallParticles<D>::fields(visit);
    visit("p", Keep::scratch, p);
  }
};
template <int D> struct Walls {
  AkinciWall<D> akinci2012;
  AdamiWall<D> adami2012;
  WallParticles<D> monaghan2009;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
