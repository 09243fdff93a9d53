// Drawings in files: chosen, dropped, saved. Where the browser can write to the user's own files, it
// does; else a drawing is downloaded. Linked into marrow.js before browser.js, which gives the host.
function marrowFiles(host) {
  const kinds = [{description: 'Marrow drawing', accept: {'application/json': ['.json']}}];
  const meshes = ['.glb', '.obj', '.ply', '.stl'];
  const readable = [{description: 'Drawings and 3D models',
                     accept: {'application/json': ['.json'], 'model/gltf-binary': meshes}}];
  const largest = 64 << 20;
  const handles = host.handles = new Map();  // by the drawing's number
  const stem = (name) => name.replace(/(.)\.[^.]*$/, '$1');
  const cancelled = (error) => error && error.name === 'AbortError';

  /// The chosen file, by a field that nobody sees; null when the user thinks better of it.
  host.chooseFile = (accept) => new Promise((resolve) => {
    const field = document.createElement('input');
    field.type = 'file';
    field.accept = accept;
    field.style.display = 'none';
    const done = () => {
      field.remove();
      resolve(field.files && field.files[0] || null);
    };
    field.addEventListener('change', done);
    field.addEventListener('cancel', done);
    document.body.appendChild(field);
    field.click();
  });

  /// Opens a file; `handle` is what later saves write to.
  async function open(file, handle) {
    if (file.size > largest) return host.say(`${file.name} cannot be opened: it is larger than 64 MB.`);
    const origin = {name: stem(file.name), place: file.name, file: file.name};
    let answer;
    try {
      answer = host.openFile(origin, new Uint8Array(await file.arrayBuffer()));
    } catch {
      return host.say(`${file.name} cannot be read.`);
    }
    if (answer.hasFile && handle) handles.set(answer.drawing, handle);
    host.wake();
  }

  host.perform.open = async () => {
    if (window.showOpenFilePicker) {
      try {
        const handle = (await window.showOpenFilePicker({types: readable}))[0];
        return open(await handle.getFile(), handle);
      } catch (error) {
        if (cancelled(error)) return;  // else another way may be allowed
      }
    }
    const file = await host.chooseFile(['.json', 'application/json', ...meshes].join());
    if (file) await open(file);
  };

  host.download = (name, type, content) => {
    const address = URL.createObjectURL(new Blob([content], {type}));
    const link = document.createElement('a');
    link.href = address;
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(address), 60000);
  };
  function download(job, text) {
    const name = job.name + '.json';
    host.download(name, 'application/json', text);
    host.call('saved', JSON.stringify({job: job.id, name: job.name, place: ''}));
    host.say(`Saved as ${name} among your downloads.`);
  }

  async function save(job) {
    const text = host.raw('jobText', String(job.id));
    let handle = job.kind === 'save' ? handles.get(job.drawing) : undefined;
    if (!handle) {
      if (!window.showSaveFilePicker) return download(job, text);
      try {
        handle = await window.showSaveFilePicker({suggestedName: job.name + '.json', types: kinds});
      } catch (error) {
        return cancelled(error) ? undefined : download(job, text);
      }
    }
    try {
      const stream = await handle.createWritable();
      await stream.write(text);
      await stream.close();
    } catch (error) {
      const why = error && error.name === 'NotAllowedError' ? 'the browser does not allow it'
                                                            : 'it may be gone, or the disk full';
      return host.say(`${handle.name} was not saved: ${why}. Try “Save as…”.`);
    }
    handles.set(job.drawing, handle);
    host.call('saved', JSON.stringify({job: job.id, name: stem(handle.name), place: handle.name}));
    host.say(`Saved ${handle.name}.`);
  }
  host.perform.save = save;
  host.perform.saveAs = save;

  // Dropped files: pictures to draw after, anything else is taken for a drawing or a 3D model.
  const isPicture = (file) => /^image\//.test(file.type);
  let depth = 0;  // of elements that the dragged file is over
  const mark = () => host.canvas.classList.toggle('dropping', depth > 0);
  const carriesFiles = (event) => event.dataTransfer && [].includes.call(event.dataTransfer.types, 'Files');
  window.addEventListener('dragenter', (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    ++depth;
    mark();
  });
  window.addEventListener('dragleave', (event) => {
    if (!carriesFiles(event)) return;
    depth = Math.max(0, depth - 1);
    mark();
  });
  window.addEventListener('dragover', (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    event.dataTransfer.dropEffect = 'copy';
  });
  window.addEventListener('drop', (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    depth = 0;
    mark();
    // The items are gone when this function ends.
    const found = [];
    for (const item of event.dataTransfer.items) {
      const file = item.kind === 'file' && item.getAsFile();
      if (!file) continue;
      const handle = !isPicture(file) && item.getAsFileSystemHandle
          ? item.getAsFileSystemHandle().catch(() => undefined) : undefined;
      found.push({file, handle});
    }
    const drawing = found.find((one) => !isPicture(one.file));
    const picture = found.find((one) => isPicture(one.file));
    if (drawing) {
      Promise.resolve(drawing.handle).then((handle) => open(drawing.file, handle));
    } else if (picture) {
      host.addPicture(picture.file);
    }
  });
  window.addEventListener('paste', (event) => {
    const files = event.clipboardData ? [].slice.call(event.clipboardData.files) : [];
    const picture = files.find(isPicture);
    if (!picture) return;
    event.preventDefault();
    host.addPicture(picture);
  });
}
