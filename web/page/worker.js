// SPDX-License-Identifier: MIT
// Runs simulations beside the page. A message is {id, call, ...}; the answer has the same id.
import { Simulation, SceneError } from './simulation.js';

/** The module for 2D is smaller: worker.js?2d. */
const file = self.location.search === '?2d' ? './freshet_2d.js' : './freshet.js';
const ready = import(file)
  .then(({ default: create }) => create({ locateFile: (name) => new URL(name, import.meta.url).href }))
  .then((module) => new Simulation(module));

/** What the page draws and shows now. */
function look(simulation, { quantity }) {
  const drawn = simulation.drawn(quantity);
  return { drawn, state: simulation.state() };
}

const calls = {
  open: (s, m) => ({ about: s.open(m), ...look(s, m) }),
  check: (s, m) => ({ warnings: s.check(m) }),
  /** Steps for `budget` milliseconds, up to `steps`. */
  advance: (s, m) => {
    const before = performance.now();
    if (m.push) s.push(m.push.place, m.push.acceleration, m.push.radius);
    else if (m.pushed) s.push([0, 0, 0], [0, 0, 0], 0);
    s.step(m.steps, m.budget, m.pastEnd);
    return { milliseconds: performance.now() - before, ...look(s, m) };
  },
  look,
  picture: (s) => ({ ...s.picture(), sha256: s.pictureSha256() }),
  digest: (s) => ({ state: s.stateSha256(), picture: s.pictureSha256(), steps: s.state().steps }),
  write: (s, m) => (s.write(m.path, m.bytes), {}),
};

self.onmessage = async ({ data }) => {
  try {
    const answer = calls[data.call](await ready, data);
    const lists = answer.drawn ? Object.values(answer.drawn) : [answer.rgba];
    const moved = lists.filter((a) => a?.buffer).map((a) => a.buffer);
    self.postMessage({ id: data.id, ...answer }, moved);
  } catch (error) {
    self.postMessage({ id: data.id, error: error.message, scene: error instanceof SceneError });
  }
};
