// SPDX-License-Identifier: MIT
// A simulation: the functions of the WebAssembly module (web/module/module.cpp) with JavaScript's
// texts and arrays. The worker and the tests in node use it.

export const quantities = ['speed', 'velocity_x', 'velocity_y', 'velocity_z', 'density',
  'density_error', 'pressure', 'height', 'id', 'liquid'];
const arrays = ['stage', 'balls', 'foam', 'placements'];

export class SceneError extends Error {}

export class Simulation {
  /** `module` is what createFreshet() resolves to. */
  constructor(module) {
    this.module = module;
    this.about = null;
  }

  /** Calls a function of the module with texts and numbers. */
  call(name, ...values) {
    const m = this.module;
    const texts = [];
    const args = values.map((value) => {
      if (typeof value !== 'string') return value;
      const size = m.lengthBytesUTF8(value) + 1;
      const place = m._malloc(size);
      m.stringToUTF8(value, place, size);
      texts.push(place);
      return place;
    });
    const result = m['_freshet_' + name](...args);
    texts.forEach((place) => m._free(place));
    return result;
  }

  text(name, ...values) {
    return this.module.UTF8ToString(this.call(name, ...values));
  }

  /** Throws the module's message, as the command prints it, where a call returns 0. */
  demand(ok) {
    if (!ok) throw new SceneError(this.text('message').trimEnd());
  }

  /** Opens a scene. `changes` are lines "KEY=VALUE", or "KEY" to remove it. With `keep` the
      particles of the open scene stay where they are, if their number is the same. */
  open({ text, name = 'scene.toml', solver = '', changes = '', keep = false }) {
    this.demand(this.call('open', text, name, solver, changes, keep ? 1 : 0));
    this.about = JSON.parse(this.text('about'));
    return this.about;
  }

  /** The warnings for a scene; throws its errors. */
  check({ text, name = 'scene.toml', solver = '', changes = '' }) {
    this.demand(this.call('check', text, name, solver, changes));
    return this.text('message').trimEnd();
  }

  /** Takes at most so many steps, for about so many milliseconds; beyond the scene's end only if
      asked to. */
  step(steps, milliseconds = Infinity, pastEnd = false) {
    this.demand(this.call('step', steps, milliseconds, pastEnd ? 1 : 0));
  }

  /** The pointer's push: acceleration at a place, which fades out at a radius. */
  push(place, acceleration, radius) {
    this.call('push', ...place, ...acceleration, radius);
  }

  setGravity(gravity) {
    this.demand(this.call('set_gravity', ...gravity, 0));
  }

  state() {
    return JSON.parse(this.text('state'));
  }

  stateSha256() {
    return this.text('state_sha256');
  }

  pictureSha256() {
    return this.text('picture_sha256');
  }

  /** The arrays to draw, coloured by a quantity: a ball has four numbers, x, y, z and its place in
      the colour map. */
  drawn(quantity) {
    const shown = this.call('update', quantities.indexOf(quantity));
    const result = {};
    arrays.forEach((name, k) => {
      const first = this.call('array', shown, k) >> 2;
      result[name] = this.module.HEAPF32.slice(first, first + this.call('array_size', shown, k));
    });
    const map = this.call('map', shown);
    result.map = this.module.HEAPU8.slice(map, map + this.call('map_size', shown));
    return result;
  }

  /** The picture of a 2D scene: {width, height, rgba}. */
  picture() {
    const first = this.call('picture');
    const width = this.call('picture_width'), height = this.call('picture_height');
    const rgb = this.module.HEAPU8.subarray(first, first + 3 * width * height);
    const rgba = new Uint8ClampedArray(4 * width * height).fill(255);
    for (let k = 0; k < width * height; ++k)
      for (let c = 0; c < 3; ++c) rgba[4 * k + c] = rgb[3 * k + c];
    return { width, height, rgba, pixels: JSON.parse(this.text('picture_pixels')) };
  }

  /** Writes a file that scenes can name. */
  write(path, bytes) {
    const folders = path.split('/').slice(0, -1);
    folders.forEach((_, k) => {
      const folder = folders.slice(0, k + 1).join('/');
      if (!this.module.FS.analyzePath(folder).exists) this.module.FS.mkdir(folder);
    });
    this.module.FS.writeFile(path, bytes);
  }
}
