// Work in a worker: marrow.js again, which does nothing there but that. A worker that is no longer
// wanted is ended, and the next one takes the program that the page has compiled.
function marrowWorker(host) {
  const script = document.querySelector('script[src$="marrow.js"]');
  let worker = null, number = 0;

  function end() {
    if (worker) worker.terminate();
    worker = null;
  }
  function hear({data}) {
    if (data.made) {
      const bytes = new Uint8Array(data.made), address = _malloc(bytes.length);
      HEAPU8.set(bytes, address);
      _marrow_work_made(number, address, bytes.length);
      _free(address);
    } else if (data.done !== undefined) {
      _marrow_work_progress(number, data.done);
    } else if (data.ended !== undefined) {
      ended(data.ended);
    }
    host.wake();
  }
  function ended(why) {
    number = 0;
    const address = host.copied(why);
    _marrow_work_ended(lastNumber, address);
    _free(address);
  }
  let lastNumber = 0;

  host.perform.work = (job) => {
    const request = host.raw('jobText', String(job.id));
    if (number) end();  // it is busy with something older
    if (!request) return;
    number = lastNumber = job.number;
    const fail = () => {
      end();
      ended('This did not work: the browser does not let the app work in the background, or has no memory left.');
      host.wake();
    };
    try {
      if (!worker) {
        worker = new Worker(script.src);
        worker.onmessage = hear;
        worker.onerror = fail;
        worker.postMessage({module: Module['compiled']});
      }
      worker.postMessage({request});
    } catch {
      fail();
    }
  };
}
