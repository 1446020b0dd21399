// SPDX-License-Identifier: MIT
// The article's page: its text, with experiments beside the formulas.
import { digestCard } from './digest.js';
import { changeLines, commandOf, readRun, save, writeRun } from './link.js';
import { sectionsOf } from './markdown.js';
import { cards, runs } from './presets.js';
import { positionOf, sliders, valueAt } from './sliders.js';
import { Stage, element } from './stage.js';
import { stageHtml } from './stage_html.js';
import { language, translate, word } from './words.js';

const texts = new Map();
async function textOf(path) {
  if (!texts.has(path)) {
    const answer = await fetch(path);
    if (!answer.ok) throw new Error(`${path}: ${answer.status} ${answer.statusText}`);
    texts.set(path, await answer.text());
  }
  return texts.get(path);
}

const sliderHtml = (name) => {
  const s = sliders[name];
  return `<label class="slider" data-slider="${name}"><span class="symbol">${s.symbol}</span>
    <span class="what">${s[language]}</span><input type="range" min="0" max="1" step="any">
    <output></output></label>`;
};

const runHtml = (name) => {
  const { mark } = runs[name];
  return `<button class="run ${mark ?? ''}" data-run="${name}">
    ${mark ? `<small>${word(mark)}</small>` : ''}${runs[name][language]}</button>`;
};

function cardHtml(card) {
  const shown = (card.shown ?? []).map((n) => `<dt>${word(n)}</dt><dd data-reading="${n}">–</dd>`).join('');
  return `<section class="card"><p>${card[language]}</p>
    ${card.runs.length ? `<div class="runs">${card.runs.map(runHtml).join('')}</div>` : ''}
    ${card.sliders.map(sliderHtml).join('')}
    ${card.colors ? `<div class="runs">${['speed', 'density', 'pressure', 'velocity_y'].map((c) => `<button class="run" data-color="${c}">${word(c)}</button>`).join('')}</div>` : ''}
    ${shown ? `<dl class="readings">${shown}</dl>` : ''}</section>${card.digest ? '<div class="digest"></div>' : ''}`;
}

/** Writes the article's text and the cards. */
async function writeText() {
  const page = language === 'zh' ? 'article.zh-CN.md' : 'article.md';
  const sections = sectionsOf(await textOf(`docs/${page}`));
  sections[0].html.shift();  // the link to the other language
  element('text').innerHTML = sections.map(({ level, title, anchor, html }, k) => {
    const card = cards[k] ? cardHtml(cards[k]) : '';
    const parts = cards[k]?.after === undefined ? [...html, card]
      : [...html.slice(0, cards[k].after), card, ...html.slice(cards[k].after)];
    return `<h${level} id="${anchor}">${title}</h${level}>${parts.join('')}`;
  }).join('');
  document.title = `Freshet: ${element('text').querySelector('h1').textContent}`;
}

class Playground {
  constructor(stage) {
    this.stage = stage;
    stage.player.pastEnd = true;
    this.run = { scene: 'article', solver: '', changes: {} };
    this.queue = Promise.resolve();
    this.timer = null;
  }

  /** Opens the run; one at a time, and only the last of several that wait. */
  open({ keep = false } = {}) {
    const { run } = this;
    const asked = (this.asked = {});
    this.queue = this.queue.then(async () => {
      if (asked !== this.asked) return;
      const playing = this.stage.player.playing || !this.stage.about;
      this.stage.pause();
      try {
        const text = await textOf(`scenes/${run.scene}.toml`);
        await this.stage.open({ text, name: `${run.scene}.toml`, solver: run.solver,
          changes: changeLines(run.changes), keep }, { play: playing || !keep });
        this.showSliders();
        if (document.querySelector('[data-reading="bright"], [data-reading="bottom_third"]') && this.run.scene === 'article')
          this.counted = null;
      } catch (error) {
        this.stage.fail(error);
      }
      element('command').textContent = commandOf(run);
      element('title').textContent = this.titleOf(run);
    });
    return this.queue;
  }

  titleOf(run) {
    const changes = Object.keys(run.changes).length;
    return `${run.scene}${run.solver ? `, ${run.solver}` : ''}${changes ? ' *' : ''}`;
  }

  choose(name) {
    const { scene, solver = '', changes = {} } = runs[name];
    this.chosen = name;
    this.run = { scene, solver, changes: { ...changes } };
    this.remember();
    document.querySelectorAll('[data-run]').forEach((e) => e.classList.toggle('chosen', e.dataset.run === name));
    return this.open();
  }

