// SPDX-License-Identifier: MIT
// The stage: the view of a run with its buttons, numbers and a curve. Both pages have one.
import { Player, Runner } from './runner.js';
import { View } from './view.js';
import { pngOf, save } from './link.js';
import { quantities } from './simulation.js';
import { word } from './words.js';

const element = (id) => document.getElementById(id);
const number = (v, digits = 3) => {
  if (v === null || v === undefined || !Number.isFinite(v)) return '–';
  if (v !== 0 && (Math.abs(v) < 1e-3 || Math.abs(v) >= 1e5)) return v.toExponential(2).replace('e+', 'e');
  return String(Number(v.toPrecision(digits)));
};
export { element, number };

/** The numbers that a panel can show: of what a session says of its scene and of its state. */
export const readings = {
  time: (a, s) => `${number(s.time, 4)} s`,
  steps: (a, s) => String(s.steps),
  particles: (a, s) => String(s.particles),
  dt: (a, s) => `${number(s.dt || a.step)} s`,
  density_mean: (a, s) => number(s.density_mean, 4),
  density_range: (a, s) => `${number(s.density_min)} … ${number(s.density_max)}`,
  density_error: (a, s) => `${number(100 * s.density_error)} %`,
  speed_mean: (a, s) => `${number(s.speed_mean)} m/s`,
  speed_max: (a, s) => `${number(s.speed_max)} m/s`,
  height_mean: (a, s) => `${number(s.height_mean)} m`,
  kinetic_energy: (a, s) => `${number(s.kinetic_energy)} ${a.dimension === 2 ? 'J/m' : 'J'}`,
  iterations: (a, s) => s.solves.map((v) => v.iterations).join(' + ') || '–',
  neighbors: (a) => number(a.neighbors),
  lattice: (a) => number(a.lattice_density),
  sound_speed: (a) => `${number(a.sound_speed)} m/s`,
  step_bound: (a) => `${number(a.step_bound)} s`,
  mass: (a) => number(a.mass),
  outside: (a, s) => String(s.outside),
  rate: (a, s, stage) => (stage.rate ? String(Math.round(stage.rate)) : '–'),
  bright: (a, s, stage) => (stage.pixels ? `${number(100 * stage.pixels.bright / stage.pixels.pixels)} %` : '–'),
  bottom_third: (a, s, stage) => (stage.pixels ? String(stage.pixels.bottom_third) : '–'),
};
const always = ['time', 'steps', 'rate', 'particles', 'density_mean', 'density_range', 'speed_mean',
  'speed_max', 'kinetic_energy'];
const solving = ['density_error', 'iterations'];

export class Stage {
  constructor({ flat = false } = {}) {
    this.canvas = element('view');
    this.runner = new Runner({ flat });
    this.player = new Player(this.runner, (answer, done) => this.onFrame(answer, done),
      (error) => this.fail(error));
    this.history = [];
    this.listeners = [];
    this.bindButtons();
    this.bindPointer();
    this.bindKeys();
  }

  async start() {
    this.view = await View.start(this.canvas);
  }

  /** The answer to a request; 3D and most solvers load the larger module first. */
  async answerTo(request) {
    try {
      return await this.player.open(request);
    } catch (error) {
      if (!this.runner.flat || !error.message.includes('this build has no')) throw error;
      this.runner.close();
      this.runner = this.player.runner = new Runner();
      return this.player.open(request);
    }
  }

  async open(request, { play = true } = {}) {
    const answer = await this.answerTo(request);
    this.pixels = null;
    this.fail(null);
    this.about = answer.about;
    const { mass, spacing, dimension, density_error: error, lattice_sum: sum } = answer.about;
    this.about.lattice_density = (1 + error) * mass / spacing ** dimension / sum;
    if (!request.keep) this.history = [];
    this.player.steps = answer.state.steps;
    this.player.dt = answer.about.step || answer.about.step_bound || 0.001;
    this.view.open(answer.about, answer.drawn);
    this.showLook();
    this.canvas.dataset.dimension = answer.about.dimension;
    element('hint').textContent = word(answer.about.dimension === 3 ? 'orbit' : 'push');
    this.onFrame(answer, 0);
    this.warn();
    const own = quantities[answer.about.color_by];
    if (!this.chosenColor && own !== this.player.quantity) await this.color(own);
    if (play) this.play();
    return answer.about;
  }

