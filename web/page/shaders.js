// SPDX-License-Identifier: MIT
// GLSL of the view. A particle is a point sprite: a glowing dot, a disc or a lit sphere.

export const particleVertex = `#version 300 es
uniform mat4 camera;     // scene -> clip space
uniform float radius;    // of a sprite, in the scene
uniform float scale;     // pixels per unit at w = 1
uniform vec2 depths;     // of clip space per unit: d(z)/d(distance), d(w)/d(distance)
layout(location = 0) in vec3 x;
layout(location = 1) in float value;
out float shade, pixels;
out vec4 center;
void main() {
  center = camera * vec4(x, 1);
  gl_Position = center;
  pixels = clamp(radius * scale / center.w, .75, 256.);
  gl_PointSize = 2. * pixels + 2.;  // room for smooth edges
  shade = value;
}`;

export const particleFragment = `#version 300 es
precision highp float;
uniform sampler2D colors;
uniform int mode;        // 0 glow, 1 disc, 2 sphere
uniform vec4 fixedColor; // of walls, bodies and foam; a = 0: by the value
uniform vec2 range;      // values at the ends of the colours
uniform float row;       // of the map in \`colors\`
uniform float radius;
uniform vec2 depths;
uniform vec3 ground;
uniform vec2 haze;       // w where it begins, and its length
in float shade, pixels;
in vec4 center;
out vec4 color;
void main() {
  vec2 p = (2. * gl_PointCoord - 1.) * (1. + 1. / pixels);  // 1 at the edge
  float r2 = dot(p, p), inside = (1. - sqrt(r2)) * pixels + .5;
  if (inside <= 0.) discard;
  float t = clamp((shade - range.x) / (range.y - range.x), 0., 1.);
  vec3 base = fixedColor.a > 0. ? fixedColor.rgb
                                : texture(colors, vec2((t * 255. + .5) / 256., row)).rgb;
  if (mode == 0) { color = vec4(base * exp(-r2 / .49), 1); return; }
  if (mode == 1) {
    color = vec4(base, min(inside, 1.));
    return;
  }
  if (r2 > 1.) discard;
  vec3 n = vec3(p.x, -p.y, sqrt(1. - r2));
  vec4 front = center + vec4(0, 0, depths * (n.z * radius));
  gl_FragDepth = .5 + .5 * front.z / front.w;
  float light = max(dot(n, normalize(vec3(-.45, .75, .55))), 0.);
  float sky = .5 + .5 * n.y;
  float shine = pow(max(dot(reflect(-normalize(vec3(-.45, .75, .55)), n), vec3(0, 0, 1)), 0.), 40.);
  vec3 lit = base * (.22 + .3 * sky + .62 * light) + vec3(.35) * shine;
  float far = clamp((center.w - haze.x) / haze.y, 0., 1.);
  color = vec4(mix(lit, ground, .55 * far), 1);
}`;

export const lineVertex = `#version 300 es
uniform mat4 camera;
layout(location = 0) in vec3 x;
void main() { gl_Position = camera * vec4(x, 1); }`;

export const lineFragment = `#version 300 es
precision highp float;
uniform vec4 tint;
out vec4 color;
void main() { color = tint; }`;
