// SPDX-License-Identifier: MIT
// The part of Markdown that docs/article.md uses, as sections of HTML.
import { mathOf } from './tex.js';

const escaped = (text) => text.replace(/[&<>"]/g,
  (c) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]);

/** The anchor that hosts of Markdown give a heading. */
export const anchorOf = (heading) => heading.toLowerCase().replace(/[^\p{L}\p{N}\s_-]/gu, '')
  .trim().replace(/\s/g, '-');

/** Links to files of the sources are shown as code, since they are not part of the page. */
function link(label, target, image) {
  if (image) return `<figure><img src="${target}" alt="${label}" loading="lazy"><figcaption>${label}</figcaption></figure>`;
  if (target.startsWith('#')) return `<a href="${target}">${label}</a>`;
  if (target.startsWith('../')) return `<span class="source">${label}</span>`;
  return `<a href="${target}">${label}</a>`;
}

function inline(text) {
  const kept = [];
  const keep = (html) => `\u0000${kept.push(html) - 1}\u0000`;
  let out = text
    .replace(/`([^`]+)`/g, (_, code) => keep(`<code>${escaped(code)}</code>`))
    .replace(/\$([^$]+)\$/g, (_, tex) => keep(mathOf(tex)));
  out = escaped(out)
    .replace(/(!?)\[([^\]]*)\]\(([^)\s]+)\)/g, (_, image, label, target) => link(label, target, image))
    .replace(/\*\*([^*]+)\*\*/g, '<strong>$1</strong>')
    .replace(/\*([^*]+)\*/g, '<em>$1</em>');
  return out.replace(/\u0000(\d+)\u0000/g, (_, k) => kept[k]);
}

/** Cells of a table's row; a bar within a formula or code is no border. */
const cells = (line) => line.replace(/^\||\|\s*$/g, '').split(/\|(?=(?:[^$`]*[$`][^$`]*[$`])*[^$`]*$)/)
  .map((cell) => inline(cell.trim()));

function table(lines) {
  const [head, , ...body] = lines;
  const line = (text, tag) => `<tr>${cells(text).map((c) => `<${tag}>${c}</${tag}>`).join('')}</tr>`;
  return `<div class="table"><table><thead>${line(head, 'th')}</thead><tbody>`
    + `${body.map((text) => line(text, 'td')).join('')}</tbody></table></div>`;
}

/** HTML of a block: lines without an empty one between them. */
function block(lines) {
  const text = lines.join('\n');
  if (text.startsWith('```')) return `<pre><code>${escaped(lines.slice(1, -1).join('\n'))}</code></pre>`;
  if (text.startsWith('$$')) return `<div class="formula">${mathOf(text.replace(/\$\$/g, ''), true)}</div>`;
  if (text.startsWith('|')) return table(lines);
  if (text.startsWith('- ')) {
    const items = text.split(/\n(?=- )/).map((item) => `<li>${inline(item.slice(2).replace(/\n\s*/g, ' '))}</li>`);
    return `<ul>${items.join('')}</ul>`;
  }
  const html = inline(text.replace(/\n/g, /[\u4e00-\u9fff]/.test(text) ? '' : ' '));
  return html.startsWith('<figure') ? html : `<p>${html}</p>`;
}

function blocks(text) {
  const all = [];
  let now = [], fence = false;
  const flush = () => { if (now.length) all.push(now); now = []; };
  for (const line of text.split('\n')) {
    if (line.startsWith('```')) {
      if (!fence) flush();
      now.push(line);
      fence = !fence;
      if (!fence) flush();
    } else if (fence || line.trim()) {
      const list = line.startsWith('- ') && now.length && !/^(- |\s)/.test(now[0]);
      if (list) flush();
      now.push(line);
    } else flush();
  }
  flush();
  return all;
}

/** The sections of a document: {level, title, anchor, html: blocks}. */
export function sectionsOf(markdown) {
  const sections = [];
  for (const lines of blocks(markdown)) {
    const heading = /^(#+) (.*)$/.exec(lines[0]);
    if (heading) {
      sections.push({ level: heading[1].length, title: inline(heading[2]), anchor: anchorOf(heading[2]), html: [] });
      if (lines.length > 1) sections.at(-1).html.push(block(lines.slice(1)));
    } else sections.at(-1).html.push(block(lines));
  }
  return sections;
}