  remember() {
    const plain = this.run.scene === 'article' && !this.run.solver && !Object.keys(this.run.changes).length;
    history.replaceState(null, '', plain ? location.pathname + location.search : writeRun(this.run));
  }

  change(name, position) {
    const slider = sliders[name];
    const value = valueAt(slider, this.stage.about, position);
    this.run = { ...this.run, changes: { ...this.run.changes, [slider.key]: slider.to(value, this.stage.about) } };
    this.showValue(name, value, position);
    clearTimeout(this.timer);
    this.timer = setTimeout(() => { this.remember(); this.open({ keep: !slider.restart }); }, 60);
  }

  showValue(name, value, position) {
    const slider = sliders[name];
    document.querySelectorAll(`[data-slider="${name}"]`).forEach((e) => {
      const input = e.querySelector('input');
      if (document.activeElement !== input || input.value === '') input.value = position;
      const shown = slider.shown?.(value) ?? Number(value.toPrecision(3));
      e.querySelector('output').textContent = `${shown} ${slider.unit}`.trim();
      e.classList.toggle('changed', slider.key in this.run.changes);
    });
  }

  showSliders() {
    const { about } = this.stage;
    for (const [name, slider] of Object.entries(sliders)) {
      const suits = slider.suits(about);
      document.querySelectorAll(`[data-slider="${name}"]`).forEach((e) => {
        e.classList.toggle('off', !suits);
        e.querySelector('input').disabled = !suits;
      });
      if (!suits) continue;
      const value = slider.from(about);
      this.showValue(name, value, positionOf(slider, about, value));
    }
  }

  bind() {
    document.querySelectorAll('[data-run]').forEach((e) => { e.onclick = () => this.choose(e.dataset.run); });
    document.querySelectorAll('[data-slider]').forEach((e) => {
      const input = e.querySelector('input');
      input.setAttribute('aria-label', sliders[e.dataset.slider][language]);
      input.oninput = () => this.change(e.dataset.slider, Number(input.value));
    });
    document.querySelectorAll('[data-color]').forEach((e) => {
      e.onclick = () => { this.stage.chosenColor = true; this.stage.color(e.dataset.color); };
    });
    element('restart').onclick = () => this.open();
    element('save_picture').onclick = () => this.stage.savePicture(this.run.scene);
    element('save_scene').onclick = () => save(`${this.run.scene}.toml`,
      new Blob([this.stage.about.source], { type: 'application/toml' }));
    element('copy_link').onclick = async (e) => {
      const address = new URL(location.href);
      address.hash = writeRun(this.run);
      history.replaceState(null, '', address);
      await navigator.clipboard?.writeText(address.href).catch(() => {});
      e.target.textContent = word('copied');
      setTimeout(() => { e.target.textContent = word('link'); }, 2000);
    };
    addEventListener('hashchange', () => {
      const run = readRun(location.hash);
      if (run) { this.run = run; this.open(); }
    });
    // The pixels of the picture are counted twice a second where they are shown.
    setInterval(() => {
      const seen = [...document.querySelectorAll('[data-reading="bright"], [data-reading="bottom_third"]')]
        .some((e) => { const r = e.getBoundingClientRect(); return r.top < innerHeight && r.bottom > 0; });
      if (seen && this.stage.about?.dimension === 2 && this.stage.state.steps !== this.counted) {
        this.counted = this.stage.state.steps;
        this.stage.countPixels().catch(() => {});
      }
    }, 500);
  }
}

async function start() {
  const all = `<details id="slider_panel"><summary>${word('all_sliders')}</summary>
    ${Object.keys(sliders).map(sliderHtml).join('')}</details>`;
  element('stage').innerHTML = stageHtml(all);
  translate();
  if (matchMedia('(max-width: 900px)').matches)
    document.querySelectorAll('#stage details').forEach((e) => { e.open = false; });
  const stage = new Stage({ flat: true });
  const playground = new Playground(stage);
  window.freshet = { stage, playground };
  element('title').textContent = word('starting');
  const run = readRun(location.hash);
  if (run) playground.run = run;
  try {
    const text = writeText().then(() => {
      document.querySelectorAll('.digest').forEach(digestCard);
      playground.bind();
    });
    await stage.start();
    await text;
    await playground.open();
    if (location.hash && !run) document.querySelector(location.hash)?.scrollIntoView();
  } catch (error) {
    stage.fail(error);
  }
}
start();
