// node run.cjs PROGRAM.js [ARGUMENT…]: runs a program compiled by Emscripten.
//
// Emscripten 3.1.6 asks fetch for the .wasm file where there is a fetch, which Node's cannot do for
// files; and Node prints the whole script where an exception is not caught.
'use strict';
const path = require('path');

delete globalThis.fetch;
process.on('uncaughtException', (error) => {
  console.error(error instanceof Error ? `${error.message}\n${error.stack}`.slice(0, 4000) : error);
  process.exit(70);
});
process.argv.splice(1, 1);
process.argv[1] = path.resolve(process.argv[1]);
require(process.argv[1]);
