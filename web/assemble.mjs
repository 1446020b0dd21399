// SPDX-License-Identifier: MIT
// web/assemble.mjs MODULE FOLDER: puts the page together: its own files, the WebAssembly modules, the
// article's text and pictures, and the bundled scenes.
import fs from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { Simulation } from './page/simulation.js';

const [module, page] = process.argv.slice(2);
const root = path.resolve(import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname), '..');
const from = (...parts) => path.join(root, ...parts);

fs.rmSync(page, { recursive: true, force: true });
fs.cpSync(from('web/page'), page, { recursive: true });
// A module is a script; the worker or the page imports it.
for (const name of ['freshet', 'freshet_2d', 'draw']) {
  const script = fs.readFileSync(path.join(module, `${name}.js`), 'utf8');
  const create = name === 'draw' ? 'createDrawing' : 'createFreshet';
  fs.writeFileSync(path.join(page, `${name}.js`), `${script}\nexport default ${create};\n`);
  fs.copyFileSync(path.join(module, `${name}.wasm`), path.join(page, `${name}.wasm`));
}

fs.mkdirSync(path.join(page, 'docs/images'), { recursive: true });
for (const name of ['article.md', 'article.zh-CN.md']) {
  const text = fs.readFileSync(from('docs', name), 'utf8');
  // Pictures are relative to the page.
  fs.writeFileSync(path.join(page, 'docs', name), text.replace(/\]\(images\//g, '](docs/images/'));
  for (const [, image] of text.matchAll(/\]\(images\/([a-z0-9_]+\.png)\)/g))
    fs.copyFileSync(from('docs/images', image), path.join(page, 'docs/images', image));
}

const createFreshet = createRequire(import.meta.url)(path.resolve(module, 'freshet.js'));
const simulation = new Simulation(await createFreshet({ wasmBinary: fs.readFileSync(path.join(module, 'freshet.wasm')) }));
/** The library that a scene needs and the page lacks. */
function missing(name, text, files) {
  files.forEach((f) => simulation.write(f, fs.readFileSync(from('scenes', f))));
  try {
    simulation.check({ text, name });
    return '';
  } catch (error) {
    const library = /Bullet|Assimp|muParser|zlib/.exec(error.message)?.[0];
    if (!library) throw new Error(`${name} is invalid in the page: ${error.message}`);
    return library;
  }
}

fs.mkdirSync(path.join(page, 'scenes/meshes'), { recursive: true });
const scenes = [];
for (const file of fs.readdirSync(from('scenes')).filter((f) => f.endsWith('.toml')).sort()) {
  const text = fs.readFileSync(from('scenes', file), 'utf8');
  const files = [...text.matchAll(/^file = "([^"]+)"/gm)].map((m) => m[1]);
  scenes.push({ name: file.slice(0, -5), title: /^title = "(.*)"$/m.exec(text)?.[1] ?? '', files,
    missing: missing(file, text, files) });
  fs.copyFileSync(from('scenes', file), path.join(page, 'scenes', file));
  for (const f of files) fs.copyFileSync(from('scenes', f), path.join(page, 'scenes', f));
}
fs.writeFileSync(path.join(page, 'scenes/scenes.json'), JSON.stringify(scenes));
