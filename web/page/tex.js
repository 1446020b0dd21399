// SPDX-License-Identifier: MIT
// The part of TeX that the article's formulas use, as MathML.

const letters = {
  alpha: 'α', beta: 'β', gamma: 'γ', delta: 'δ', Delta: 'Δ', rho: 'ρ', mu: 'μ', nu: 'ν', pi: 'π',
  sigma: 'σ', eta: 'η', lambda: 'λ', infty: '∞',
};
const operators = {
  cdot: '⋅', times: '×', nabla: '∇', le: '≤', ge: '≥', leftarrow: '←', to: '→', approx: '≈',
  dots: '…', sum: '∑', int: '∫', pm: '±', propto: '∝', partial: '∂', '{': '{', '}': '}',
};
const spaces = { quad: 1, qquad: 2, ',': 0.17, ';': 0.28, ' ': 0.25 };
const functions = new Set(['min', 'max', 'exp', 'sin', 'cos', 'log']);

const escaped = (text) => text.replace(/[&<>]/g, (c) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;' })[c]);
const row = (parts) => (parts.length === 1 ? parts[0] : `<mrow>${parts.join('')}</mrow>`);

class Reader {
  constructor(text, display) {
    this.tokens = text.match(/\\[a-zA-Z]+|\\.|[0-9]+(?:\.[0-9]+)?|\s+|./gu) ?? [];
    this.display = display;
    this.at = 0;
  }

  next() {
    while (/^\s+$/.test(this.tokens[this.at] ?? '')) ++this.at;
    return this.tokens[this.at++];
  }

  peek() {
    const at = this.at, token = this.next();
    this.at = at;
    return token;
  }

  /** The text of a group {...}, for \text and \mathbf. */
  raw() {
    this.next();
    let text = '';
    while (this.at < this.tokens.length && this.tokens[this.at] !== '}') text += this.tokens[this.at++];
    ++this.at;
    return text;
  }

  /** Reads up to a token. */
  until(end) {
    const parts = [];
    for (let token = this.peek(); token !== undefined && token !== end; token = this.peek())
      parts.push(this.scripted());
    if (end !== undefined) this.next();
    return parts;
  }

  /** An atom with its subscript and superscript. */
  scripted() {
    const start = this.peek();
    const base = this.atom();
    let below, above;
    for (let token = this.peek(); token === '_' || token === '^'; token = this.peek()) {
      this.next();
      if (token === '_') below = this.atom(true);
      else above = this.atom(true);
    }
    if (!below && !above) return base;
    const limits = this.display && start === '\\sum';
    const name = (below && above ? (limits ? 'munderover' : 'msubsup')
      : below ? (limits ? 'munder' : 'msub') : limits ? 'mover' : 'msup');
    return `<${name}>${base}${below ?? ''}${above ?? ''}</${name}>`;
  }

  atom(script = false) {
    const token = this.next();
    if (token === '{') {
      const parts = this.until('}');
      const word = script && parts.length > 2 && parts.every((p) => /^<m([in])>[a-z0-9]<\/m\1>$/.test(p));
      if (word) return `<mi mathvariant="normal">${parts.map((p) => p[4]).join('')}</mi>`;
      return row(parts);
    }
    if (/^[0-9]/.test(token)) return `<mn>${token}</mn>`;
    if (token[0] === '\\') return this.command(token.slice(1));
    if (/^\p{L}$/u.test(token)) return `<mi>${token}</mi>`;
    if (token === '-') return '<mo>−</mo>';
    if (token === '|') return '<mo stretchy="false">|</mo>';
    if ('()[]'.includes(token)) return `<mo stretchy="false">${token}</mo>`;
    return `<mo>${escaped(token)}</mo>`;
  }

  command(name) {
    if (name === 'frac' || name === 'tfrac') {
      const parts = [this.atom(), this.atom()].join('');
      return name === 'tfrac' ? `<mstyle displaystyle="false"><mfrac>${parts}</mfrac></mstyle>`
        : `<mfrac>${parts}</mfrac>`;
    }
    if (name === 'sqrt') return `<msqrt>${this.atom()}</msqrt>`;
    if (name === 'mathbf') return `<mi mathvariant="bold" class="bold">${escaped(this.raw())}</mi>`;
    if (name === 'text') return `<mtext>${escaped(this.raw())}</mtext>`;
    if (name === 'left') {
      const open = this.next();
      const inner = this.until('\\right').join('');
      return `<mrow><mo>${open}</mo>${inner}<mo>${this.next()}</mo></mrow>`;
    }
    if (name in spaces) return `<mspace width="${spaces[name]}em"></mspace>`;
    if (name in letters) return `<mi>${letters[name]}</mi>`;
    if (name in operators) return `<mo>${operators[name]}</mo>`;
    if (functions.has(name)) return `<mi>${name}</mi>`;
    return `<mtext>${escaped(name)}</mtext>`;
  }
}

/** MathML of a formula. */
export function mathOf(tex, display = false) {
  const body = new Reader(tex, display).until(undefined).join('');
  return `<math${display ? ' display="block"' : ''}><mrow>${body}</mrow></math>`;
}
