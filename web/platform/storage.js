// Drawings that are kept by themselves, in the browser's own storage: one slot a drawing, at most
// ten. A page holds the slots of its drawings, and no other page offers or touches them until it is
// gone, however it went. Linked into marrow.js before browser.js, which gives the host.
function marrowStorage(host) {
  const most = 10;
  const prefix = 'marrow-slot-';
  const cannotKeep = 'This browser keeps nothing here, so save your drawing before you leave.';
  const full = 'There is no room left to keep your drawing, so please save it.';
  let said = '';
  const sayOnce = (sentence) => {
    if (said === sentence) return;
    said = sentence;
    host.say(sentence);
  };

  // Who holds a slot: the browser's own locks, which end with the page. Where there are none (a page
  // that came without encryption), a sign of life in localStorage.
  const locks = navigator.locks, beat_ms = 5000, dead_ms = 70000;
  const own = new Map();  // slots of this page → what lets go of them
  const local = (() => {
    try {
      localStorage.setItem('marrow-test', '1');
      localStorage.removeItem('marrow-test');
      return localStorage;
    } catch {
      return null;
    }
  })();
  const alive = (slot) => {
    const seen = local ? Number(local.getItem('marrow-alive-' + slot)) : 0;
    return seen > 0 && Date.now() - seen < dead_ms;
  };
  const beat = () => own.forEach((release, slot) => {
    try {
      if (local) local.setItem('marrow-alive-' + slot, String(Date.now()));
    } catch { /* full: the others will think that this page is gone */ }
  });
  /// Whether the slot belongs to this page from now on.
  function hold(slot) {
    if (own.has(slot)) return Promise.resolve(true);
    if (!locks) {
      if (alive(slot)) return Promise.resolve(false);
      own.set(slot, () => local && local.removeItem('marrow-alive-' + slot));
      beat();
      return Promise.resolve(true);
    }
    return new Promise((resolve) => {
      locks.request(prefix + slot, {ifAvailable: true}, (lock) => {
        if (!lock) return resolve(false);
        return new Promise((release) => {
          own.set(slot, release);
          resolve(true);
        });
      }).catch(() => resolve(false));
    });
  }
  /// The slots that some page holds.
  async function held() {
    if (!locks) return {has: (slot) => own.has(slot) || alive(slot)};
    const names = new Set((await locks.query()).held.map((lock) => lock.name));
    return {has: (slot) => names.has(prefix + slot)};
  }
  if (!locks) setInterval(beat, beat_ms);

  // Two stores, so that the list of drawings can be read without the drawings: `slots` and `texts`.
  const wait = (request) => new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
  function openDatabase() {
    return new Promise((resolve, reject) => {
      const request = indexedDB.open('marrow', 1);
      request.onupgradeneeded = () => {
        request.result.createObjectStore('slots', {keyPath: 'slot'});
        request.result.createObjectStore('texts');
      };
      request.onsuccess = () => {
        request.result.onversionchange = () => request.result.close();
        resolve(request.result);
      };
      request.onerror = () => reject(request.error);
    });
  }
  /// The same with what localStorage offers: a few megabytes.
  function smallDatabase() {
    const read = (name) => JSON.parse(local.getItem(name) || 'null');
    return {
      list: async () => read('marrow-slots') || [],
      text: async (slot) => local.getItem('marrow-text-' + slot),
      async put(entry, text) {
        if (text !== undefined) local.setItem('marrow-text-' + entry.slot, text);
        const others = (read('marrow-slots') || []).filter((one) => one.slot !== entry.slot);
        local.setItem('marrow-slots', JSON.stringify(others.concat([entry])));
      },
      async remove(slot) {
        local.removeItem('marrow-text-' + slot);
        const others = (read('marrow-slots') || []).filter((one) => one.slot !== slot);
        local.setItem('marrow-slots', JSON.stringify(others));
      },
    };
  }
  function largeDatabase(database) {
    /// Runs in one transaction, and is done when that is.
    const within = (mode, run) => new Promise((resolve, reject) => {
      const transaction = database.transaction(['slots', 'texts'], mode);
      let result;
      transaction.oncomplete = () => resolve(result);
      transaction.onabort = transaction.onerror = () => reject(transaction.error);
      Promise.resolve(run(transaction)).then((value) => { result = value; }, reject);
    });
    return {
      list: () => within('readonly', (all) => wait(all.objectStore('slots').getAll())),
      text: (slot) => within('readonly', (all) => wait(all.objectStore('texts').get(slot))),
      put: (entry, text) => within('readwrite', (all) => {
        all.objectStore('slots').put(entry);
        if (text !== undefined) all.objectStore('texts').put(text, entry.slot);
      }),
      remove: (slot) => within('readwrite', (all) => {
        all.objectStore('slots').delete(slot);
        all.objectStore('texts').delete(slot);
      }),
    };
  }
  const storage = Promise.resolve()
      .then(openDatabase).then(largeDatabase)
      .catch(() => (local ? smallDatabase() : null));

  const slotOf = new Map();  // drawing → its slot, and the slot's entry
  let order = Promise.resolve();  // one write after another
  const inOrder = (run) => {
    order = order.then(run, run);
    return order;
  };

  // What a page that goes away leaves behind where there is no time for the database.
  const lastWords = 'marrow-last-';
  function leaveBehind(entry, text) {
    try {
      if (local) local.setItem(lastWords + entry.slot, JSON.stringify({entry, text}));
    } catch { /* too large: the database may still make it */ }
  }
  async function gatherLastWords(database) {
    if (!local) return;
    const taken = await held();
    for (const name of Object.keys(local).filter((one) => one.startsWith(lastWords))) {
      const slot = name.slice(lastWords.length);
      if (taken.has(slot) && !own.has(slot)) continue;
      let left = null;
      try { left = JSON.parse(local.getItem(name)); } catch { /* not ours */ }
      const there = (await database.list()).find((one) => one.slot === slot);
      if (left && left.entry && typeof left.text === 'string' &&
          !(there && there.changed >= left.entry.changed)) {
        await database.put(left.entry, left.text);
      }
      local.removeItem(name);
    }
  }

  function newSlot() {
    const words = crypto.getRandomValues(new Uint32Array(3));
    return [].map.call(words, (word) => word.toString(36)).join('');
  }
  /// The slot of a drawing; a new one where it has none yet.
  async function slotFor(drawing) {
    if (!slotOf.has(drawing)) slotOf.set(drawing, newSlot());
    const slot = slotOf.get(drawing);
    await hold(slot);
    return slot;
  }
  function entryOf(job, slot) {
    const entry = {slot, name: job.name, parts: job.parts, saved: job.saved, changed: Date.now()};
    const handle = host.handles.get(job.drawing);
    if (handle) entry.handle = handle;
    return entry;
  }
  /// Forgets the oldest drawings, but none that somebody has open.
  async function makeRoom(database, left) {
    const taken = await held();
    const entries = (await database.list()).sort((a, b) => b.changed - a.changed);
    for (const entry of entries.slice(left)) {
      if (!taken.has(entry.slot)) await database.remove(entry.slot);
    }
  }

  const unwritten = new Map();  // drawing → what is on its way into the database
  host.perform.keep = (job) => {
    const text = host.raw('jobText', String(job.id));
    const write = {job, text};
    unwritten.set(job.drawing, write);
    return inOrder(async () => {
      const database = await storage;
      if (!database) {
        unwritten.delete(job.drawing);
        host.call('notKept', String(job.drawing));
        return sayOnce(cannotKeep);
      }
      const entry = entryOf(job, await slotFor(job.drawing));
      try {
        await database.put(entry, text).catch(async (error) => {
          // Some storages cannot hold a file's handle, and a full one may hold old drawings.
          if (error && error.name === 'QuotaExceededError') await makeRoom(database, 1);
          delete entry.handle;
          await database.put(entry, text);
        });
        if (unwritten.get(job.drawing) === write) {
          unwritten.delete(job.drawing);
          if (local) local.removeItem(lastWords + entry.slot);
        }
        said = '';
        await makeRoom(database, most);
      } catch {
        host.call('notKept', String(job.drawing));
        sayOnce(full);
      }
    });
  };

  /// Tells which drawings there are beside the one that is open here. offering: the newest one is
  /// to be offered.
  async function list(drawing, offering) {
    const database = await storage;
    if (!database) {
      host.call('noStorage');
      return;
    }
    const taken = await held();
    const entries = (await database.list())
        .filter((one) => own.has(one.slot) ? one.slot !== slotOf.get(drawing) : !taken.has(one.slot))
        .sort((a, b) => b.changed - a.changed).slice(0, most);
    host.call('recent', JSON.stringify(entries.map((one, i) => ({
      slot: one.slot, name: one.name || '', parts: one.parts || 0, changed: one.changed,
      age: Math.max(0, (Date.now() - one.changed) / 1000),
      offered: offering && i === 0 && !one.dismissed,
    }))));
    host.wake();
  }
  host.perform.list = (job) => inOrder(() => list(job.drawing, false));
  host.perform.peek = (job) => inOrder(async () => {
    const database = await storage, text = database && await database.text(job.slot);
    if (text) host.call('peeked', job.slot + '\n' + text);
    host.wake();
  });
  host.perform.dismiss = (job) => inOrder(async () => {
    const database = await storage;
    const entry = database && (await database.list()).find((one) => one.slot === job.slot);
    if (!entry) return;
    entry.dismissed = true;
    await database.put(entry);
  });
  host.perform.restore = (job) => inOrder(async () => {
    const database = await storage;
    const entry = database && (await database.list()).find((one) => one.slot === job.slot);
    const text = entry && await database.text(job.slot);
    if (!text) return host.say('This drawing is no longer there.');
    // Another page may have been faster: then this is a copy.
    const mine = await hold(job.slot);
    const origin = {name: entry.name, place: entry.handle ? entry.handle.name : '',
                    saved: Boolean(entry.saved), kept: mine};
    const answer = host.call('open', JSON.stringify(origin) + '\n' + text);
    if (answer.drawing !== undefined) {
      if (mine) slotOf.set(answer.drawing, job.slot);
      if (entry.handle) host.handles.set(answer.drawing, entry.handle);
    }
    await list(answer.drawing, false);
  });

  // A page that is hidden may never be seen again.
  function leave() {
    host.frame();
    host.call('keepNow');
    host.runJobs();
    unwritten.forEach((write, drawing) => {
      if (!slotOf.has(drawing)) slotOf.set(drawing, newSlot());
      const entry = entryOf(write.job, slotOf.get(drawing));
      delete entry.handle;  // is no text
      leaveBehind(entry, write.text);
    });
  }
  document.addEventListener('visibilitychange', () => {
    if (document.visibilityState === 'hidden') leave();
  });
  window.addEventListener('pagehide', () => {
    leave();
    if (!locks) own.forEach((release) => release());
  });
  window.addEventListener('pageshow', (event) => { if (event.persisted && !locks) beat(); });

  inOrder(async () => {
    const database = await storage;
    if (database) await gatherLastWords(database);
    await list(0, true);
  }).catch(() => {});
}
