// SPDX-License-Identifier: MIT
// The pages in headless Chromium. Screenshots are in build/web_screenshots.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import test, { after, before } from 'node:test';
import { gzipSync } from 'node:zlib';
import { native } from '../page/native.js';
import { Chromium, pause } from './chromium.mjs';
import { root } from './module.mjs';

const folder = path.join(root, 'build/page');
const pictures = path.join(root, 'build/web_screenshots');
let browser, served, plain;
const open = [];

/** web/serve, which sends the headers for threads. */
async function serve() {
  const server = spawn(path.join(root, 'web/serve'), ['--port', '0', folder], { stdio: ['ignore', 'pipe', 'inherit'] });
  const address = await new Promise((resolve) => server.stdout.once('data', (d) => resolve(String(d).trim())));
  return { address, stop: () => server.kill() };
}

/** Any static host: no such headers. */
async function host() {
  const types = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm' };
  const server = http.createServer((request, response) => {
    const file = path.join(folder, new URL(request.url, 'http://x').pathname.replace(/\/$/, '/index.html'));
    if (!fs.existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, { 'content-type': types[path.extname(file)] ?? 'application/octet-stream' });
    return response.end(fs.readFileSync(file));
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return { address: `http://127.0.0.1:${server.address().port}/`, stop: () => server.close() };
}

before(async () => {
  [served, plain] = await Promise.all([serve(), host()]);
  browser = await Chromium.start();
});
after(async () => {
  await browser?.stop();
  served?.stop();
  plain?.stop();
});

const state = 'freshet.stage.state';
async function visit(address, width = 1440, height = 900, options = {}) {
  const page = await browser.page(width, height, options);
  await page.go(address);
  await page.until(`window.freshet && ${state} && ${state}.steps > 5`);
  open.push(page);
  return page;
}
const noErrors = (page) => assert.deepEqual(page.errors, []);
/** Shares of pixels of the view that are brighter than the night. */
const drawn = `(() => { const v = freshet.stage.view, g = v.gl; v.draw();
  const p = new Uint8Array(4 * g.drawingBufferWidth * g.drawingBufferHeight);
  g.readPixels(0, 0, g.drawingBufferWidth, g.drawingBufferHeight, g.RGBA, g.UNSIGNED_BYTE, p);
  let n = 0; for (let k = 0; k < p.length; k += 4) n += p[k] > 60 || p[k + 1] > 60 || p[k + 2] > 110;
  return n / (p.length / 4); })()`;
/** The share of pixels with the colour of water. */
const blues = drawn.replace('p[k] > 60 || p[k + 1] > 60 || p[k + 2] > 110', 'p[k + 2] > p[k] + 40 && p[k + 1] > p[k] + 20');

test('the first page is at most 1 MB compressed', () => {
  const first = ['index.html', 'style.css', 'freshet_2d.js', 'freshet_2d.wasm', 'draw.wasm', 'docs/article.zh-CN.md', 'scenes/article.toml',
    ...fs.readdirSync(folder).filter((f) => f.endsWith('.js') && !/^(freshet|editor)/.test(f))];
  const bytes = first.reduce((sum, f) => sum + gzipSync(fs.readFileSync(path.join(folder, f)), { level: 9 }).length, 0);
  console.log(`  first page: ${(bytes / 1e6).toFixed(3)} MB compressed`);
  assert.ok(bytes <= 1e6, `${bytes} bytes`);
});

test('the article runs, sliders change it, and the address keeps the numbers', async () => {
  const page = await visit(`${served.address}?lang=en`);
  assert.equal(await page.value('crossOriginIsolated'), true);
  assert.equal(await page.value(`${state}.particles`), 600);
  assert.ok(await page.value(drawn) > 0.02);
  await page.screenshot(`${pictures}/article.png`);
  await page.value(`(() => { const i = document.querySelector('[data-slider="k"] input'); i.value = 0.9; i.dispatchEvent(new Event('input')); })()`);
  await page.until('Math.abs(freshet.stage.about.stiffness / 4680 - 1) < 0.02');
  const hash = await page.value('location.hash');
  assert.match(hash, /set\.solver\.stiffness=\d+/);
  assert.match(await page.value('document.getElementById("command").textContent'), /^freshet run article --set solver\.stiffness=\d+$/);
  noErrors(page);
  const again = await visit(`${served.address}?lang=en${hash}`);
  assert.equal(await again.value('freshet.stage.about.stiffness'), await page.value('freshet.stage.about.stiffness'));
  noErrors(again);
});

test('the digests equal the native ones', async () => {
  const page = await visit(`${served.address}?lang=en`);
  await page.value('freshet.stage.pause(), document.querySelector(".digest button").click()');
  await page.until('document.querySelector(".digest .result").dataset.state', 120);
  const { state: s, picture } = await page.value('({ ...document.querySelector(".digest .result").dataset })');
  assert.deepEqual({ s, picture }, { s: native.state, picture: native.picture });
  assert.equal(await page.value('document.querySelectorAll(".digest .sum.same").length'), 2);
  await page.value('document.querySelector(".digest").scrollIntoView({ block: "center" })');
  await pause(300);
  await page.screenshot(`${pictures}/digest.png`);
  noErrors(page);
});

test('every experiment runs without an error', async () => {
  const page = await visit(`${served.address}?lang=en`);
  const names = await page.value('[...new Set([...document.querySelectorAll("[data-run]")].map((e) => e.dataset.run))]');
  assert.ok(names.length > 20);
  for (const name of names) {
    await page.value(`document.querySelector('[data-run="${name}"]').click()`);
    await page.value('freshet.playground.queue');
    assert.equal(await page.value('document.getElementById("error").hidden'), true, `${name}: ${await page.value('document.getElementById("error").textContent')}`);
    await page.until(`${state}.steps > 2`);
    if (['walls', 'deep', 'boiling', 'dfsph'].includes(name)) {
      await pause(2500);
      await page.value(`document.querySelector('[data-run="${name}"]').scrollIntoView({ block: 'center' })`);
      await page.screenshot(`${pictures}/run_${name}.png`);
    }
    assert.ok(await page.value(drawn) > 0.01, name);
  }
  noErrors(page);
});

test('buttons, keys and the pointer', async () => {
  const page = await visit(`${served.address}?lang=en`);
  await page.value('document.getElementById("play").click()');
  await page.value('freshet.stage.player.idle()');
  const stopped = await page.value(`${state}.steps`);
  await pause(300);
  assert.equal(await page.value(`${state}.steps`), stopped);
  await page.key('s', 'KeyS');
  await page.until(`${state}.steps === ${stopped + 1}`);
  await page.key(' ', 'Space');
  await page.until(`${state}.steps > ${stopped + 10}`);
  await page.value(`(() => { window.pushes = []; window.opened = 0; const { runner } = freshet.stage, old = runner.call;
    runner.call = function (name, m) { opened += name === 'open'; if (m?.push) pushes.push(m.push); return old.call(this, name, m); }; })()`);
  await page.key('r', 'KeyR');
  await page.until('opened === 1');
  const box = await page.value('(({ left, top, width, height }) => [left, top, width, height])(document.getElementById("view").getBoundingClientRect())');
  await page.until(`${state}.steps > 300`);
  const at = (x, y) => [box[0] + x * box[2], box[1] + y * box[3]];
  await page.drag(at(0.3, 0.9), at(0.6, 0.6));
  const push = await page.value('pushes');
  assert.ok(push.some((p) => p.acceleration[0] > 10 && p.acceleration[1] > 10), JSON.stringify(push));
  await page.value('document.getElementById("color").value = "density", freshet.stage.color("density")');
  await pause(200);
  await page.screenshot(`${pictures}/density.png`);
  // Pictures and scenes are saved as files.
  const saved = await page.value(`(async () => { const names = [], old = HTMLAnchorElement.prototype.click;
    HTMLAnchorElement.prototype.click = function () { names.push(this.download); };
    await freshet.stage.savePicture('article'); document.getElementById('save_scene').click();
    HTMLAnchorElement.prototype.click = old; return names; })()`);
  assert.deepEqual(saved, ['article.png', 'article.toml']);
  noErrors(page);
});

test('a lost graphics context comes back', async () => {
  const page = await visit(`${plain.address}?lang=en`);
  const before = await page.value(drawn);
  await page.value('(window.lose = freshet.stage.view.gl.getExtension("WEBGL_lose_context")).loseContext()');
  await page.until('freshet.stage.view.lost');
  const steps = await page.value(`${state}.steps`);
  await page.until(`${state}.steps > ${steps + 20}`);
  await page.value('lose.restoreContext()');
  await page.until('!freshet.stage.view.lost');
  assert.ok(await page.value(drawn) > before / 2);
  noErrors(page);
});

test('the page in Chinese, without the headers', async () => {
  const page = await visit(`${plain.address}?lang=zh`);
  assert.equal(await page.value('crossOriginIsolated'), false);
  assert.match(await page.value('document.querySelector("h1").textContent'), /逐章/);
  assert.ok(await page.value('document.querySelectorAll(".card").length') > 12);
  await page.value('document.querySelectorAll("h2")[3].scrollIntoView()');
  await pause(300);
  await page.screenshot(`${pictures}/chinese.png`);
  noErrors(page);
});

test('a phone of 390 x 844', async () => {
  const page = await visit(`${plain.address}?lang=en`, 390, 844, { phone: true });
  const wide = 'document.documentElement.scrollWidth';
  assert.ok(await page.value(wide) <= 390, `${await page.value(wide)} px wide`);
  await page.screenshot(`${pictures}/phone.png`);
  await page.value('document.querySelector("#poly6-for-densities").scrollIntoView()');
  await pause(300);
  await page.screenshot(`${pictures}/phone_chapter.png`);
  const covered = await page.value(`(() => { const r = document.querySelector('#poly6-for-densities').getBoundingClientRect();
    return document.elementFromPoint(r.left + 5, r.top + 5)?.closest('#stage') !== null; })()`);
  assert.equal(covered, false, 'the heading is behind the stage');
  noErrors(page);
});

test('scenes: TOML with the messages of the command', async () => {
  const page = await visit(`${plain.address}scenes.html?lang=en`);
  await page.until(`${state}.time > 0.05`, 120);
  await page.screenshot(`${pictures}/scenes.png`);
  await page.value(`(() => { const a = document.getElementById('toml');
    a.value = a.value.replace('spacing = 0.02', 'spacng = 0.02'); a.dispatchEvent(new Event('input')); })()`);
  await page.until('document.getElementById("messages").className === "error"');
  const text = await page.value('document.getElementById("messages").textContent');
  assert.match(text, /^dam_break_2d\.toml:\d+:1: error: unknown key particles\.spacng; did you mean/m);
  assert.ok(await page.value('document.querySelectorAll("#lines b").length') > 0);
  await page.screenshot(`${pictures}/scenes_error.png`);
  await page.value(`freshet.editor.load('dam_break_3d')`);
  await page.until('freshet.stage.about.dimension === 3');
  await page.until(`${state}.steps > 3`, 120);
  const box = await page.value('(({ left, top, width, height }) => [left, top, width, height])(document.getElementById("view").getBoundingClientRect())');
  const turned = await page.value('freshet.stage.view.yaw');
  await page.drag([box[0] + 100, box[1] + 100], [box[0] + 200, box[1] + 120]);
  assert.notEqual(await page.value('freshet.stage.view.yaw'), turned);
  await page.screenshot(`${pictures}/scenes_3d.png`);
  const choose = (id, value) => page.value(`(() => { const e = document.getElementById('${id}'); e.value = '${value}'; e.dispatchEvent(new Event('input')); })()`);
  const whole = await page.value(drawn);
  await choose('slice', '2');
  const cut = await page.value(drawn);
  assert.ok(cut < whole, `${cut} of ${whole}`);
  await choose('slice', '-1');
  assert.equal(await page.value('freshet.stage.view.floats'), true);
  await choose('style', 'water');
  await pause(500);
  await page.screenshot(`${pictures}/scenes_water.png`);
  const blue = await page.value(blues);
  await choose('style', 'balls');
  assert.ok(blue > 0.01 && blue < 0.5, `${blue} of the picture is water`);
  noErrors(page);
});

test('walls of points, and libraries that the page lacks', async () => {
  const page = await visit(`${plain.address}scenes.html?lang=en`);
  const run = async (text) => {
    await page.value(`(() => { const a = document.getElementById('toml'); a.value = ${JSON.stringify(text)}; })()`);
    await page.value('freshet.editor.run()');
    return page.value('document.getElementById("messages").textContent');
  };
  const points = Array.from({ length: 40 }, (_, k) => `${0.5 + 0.0125 * k},${0.3}`).join('\n');
  await page.value(`freshet.stage.runner.call('write', { path: 'ramp.csv', bytes: new TextEncoder().encode('x,y\\n' + ${JSON.stringify(points)} + '\\n') })`);
  const tank = '[domain]\nmax = [1.0, 1.0]\n[particles]\nspacing = 0.025\n[fluid]\nshape = "box"\nmin = [0.0, 0.0]\nmax = [0.2, 0.2]\n[solver]\nname = "wcsph"\n[time]\nend = 0.5\nstep = 0.0005\n';
  await run(tank);
  const without = await page.value(drawn);
  await run(`${tank}[[wall]]\nshape = "points"\nfile = "ramp.csv"\n`);
  const withWall = await page.value(drawn);
  assert.ok(withWall > without + 0.005, `${withWall} after ${without}: ${await page.value('document.getElementById("messages").textContent')}`);
  await page.screenshot(`${pictures}/scenes_points.png`);
  const free = await run(`${tank}[[body]]\nshape = "sphere"\ncenter = [0.5, 0.5]\nradius = 0.1\nmotion = "free"\ndensity = 500\n`);
  assert.match(free, /Bullet/);
  const pulsed = await run(tank.replace('[particles]', 'body_force = ["sin(t)", "0"]\n[particles]'));
  assert.match(pulsed, /muParser/);
  noErrors(page);
});

test('a link holds an edited scene', async () => {
  const page = await visit(`${plain.address}scenes.html?lang=zh`);
  await page.value(`(() => { const a = document.getElementById('toml'); a.value = a.value.replace('[1.0, 2.0]', '[0.5, 1.0]'); })()`);
  await page.value('freshet.editor.share()');
  const again = await visit(await page.value('location.href'));
  assert.match(await again.value('document.getElementById("toml").value'), /\[0\.5, 1\.0\]/);
  assert.equal(await again.value(`${state}.particles`), 1250);
  noErrors(again);
});

test('scenes on a phone', async () => {
  const page = await visit(`${plain.address}scenes.html?lang=zh`, 390, 844, { phone: true });
  assert.ok(await page.value('document.documentElement.scrollWidth') <= 390);
  await page.screenshot(`${pictures}/phone_scenes.png`);
  noErrors(page);
});
