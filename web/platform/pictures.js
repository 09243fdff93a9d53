// Pictures to draw after: chosen, dropped or pasted, made small enough to be kept in the document,
// and turned into pixels. Linked into marrow.js before browser.js, which gives the host.
function marrowPictures(host) {
  const largestSide = 2048, largestFile = 2 << 20;
  const kept = /^image\/(png|jpeg|webp)$/;
  const unreadable = (name) => `${name} cannot be shown: it is not a PNG, JPEG or WebP picture that ` +
      'can be read.';

  function drawn(image, width, height) {
    const canvas = document.createElement('canvas');
    canvas.width = width;
    canvas.height = height;
    const context = canvas.getContext('2d', {willReadFrequently: true});
    context.drawImage(image, 0, 0, width, height);
    return canvas;
  }
  function pixelsOf(canvas) {
    return canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
  }
  function isOpaque(canvas) {
    const pixels = pixelsOf(canvas);
    for (let i = 3; i < pixels.length; i += 4) if (pixels[i] !== 255) return false;
    return true;
  }
  const toBlob = (canvas, type) => new Promise((resolve) => canvas.toBlob(resolve, type, 0.9));
  const toText = (blob) => new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(reader.result);
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(blob);
  });
  function load(address) {
    const image = new Image();
    image.src = address;
    return image.decode().then(() => image);
  }

  host.addPicture = async (file) => {
    const name = file.name || 'This picture';
    const address = URL.createObjectURL(file);
    try {
      const image = await load(address);
      const longest = Math.max(image.naturalWidth, image.naturalHeight);
      if (!longest) throw new Error('no size');
      const shrink = Math.min(1, largestSide / longest);
      const width = Math.max(1, Math.round(image.naturalWidth * shrink));
      const height = Math.max(1, Math.round(image.naturalHeight * shrink));
      let blob = file;
      if (shrink < 1 || file.size > largestFile || !kept.test(file.type)) {
        const canvas = drawn(image, width, height);
        blob = await toBlob(canvas, isOpaque(canvas) ? 'image/jpeg' : 'image/png');
        // What is transparent and full of noise stays large.
        if (blob.size > 4 * largestFile) blob = await toBlob(canvas, 'image/webp');
      }
      const text = await toText(blob);
      host.call('picture', JSON.stringify({width, height}) + '\n' + text);
    } catch {
      host.say(unreadable(name));
    } finally {
      URL.revokeObjectURL(address);
    }
    host.wake();
  };
  host.perform.picture = async () => {
    const file = await host.chooseFile('image/png,image/jpeg,image/webp');
    if (file) await host.addPicture(file);
  };

  // Only what is in the text itself: a drawing makes nobody ask a server.
  const inText = /^data:image\/(png|jpeg|webp);base64,/;
  host.perform.decode = async (job) => {
    const address = host.raw('jobText', String(job.id));
    try {
      if (!inText.test(address)) throw new Error('not in the text');
      const image = await load(address);
      const longest = Math.max(image.naturalWidth, image.naturalHeight);
      const shrink = Math.min(1, largestSide / longest);
      const canvas = drawn(image, Math.max(1, Math.round(image.naturalWidth * shrink)),
                           Math.max(1, Math.round(image.naturalHeight * shrink)));
      const at = host.placed(pixelsOf(canvas));
      _marrow_pixels(job.drawing, canvas.width, canvas.height, image.naturalWidth,
                     image.naturalHeight, at);
      _free(at);
    } catch {
      host.call('noPixels', String(job.drawing));
    }
    host.wake();
  };
}
