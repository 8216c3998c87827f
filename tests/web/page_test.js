// The page in a headless Chromium: node tests/web/page_test.js FOLDER-OF-THE-SITE PAGE.html REPLAN [PICTURES]
// FOLDER is served over http, PAGE is opened as a file. REPLAN is the desktop program, which writes and draws the same.
// PICTURES: a folder for what the page looked like.
'use strict';
const assert = require('assert');
const { execFileSync } = require('child_process');
const fs = require('fs');
const http = require('http');
const os = require('os');
const path = require('path');
const { pathToFileURL } = require('url');
const { Browser, sleep } = require('./browser.js');

const [site, one_file, desktop, pictures] = process.argv.slice(2);
const kTypes = { '.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm' };

// Any static server does: this one knows nothing but files.
function serve(folder) {
  const server = http.createServer((request, answer) => {
    const name = path.basename(new URL(request.url, 'http://x').pathname) || 'index.html';
    const file = path.join(folder, name);
    if (!fs.existsSync(file)) return answer.writeHead(404).end();
    answer.writeHead(200, { 'Content-Type': kTypes[path.extname(file)] ?? 'application/octet-stream' });
    fs.createReadStream(file).pipe(answer);
  });
  return new Promise((done) => server.listen(0, '127.0.0.1', () => done(server)));
}

const world_file = (name) => path.join(__dirname, '../../maps', name);
const world = (name) => fs.readFileSync(world_file(name));

// What the desktop program writes by a command that is given the file to write, and a folder for what it reads.
function of_desktop(ending, command) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'replan-desktop-'));
  const file = path.join(folder, 'out' + ending);
  execFileSync(desktop, command(file, folder), { stdio: ['ignore', 'ignore', 'inherit'] });
  const bytes = fs.readFileSync(file);
  fs.rmSync(folder, { recursive: true });
  return bytes;
}

async function facts(page) {
  return JSON.parse(await page.value('UTF8ToString(Module._replan_facts())'));
}

// Waits until a fact of the session is as it should be.
async function until(page, holds, what) {
  for (const end = Date.now() + 60000; Date.now() < end; await sleep(100)) {
    const now = await facts(page);
    if (holds(now)) return now;
  }
  throw new Error('waited in vain until ' + what + ': ' + JSON.stringify(await facts(page)));
}

// The demo without its caption, which stands over the world in a window and not in a picture of one.
function uncaptioned() {
  const { caption, ...rest } = JSON.parse(world('demo.json').toString());
  return JSON.stringify(rest);
}

async function shown(page, url) {
  const begun = Date.now();
  await page.go(url);
  await page.until("document.getElementById('cover').hidden", 'the program shows');
  page.started = Date.now() - begun;
  await page.rest();
}

// A page without the tutorial that a first start begins with: it would take the keys.
async function quiet(page, url, demo = world('demo.json')) {
  await shown(page, url);
  await page.drop('demo.json', demo);
  return until(page, (now) => now.file.endsWith('/demo.json') && now.mission !== 'planning', 'the demo has a plan');
}

async function look(page, name) {
  if (pictures) await page.picture(path.join(pictures, name + '.png'));
}

