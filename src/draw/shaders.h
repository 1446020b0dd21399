// SPDX-License-Identifier: MIT
/// The shaders, without their first lines. They compile as GLSL 3.30 and as GLSL ES 3.00.
#pragma once

namespace freshet::gl {

struct ShaderSource {
  const char *vertex, *fragment;
};

extern const ShaderSource ball_shader;       ///< particles as lit balls
extern const ShaderSource disc_shader;       ///< particles in 2D: discs or glowing dots
extern const ShaderSource solid_shader;      ///< lit triangles
extern const ShaderSource line_shader;       ///< lines of one colour
extern const ShaderSource floor_shader;      ///< the floor with its tiles
extern const ShaderSource foam_shader;       ///< spray and foam as soft discs
extern const ShaderSource depth_shader;      ///< distance of the nearest ball
extern const ShaderSource thickness_shader;  ///< length of the line of sight within balls
extern const ShaderSource smooth_shader;     ///< one pass of the narrow-range filter
extern const ShaderSource water_shader;      ///< the liquid from both
extern const ShaderSource copy_shader;       ///< colours and depths of another target

}  // namespace freshet::gl