  onFrame(answer, done) {
    this.state = answer.state;
    this.view.show(answer.drawn);
    if (done > 0) {
      const rate = 1000 * done / Math.max(0.1, answer.milliseconds);
      this.rate = this.rate ? this.rate + 0.1 * (rate - this.rate) : rate;
      this.history.push([answer.state.time, answer.state.kinetic_energy, answer.state.density_mean]);
      if (this.history.length > 600) this.history = this.history.filter((_, k) => k % 2 === 0);
    }
    this.showNumbers();
    this.drawCurve();
    this.mark();
    if (answer.state.warnings.length) this.warn();
    this.listeners.forEach((f) => f(this));
  }

  showNumbers() {
    const names = [...always, ...(this.state.solves.length ? solving : [])];
    const text = (name) => readings[name](this.about, this.state, this);
    const panel = element('numbers');
    if (panel.dataset.names !== names.join()) {
      panel.dataset.names = names.join();
      panel.innerHTML = names.map((n) => `<dt>${word(n)}</dt><dd data-reading="${n}"></dd>`).join('');
    }
    document.querySelectorAll('[data-reading]').forEach((e) => {
      const now = text(e.dataset.reading);
      if (e.textContent !== now) e.textContent = now;
    });
    element('clock').textContent = `${number(this.state.time, 3)} s`;
    element('bar').style.width = `${Math.min(100, 100 * this.state.time / this.about.end)}%`;
  }

  /** The kinetic energy over time. */
  drawCurve() {
    const canvas = element('curve');
    if (!canvas.clientWidth) return;
    const ratio = Math.min(2, devicePixelRatio || 1);
    const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    const c = canvas.getContext('2d');
    c.clearRect(0, 0, width, height);
    if (this.history.length < 2) return;
    const end = Math.max(this.history.at(-1)[0], 1e-9);
    const top = Math.max(...this.history.map((h) => h[1]), 1e-12);
    c.beginPath();
    for (const [time, energy] of this.history)
      c.lineTo(time / end * width, height - 2 - energy / top * (height - 6));
    c.strokeStyle = '#0f766e';
    c.lineWidth = 1.5 * ratio;
    c.stroke();
    element('curve_top').textContent = `${word('kinetic_energy')} ≤ ${number(top)} ${this.about.dimension === 2 ? 'J/m' : 'J'}`;
  }

  warn() {
    const lines = this.about.warnings.split('\n').filter(Boolean)
      .concat((this.state?.warnings ?? []).map((w) => `warning: ${w.message}`));
    element('warnings').textContent = lines.join('\n');
    element('warning_count').textContent = lines.length || '';
    element('warning_panel').hidden = !lines.length;
  }

  fail(error) {
    element('error').hidden = !error;
    element('error').textContent = error ? error.message : '';
    this.mark();
  }

  play() {
    this.player.play();
    this.mark();
  }

  pause() {
    this.player.pause();
    this.mark();
  }

  mark() {
    const button = element('play');
    const now = this.player.playing ? 'pause' : 'play';
    if (button.dataset.state === now) return;
    button.dataset.state = now;
    button.title = word(now);
    button.setAttribute('aria-label', word(now));
  }

  async step(count = 1) {
    this.pause();
    await this.player.idle();
    await this.player.advance(count);
  }

  /** Balls or water, and slices: in 3D. */
  showLook() {
    const deep = this.about.dimension === 3;
    element('look').hidden = !deep;
    const axis = Number(element('slice').value);
    element('slice_at').hidden = axis < 0;
    this.view.setStyle(deep && this.view.floats ? element('style').value : 'balls');
    this.view.setSlice(deep ? axis : -1, Number(element('slice_at').value));
  }

  async color(quantity) {
    element('color').value = quantity;
    this.player.quantity = quantity;
    if (!this.about) return;
    await this.player.idle();
    const answer = await this.runner.call('look', { quantity });
    this.view.show(answer.drawn);
  }

