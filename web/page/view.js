// SPDX-License-Identifier: MIT
// The view of a run: src/draw, compiled to WebAssembly, on the page's canvas.
import { word } from './words.js';
import createDrawing from './draw.js';

const arrays = ['stage', 'balls', 'foam', 'placements'];

export class View {
  static async start(canvas) {
    const module = await createDrawing({ locateFile: (name) => new URL(name, import.meta.url).href });
    return new View(canvas, module);
  }

  constructor(canvas, module) {
    this.canvas = canvas;
    this.module = module;
    this.gl = canvas.getContext('webgl2', { antialias: true, alpha: false, preserveDrawingBuffer: true });
    if (!this.gl) throw new Error(word('no_webgl'));
    this.context = module.GL.registerContext(this.gl, { majorVersion: 2 });
    this.prepare();
    canvas.addEventListener('webglcontextlost', (event) => { event.preventDefault(); this.lost = true; });
    canvas.addEventListener('webglcontextrestored', () => { this.prepare(); this.draw(); });
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  prepare() {
    this.lost = false;
    this.module.GL.makeContextCurrent(this.context);
    this.floats = this.gl.getExtension('EXT_color_buffer_float') !== null;  // which water needs
    this.demand(this.module._freshet_begin());
  }

  demand(ok) {
    if (!ok) throw new Error(this.module.UTF8ToString(this.module._freshet_message()));
  }

  /** Copies an array of a frame to the module. */
  put(name, values) {
    const place = this.module._freshet_numbers(arrays.indexOf(name), values.length);
    this.module.HEAPF32.set(values, place >> 2);
  }

  /** Shows another scene: what a session's about() returns, and the first arrays. */
  open(about, drawn) {
    const box = [about.min, about.max].join();
    this.put('stage', drawn.stage);
    this.module._freshet_show_stage(this.box === box ? 1 : 0);
    this.box = box;
    this.show(drawn);
  }

  show(drawn) {
    for (const name of arrays.slice(1)) this.put(name, drawn[name]);
    this.module.HEAPU8.set(drawn.map, this.module._freshet_map(drawn.map.length));
    this.module._freshet_show_frame();
    this.draw();
  }

  resize() {
    const ratio = Math.min(2, devicePixelRatio || 1);
    const width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    const height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    if (this.canvas.width !== width || this.canvas.height !== height)
      Object.assign(this.canvas, { width, height });
  }

  draw() {
    if (!this.box || this.lost) return;
    this.resize();
    this.demand(this.module._freshet_draw(this.canvas.width, this.canvas.height));
  }

  /** The place in a 2D scene of a place on the canvas [CSS px]. */
  place(x, y) {
    const { clientWidth, clientHeight } = this.canvas;
    const place = this.module._freshet_place(2 * x / clientWidth - 1, 1 - 2 * y / clientHeight) >> 3;
    return [...this.module.HEAPF64.subarray(place, place + 3)];
  }

  /** Turns the camera by CSS pixels, to the right and down. */
  turn(dx, dy) {
    this.module._freshet_orbit(dx / this.canvas.clientHeight, -dy / this.canvas.clientHeight);
    this.draw();
  }

  zoom(factor) {
    this.module._freshet_zoom(1 / factor);
    this.draw();
  }

  get yaw() {
    return this.module._freshet_yaw();
  }

  setStyle(name) {
    this.module._freshet_style(['balls', 'water'].indexOf(name));
    this.draw();
  }

  /** A slice across axis 0 to 2 at a part of the domain; -1: none. */
  setSlice(axis, part) {
    this.module._freshet_slice(axis, part);
    this.draw();
  }
}
