// SPDX-License-Identifier: MIT
// The module in node: its bits are those of the native program, and its messages those of the command.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test from 'node:test';
import { native } from '../page/native.js';
import { changeLines } from '../page/link.js';
import { runs } from '../page/presets.js';
import { root, scene, simulation } from './module.mjs';

const program = path.join(root, 'build/release/bin/freshet');
const has = fs.existsSync(program) ? {} : { skip: 'build/release/bin/freshet is not built' };

/** state_sha256 of a native run. */
function nativeDigest(name, args) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'freshet_web_'));
  try {
    execFileSync(program, ['run', path.join(root, 'scenes', `${name}.toml`), '--output', `${folder}/run`,
      '--quiet', ...args], { stdio: 'pipe' });
    return JSON.parse(fs.readFileSync(`${folder}/run/report.json`, 'utf8')).state_sha256;
  } finally {
    fs.rmSync(folder, { recursive: true });
  }
}

test('the article\'s scene has the native state and picture after 2000 steps', async () => {
  const golden = fs.readFileSync(path.join(root, 'tests/sim/article_golden_test.cpp'), 'utf8');
  assert.ok(golden.includes(native.state) && golden.includes(native.picture));
  const s = await simulation();
  s.open({ text: scene('article'), name: 'article.toml' });
  s.step(2000);
  assert.equal(s.state().steps, 2000);
  assert.equal(s.stateSha256(), native.state);
  assert.equal(s.pictureSha256(), native.picture);
  const { pixels } = s.picture();
  assert.deepEqual([pixels.bright, pixels.bottom_third], [30844, 41727]);
});

const compared = [
  ['article', '', { checks: null }, 0.2],
  ['article_corrected', 'wcsph', runs.walls.changes, 0.02],
  ['article_corrected', 'pcisph', runs.pcisph.changes, 0.05],
  ['article_corrected', 'iisph', runs.iisph.changes, 0.05],
  ['article_corrected', 'dfsph', runs.dfsph.changes, 0.05],
  ['article_corrected', 'pbf', runs.pbf.changes, 0.05],
  ['dam_break_2d', '', { checks: null }, 0.02],
  ['dam_break_3d', 'dfsph', runs.deep.changes, 0.02],
];
for (const [name, solver, changes, end] of compared)
  test(`${name} ${solver} has the native state at ${end} s`, has, async () => {
    const all = { ...changes, 'time.end': String(end) };
    const s = await simulation();
    s.open({ text: scene(name), name: `${name}.toml`, solver, changes: changeLines(all) });
    s.step(1e9);
    assert.ok(s.state().finished);
    const args = Object.entries(all).flatMap(([k, v]) => (v === null ? ['--unset', k] : ['--set', `${k}=${v}`]));
    assert.equal(s.stateSha256(), nativeDigest(name, solver ? ['--solver', solver, ...args] : args));
  });

test('every run beside the article opens and steps', async () => {
  const s = await simulation();
  for (const [name, { scene: file, solver, changes = {} }] of Object.entries(runs)) {
    const about = s.open({ text: scene(file), name: `${file}.toml`, solver, changes: changeLines(changes) });
    s.step(3);
    assert.equal(s.state().steps, 3, name);
    const drawn = s.drawn('speed');
    assert.equal(drawn.balls.length, 4 * about.particles, name);
    assert.ok(drawn.balls.every(Number.isFinite), name);
    assert.equal(drawn.map.length, 4 * 256, name);
  }
});

test('errors are those of the command', has, async () => {
  const s = await simulation();
  const folder = path.join(root, 'tests/scenes/bad');
  for (const file of fs.readdirSync(folder, { recursive: true }))
    if (fs.statSync(path.join(folder, file)).isFile()) s.write(file, fs.readFileSync(path.join(folder, file)));
  let count = 0;
  for (const file of fs.readdirSync(folder).filter((f) => f.endsWith('.toml'))) {
    const bytes = fs.readFileSync(path.join(folder, file));
    const text = bytes.toString('utf8');
    if (bytes.includes(0) || !Buffer.from(text).equals(bytes)) continue;  // a text area holds no such text
    let message;
    try { message = s.check({ text, name: file }); } catch (error) { message = error.message; }
    if (/was built without it|\.\.\//.test(message)) continue;  // libraries and folders that the page lacks
    const { stderr } = spawnSync(program, ['check', file], { cwd: folder, encoding: 'utf8' });
    assert.equal(message, stderr.trimEnd(), file);
    ++count;
  }
  assert.ok(count > 20, `${count} scenes`);
});

test('an error leaves the open scene as it is', async () => {
  const s = await simulation();
  s.open({ text: scene('article'), name: 'article.toml' });
  s.step(5);
  assert.throws(() => s.open({ text: 'x = 1\n', name: 'a.toml' }), /a\.toml:1:1: error/);
  assert.equal(s.state().steps, 5);
});

/** Three numbers of each particle. */
const places = (s) => s.drawn('speed').balls.filter((_, k) => k % 4 < 3);

test('a changed number keeps the particles in place, another count does not', async () => {
  const s = await simulation();
  const request = { text: scene('article'), name: 'article.toml' };
  s.open(request);
  s.step(300);
  const before = places(s);
  s.open({ ...request, changes: 'solver.stiffness=500', keep: true });
  assert.deepEqual(places(s), before);
  assert.equal(s.about.stiffness, 500);
  s.open({ ...request, changes: 'fluid.count=[24, 17]', keep: true });
  assert.equal(places(s).length, 3 * 408);
});

test('a push moves the particles near it and no others', async () => {
  const s = await simulation();
  const pushedPlaces = (push) => {
    s.open({ text: scene('article_corrected'), name: 'a.toml' });
    if (push) s.push([0.5, 1, 0], [50, 0, 0], 0.3);
    s.step(20);
    return places(s);
  };
  const free = pushedPlaces(false), pushed = pushedPlaces(true);
  let near = 0, far = 0;
  for (let k = 0; k < free.length; k += 3) {
    const away = Math.hypot(free[k] - 0.5, free[k + 1] - 1), moved = pushed[k] - free[k];
    if (away < 0.1) near = Math.max(near, moved);
    if (away > 0.9) far = Math.max(far, Math.abs(moved));
  }
  assert.ok(near > 5e-4 && far === 0, `${near} ${far}`);
});

test('steps per second of processor time are measured and printed', async () => {
  const s = await simulation();
  const rate = (name, solver, count) => {
    s.open({ text: scene(name), name: `${name}.toml`, solver });
    s.step(count / 5);
    const before = process.cpuUsage();
    s.step(count);
    const { user, system } = process.cpuUsage(before);
    return Math.round(1e6 * count / (user + system));
  };
  const article = rate('article', '', 1000), dam = rate('dam_break_2d', 'wcsph', 200);
  console.log(`  article: ${article} steps/s; dam_break_2d by wcsph, ${s.about.particles} particles: ${dam} steps/s`);
  assert.ok(article > 0 && dam > 0);
});
