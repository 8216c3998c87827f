// A headless Chromium, driven by its own protocol through a pipe: no package of npm is needed.
'use strict';
const { spawn } = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');

const kTimeoutMs = 120000; // a page of this size starts slowly on a loaded machine

function sleep(ms) {
  return new Promise((done) => setTimeout(done, ms));
}

// One message is JSON and a zero byte, both ways.
class Pipe {
  constructor(input, output) {
    this.output = output;
    this.next = 1;
    this.waiting = new Map();
    this.listeners = [];
    let parts = [];
    input.on('data', (data) => {
      for (let end; (end = data.indexOf(0)) >= 0; data = data.subarray(end + 1)) {
        parts.push(data.subarray(0, end));
        this.take(JSON.parse(Buffer.concat(parts).toString()));
        parts = [];
      }
      parts.push(data);
    });
  }

  take(message) {
    if (message.id === undefined) {
      for (const listener of this.listeners) listener(message);
      return;
    }
    const { done, failed } = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (message.error) failed(new Error(message.error.message));
    else done(message.result);
  }

  send(method, params = {}, sessionId = undefined) {
    const id = this.next++;
    this.output.write(JSON.stringify({ id, method, params, sessionId }) + '\0');
    return new Promise((done, failed) => this.waiting.set(id, { done, failed }));
  }
}

// A page of the browser. `complaints` holds what it wrote to its console as an error, and what it threw.
class Page {
  constructor(pipe, session, downloads) {
    this.pipe = pipe;
    this.session = session;
    this.downloads = downloads;
    this.complaints = [];
    this.chooser = undefined;
    pipe.listeners.push((message) => this.listen(message));
  }

