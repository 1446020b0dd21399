// SPDX-License-Identifier: MIT
#include "draw/shaders.h"

namespace freshet::gl {

namespace {

// A particle is a point whose square covers its ball; `at` holds its position and its place in the
// colour map, which `fill` replaces if it is not transparent. Particles outside of the slice are
// moved out of sight.
constexpr const char* particle_vertex = R"(
layout(location = 0) in vec4 at;
uniform mat4 view, projection;
uniform float radius, height, grown, slice_middle, slice_half;
uniform int slice_axis, marked;
uniform vec4 fill;
uniform sampler2D map;
out vec3 eye;
out vec3 color;
out float pixels;
void main() {
  vec4 place = view * vec4(at.xyz, 1.0);
  eye = place.xyz;
  color = fill.a > 0.0 ? fill.rgb : texture(map, vec2(at.w, 0.5)).rgb;
  float size = radius;
  if (gl_VertexID == marked) { color = vec3(1.0, 0.3, 0.1); size = 1.6 * radius; }
  gl_Position = projection * place;
  gl_PointSize = max(1.0, height * projection[1][1] * size / gl_Position.w + grown);
  pixels = 0.5 * gl_PointSize;
  float along = slice_axis == 0 ? at.x : slice_axis == 1 ? at.y : at.z;
  if (slice_axis >= 0 && abs(along - slice_middle) > slice_half) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
)";

}  // namespace

const ShaderSource ball_shader{particle_vertex, R"(
in vec3 eye;
in vec3 color;
uniform mat4 projection;
uniform float radius;
uniform vec3 light;
out vec4 result;
void main() {
  vec2 c = gl_PointCoord * 2.0 - 1.0;
  c.y = -c.y;
  float r2 = dot(c, c);
  if (r2 > 1.0) discard;
  vec3 normal = vec3(c, sqrt(1.0 - r2));
  float lit = 0.42 * (0.8 + 0.2 * normal.y) + 0.58 * max(0.0, dot(normal, light));
  float gloss = 0.25 * pow(max(0.0, dot(reflect(-light, normal), normalize(-eye))), 30.0);
  result = vec4(color * (0.35 + 0.9 * lit) + gloss, 1.0);
  vec4 surface = projection * vec4(eye + vec3(0.0, 0.0, radius * normal.z), 1.0);
  gl_FragDepth = 0.5 * surface.z / surface.w + 0.5;
}
)"};

// All discs have one depth, so that the first of two that overlap is seen and the second costs
// little.
const ShaderSource disc_shader{particle_vertex, R"(
in vec3 color;
in float pixels;
uniform float glow, softness;
out vec4 result;
void main() {
  vec2 c = gl_PointCoord * 2.0 - 1.0;
  float r2 = dot(c, c);
  if (r2 > 1.0) discard;
  float edge = min(1.0, pixels * (1.0 - sqrt(r2)));
  vec4 disc = vec4(color * (0.82 + 0.18 * sqrt(1.0 - r2)), mix(1.0, edge, softness));
  result = mix(disc, vec4(color * exp(-r2 / 0.49), 1.0), glow);
}
)"};

const ShaderSource solid_shader{
    R"(
layout(location = 0) in vec3 at;
layout(location = 1) in vec3 normal;
uniform mat4 placement, view, projection;
out vec3 facing;
out vec3 eye;
void main() {
  vec4 place = view * placement * vec4(at, 1.0);
  eye = place.xyz;
  facing = mat3(view) * mat3(placement) * normal;
  gl_Position = projection * place;
}
)",
    R"(
in vec3 facing;
in vec3 eye;
uniform vec4 fill;
uniform vec3 light, up;
uniform float flatness;
out vec4 result;
void main() {
  vec3 n = normalize(facing);
  if (dot(n, eye) > 0.0) n = -n;
  float lit = 0.42 * (0.8 + 0.2 * dot(n, up)) + 0.58 * max(0.0, dot(n, light));
  result = vec4(fill.rgb * mix(0.35 + 0.85 * lit, 1.0, flatness), fill.a);
}
)"};

const ShaderSource line_shader{
    R"(
layout(location = 0) in vec3 at;
uniform mat4 placement, view, projection;
void main() { gl_Position = projection * view * placement * vec4(at, 1.0); }
)",
    R"(
uniform vec4 fill;
out vec4 result;
void main() { result = fill; }
)"};

