// In Node the engine is read from the file beside this one, when it is imported.
import { readFileSync } from 'node:fs';
import { initSync } from './swarm_playground.js';

const exports = initSync({ module: readFileSync(new URL('./swarm_playground_bg.wasm', import.meta.url)) });

export * from './swarm_playground.js';

/** The engine is ready already; so that one program runs in Node and in browsers. */
export default async function init() {
  return exports;
}
