// SPDX-License-Identifier: MIT
// The card that compares this browser's bits with the native program's.
import { native } from './native.js';
import { Runner } from './runner.js';
import { word } from './words.js';

/** Runs the scene in a worker of its own. */
export async function compare() {
  const runner = new Runner({ flat: true });
  try {
    const answer = await fetch('scenes/article.toml');
    await runner.call('open', { text: await answer.text(), name: 'article.toml', quantity: 'speed' });
    const { milliseconds } = await runner.call('advance',
      { steps: 2000, budget: 1e9, quantity: 'speed' });
    const digest = await runner.call('digest');
    return { ...digest, rate: 2000 / milliseconds * 1000 };
  } finally {
    runner.close();
  }
}

export function digestCard(place) {
  place.innerHTML = `<section class="card bits"><h4>${word('bits')}</h4><p>${word('bits_text')}</p>
    <button class="run">${word('compare')}</button><div class="result" role="status"></div></section>`;
  const button = place.querySelector('button'), result = place.querySelector('.result');
  const line = (name, here, there) => `<div class="sum ${here === there ? 'same' : 'different'}">
    <b>${word(here === there ? 'same' : 'different')}</b> ${word(name)}
    <code>${word('native')} ${there}</code><code>${word('here')} ${here}</code></div>`;
  button.onclick = async () => {
    button.disabled = true;
    result.textContent = word('running');
    try {
      const { state, picture, steps, rate } = await compare();
      result.innerHTML = line('state_sha', state, native.state) + line('picture_sha', picture, native.picture)
        + `<small>${steps} ${word('steps')}, ${Math.round(rate)} ${word('rate')}</small>`;
      result.dataset.state = state;
      result.dataset.picture = picture;
    } catch (error) {
      result.textContent = error.message;
    }
    button.disabled = false;
  };
}
