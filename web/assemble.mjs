// SPDX-License-Identifier: MIT
// web/assemble.mjs MODULE FOLDER: puts the page together: its own files, the WebAssembly modules, the
// article's text and pictures, and the bundled scenes.
import fs from 'node:fs';
import path from 'node:path';

const [module, page] = process.argv.slice(2);
const root = path.resolve(import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname), '..');
const from = (...parts) => path.join(root, ...parts);

fs.rmSync(page, { recursive: true, force: true });
fs.cpSync(from('web/page'), page, { recursive: true });
// A module is a script; the worker imports it.
for (const name of ['freshet', 'freshet_2d']) {
  const script = fs.readFileSync(path.join(module, `${name}.js`), 'utf8');
  fs.writeFileSync(path.join(page, `${name}.js`), script + '\nexport default createFreshet;\n');
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

fs.mkdirSync(path.join(page, 'scenes/meshes'), { recursive: true });
const scenes = [];
for (const file of fs.readdirSync(from('scenes')).filter((f) => f.endsWith('.toml')).sort()) {
  const text = fs.readFileSync(from('scenes', file), 'utf8');
  const files = [...text.matchAll(/^file = "([^"]+)"/gm)].map((m) => m[1]);
  // The page has neither Bullet nor Assimp.
  const missing = [/motion = "free"/.test(text) ? 'Bullet' : '',
    files.some((f) => /\.(obj|stl)$/.test(f)) ? 'Assimp' : ''].filter(Boolean).join(', ');
  scenes.push({ name: file.slice(0, -5), title: /^title = "(.*)"$/m.exec(text)?.[1] ?? '', files, missing });
  fs.copyFileSync(from('scenes', file), path.join(page, 'scenes', file));
  for (const f of files) fs.copyFileSync(from('scenes', f), path.join(page, 'scenes', f));
}
fs.writeFileSync(path.join(page, 'scenes/scenes.json'), JSON.stringify(scenes));