  listen({ method, params, sessionId }) {
    if (sessionId !== this.session) return;
    if (method === 'Runtime.exceptionThrown')
      this.complaints.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === 'Runtime.consoleAPICalled' && params.type === 'error')
      this.complaints.push(params.args.map((each) => each.value ?? each.description).join(' '));
    if (method === 'Log.entryAdded' && params.entry.level === 'error') this.complaints.push(params.entry.text);
    if (method === 'Page.fileChooserOpened') this.chooser = params.backendNodeId;
  }

  send(method, params) {
    return this.pipe.send(method, params, this.session);
  }

  async go(url) {
    await this.send('Page.navigate', { url });
  }

  // The value of an expression; promises are waited for.
  async value(expression) {
    const answer = await this.send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
    if (answer.exceptionDetails)
      throw new Error(answer.exceptionDetails.exception?.description ?? answer.exceptionDetails.text);
    return answer.result.value;
  }

  // Waits until an expression is true; says what was waited for if it never is.
  async until(expression, what = expression) {
    for (const end = Date.now() + kTimeoutMs; Date.now() < end; await sleep(50))
      if (await this.value(expression).catch(() => false)) return;
    throw new Error('waited in vain until ' + what + '; complaints: ' + JSON.stringify(this.complaints));
  }

  async size(width, height, ratio = 1, mobile = false) {
    await this.send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: ratio, mobile });
    await this.send('Emulation.setTouchEmulationEnabled', { enabled: mobile, maxTouchPoints: 5 });
  }

  // A PNG.
  async screenshot() {
    const { data } = await this.send('Page.captureScreenshot', { format: 'png' });
    return Buffer.from(data, 'base64');
  }

  async picture(file) {
    fs.writeFileSync(file, await this.screenshot());
  }

  // What share of the pixels of an area differs between two PNGs by more than a little; the browser reads them.
  async difference(one, other, { x, y, width, height }) {
    return this.value(`(async () => {
      const pixels = async (text) => {
        const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
        const canvas = new OffscreenCanvas(${width}, ${height});
        canvas.getContext('2d').drawImage(await createImageBitmap(new Blob([bytes], { type: 'image/png' })), -${x}, -${y});
        return canvas.getContext('2d').getImageData(0, 0, ${width}, ${height}).data;
      };
      const [a, b] = await Promise.all(${JSON.stringify([one, other].map((each) => each.toString('base64')))}.map(pixels));
      let differ = 0;
      for (let i = 0; i < a.length; i += 4)
        if ([0, 1, 2].some((k) => Math.abs(a[i + k] - b[i + k]) > 24)) differ++;
      return differ / (a.length / 4);
    })()`);
  }

  // How long a film is that the browser plays.
  async film_seconds(bytes) {
    return this.value(`new Promise((done, failed) => {
      const bytes = Uint8Array.from(atob('${bytes.toString('base64')}'), (c) => c.charCodeAt(0));
      const film = document.createElement('video');
      film.onerror = () => failed(new Error('it cannot be played'));
      // A recorder writes no length: a place far behind the end leads to the end.
      film.onloadedmetadata = () => (film.currentTime = 1e6);
      film.onseeked = () => done(film.currentTime);
      film.src = URL.createObjectURL(new Blob([bytes], { type: 'video/webm' }));
    })`);
  }

  async mouse(type, x, y, button = 'none', buttons = 0) {
    await this.send('Input.dispatchMouseEvent', { type, x, y, button, buttons, clickCount: button === 'none' ? 0 : 1 });
  }

  async click(x, y, button = 'left') {
    await this.mouse('mouseMoved', x, y);
    await this.mouse('mousePressed', x, y, button, 1);
    await this.mouse('mouseReleased', x, y, button);
    await this.rest();
  }

  async drag(from, to, steps = 8) {
    await this.mouse('mouseMoved', ...from);
    await this.mouse('mousePressed', ...from, 'left', 1);
    for (let i = 1; i <= steps; ++i) {
      const at = from.map((start, axis) => start + ((to[axis] - start) * i) / steps);
      await this.mouse('mouseMoved', ...at, 'left', 1);
    }
    await this.mouse('mouseReleased', ...to, 'left');
    await this.rest();
  }

  async wheel(x, y, deltaY) {
    await this.send('Input.dispatchMouseEvent', { type: 'mouseWheel', x, y, deltaX: 0, deltaY });
    await this.rest();
  }

  // Fingers as [[x, y], ...]; none: all are lifted.
  async touch(type, fingers) {
    const touchPoints = fingers.map(([x, y], id) => ({ x, y, id }));
    await this.send('Input.dispatchTouchEvent', { type, touchPoints });
  }

  async tap(x, y) {
    await this.touch('touchStart', [[x, y]]);
    await this.touch('touchEnd', []);
    await this.rest();
  }

  // A key by its name in browsers, such as 'a', 'ArrowRight'; modifiers: 1 Alt, 2 Ctrl, 8 Shift.
  async key(key, { code = '', modifiers = 0, text = undefined } = {}) {
    const typed = text ?? (key.length === 1 && modifiers < 2 ? key : undefined);
    await this.send('Input.dispatchKeyEvent', { type: 'keyDown', key, code, modifiers, text: typed });
    await this.send('Input.dispatchKeyEvent', { type: 'keyUp', key, code, modifiers });
    await this.rest();
  }

  // A letter with keys held, such as 'Ctrl+Shift'.
  async shortcut(held, letter) {
    const keys = { Alt: ['Alt', 'AltLeft', 1], Ctrl: ['Control', 'ControlLeft', 2], Shift: ['Shift', 'ShiftLeft', 8] };
    const all = held.split('+').map((name) => keys[name]);
    let modifiers = 0;
    for (const [key, code, bit] of all) {
      modifiers |= bit;
      await this.send('Input.dispatchKeyEvent', { type: 'keyDown', key, code, modifiers });
    }
    await this.key(letter, { code: 'Key' + letter.toUpperCase(), modifiers });
    for (const [key, code, bit] of all.reverse()) {
      modifiers &= ~bit;
      await this.send('Input.dispatchKeyEvent', { type: 'keyUp', key, code, modifiers });
    }
    await this.rest();
  }

  // Until a few frames are drawn: what was done has had its effect.
  async rest(frames = 4) {
    await this.value(
      `new Promise((done) => { let left = ${frames};
         const go = () => (--left < 0 ? done() : requestAnimationFrame(go)); go(); })`,
    );
  }

  // Drops a file of that name and text onto the page.
  async drop(name, bytes) {
    const data = Buffer.from(bytes).toString('base64');
    await this.value(`(() => {
      const bytes = Uint8Array.from(atob('${data}'), (c) => c.charCodeAt(0));
      const transfer = new DataTransfer();
      transfer.items.add(new File([bytes], ${JSON.stringify(name)}));
      document.dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true, cancelable: true }));
    })()`);
    await this.rest();
  }

  downloaded_to(name) {
    return path.join(this.downloads, name);
  }

  // The text of a file that the page hands over.
  async downloaded(name) {
    const file = this.downloaded_to(name);
    for (const end = Date.now() + kTimeoutMs; Date.now() < end; await sleep(50))
      if (fs.existsSync(file)) return fs.readFileSync(file);
    throw new Error('no download of ' + name + '; there are ' + fs.readdirSync(this.downloads).join(', '));
  }

  // The name and the text of the first file with that ending.
  async any_download(ending) {
    for (const end = Date.now() + kTimeoutMs; Date.now() < end; await sleep(50)) {
      const name = fs.readdirSync(this.downloads).find((each) => each.endsWith(ending));
      if (name) return [name, fs.readFileSync(path.join(this.downloads, name))];
    }
    throw new Error('no download of *' + ending + '; there are ' + fs.readdirSync(this.downloads).join(', '));
  }
}

