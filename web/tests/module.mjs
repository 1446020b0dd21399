// SPDX-License-Identifier: MIT
// The WebAssembly module in node.
import fs from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { Simulation } from '../page/simulation.js';

export const root = path.resolve(path.dirname(new URL(import.meta.url).pathname), '../..');
export const scene = (name) => fs.readFileSync(path.join(root, 'scenes', `${name}.toml`), 'utf8');

export async function simulation() {
  const folder = path.join(root, 'build/web/bin');
  const createFreshet = createRequire(import.meta.url)(path.join(folder, 'freshet.js'));
  return new Simulation(await createFreshet({ wasmBinary: fs.readFileSync(path.join(folder, 'freshet.wasm')) }));
}
