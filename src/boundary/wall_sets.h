// SPDX-License-Identifier: MIT
#pragma once
#include "boundary/rigid_bodies.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The boundary particles of one wall method. They are at rest, except body particles.
///
///   wall      kept: index of the wall for its force; -1: no force is reported
///   friction  kept: 1 for no slip, 0 for free slip
template <int D> struct WallParticles : Particles<D> {
  Field<int> wall;
  Field<Real> friction;
  Field<Vec<D>> force;  ///< scratch: on the particle, over a fluid particle's mass [m/s^2]
  template <class Visit> void fields(Visit visit) {
    visit("wall", Keep::kept, wall);
    visit("friction", Keep::kept, friction);
    visit("force", Keep::scratch, force);
  }
};
/// The single layer of boundary particles of Akinci 2012.
template <int D> struct AkinciWall : WallParticles<D> {
  Field<Real> psi;  ///< kept: rho0 V_k [kg/m^(3-D)]
  template <class Visit> void fields(Visit visit) {
    WallParticles<D>::fields(visit);
    visit("psi", Keep::kept, psi);
  }
};
/// The layers of boundary particles of Adami 2012. Their pressure and velocity are extrapolated
/// from the fluid.
template <int D> struct AdamiWall : WallParticles<D> {
  Field<Real> p;        ///< scratch: pressure [Pa]; the extrapolated velocity v is scratch as well
  Field<Vec<D>> slide;  ///< kept: tangential velocity of the wall's surface [m/s]
  Field<Vec<D>> u, a;   ///< scratch: velocity and acceleration of the body there [m/s, m/s^2]
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
  /// Body particles are in akinci2012, together with their periodic images. of_bodies holds them
  /// again without images, as targets of the fluid's reaction. Their id is the index of the body
  /// particle.
  AkinciWall<D> of_bodies;
  AdamiWall<D> of_layered_bodies;    ///< of_bodies for body particles in adami2012
  RigidBodies<D>* bodies = nullptr;  ///< null: no bodies
  Field<Real> rate;  ///< scratch, per fluid particle: density rate by moving boundary particles
};

}  // namespace FRESHET_ISA
}  // namespace freshet
