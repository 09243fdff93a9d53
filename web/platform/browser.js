// What the page does for the app: pointers, wheel, keys, size, a lost context, the frame loop, and
// window.marrow. Linked into marrow.js; holds no state of the app. Nothing is taken apart by pattern
// here: the optimizer of older Emscriptens loses such variables.
Module['postRun'] = [].concat(Module['postRun'] || [], function attach() {
  if (typeof document === 'undefined') return;
  const canvas = Module['canvas'];
  const kinds = {mouse: 0, touch: 1, pen: 2};
  const types = {down: 0, move: 1, up: 2, cancel: 3, leave: 4};
  const allocated = (size) => {
    const address = _malloc(size);
    if (!address) throw new RangeError('no memory left');
    return address;
  };
  const copied = (text) => {
    const size = lengthBytesUTF8(text) + 1, address = allocated(size);
    stringToUTF8(text, address, size);
    return address;
  };
  const placed = (bytes) => {
    const address = allocated(bytes.length + 1);
    HEAPU8.set(bytes, address);
    return address;
  };
  const raw = (name, text = '') => {
    const pointers = [copied(name), copied(text)];
    const answer = UTF8ToString(_marrow_call(pointers[0], pointers[1]));
    pointers.forEach(_free);
    return answer;
  };
  const call = (name, text) => JSON.parse(raw(name, text));
  const openFile = (head, bytes) => {
    const pointers = [copied(JSON.stringify(head)), placed(bytes)];
    const answer = UTF8ToString(_marrow_file(pointers[0], pointers[1], bytes.length));
    pointers.forEach(_free);
    return JSON.parse(answer);
  };

  // Frames: only when something happened or the app asked for one.
  let scheduled = false, timer = 0, contextLosses = 0, contextAlive = true;
  function frame() {
    scheduled = false;
    clearTimeout(timer);
    if (!contextAlive) return;
    const wait = _marrow_frame();
    if (wait === 0) wake();
    if (wait > 0) timer = setTimeout(wake, wait);
    syncTextField();
    runJobs();
  }
  function wake() {
    if (scheduled) return;
    scheduled = true;
    requestAnimationFrame(frame);
  }

  // What the app asks of files, storage and pictures, which have scripts of their own.
  const host = {
    call, raw, copied, placed, openFile, wake, frame, canvas, runJobs, perform: {},
    say(sentence) { call('say', sentence); wake(); },
  };
  marrowFiles(host);
  marrowExports(host);
  marrowPictures(host);
  marrowStorage(host);
  marrowWorker(host);
  function runJobs() {
    const asked = call('jobs');
    if (document.title !== asked.title) document.title = asked.title;
    for (const job of asked.jobs) host.perform[job.kind](job);
  }

  // Pointers. A pointer that is held belongs to the canvas until it goes up.
  const held = new Set();
  function send(type, event, button = 0) {
    const box = canvas.getBoundingClientRect();
    _marrow_pointer(types[type], kinds[event.pointerType] ?? 0, event.pointerId, button,
                    event.clientX - box.left, event.clientY - box.top, event.pressure,
                    event.timeStamp, (event.altKey ? 1 : 0) + (event.shiftKey ? 2 : 0));
  }
  function release(type, event) {
    if (!held.delete(event.pointerId)) return;
    send(type, event, event.button === 2 ? 2 : event.button === 1 ? 1 : 0);
    wake();
  }
  canvas.addEventListener('pointerdown', (event) => {
    event.preventDefault();
    if (document.activeElement !== textField) canvas.focus({preventScroll: true});
    try { canvas.setPointerCapture(event.pointerId); } catch { /* already gone */ }
    held.add(event.pointerId);
    send('down', event, event.button === 2 ? 2 : event.button === 1 ? 1 : 0);
    wake();
  });
  canvas.addEventListener('pointermove', (event) => {
    const samples = event.getCoalescedEvents ? event.getCoalescedEvents() : [];
    for (const sample of samples.length ? samples : [event]) send('move', sample);
    wake();
  });
  canvas.addEventListener('pointerup', (event) => release('up', event));
  canvas.addEventListener('pointercancel', (event) => release('cancel', event));
  canvas.addEventListener('lostpointercapture', (event) => release('cancel', event));
  canvas.addEventListener('pointerleave', (event) => {
    if (held.has(event.pointerId)) return;
    send('leave', event);
    wake();
  });

  // Nothing scrolls, zooms or opens a menu under a drawing hand.
  for (const type of ['touchstart', 'touchmove', 'touchend', 'gesturestart', 'gesturechange',
                      'contextmenu', 'dragstart', 'selectstart']) {
    canvas.addEventListener(type, (event) => event.preventDefault(), {passive: false});
  }
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    const box = canvas.getBoundingClientRect();
    const unit = event.deltaMode === 1 ? 33 : event.deltaMode === 2 ? 400 : 1;
    const dx = event.deltaX * unit, dy = event.deltaY * unit;
    // A trackpad pinches with Ctrl set; two fingers that drag on it also move sideways.
    const pans = !event.ctrlKey && dx !== 0;
    const zoom = pans ? 0 : -dy * (event.ctrlKey ? 0.01 : 0.0016);
    _marrow_wheel(event.clientX - box.left, event.clientY - box.top, zoom, pans ? -dx : 0,
                  pans ? -dy : 0);
    wake();
  }, {passive: false});

  // Keys. Letters by what they write, or by their place on keyboards of other scripts.
  const namedKeys = {
    escape: 'escape', delete: 'deleteForward', backspace: 'backspace', enter: 'enter',
    arrowleft: 'leftArrow', arrowright: 'rightArrow', home: 'home', end: 'end',
  };
  const characters = 'abcdfghlmnprstvwxyzABCDFGHLMNPRSTVWXYZ0123456789.-?[]';
  function keyName(event) {
    const latin = event.key.length > 1 || event.key.charCodeAt(0) < 128;
    const written = latin ? event.key : event.code.replace(/^Key/, '').toLowerCase();
    const key = written.toLowerCase();
    if (event.ctrlKey || event.metaKey) {
      if (key === 'z') return event.shiftKey ? 'redo' : 'undo';
      if (key === 's') return event.shiftKey ? 'saveAs' : 'save';
      if (key === 'o') return event.shiftKey ? undefined : 'open';
      return key === 'y' ? 'redo' : key === 'a' ? 'selectAll' : undefined;
    }
    if (event.altKey) return undefined;
    return namedKeys[key] ?? (written.length === 1 && characters.includes(written) ? written
                                                                                   : undefined);
  }
  window.addEventListener('keydown', (event) => {
    const target = event.target;
    if (target !== textField && target !== canvas && target !== document.body) return;
    const name = keyName(event);
    if (!name) return;
    if (target !== textField || !/^.$/u.test(event.key) || event.ctrlKey || event.metaKey) {
      event.preventDefault();
    }
    call('key', name);
    wake();
  });

  // Text goes through a real field that nobody sees, so that phones show their keyboard.
  const textField = document.createElement('input');
  textField.setAttribute('aria-hidden', 'true');
  textField.tabIndex = -1;
  textField.style.cssText = 'position:fixed;left:0;top:0;width:1px;height:1px;opacity:0;border:0;' +
      'padding:0;font-size:16px;pointer-events:none';
  canvas.parentNode.appendChild(textField);
  textField.addEventListener('input', () => {
    for (const character of textField.value) _marrow_text(character.codePointAt(0));
    textField.value = '';
    wake();
  });
  function syncTextField() {
    const wanted = call('wantsText'), has = document.activeElement === textField;
    if (wanted && !has) textField.focus({preventScroll: true});
    if (!wanted && has) canvas.focus({preventScroll: true});
  }

  // Size: exact device pixels where the browser tells them.
  function resize(entry) {
    const box = canvas.getBoundingClientRect();
    const exact = entry && entry.devicePixelContentBoxSize && entry.devicePixelContentBoxSize[0];
    let width = Math.round(box.width * devicePixelRatio);
    let height = Math.round(box.height * devicePixelRatio);
    // An emulated density is not in the exact size: that one only rounds better.
    if (exact && Math.abs(exact.inlineSize - width) < 2 && Math.abs(exact.blockSize - height) < 2) {
      width = exact.inlineSize;
      height = exact.blockSize;
    }
    if (!width || !height) return;
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    _marrow_resize(box.width, box.height, width / box.width);
    frame();
  }
  const observer = new ResizeObserver((entries) => resize(entries[0]));
  try {
    observer.observe(canvas, {box: 'device-pixel-content-box'});
  } catch {
    observer.observe(canvas);
  }
  resize();

  canvas.addEventListener('webglcontextlost', (event) => {
    event.preventDefault();
    ++contextLosses;
    contextAlive = false;
    _marrow_context(0);
  });
  canvas.addEventListener('webglcontextrestored', () => {
    contextAlive = true;
    _marrow_context(1);
    frame();
  });

  // Slices between which the page can do what it has to.
  const slices = new MessageChannel();
  slices.port1.onmessage = () => {
    if (!_marrow_warm(6)) setTimeout(() => slices.port2.postMessage(0), 0);
  };
  slices.port2.postMessage(0);

  function meshAt(address) {
    const table = address >> 2;
    if (!table) return null;
    const doubles = (at, count) => HEAPF64.slice(at >> 3, (at >> 3) + count);
    const vertices = HEAPU32[table + 3], triangles = HEAPU32[table + 2] >> 2;
    return {
      positions: doubles(HEAPU32[table], 3 * vertices),
      normals: doubles(HEAPU32[table + 1], 3 * vertices),
      triangles: HEAPU32.slice(triangles, triangles + 3 * HEAPU32[table + 4]),
    };
  }

  Object.assign(window.marrow, {
    document: () => call('document'),
    async load(json) {
      const answer = call('load', typeof json === 'string' ? json : JSON.stringify(json));
      wake();
      if (answer.error) throw new Error(answer.error);
    },
    parts: () => call('parts'),
    rig: () => call('rig'),
    mesh: (index) => meshAt(_marrow_mesh(index)),
    posed: () => meshAt(_marrow_posed()),
    undo() { const done = call('undo'); wake(); return done; },
    redo() { const done = call('redo'); wake(); return done; },
    stats: () => Object.assign(call('stats'), {idle: !scheduled, contextLosses}),
  });
  Module['onReady'] && Module['onReady']();
});