const ShaderSource floor_shader{
    R"(
layout(location = 0) in vec3 at;
uniform mat4 view, projection;
out vec2 place;
void main() {
  place = at.xz;
  gl_Position = projection * view * vec4(at, 1.0);
}
)",
    R"(
in vec2 place;
uniform vec4 fill, horizon;
uniform vec2 middle;
uniform float tile, reach, contrast;
out vec4 result;
void main() {
  vec2 t = place / tile;
  float odd = mod(floor(t.x) + floor(t.y), 2.0);
  vec2 edge = min(fract(t), 1.0 - fract(t)) / max(fwidth(t), vec2(1e-6));
  float sharp = clamp(min(edge.x, edge.y), 0.0, 1.0);
  float shade = mix(0.5, odd, 0.5 + 0.5 * sharp);
  float far = smoothstep(0.45, 1.0, length(place - middle) / reach);
  result = vec4(mix(fill.rgb * (1.0 - contrast * shade), horizon.rgb, far), 1.0);
}
)"};

const ShaderSource foam_shader{
    R"(
layout(location = 0) in vec3 at;
uniform mat4 view, projection;
uniform float radius, height, forward, slice_middle, slice_half;
uniform int slice_axis;
void main() {
  vec4 place = view * vec4(at, 1.0);
  gl_Position = projection * place;
  gl_PointSize = max(1.0, height * projection[1][1] * radius / gl_Position.w);
  vec4 nearer = projection * vec4(place.xy, place.z + forward, 1.0);
  gl_Position.z = nearer.z / nearer.w * gl_Position.w;
  float along = slice_axis == 0 ? at.x : slice_axis == 1 ? at.y : at.z;
  if (slice_axis >= 0 && abs(along - slice_middle) > slice_half) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
)",
    R"(
uniform vec4 fill;
out vec4 result;
void main() {
  vec2 c = gl_PointCoord * 2.0 - 1.0;
  float r2 = dot(c, c);
  if (r2 > 1.0) discard;
  result = vec4(fill.rgb, fill.a * (1.0 - r2));
}
)"};

namespace {

constexpr const char* ball_vertex = R"(
layout(location = 0) in vec4 at;
uniform mat4 view, projection;
uniform float radius, height, slice_middle, slice_half;
uniform int slice_axis;
out vec3 eye;
void main() {
  vec4 place = view * vec4(at.xyz, 1.0);
  eye = place.xyz;
  gl_Position = projection * place;
  gl_PointSize = max(1.0, height * projection[1][1] * radius / gl_Position.w);
  float along = slice_axis == 0 ? at.x : slice_axis == 1 ? at.y : at.z;
  if (slice_axis >= 0 && abs(along - slice_middle) > slice_half) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
)";

constexpr const char* screen_vertex = R"(
layout(location = 0) in vec2 at;
out vec2 place;
void main() {
  place = 0.5 * at + 0.5;
  gl_Position = vec4(at, 0.0, 1.0);
}
)";

}  // namespace

const ShaderSource depth_shader{ball_vertex, R"(
in vec3 eye;
uniform mat4 projection;
uniform float radius;
out float result;
void main() {
  vec2 c = gl_PointCoord * 2.0 - 1.0;
  float r2 = dot(c, c);
  if (r2 > 1.0) discard;
  vec3 surface = eye + vec3(0.0, 0.0, radius * sqrt(1.0 - r2));
  vec4 seen = projection * vec4(surface, 1.0);
  gl_FragDepth = 0.5 * seen.z / seen.w + 0.5;
  result = -surface.z;
}
)"};

const ShaderSource thickness_shader{ball_vertex, R"(
in vec3 eye;
uniform float radius, chord;
out float result;
void main() {
  vec2 c = gl_PointCoord * 2.0 - 1.0;
  float r2 = dot(c, c);
  if (r2 > 1.0) discard;
  result = chord * 2.0 * radius * sqrt(1.0 - r2);
}
)"};

// The narrow-range filter [Truong and Yuksel 2018]: a Gauss filter of the distances that are within
// a range of the middle's. Nearer ones end the filter on their side; farther ones count as if they
// were at the end of the range. A pass filters along one axis.
const ShaderSource smooth_shader{screen_vertex, R"(
in vec2 place;
uniform sampler2D depth;
uniform vec2 stride;
uniform float range, width, longest;
out float result;
void main() {
  float middle = texture(depth, place).r;
  result = middle;
  if (middle <= 0.0) return;
  int reach = int(min(longest, ceil(width / middle)));
  float sigma = max(0.5, 0.5 * float(reach));
  float sum = middle, weights = 1.0, low = middle - range, high = middle + range;
  for (int k = 1; k <= 32; ++k) {
    if (k > reach) break;
    float w = exp(-0.5 * float(k * k) / (sigma * sigma));
    float a = texture(depth, place - float(k) * stride).r;
    float b = texture(depth, place + float(k) * stride).r;
    bool both = a > low && b > low;
    if (both) {
      sum += w * (min(a, high) + min(b, high));
      weights += 2.0 * w;
    }
  }
  result = sum / weights;
}
)"};