  /** The picture as a run writes it in 2D, and the view in 3D. */
  async savePicture(name) {
    await this.player.idle();
    if (this.about.dimension === 2) {
      const picture = await this.runner.call('picture');
      return save(`${name}.png`, await pngOf(picture));
    }
    this.view.draw();
    return new Promise((resolve) => this.canvas.toBlob((blob) => { save(`${name}.png`, blob); resolve(); }));
  }

  async countPixels() {
    await this.player.idle();
    this.pixels = (await this.runner.call('picture')).pixels;
    this.showNumbers();
  }

  bindButtons() {
    element('play').onclick = () => (this.player.playing ? this.pause() : this.play());
    element('step').onclick = () => this.step();
    element('show_panels').onclick = () => element('panels').classList.toggle('shown');
    element('pace').onchange = (e) => {
      this.player.pace = e.target.value === 'fastest' ? Infinity : Number(e.target.value);
    };
    for (const id of ['style', 'slice', 'slice_at']) element(id).oninput = () => this.showLook();
    element('color').onchange = (e) => { this.chosenColor = true; this.color(e.target.value); };
  }

  bindPointer() {
    const { canvas } = this;
    const touching = new Map();
    let spread = 0;
    const distance = () => {
      const [a, b] = [...touching.values()];
      return Math.hypot(a.x - b.x, a.y - b.y);
    };
    canvas.onpointerdown = (e) => {
      canvas.setPointerCapture(e.pointerId);
      touching.set(e.pointerId, { x: e.offsetX, y: e.offsetY, time: e.timeStamp });
      if (touching.size === 2) spread = distance();
      element('hint').classList.add('gone');
    };
    canvas.onpointermove = (e) => {
      const before = touching.get(e.pointerId);
      if (!before || !this.about) return;
      const now = { x: e.offsetX, y: e.offsetY, time: e.timeStamp };
      touching.set(e.pointerId, now);
      if (this.about.dimension === 3) {
        if (touching.size === 2) {
          const wide = distance();
          this.view.zoom(wide / spread);
          spread = wide;
        } else this.view.turn(now.x - before.x, now.y - before.y);
      } else this.pushBy(before, now);
    };
    const end = (e) => {
      touching.delete(e.pointerId);
      this.player.push = null;
    };
    canvas.onpointerup = end;
    canvas.onpointercancel = end;
    canvas.addEventListener('wheel', (e) => {
      if (this.about?.dimension !== 3) return;
      e.preventDefault();
      this.view.zoom(Math.exp(-e.deltaY * 0.001));
    }, { passive: false });
  }

  /** A drag pushes the water along: the acceleration follows the speed of the pointer. */
  pushBy(before, now) {
    const from = this.view.place(before.x, before.y), to = this.view.place(now.x, now.y);
    const seconds = Math.max(0.008, (now.time - before.time) / 1000);
    const limit = 150;
    const pull = to.map((v, k) => Math.max(-limit, Math.min(limit, 12 * (v - from[k]) / seconds)));
    const radius = 0.14 * (this.about.max[1] - this.about.min[1]);
    this.player.push = { place: to, acceleration: pull, radius };
    if (!this.player.playing) this.play();
  }

  bindKeys() {
    addEventListener('keydown', (e) => {
      if (e.target.closest('input, select, textarea, button, summary, a') || e.ctrlKey || e.metaKey || e.altKey) return;
      const turn = { ArrowLeft: [-12, 0], ArrowRight: [12, 0], ArrowUp: [0, 12], ArrowDown: [0, -12] }[e.key];
      if (e.key === ' ') element('play').click();
      else if (e.key === 's') element('step').click();
      else if (e.key === 'r') element('restart').click();
      else if (turn && this.about?.dimension === 3 && document.activeElement === this.canvas) {
        this.view.turn(...turn);
      } else if ((e.key === '+' || e.key === '-') && this.about?.dimension === 3) {
        this.view.zoom(e.key === '+' ? 1.1 : 0.9);
      } else return;
      e.preventDefault();
    });
  }
}
