// SPDX-License-Identifier: MIT
// Draws particles with WebGL2.
import { Orbit, flatCamera } from './camera.js';
import { lineFragment, lineVertex, particleFragment, particleVertex } from './shaders.js';
import { maps } from './simulation.js';

const night = [8 / 255, 10 / 255, 28 / 255];
const frameTint = [80 / 255, 80 / 255, 120 / 255, 1];
const wallTint = [0.5, 0.5, 0.48, 1], bodyTint = [0.84, 0.62, 0.38, 1], foamTint = [0.95, 0.97, 1, 1];
const glowRadius = 5 / 590;  // of a dot, in heights of the domain: as in the article's picture
const discGirth = 1.15;    // diameter of a disc in spacings, which closes the gaps

function compile(gl, vertex, fragment) {
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
    throw new Error(gl.getProgramInfoLog(program) || 'The shaders do not link.');
  const places = {};
  const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS);
  for (let k = 0; k < count; ++k) {
    const { name } = gl.getActiveUniform(program, k);
    places[name] = gl.getUniformLocation(program, name);
  }
  return { program, places };
}

/** The edges of a box, as pairs of points. */
function edges(min, max) {
  const at = (k) => [0, 1, 2].map((d) => (k >> d & 1 ? max[d] ?? 0 : min[d] ?? 0));
  const all = [];
  const axes = max.length;
  for (let k = 0; k < 1 << axes; ++k)
    for (let d = 0; d < axes; ++d)
      if (!(k >> d & 1)) all.push(...at(k), ...at(k | 1 << d));
  return new Float32Array(all);
}

export class View {
  /** `colors` are the 256 colours of each map. */
  constructor(canvas, colors) {
    this.canvas = canvas;
    this.colors = colors;
    this.gl = canvas.getContext('webgl2', { antialias: true, alpha: false, preserveDrawingBuffer: true });
    if (!this.gl) throw new Error('This browser has no WebGL2, which the page draws with.');
    canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
    canvas.addEventListener('webglcontextrestored', () => { this.prepare(); this.draw(); });
    this.prepare();
    this.map = 'article';
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  prepare() {
    const { gl } = this;
    this.particles = compile(gl, particleVertex, particleFragment);
    this.lines = compile(gl, lineVertex, lineFragment);
    this.buffers = [gl.createBuffer(), gl.createBuffer()];
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    const bytes = new Uint8Array(768 * maps.length);
    maps.forEach((name, k) => bytes.set(this.colors[name], 768 * k));
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB, 256, maps.length, 0, gl.RGB, gl.UNSIGNED_BYTE, bytes);
    for (const [key, value] of [[gl.TEXTURE_MIN_FILTER, gl.NEAREST], [gl.TEXTURE_MAG_FILTER, gl.NEAREST],
      [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE], [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE]])
      gl.texParameteri(gl.TEXTURE_2D, key, value);
  }

  /** Shows another scene: what a session's about() returns, and the first arrays. */
  open(about, drawn) {
    const box = [about.min, about.max].join();
    if (about.dimension === 3 && this.box !== box) this.orbit = new Orbit(about.min, about.max);
    this.box = box;
    this.about = about;
    this.show(drawn);
  }

  show(drawn) {
    this.drawn = drawn;
    this.draw();
  }

  /** The place in a 2D scene of a place on the canvas [CSS px]. */
  place(x, y) {
    const ratio = this.canvas.width / this.canvas.clientWidth;
    return this.camera.place(x * ratio, y * ratio);
  }

  resize() {
    const ratio = Math.min(2, devicePixelRatio || 1);
    const width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    const height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    if (this.canvas.width !== width || this.canvas.height !== height)
      Object.assign(this.canvas, { width, height });
  }

  draw() {
    if (!this.drawn) return;
    this.resize();
    const { gl, about, canvas: { width, height } } = this;
    const flat = about.dimension === 2;
    const window = about.window.length === 4 ? about.window : [...about.min, ...about.max];
    this.camera = flat
      ? flatCamera(window.slice(0, 2), window.slice(2), width, height, Math.round(0.02 * height))
      : this.orbit.view(width, height);
    gl.viewport(0, 0, width, height);
    gl.clearColor(...night, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.disable(gl.BLEND);
    this.drawLines();
    this.drawParticles(flat);
  }

  drawLines() {
    const { gl, lines: { program, places }, about, camera } = this;
    gl.useProgram(program);
    gl.uniformMatrix4fv(places.camera, false, camera.matrix);
    gl.uniform4fv(places.tint, frameTint);
    const points = edges(about.min, about.max);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[0]);
    gl.bufferData(gl.ARRAY_BUFFER, points, gl.STREAM_DRAW);
    gl.enableVertexAttribArray(0);
    gl.disableVertexAttribArray(1);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.drawArrays(gl.LINES, 0, points.length / 3);
  }

  drawParticles(flat) {
    const { gl, particles: { program, places }, about, drawn, camera } = this;
    const glow = flat && about.glow;
    const disc = discGirth / 2 * about.spacing;
    gl.useProgram(program);
    gl.uniformMatrix4fv(places.camera, false, camera.matrix);
    gl.uniform1f(places.scale, camera.scale);
    gl.uniform2fv(places.depths, camera.depths ?? [0, 0]);
    gl.uniform2fv(places.haze, camera.haze ?? [1e9, 1]);
    gl.uniform3fv(places.ground, night);
    gl.uniform2f(places.range, drawn.low, drawn.high);
    gl.uniform1f(places.row, (maps.indexOf(this.map) + 0.5) / maps.length);
    if (flat) gl.enable(gl.BLEND); else gl.disable(gl.BLEND);
    if (flat) gl.disable(gl.DEPTH_TEST); else gl.enable(gl.DEPTH_TEST);
    const sets = (mode, radius, tint, x, values) => {
      if (!x.length) return;
      gl.blendFunc(mode === 0 ? gl.ONE : gl.SRC_ALPHA, mode === 0 ? gl.ONE : gl.ONE_MINUS_SRC_ALPHA);
      gl.uniform1i(places.mode, mode);
      gl.uniform1f(places.radius, radius);
      gl.uniform4fv(places.fixedColor, tint);
      this.upload(0, 3, x);
      if (values) this.upload(1, 1, values); else gl.disableVertexAttribArray(1);
      gl.drawArrays(gl.POINTS, 0, x.length / 3);
    };
    const solid = flat ? 1 : 2;
    sets(solid, disc, wallTint, this.walls ?? drawn.walls);
    const height = about.max[1] - about.min[1];
    const radius = glow ? glowRadius * height : flat ? disc : about.spacing / 2;
    sets(glow ? 0 : solid, radius, [0, 0, 0, 0], drawn.x, drawn.values);
    sets(solid, disc, bodyTint, drawn.bodies);
    sets(solid, disc / 3, foamTint, drawn.foam);
  }

  upload(place, size, values) {
    const { gl } = this;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[place]);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.STREAM_DRAW);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, size, gl.FLOAT, false, 0, 0);
  }
}