// Fresnel's mix of what the surface reflects, a bright sky, and of what is seen through it: the
// scene behind, displaced by refraction and coloured by absorption [van der Laan 2009].
const ShaderSource water_shader{screen_vertex, R"(
in vec2 place;
uniform sampler2D depth, thick, scene, scene_depth;
uniform mat4 projection;
uniform vec2 texel, half_size;
uniform vec3 light, up, absorption, deep;
uniform float longest_path;
out vec4 result;

vec3 eye_at(vec2 p, float distance) {
  return distance * vec3((2.0 * p - 1.0) * half_size, -1.0);
}
vec3 sky(vec3 direction) {
  float h = clamp(0.5 + 0.5 * dot(direction, up), 0.0, 1.0);
  vec3 color = mix(vec3(0.72, 0.76, 0.80), vec3(0.55, 0.74, 0.95), smoothstep(0.5, 1.0, h));
  color = mix(vec3(0.30, 0.33, 0.36), color, smoothstep(0.3, 0.55, h));
  return color + 1.5 * pow(max(0.0, dot(direction, light)), 300.0);
}
void main() {
  float d = texture(depth, place).r;
  if (d <= 0.0) discard;
  vec3 eye = eye_at(place, d);
  float l = texture(depth, place - vec2(texel.x, 0.0)).r, r = texture(depth, place + vec2(texel.x, 0.0)).r;
  float b = texture(depth, place - vec2(0.0, texel.y)).r, t = texture(depth, place + vec2(0.0, texel.y)).r;
  vec3 left = eye - eye_at(place - vec2(texel.x, 0.0), l), right = eye_at(place + vec2(texel.x, 0.0), r) - eye;
  vec3 below = eye - eye_at(place - vec2(0.0, texel.y), b), above = eye_at(place + vec2(0.0, texel.y), t) - eye;
  vec3 dx = l <= 0.0 || (r > 0.0 && abs(right.z) < abs(left.z)) ? right : left;
  vec3 dy = b <= 0.0 || (t > 0.0 && abs(above.z) < abs(below.z)) ? above : below;
  if (l <= 0.0 && r <= 0.0) dx = vec3(1.0, 0.0, 0.0);
  if (b <= 0.0 && t <= 0.0) dy = vec3(0.0, 1.0, 0.0);
  vec3 normal = normalize(cross(dx, dy));
  vec4 seen = projection * vec4(eye, 1.0);
  float own = 0.5 * seen.z / seen.w + 0.5;
  if (texture(scene_depth, place).r < own) discard;
  float thickness = texture(thick, place).r;
  vec3 along = normalize(eye);
  vec2 shift = 0.25 * min(thickness, longest_path) * normal.xy / d;
  vec2 through = clamp(place - 0.5 * shift / half_size, vec2(0.0), vec2(1.0));
  if (texture(scene_depth, through).r < own) through = place;
  vec3 light_through = exp(-absorption * thickness);
  vec3 refracted = texture(scene, through).rgb * light_through + deep * (1.0 - light_through);
  float facing = clamp(-dot(normal, along), 0.0, 1.0);
  float fresnel = 0.04 + 0.96 * pow(1.0 - facing, 4.0);  // a little stronger than water's
  float lit = max(0.0, dot(normal, light));
  refracted *= 0.80 + 0.28 * lit;
  vec3 reflected = sky(reflect(along, normal));
  float gloss = pow(max(0.0, dot(reflect(-light, normal), -along)), 120.0);
  result = vec4(mix(refracted, reflected, fresnel) + 0.6 * gloss, 1.0);
  gl_FragDepth = own;
}
)"};

const ShaderSource copy_shader{screen_vertex, R"(
in vec2 place;
uniform sampler2D scene, scene_depth;
out vec4 result;
void main() {
  result = texture(scene, place);
  gl_FragDepth = min(texture(scene_depth, place).r, 0.99999);  // nearer than what was cleared
}
)"};

}  // namespace freshet::gl
