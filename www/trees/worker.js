// Owns the tree engine and never runs by itself: it answers requests, one at a time, in order. See types.js.
// The handler is set before wasm is initialised, or the first request would be lost.

import init, { Bench, format, models, variants, version } from './engine/swarm_playground.js';

/** @typedef {{ id: number, type: string } & Record<string, any>} Request */

const port = /** @type {{ postMessage(message: object): void, onmessage: ((event: MessageEvent) => void) | null }} */ (/** @type {unknown} */ (self));

/** @type {Bench[]} made when they are first opened */
const benches = [];
/** @type {Promise<unknown> | undefined} */
let ready;
let queue = Promise.resolve();

port.onmessage = (event) => {
  const request = /** @type {Request} */ (event.data);
  queue = queue.then(() => answer(request));
};

/** @param {Request} request */
async function answer(request) {
  try {
    ready ??= init();
    await ready;
    port.postMessage({ id: request.id, type: request.type, ...ANSWERS[request.type](request) });
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    const refused = REFUSES.has(request.type) && !(error instanceof WebAssembly.RuntimeError) && !/panicked at/.test(message);
    port.postMessage({ id: request.id, type: 'error', message, fatal: !refused });
  }
}

/** Requests that may fail because of what was asked; any other failure means that the engine is broken. */
const REFUSES = new Set(['open', 'format', 'breakpoints']);

/** @type {Record<string, (request: Request) => object>} */
const ANSWERS = {
  hello: () => ({ version: version(), models: JSON.parse(models()) }),
  open: ({ bench, setup }) => ({ opened: JSON.parse((benches[bench] ??= new Bench()).open(JSON.stringify(setup))) }),
  advance: ({ bench, ticks }) => ({ moment: JSON.parse(opened(bench).advance(ticks)) }),
  seek: ({ bench, tick }) => ({ moment: JSON.parse(opened(bench).seek(tick)) }),
  timeline: ({ bench, from, to }) => ({ timeline: JSON.parse(opened(bench).timeline(from, to)) }),
  breakpoints({ bench, list }) {
    opened(bench).breakpoints(JSON.stringify(list));
    return {};
  },
  variants: ({ xml, line, column }) => ({ variants: JSON.parse(variants(xml, line, column)) }),
  format: ({ xml }) => ({ xml: format(xml) }),
};

/** @param {number} bench */
function opened(bench) {
  if (!benches[bench]) throw new Error(`bench ${bench} holds no tree`);
  return benches[bench];
}
