// The page around the program: what shows until it runs, its files, its clipboard. Goes before the script that emscripten
// makes (--pre-js), so that everything is in place when main() is called.

Module.canvas = document.getElementById('canvas');
Module.replan = (() => {
  const cover = document.getElementById('cover');
  const words = document.getElementById('words');
  const home = '/home/web_user';
  const files = home + '/Files'; // of the user's: what is opened comes there, what is saved goes out from there
  let failed = false;

  function tell(sentence) {
    words.textContent = sentence;
    cover.hidden = false;
  }

  // The end of the program, for a reason that its user can do something about.
  function fail(sentence) {
    if (failed) return;
    failed = true;
    tell(sentence);
  }

  function reveal() {
    cover.hidden = true;
    Module.canvas.focus();
  }

  // Reading and writing what the browser keeps of the home folder takes its time: one after the other.
  let keeping = false;
  let again = false;
  let kept = false; // whether there is a place to keep anything in

  function keep() {
    if (!kept) return;
    if (keeping) {
      again = true;
      return;
    }
    keeping = true;
    FS.syncfs(false, () => {
      keeping = false;
      if (again) {
        again = false;
        keep();
      }
    });
  }

  // Before main(): the home folder as it was left. A browser that keeps nothing (a private window) begins afresh.
  function bring_back() {
    addRunDependency('home');
    FS.mkdirTree(home);
    FS.mount(IDBFS, {}, home);
    FS.syncfs(true, (error) => {
      kept = !error;
      FS.mkdirTree(files);
      FS.chdir(files);
      // A file is written beside its place and then moved there: from then on it is whole.
      FS.trackingDelegate.onMovePath = (from, to) => {
        if (!to.startsWith(home)) return;
        if (to.startsWith(files)) download(to);
        keep();
      };
      removeRunDependency('home');
    });
  }

  function leave() {
    if (failed || !Module.calledRun) return;
    Module._replan_leave();
    keep();
  }

  // Writes files of the user's into the page's file system and opens the first.
  async function take_files(chosen) {
    const paths = [];
    for (const file of chosen) {
      const path = files + '/' + file.name.replaceAll('/', '_');
      FS.writeFile(path, new Uint8Array(await file.arrayBuffer()));
      paths.push(path);
    }
    const text = stringToNewUTF8(paths.join('\n'));
    Module._replan_drop(text);
    Module._free(text);
  }

  // The browser's own way to choose a file; what is chosen comes as if it were dropped.
  function pick(extensions) {
    const input = document.createElement('input');
    input.type = 'file';
    input.multiple = true;
    input.accept = extensions;
    input.onchange = () => take_files([...input.files]);
    input.click();
  }

  // Hands a file of the page's file system to the browser, which puts it among its downloads.
  function download(path) {
    hand_over(path.slice(path.lastIndexOf('/') + 1), new Blob([FS.readFile(path)]));
  }

  function hand_over(name, blob) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  }

  // A film of what is put onto a hidden canvas.
  const film = (() => {
    let canvas, recorder, track, parts, file, step, last;

    function begin(name, width, height, fps) {
      if (!window.MediaRecorder || !HTMLCanvasElement.prototype.captureStream) return false;
      canvas = document.createElement('canvas');
      canvas.width = width;
      canvas.height = height;
      canvas.getContext('2d');
      const stream = canvas.captureStream(0);
      track = stream.getVideoTracks()[0];
      try {
        recorder = new MediaRecorder(stream, { mimeType: 'video/webm', videoBitsPerSecond: 8e6 });
      } catch (error) {
        return false;
      }
      parts = [];
      recorder.ondataavailable = (event) => parts.push(event.data);
      file = name;
      step = 1000 / fps;
      last = -Infinity;
      recorder.start(1000);
      return true;
    }

    // The recorder goes by the clock: a frame that comes early would make the film run fast.
    function ready() {
      return performance.now() - last > step - 2;
    }

    function add(rgba, width, height) {
      last = performance.now();
      const image = new ImageData(new Uint8ClampedArray(rgba), width, height);
      canvas.getContext('2d').putImageData(image, 0, 0);
      if (track.requestFrame) track.requestFrame();
    }

    function end(keep) {
      if (!recorder) return;
      const made = parts;
      const name = file;
      recorder.onstop = () => {
        if (keep) hand_over(name, new Blob(made, { type: 'video/webm' }));
      };
      recorder.stop();
      track.stop();
      recorder = undefined;
    }

    return { begin, ready, add, end };
  })();

  // A field that nobody sees brings up the keyboard of a screen; what is typed there goes to the program. It holds one
  // character, so that there is something to delete.
  const typing = document.getElementById('typing');
  const held = '.';
  let typed = held;

  function empty_typing() {
    typing.value = typed = held;
    typing.setSelectionRange(held.length, held.length);
  }

  // Keyboards that propose words change what they have typed: what differs is taken back and typed anew.
  function on_typing(event) {
    const before = [...typed];
    const now = [...typing.value];
    let same = 0;
    while (same < before.length && same < now.length && before[same] === now[same]) same++;
    for (let i = same; i < before.length; i++) Module._replan_type(8);
    for (const letter of now.slice(same)) Module._replan_type(letter.codePointAt(0));
    typed = typing.value;
    if (typed === '' || !event.isComposing) empty_typing();
  }

  function type(on) {
    if (!on) {
      typing.blur();
      Module.canvas.focus({ preventScroll: true });
      return;
    }
    empty_typing();
    typing.focus({ preventScroll: true });
  }

  typing.addEventListener('input', on_typing);
  typing.addEventListener('compositionend', empty_typing);

  let copied = '';
  const api = { tell, fail, reveal, keep, bring_back, leave, take_files, pick, film, type, pasted: '' };

  // A text goes to the clipboard within the browser's copy event, where there is one; else by the clipboard's own
  // interface, or by an event that is made for it where pages do not have that (plain http).
  let in_event = false;
  api.copy = (text) => {
    copied = text;
    if (in_event) return;
    if (navigator.clipboard) navigator.clipboard.writeText(text).catch(() => document.execCommand('copy'));
    else document.execCommand('copy');
  };

  function on_copy(event, letter) {
    if (event.isTrusted && letter && !document.activeElement.matches('input:not(#typing), textarea')) {
      in_event = true;
      copied = '';
      Module._replan_clipboard_key(letter.charCodeAt(0));
      in_event = false;
    }
    if (copied === '') return;
    event.clipboardData.setData('text/plain', copied);
    event.preventDefault();
  }

  document.addEventListener('copy', (event) => on_copy(event, 'C'));
  document.addEventListener('cut', (event) => on_copy(event, 'X'));
  document.addEventListener('paste', (event) => {
    if (event.clipboardData.files.length > 0) {
      take_files([...event.clipboardData.files]);
    } else {
      api.pasted = event.clipboardData.getData('text/plain');
      Module._replan_clipboard_key('V'.charCodeAt(0));
    }
    event.preventDefault();
  });

  document.addEventListener('contextmenu', (event) => event.preventDefault());
  document.addEventListener('dragover', (event) => event.preventDefault());
  document.addEventListener('drop', (event) => {
    event.preventDefault();
    take_files([...event.dataTransfer.files]);
  });
  document.addEventListener('visibilitychange', () => {
    if (document.visibilityState === 'hidden') leave();
  });
  window.addEventListener('pagehide', leave);
  // What a page begins to keep while it goes is not always kept.
  setInterval(leave, 20000);
  window.addEventListener('blur', leave);
  window.addEventListener('hashchange', () => {
    if (failed || location.hash.length < 2) return;
    const text = stringToNewUTF8(location.hash);
    Module._replan_open_link(text);
    Module._free(text);
  });
  return api;
})();

// After the files that come with the program have been put into place.
Module.preRun = [].concat(Module.preRun || [], Module.replan.bring_back);
Module.setStatus = () => {};
Module.onAbort = (what) =>
  Module.replan.fail(
    /memory|OOM/i.test(String(what))
      ? 'The world and its log have filled the memory that a page may have (2 GB). Reload the page and take a smaller world, or use the desktop program for this one.'
      : 'Replan has stopped: ' + what + '. Reload the page to go on.',
  );
