// SPDX-License-Identifier: MIT
// Cameras: a flat one that fits a rectangle, and one that orbits a box. Matrices are column-major.

/** The matrix of a rectangle that fills the canvas, both axes with one scale. */
export function flatCamera(min, max, width, height, margin) {
  const sides = [max[0] - min[0], max[1] - min[1]];
  const scale = Math.min((width - 2 * margin) / sides[0], (height - 2 * margin) / sides[1]);
  const middle = [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2];
  const sx = 2 * scale / width, sy = 2 * scale / height;
  return {
    matrix: new Float32Array([sx, 0, 0, 0, 0, sy, 0, 0, 0, 0, 0, 0,
      -sx * middle[0], -sy * middle[1], 0, 1]),
    scale,
    place: (x, y) => [(x - width / 2) / scale + middle[0], (height / 2 - y) / scale + middle[1], 0],
  };
}

const subtract = (a, b) => a.map((v, k) => v - b[k]);
const dot = (a, b) => a.reduce((sum, v, k) => sum + v * b[k], 0);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((v) => v / Math.hypot(...a));

/** A camera around the middle of a box, y up. */
export class Orbit {
  constructor(min, max) {
    this.target = min.map((v, k) => (v + max[k]) / 2);
    this.size = Math.hypot(...subtract(max, min));
    this.reset();
  }

  reset() {
    this.azimuth = 0.55;
    this.elevation = 0.36;
    this.zoom = 1;
  }

  turn(dx, dy) {
    this.azimuth -= dx;
    this.elevation = Math.min(1.5, Math.max(-0.1, this.elevation + dy));
  }

  scaleBy(factor) {
    this.zoom = Math.min(6, Math.max(0.4, this.zoom * factor));
  }

  view(width, height) {
    const field = 0.62;  // vertical [rad]
    const wide = Math.min(1, width / height / 1.3);
    const distance = 0.46 * this.size / Math.tan(field / 2) / this.zoom / wide;
    const { azimuth: a, elevation: e } = this;
    const back = [Math.cos(e) * Math.sin(a), Math.sin(e), Math.cos(e) * Math.cos(a)];
    const eye = this.target.map((v, k) => v + distance * back[k]);
    const right = unit(cross([0, 1, 0], back)), up = cross(back, right);
    const near = Math.max(0.02 * this.size, distance - 1.2 * this.size);
    const far = distance + 1.2 * this.size;
    const f = 1 / Math.tan(field / 2), aspect = width / height;
    const m = new Float32Array(16);
    const za = -(far + near) / (far - near), zb = -2 * far * near / (far - near);
    for (let k = 0; k < 3; ++k) {
      m[4 * k] = f / aspect * right[k];
      m[4 * k + 1] = f * up[k];
      m[4 * k + 2] = za * back[k];
      m[4 * k + 3] = -back[k];
    }
    m[12] = -f / aspect * dot(right, eye);
    m[13] = -f * dot(up, eye);
    m[14] = -za * dot(back, eye) + zb;
    m[15] = dot(back, eye);
    return {
      matrix: m, scale: f * height / 2, depths: [za, -1],
      haze: [distance - 0.4 * this.size, this.size],
    };
  }
}
