// SPDX-License-Identifier: MIT
// The elements of a stage.
import { word } from './words.js';

const icon = (path) => `<svg viewBox="0 0 20 20" aria-hidden="true"><path d="${path}"/></svg>`;
const button = (id, name, path) => `<button id="${id}" class="icon" title="${word(name)}" aria-label="${word(name)}">${icon(path)}</button>`;
const colors = ['speed', 'density', 'pressure', 'velocity_x', 'velocity_y', 'height', 'liquid', 'density_error'];

export const stageHtml = (extra = '') => `
<div class="screen">
  <canvas id="view" tabindex="0" aria-label="${word('keys')}" title="${word('keys')}"></canvas>
  <span id="clock">0 s</span>
  <span id="title"></span>
  <span id="hint"></span>
  <div id="error" role="alert" hidden></div>
  <div class="track"><i id="bar"></i></div>
</div>
<div class="transport">
  <button id="play" class="icon main" data-state="play" title="${word('play')}" aria-label="${word('play')}">
    <svg viewBox="0 0 20 20" aria-hidden="true"><path class="when-play" d="M6 3.5v13l11-6.5z"/><path class="when-pause" d="M5 3.5h3.5v13H5zM11.5 3.5H15v13h-3.5z"/></svg>
  </button>
  ${button('step', 'step', 'M4 3.5v13l8-6.5zM13.5 3.5H16v13h-2.5z')}
  ${button('restart', 'restart', 'M10 3.2V.8L5.6 4.4 10 8V5.4a4.9 4.9 0 1 1-4.9 4.9H2.9A7.1 7.1 0 1 0 10 3.2z')}
  ${button('show_panels', 'panels', 'M3 5h14v2H3zM3 9.5h14v2H3zM3 14h14v2H3z')}
  <label class="choice"><span>${word('color')}</span><select id="color">
    ${colors.map((c) => `<option value="${c}">${word(c === 'density_error' ? 'density_error_color' : c)}</option>`).join('')}
  </select></label>
  <label class="choice"><span>${word('pace')}</span><select id="pace">
    <option value="0.1">0.1 ×</option><option value="0.25">0.25 ×</option>
    <option value="1" selected>${word('real_time')}</option><option value="2">2 ×</option>
    <option value="fastest">${word('fastest')}</option>
  </select></label>
</div>
<div class="panels" id="panels">
  <div class="row" id="look" hidden>
    <label class="choice"><span>${word('look')}</span><select id="style">
      <option value="balls">${word('balls')}</option><option value="water">${word('water')}</option>
    </select></label>
    <label class="choice"><span>${word('slice')}</span><select id="slice">
      <option value="-1">${word('none')}</option><option value="0">x</option>
      <option value="1">y</option><option value="2">z</option>
    </select></label>
    <input id="slice_at" type="range" min="0" max="1" step="0.01" value="0.5" aria-label="${word('slice')}" hidden>
  </div>
  ${extra}
  <details id="number_panel" open>
    <summary>${word('numbers')}</summary>
    <dl id="numbers"></dl>
    <canvas id="curve"></canvas><small id="curve_top"></small>
  </details>
  <details id="warning_panel" hidden>
    <summary>${word('warnings')} <b id="warning_count"></b></summary>
    <pre id="warnings"></pre>
  </details>
  <details id="more" open>
    <summary>${word('more')}</summary>
    <div class="row">
      <button id="save_picture">${word('picture')}</button>
      <button id="save_scene">${word('scene_file')}</button>
      <button id="copy_link">${word('link')}</button>
    </div>
    <p class="small">${word('command')}</p>
    <pre id="command"></pre>
  </details>
</div>`;
