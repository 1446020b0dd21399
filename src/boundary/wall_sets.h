// SPDX-License-Identifier: MIT
#pragma once
#include "boundary/rigid_bodies.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The particles of walls, one set a method; they stand still, but those that bodies carry. wall is
/// the number that a wall's force is told by (-1: none), friction 1 for no slip and 0 for free
/// slip; both kept.
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
  Field<Real> p;        ///< scratch: pressure [Pa]; v, what it shows the fluid, is scratch as well
  Field<Vec<D>> slide;  ///< kept: velocity of the wall's surface along itself [m/s]
  Field<Vec<D>> u, a;   ///< scratch: velocity and acceleration of a body there [m/s, m/s^2]
  template <class Visit> void fields(Visit visit) {
    WallParticles<D>::fields(visit);
    visit("p", Keep::scratch, p);
    visit("slide", Keep::kept, slide);
    visit("u", Keep::scratch, u);
    visit("a", Keep::scratch, a);
  }
};
template <int D> struct Walls {
  AkinciWall<D> akinci2012;
  AdamiWall<D> adami2012;
  WallParticles<D> monaghan2009;
  /// The samples of bodies are among those of akinci2012, images beyond periodic ends as well; here
  /// they are once more and without images, as targets of what the fluid does to them. The id is
  /// the number of the sample.
  AkinciWall<D> of_bodies;
  AdamiWall<D> of_layered_bodies;    ///< the same where bodies are among those of adami2012
  RigidBodies<D>* bodies = nullptr;  ///< none: nothing moves
  Field<Real> rate;  ///< scratch, by particle of the fluid: the density's rate by moving samples
};

}  // namespace FRESHET_ISA
}  // namespace freshet
