// SPDX-License-Identifier: MIT
// The page's side of a worker: calls as promises, and a run that keeps pace with the clock.

export class Runner {
  /** With `flat` the simulation has 2D only, and is smaller to load. */
  constructor({ flat = false } = {}) {
    this.flat = flat;
    this.worker = new Worker(new URL(`worker.js${flat ? '?2d' : ''}`, import.meta.url), { type: 'module' });
    this.waiting = new Map();
    this.count = 0;
    this.worker.onmessage = ({ data }) => {
      const { resolve, reject } = this.waiting.get(data.id);
      this.waiting.delete(data.id);
      if (data.error === undefined) resolve(data);
      else reject(Object.assign(new Error(data.error), { scene: data.scene }));
    };
    this.worker.onerror = (event) => {
      const error = new Error(event.message || 'The worker could not start.');
      this.waiting.forEach(({ reject }) => reject(error));
      this.waiting.clear();
    };
  }

  call(name, values = {}) {
    return new Promise((resolve, reject) => {
      const id = ++this.count;
      this.waiting.set(id, { resolve, reject });
      this.worker.postMessage({ id, call: name, ...values });
    });
  }

  close() {
    this.worker.terminate();
  }
}

/** Runs the open scene: onFrame(answer) after each batch of steps. */
export class Player {
  constructor(runner, onFrame, onError) {
    Object.assign(this, { runner, onFrame, onError });
    this.playing = false;
    this.busy = null;         // the batch in progress
    this.pace = 1;            // seconds of the scene per second; Infinity: as fast as it goes
    this.quantity = 'speed';
    this.owed = 0;            // time of the scene that the run is behind [s]
    this.pastEnd = false;     // whether a run goes on after the end of its scene
    this.push = null;
    this.pushed = false;
    this.dt = 0.001;
  }

  /** Opens a scene after the batch in progress. */
  async open(request) {
    await this.idle();
    this.owed = 0;
    return this.runner.call('open', { ...request, quantity: this.quantity });
  }

  async idle() {
    while (this.busy) await this.busy.catch(() => {});
  }

  play() {
    if (this.playing) return;
    this.playing = true;
    this.before = performance.now();
    const frame = (now) => {
      if (!this.playing) return;
      requestAnimationFrame(frame);
      const passed = Math.min(0.1, (now - this.before) / 1000);
      this.before = now;
      if (this.busy) return;
      this.owed = Math.min(0.05, this.owed + passed * this.pace);
      const steps = this.pace === Infinity ? 1e9 : Math.floor(this.owed / this.dt + 1e-6);
      if (steps > 0) this.advance(steps, 14);
    };
    requestAnimationFrame(frame);
  }

  pause() {
    this.playing = false;
  }

  /** Takes steps now. */
  advance(steps, budget = 1e9) {
    const { quantity, push, pushed, pastEnd } = this;
    this.pushed = Boolean(push);
    this.busy = this.runner.call('advance', { steps, budget, quantity, push, pushed, pastEnd });
    return this.busy.then((answer) => {
      this.busy = null;
      if (answer.state.dt > 0) this.dt = answer.state.dt;
      const done = answer.state.steps - (this.steps ?? 0);
      this.steps = answer.state.steps;
      this.owed = Math.max(0, this.owed - Math.max(1, done) * this.dt);
      if (answer.state.finished && !pastEnd) this.pause();
      this.onFrame(answer, done);
    }, (error) => {
      this.busy = null;
      this.pause();
      this.onError(error);
    });
  }
}
