// SPDX-License-Identifier: MIT
/// Light in and on liquids.
#pragma once
#include <array>
#include <vector>

#include "render/camera.h"
#include "render/image.h"

namespace freshet {

/// Linear light: red, green, blue; 1 is white.
using Light = Vec<3, float>;

Light light_of(Color c);
Color color_of(Light l);

/// The light of the sky, dark at the horizon and light at the zenith, with the sun and a soft glow
/// around it. The direction has unit length.
Light sky_light(Vec<3, float> direction);

/// The fraction of light that water reflects, after Schlick 1994. `facing` is the cosine between
/// the line of sight and the normal.
float fresnel(float facing);

/// The direction of a ray from air in the water, or that of the ray if the normal is turned away.
Vec<3, float> refracted(Vec<3, float> ray, Vec<3, float> normal);

/// Absorption in a liquid by the law of Beer and Lambert, and light that it scatters to the eye.
class Absorption {
 public:
  /// `scale`: length of the scene [m]. A quarter of it gives white light the liquid's colour.
  Absorption(Color liquid, double scale);

  struct Passed {
    Light through;    ///< fractions of the light from behind
    Light scattered;  ///< light from the liquid itself
  };
  Passed operator()(float length) const;

 private:
  Light rate_, color_;  // absorption [1/m]; light of infinitely deep liquid
  float cloud_;         // scattering [1/m]
};

}  // namespace freshet