const tests = {
  async 'opens from a server'(browser, address) {
    const page = await browser.page();
    await shown(page, address);
    console.log('    shows after ' + page.started + ' ms');
    await until(page, (now) => now.events > 0, 'there are events');
    await look(page, 'server');
    return page;
  },

  async 'opens from a file, as one file'(browser) {
    const page = await browser.page();
    await shown(page, pathToFileURL(one_file).href);
    console.log('    shows after ' + page.started + ' ms');
    await until(page, (now) => now.events > 0, 'there are events');
    await look(page, 'file');
    return page;
  },

  async 'a dropped scenario opens; keys step back and forth'(browser, address) {
    const page = await browser.page();
    const demo = await quiet(page, address);
    await page.key('Home', { code: 'Home' });
    assert.equal((await facts(page)).cursor, 0);
    await page.key('ArrowRight', { code: 'ArrowRight' });
    const stepped = (await facts(page)).cursor;
    assert(stepped > 0 && stepped < demo.events, 'a step of ' + stepped + ' events');
    await page.key('End', { code: 'End' });
    await until(page, (now) => now.cursor === now.events && now.mission === 'arrived', 'the run is at its end');
    await look(page, 'demo');
    return page;
  },

  async 'a stroke paints, and is taken back by Ctrl+Z'(browser, address) {
    const page = await browser.page();
    const demo = await quiet(page, address);
    await page.key('b', { code: 'KeyB' });
    await page.drag([400, 150], [460, 150]);
    const painted = await until(page, (now) => now.obstacles > demo.obstacles, 'there are more obstacles');
    assert(painted.undo.length > 0 && painted.modified);
    await look(page, 'stroke');
    await page.shortcut('Ctrl', 'z');
    await until(page, (now) => now.obstacles === demo.obstacles, 'the stroke is gone');
    return page;
  },

  async 'a surprise is repaired'(browser, address) {
    const page = await browser.page();
    await shown(page, address);
    await page.drop('closing-door.json', world('closing-door.json'));
    await until(page, (now) => now.file.endsWith('/closing-door.json') && now.mission !== 'planning', 'a plan stands');
    await page.key(' ', { code: 'Space' });
    const over = await until(page, (now) => now.mission === 'arrived', 'the robot has arrived');
    assert(over.moves > 0);
    await look(page, 'arrived');
    return page;
  },

  async 'saving hands over the bytes that the desktop writes'(browser, address) {
    const page = await browser.page();
    await quiet(page, address);
    await page.shortcut('Ctrl', 's');
    const saved = (await page.downloaded('demo.json')).toString();
    assert.equal(saved, of_desktop('.json', (file) => ['convert', page.downloaded_to('demo.json'), file]).toString());
    // A window writes the overlays that it shows, in an order of its own.
    const in_order = (text) => {
      const { view, ...rest } = JSON.parse(text);
      return { ...rest, view: { ...view, overlays: view.overlays.sort() } };
    };
    assert.deepEqual(in_order(saved), in_order(world('demo.json').toString()));
    return page;
  },

  async 'what is new is saved too, and settings are there after a reload'(browser, address) {
    const page = await browser.page();
    await quiet(page, address);
    assert.equal((await facts(page)).dark, true);
    await page.key('t', { code: 'KeyT' });
    await until(page, (now) => !now.dark, 'the theme is light');
    await page.shortcut('Ctrl+Shift', 'P');
    await page.rest(20);
    await page.key('Enter', { code: 'Enter' });
    const [, picture] = await page.any_download('.png');
    assert.equal(picture.toString('latin1', 1, 4), 'PNG');
    await page.value("window.dispatchEvent(new Event('blur'))");
    await sleep(1000);
    await page.send('Page.reload');
    await sleep(1000);
    await page.until("document.getElementById('cover').hidden", 'the program shows again');
    await page.rest(20);
    await look(page, 'again');
    assert.equal((await facts(page)).dark, false);
    return page;
  },

  async 'a link restores the moment'(browser, address) {
    const page = await browser.page();
    await quiet(page, address);
    await page.key('Home', { code: 'Home' });
    for (let i = 0; i < 7; i++) await page.key('ArrowRight', { code: 'ArrowRight' });
    const left = await facts(page);
    const link = await page.value('UTF8ToString(Module._replan_link())');
    assert(link.startsWith(address), link.slice(0, 60));
    const other = await browser.page();
    await shown(other, link);
    await until(other, (now) => now.cursor === left.cursor && now.state === left.state, 'the moment is there');
    await look(other, 'link');
    await browser.shut(other);
    return page;
  },

  async 'the link goes to the clipboard'(browser, address) {
    const page = await browser.page();
    await browser.allow_clipboard(page);
    await quiet(page, address);
    await page.shortcut('Ctrl+Shift', 'L');
    await page.rest(30);
    await look(page, 'link_dialog');
    await page.key('Enter', { code: 'Enter' });
    const copied = await page.value('navigator.clipboard.readText()');
    assert.equal(copied, await page.value('UTF8ToString(Module._replan_link())'));
    return page;
  },

  async 'a film is made by the recorder of the browser'(browser, address) {
    const page = await browser.page();
    await quiet(page, address);
    await page.key('Home', { code: 'Home' });
    await page.shortcut('Ctrl+Shift', 'R');
    await page.rest(20);
    await look(page, 'film_dialog');
    await page.key('Enter', { code: 'Enter' });
    await page.rest(10);
    await page.key(' ', { code: 'Space' });
    await sleep(2000);
    await look(page, 'filming');
    await page.shortcut('Ctrl+Shift', 'R');
    const [name, film] = await page.any_download('.webm');
    console.log('    ' + name + ' of ' + film.length + ' bytes');
    assert.equal(film.readUInt32BE(0), 0x1a45dfa3, 'it begins as Matroska does');
    const seconds = await page.film_seconds(film);
    assert(seconds > 1, 'it lasts ' + seconds + ' s');
    return page;
  },

  async 'shows what the desktop program shows'(browser, address) {
    const page = await browser.page();
    await quiet(page, address, uncaptioned());
    await page.key('End', { code: 'End' });
    await until(page, (now) => now.cursor === now.events && now.mission === 'arrived', 'the run is at its end');
    await page.send('Input.dispatchMouseEvent', { type: 'mouseMoved', x: 640, y: 1 });
    await page.rest(60);
    const shown = await page.screenshot();
    const wanted = of_desktop('.png', (file, folder) => {
      const demo = path.join(folder, 'demo.json');
      fs.writeFileSync(demo, uncaptioned());
      return ['render', demo, '-o', file, '--at-end', '--size', '1280x800'];
    });
    if (pictures) fs.writeFileSync(path.join(pictures, 'of_desktop.png'), wanted);
    if (pictures) fs.writeFileSync(path.join(pictures, 'of_page.png'), shown);
    // The world: around it there are times, and the name of the file.
    const share = await page.difference(shown, wanted, { x: 50, y: 40, width: 850, height: 540 });
    console.log('    ' + (100 * share).toFixed(2) + ' % of the pixels differ by more than 24 of 255');
    assert(share < 0.01);
    return page;
  },

  async 'is sharp at 2x'(browser, address) {
    const page = await browser.page({ width: 1280, height: 800, ratio: 2 });
    await quiet(page, address);
    assert.deepEqual(await page.value('[Module.canvas.width, Module.canvas.height]'), [2560, 1600]);
    await look(page, 'twice');
    return page;
  },

  async 'plays, draws and explains a cell on a phone'(browser, address) {
    const page = await browser.page({ width: 390, height: 844, ratio: 2, mobile: true });
    const demo = await quiet(page, address);
    await page.tap(195, 200);
    await page.rest(20);
    await look(page, 'phone');
    await page.tap(160, 393); // plays
    await until(page, (now) => now.moves > 0 || now.cursor !== demo.cursor, 'it plays');
    await look(page, 'phone_plays');
    return page;
  },
};

(async () => {
  const server = await serve(site);
  const address = 'http://127.0.0.1:' + server.address().port + '/index.html';
  const browser = await Browser.open();
  let failed = 0;
  for (const [name, test] of Object.entries(tests)) {
    try {
      const page = await test(browser, address);
      assert.deepEqual(page.complaints, [], 'the console has errors');
      await browser.shut(page);
      console.log('ok      ' + name);
    } catch (error) {
      failed++;
      console.log('FAILED  ' + name + '\n' + error.stack);
    }
  }
  await browser.close();
  server.close();
  console.log(failed === 0 ? 'All ' + Object.keys(tests).length + ' tests of the page passed.' : failed + ' failed.');
  process.exit(failed === 0 ? 0 : 1);
})();
