// SPDX-License-Identifier: MIT
/// Whether the solids of a scene leave its fluid room, at one time. Slow: for a run that has gone
/// wrong.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "freshet/particles.h"
#include "freshet/scene.h"

namespace freshet {

class Bodies;

/// A particle between a moved body and a solid that it approaches, with less than a spacing of
/// room.
struct Pinch {
  std::uint64_t id = 0;
  std::array<double, 3> x{};  ///< [m]
  std::string body, solid;
  double gap = 0, speed = 0;  ///< width [m]; speed of the body towards the particle [m/s]
};
/// The narrowest one. `bodies` may be null.
std::optional<Pinch> find_pinch(const Scene& scene, const Bodies* bodies,
                                const ParticleView& fluid);

/// A volume that no opening leads out of. Its size is in particles at rest density.
struct ClosedVolume {
  double particles = 0, room = 0;
  std::string inlet;  ///< one that has flowed into it; empty: none
  std::string body;   ///< a moved body that takes room away; empty: none
  double speed = 0;   ///< of the body, the mean over the faces that bound the volume [m/s]
};
/// The fullest closed volume, by cells of a spacing; none if there are too many cells. Gaps of less
/// than a spacing count as closed.
std::optional<ClosedVolume> fullest_closed_volume(const Scene& scene, const Bodies* bodies,
                                                  const ParticleView& fluid, double time);

/// An inlet, and the particles in the zone behind its opening, at its sides and at its back.
struct CrowdedInlet {
  std::string name;
  double particles = 0, room = 0;
  double crowding() const { return particles / room; }
};
/// The fullest one that has begun. The zone takes no liquid from outside.
std::optional<CrowdedInlet> most_crowded_inlet(const Scene& scene, const ParticleView& fluid,
                                               double time);

}  // namespace freshet
