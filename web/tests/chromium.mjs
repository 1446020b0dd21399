// SPDX-License-Identifier: MIT
// Headless Chromium over its DevTools protocol.
import { spawn } from 'node:child_process';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';

const WebSocket = createRequire(import.meta.url)('ws');
export const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

export class Chromium {
  static async start() {
    const self = new Chromium();
    self.profile = fs.mkdtempSync(path.join(os.tmpdir(), 'freshet_chromium_'));
    self.process = spawn('chromium', ['--headless=new', '--no-sandbox', '--disable-dev-shm-usage',
      '--no-first-run', '--disable-extensions', '--disable-background-networking', '--mute-audio',
      '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--remote-debugging-port=0',
      `--user-data-dir=${self.profile}`, 'about:blank'], { stdio: ['ignore', 'ignore', 'pipe'] });
    const address = await new Promise((resolve, reject) => {
      let text = '';
      self.process.stderr.on('data', (data) => {
        text += data;
        const found = /DevTools listening on (ws:\S+)/.exec(text);
        if (found) resolve(found[1]);
      });
      self.process.on('exit', () => reject(new Error(`Chromium ended: ${text.slice(-500)}`)));
      setTimeout(() => reject(new Error('Chromium did not start in 60 s')), 60000).unref();
    });
    self.socket = new WebSocket(address, { perMessageDeflate: false, maxPayload: 1 << 28 });
    await new Promise((resolve, reject) => self.socket.on('open', resolve).on('error', reject));
    self.waiting = new Map();
    self.pages = new Map();
    self.count = 0;
    self.socket.on('message', (data) => self.receive(JSON.parse(data)));
    return self;
  }

  receive(message) {
    if (message.id) {
      const { resolve, reject } = this.waiting.get(message.id);
      this.waiting.delete(message.id);
      if (message.error) reject(new Error(message.error.message));
      else resolve(message.result);
    } else this.pages.get(message.sessionId)?.notice(message);
  }

  send(method, params = {}, sessionId = undefined) {
    return new Promise((resolve, reject) => {
      const id = ++this.count;
      this.waiting.set(id, { resolve, reject });
      this.socket.send(JSON.stringify({ id, method, params, sessionId }));
    });
  }

  async page(width, height, { phone = false } = {}) {
    const { targetId } = await this.send('Target.createTarget', { url: 'about:blank' });
    const { sessionId } = await this.send('Target.attachToTarget', { targetId, flatten: true });
    const page = new Page(this, sessionId);
    this.pages.set(sessionId, page);
    for (const domain of ['Page', 'Runtime', 'Log', 'Network']) await page.send(`${domain}.enable`);
    await page.send('Emulation.setDeviceMetricsOverride',
      { width, height, deviceScaleFactor: phone ? 2 : 1, mobile: phone });
    if (phone) await page.send('Emulation.setTouchEmulationEnabled', { enabled: true });
    return page;
  }

  async stop() {
    const ended = new Promise((resolve) => this.process.on('exit', resolve));
    await this.send('Browser.close').catch(() => {});
    await Promise.race([ended, pause(5000)]);
    if (this.process.exitCode === null) this.process.kill('SIGKILL');
    fs.rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }
}

class Page {
  constructor(browser, sessionId) {
    Object.assign(this, { browser, sessionId, errors: [] });
  }

  send(method, params) {
    return this.browser.send(method, params, this.sessionId);
  }

  notice({ method, params }) {
    if (method === 'Runtime.exceptionThrown') {
      const { exceptionDetails: e } = params;
      this.errors.push(e.exception?.description ?? e.text);
    } else if (method === 'Runtime.consoleAPICalled' && params.type === 'error')
      this.errors.push(params.args.map((a) => a.value ?? a.description).join(' '));
    else if (method === 'Log.entryAdded' && params.entry.level === 'error')
      this.errors.push(`${params.entry.text} ${params.entry.url ?? ''}`);
  }

  async go(url) {
    await this.send('Page.navigate', { url });
    await this.until('document.readyState === "complete"');
  }

  /** The value of an expression, awaited. */
  async value(expression) {
    const { result, exceptionDetails: e } = await this.send('Runtime.evaluate',
      { expression, awaitPromise: true, returnByValue: true });
    if (e) throw new Error(e.exception?.description ?? e.text);
    return result.value;
  }

  async until(expression, seconds = 60) {
    const end = Date.now() + 1000 * seconds;
    for (;;) {
      const value = await this.value(expression).catch(() => undefined);
      if (value) return value;
      if (Date.now() > end) throw new Error(`not within ${seconds} s: ${expression}`);
      await pause(100);
    }
  }

  async screenshot(file) {
    const { data } = await this.send('Page.captureScreenshot', { format: 'png' });
    fs.mkdirSync(path.dirname(file), { recursive: true });
    fs.writeFileSync(file, Buffer.from(data, 'base64'));
  }

  /** Drags the pointer from one place to another. */
  async drag([x0, y0], [x1, y1]) {
    const mouse = (type, x, y) => this.send('Input.dispatchMouseEvent',
      { type, x, y, button: 'left', buttons: 1, clickCount: 1 });
    await mouse('mousePressed', x0, y0);
    for (let k = 1; k <= 8; ++k) {
      await mouse('mouseMoved', x0 + (x1 - x0) * k / 8, y0 + (y1 - y0) * k / 8);
      await pause(20);
    }
    await mouse('mouseReleased', x1, y1);
  }

  async key(key, code = key) {
    await this.send('Input.dispatchKeyEvent', { type: 'keyDown', key, code, text: key.length === 1 ? key : undefined });
    await this.send('Input.dispatchKeyEvent', { type: 'keyUp', key, code });
  }
}
