// SPDX-License-Identifier: MIT
// A run in the address: #scene=article&solver=dfsph&set.KEY=VALUE&unset=KEY.

export function readRun(hash) {
  const values = new URLSearchParams(hash.replace(/^#/, ''));
  if (!values.has('scene')) return null;
  const run = { scene: values.get('scene'), solver: values.get('solver') ?? '', changes: {} };
  for (const [key, value] of values) {
    if (key.startsWith('set.')) run.changes[key.slice(4)] = value;
    if (key === 'unset') run.changes[value] = null;
  }
  return run;
}

export function writeRun({ scene, solver, changes }) {
  const values = new URLSearchParams({ scene });
  if (solver) values.set('solver', solver);
  for (const [key, value] of Object.entries(changes)) {
    if (value === null) values.append('unset', key);
    else values.set('set.' + key, value);
  }
  return '#' + values;
}

/** The lines that the module takes. */
export const changeLines = (changes) => Object.entries(changes)
  .map(([key, value]) => (value === null ? key : `${key}=${value}`)).join('\n');

/** The command that makes the same run. */
export function commandOf({ scene, solver, changes }) {
  const quoted = (text) => (/[\s"'[\],;*]/.test(text) ? `'${text}'` : text);
  const parts = ['freshet run', scene];
  if (solver) parts.push('--solver', solver);
  for (const [key, value] of Object.entries(changes))
    parts.push(value === null ? `--unset ${key}` : `--set ${quoted(`${key}=${value}`)}`);
  return parts.join(' ');
}

/** Gives a file to the reader. */
export function save(name, blob) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

export const pngOf = (picture) => new Promise((resolve) => {
  const canvas = document.createElement('canvas');
  Object.assign(canvas, { width: picture.width, height: picture.height });
  canvas.getContext('2d').putImageData(new ImageData(picture.rgba, picture.width), 0, 0);
  canvas.toBlob(resolve, 'image/png');
});
