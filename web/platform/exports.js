// Files of the character, handed over when they are made. That may be long after the button was
// pressed: where the browser then no longer lets the user choose a place, they are downloaded.
// Linked into marrow.js before browser.js, which gives the host.
function marrowExports(host) {
  const types = {
    glb: ['model/gltf-binary', '3D model'],
    gltf: ['model/gltf+json', '3D model'],
    obj: ['model/obj', '3D shape'],
    stl: ['model/stl', '3D shape'],
    ply: ['model/ply', '3D shape'],
  };

  host.perform.handOver = async (job) => {
    const table = _marrow_job_bytes(job.id) >> 2;
    const address = HEAPU32[table];
    const bytes = HEAPU8.slice(address, address + HEAPU32[table + 1]);
    const ending = job.name.slice(job.name.lastIndexOf('.') + 1);
    const type = types[ending][0];
    let handle = null;
    try {
      if (window.showSaveFilePicker) {
        handle = await window.showSaveFilePicker({
          suggestedName: job.name,
          types: [{description: types[ending][1], accept: {[type]: ['.' + ending]}}],
        });
      }
    } catch (error) {
      if (error && error.name === 'AbortError') return;
    }
    if (!handle) {
      host.download(job.name, type, bytes);
      return host.say(`Saved as ${job.name} among your downloads.`);
    }
    try {
      const stream = await handle.createWritable();
      await stream.write(bytes);
      await stream.close();
      host.say(`Saved ${handle.name}.`);
    } catch {
      host.say(`${handle.name} was not saved: the browser does not allow it, or the disk is full.`);
    }
  };
}
