// Work in a worker: marrow.js again, which does nothing there but that. A worker that is no longer
// wanted is ended, and the next one takes the program that the page has compiled.
function marrowWorker(host) {
  const script = document.querySelector('script[src$="marrow.js"]');
  let worker = null, number = 0;

  function begin() {
    const own = new Worker(script.src);
    // What an ended one said last is not of the next one's work.
    const heard = (handle) => (event) => {
      if (own === worker) handle(event);
    };
    own.onmessage = heard(({data}) => hear(data));
    own.onerror = own.onmessageerror = heard(fail);
    own.postMessage({module: Module['compiled']});
    worker = own;
  }
  function end() {
    if (worker) worker.terminate();
    worker = null;
    number = 0;
  }
  function hear(data) {
    try {
      if (data.failed) {
        fail();
      } else if (data.made) {
        const bytes = new Uint8Array(data.made), address = host.placed(bytes);
        _marrow_work_made(number, address, bytes.length);
        _free(address);
      } else if (data.done !== undefined) {
        _marrow_work_progress(number, data.done);
      } else if (data.ended !== undefined) {
        const of = number;
        number = 0;
        ended(of, data.ended);
      }
    } catch {
      fail();
    }
    host.wake();
  }
  function ended(of, why) {
    const address = host.copied(why);
    _marrow_work_ended(of, address);
    _free(address);
  }
  // A worker in which anything was thrown is not asked again.
  function fail() {
    const of = number;
    end();
    ended(of, 'This did not work: the browser does not let the app work in the background, or has no memory left.');
    host.wake();
  }

  host.perform.work = (job) => {
    const request = host.raw('jobText', String(job.id));
    if (number) end();  // it is busy with something older
    if (!request) return;
    number = job.number;
    try {
      if (!worker) begin();
      worker.postMessage({request});
    } catch {
      fail();
    }
  };
}
