// SPDX-License-Identifier: MIT
// The page of scenes: TOML with the messages of the command.
import { save } from './link.js';
import { Stage, element } from './stage.js';
import { stageHtml } from './stage_html.js';
import { translate, word } from './words.js';

const solvers = ['', 'mueller2003', 'wcsph', 'delta_sph', 'pcisph', 'iisph', 'dfsph', 'pbf'];

/** A scene in the address, compressed where the browser can: #toml=... */
async function packed(text) {
  const bytes = new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  const all = new Uint8Array(await new Response(bytes).arrayBuffer());
  return btoa(String.fromCharCode(...all)).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
}
async function unpacked(code) {
  const all = Uint8Array.from(atob(code.replace(/-/g, '+').replace(/_/g, '/')), (c) => c.charCodeAt(0));
  const text = new Blob([all]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  return new Response(text).text();
}

class Editor {
  constructor(stage, scenes) {
    Object.assign(this, { stage, scenes, name: 'dam_break_2d', count: 0 });
    this.area = element('toml');
  }

  bind() {
    element('scene').innerHTML = this.scenes.map(({ name, title, missing }) =>
      `<option value="${name}">${name}${missing ? ` (${word('not_here')}: ${missing})` : ''} — ${title}</option>`).join('');
    element('solver').innerHTML = solvers.map((s) => `<option value="${s}">${s || word('own_solver')}</option>`).join('');
    element('scene').onchange = (e) => this.load(e.target.value);
    element('solver').onchange = () => this.run();
    this.area.oninput = () => { this.number(); clearTimeout(this.timer); this.timer = setTimeout(() => this.check(), 250); };
    this.area.onscroll = () => { element('lines').scrollTop = this.area.scrollTop; };
    this.area.onkeydown = (e) => { if (e.key === 'Enter' && (e.ctrlKey || e.metaKey)) this.run(); };
    element('run').onclick = () => this.run();
    element('restart').onclick = () => this.run();
    const saveScene = () => save(`${this.name}.toml`, new Blob([this.area.value], { type: 'application/toml' }));
    element('save_toml').onclick = saveScene;
    element('save_scene').onclick = saveScene;
    element('save_picture').onclick = () => this.stage.savePicture(this.name);
    element('share').onclick = () => this.share();
    element('copy_link').onclick = () => this.share();
  }

  async share() {
    const own = this.area.value === this.original;
    const code = own ? `scene=${this.name}` : `name=${this.name}&toml=${await packed(this.area.value)}`;
    const solver = element('solver').value;
    history.replaceState(null, '', `#${code}${solver ? `&solver=${solver}` : ''}`);
    await navigator.clipboard?.writeText(location.href).catch(() => {});
    for (const id of ['share', 'copy_link']) {
      element(id).textContent = word('copied');
      setTimeout(() => { element(id).textContent = word('link'); }, 2000);
    }
  }

  async load(name, text) {
    this.name = name;
    element('scene').value = name;
    const answer = await fetch(`scenes/${name}.toml`);
    this.original = await answer.text();
    this.area.value = text ?? this.original;
    this.area.scrollTop = 0;
    this.number();
    await this.files(name);
    await this.run();
  }

  /** Fetches the files that a scene reads. */
  async files(name) {
    for (const file of this.scenes.find((s) => s.name === name)?.files ?? []) {
      const bytes = new Uint8Array(await (await fetch(`scenes/${file}`)).arrayBuffer());
      await this.stage.runner.call('write', { path: file, bytes });
    }
  }

  number(marked = new Set()) {
    const count = this.area.value.split('\n').length;
    element('lines').innerHTML = Array.from({ length: count },
      (_, k) => (marked.has(k + 1) ? `<b>${k + 1}</b>` : k + 1)).join('\n');
    element('lines').scrollTop = this.area.scrollTop;
  }

  request() {
    return { text: this.area.value, name: `${this.name}.toml`, solver: element('solver').value };
  }

  /** Shows messages, and marks their lines. */
  tell(text, kind) {
    const lines = [...text.matchAll(/\.toml:(\d+):\d+:/g)].map((m) => Number(m[1]));
    const box = element('messages');
    box.className = kind;
    box.textContent = text || word('valid');
    this.number(kind === 'error' ? new Set(lines) : new Set());
  }

  async check() {
    try {
      const { warnings } = await this.stage.runner.call('check', this.request());
      this.tell(warnings, warnings ? 'warning' : '');
    } catch (error) {
      this.tell(error.message, 'error');
    }
  }

  async run() {
    this.stage.pause();
    const request = this.request();
    try {
      const about = await this.stage.open(request);
      this.tell(about.warnings.trimEnd(), about.warnings ? 'warning' : '');
    } catch (error) {
      this.tell(error.message, 'error');
      this.stage.fail(error);
    }
    element('title').textContent = `${this.name}${request.solver ? `, ${request.solver}` : ''}`;
    element('command').textContent = `freshet run ${this.name}.toml${request.solver ? ` --solver ${request.solver}` : ''}`;
  }
}

async function start() {
  element('stage').innerHTML = stageHtml();
  translate();
  const stage = new Stage();
  element('title').textContent = word('starting');
  try {
    const scenes = await (await fetch('scenes/scenes.json')).json();
    const editor = new Editor(stage, scenes);
    window.freshet = { stage, editor };
    editor.bind();
    await stage.start();
    const asked = new URLSearchParams(location.hash.slice(1));
    element('solver').value = asked.get('solver') ?? '';
    const text = asked.has('toml') ? await unpacked(asked.get('toml')) : undefined;
    const known = (name) => scenes.some((s) => s.name === name);
    const name = [asked.get('scene'), asked.get('name')].find(known) ?? 'dam_break_2d';
    await editor.load(name, text);
  } catch (error) {
    stage.fail(error);
  }
}
start();