class Browser {
  static async open(executable = process.env.CHROMIUM ?? 'chromium') {
    const browser = new Browser();
    browser.folder = fs.mkdtempSync(path.join(os.tmpdir(), 'replan-browser-'));
    browser.process = spawn(
      executable,
      [
        '--headless=new', '--no-sandbox', '--remote-debugging-pipe', '--user-data-dir=' + browser.folder + '/profile',
        '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--force-color-profile=srgb', '--hide-scrollbars',
        '--no-first-run', '--disable-background-networking', '--disable-component-update', '--mute-audio',
        '--disable-dev-shm-usage', 'about:blank',
      ],
      { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] },
    );
    browser.pipe = new Pipe(browser.process.stdio[4], browser.process.stdio[3]);
    return browser;
  }

  // A page of its own: nothing is kept from one to the next unless `context` is that of an earlier one.
  async page({ width = 1280, height = 800, ratio = 1, mobile = false, context = undefined } = {}) {
    const browserContextId =
      context ?? (await this.pipe.send('Target.createBrowserContext', {})).browserContextId;
    const downloads = fs.mkdtempSync(path.join(this.folder, 'downloads-'));
    await this.pipe.send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: downloads, browserContextId });
    const { targetId } = await this.pipe.send('Target.createTarget', { url: 'about:blank', browserContextId });
    const { sessionId } = await this.pipe.send('Target.attachToTarget', { targetId, flatten: true });
    const page = new Page(this.pipe, sessionId, downloads);
    page.context = browserContextId;
    page.target = targetId;
    for (const domain of ['Page', 'Runtime', 'Log', 'DOM']) await page.send(domain + '.enable');
    await page.size(width, height, ratio, mobile);
    return page;
  }

  // What a user answers a browser's question with.
  async allow_clipboard(page) {
    const permissions = ['clipboardReadWrite', 'clipboardSanitizedWrite'];
    await this.pipe.send('Browser.grantPermissions', { permissions, browserContextId: page.context });
  }

  async shut(page) {
    await this.pipe.send('Target.closeTarget', { targetId: page.target });
  }

  async close() {
    await this.pipe.send('Browser.close').catch(() => {});
    await new Promise((done) => this.process.once('exit', done));
    fs.rmSync(this.folder, { recursive: true, force: true });
  }
}

module.exports = { Browser, sleep };
