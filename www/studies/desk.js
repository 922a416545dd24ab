// Reads studies and writes reports, so that the page only draws: it answers requests, one at a time, in order.
// The handler is set before wasm is initialised, or the first request would be lost.

import init, { Study, check, metrics, schema, version } from './engine/swarm_playground.js';

/** @typedef {{ id: number, type: string } & Record<string, any>} Request */

const port = /** @type {{ postMessage(message: object): void, onmessage: ((event: MessageEvent) => void) | null }} */ (/** @type {unknown} */ (self));

/** @type {Map<string, Study>} the studies on the desk, by what the page calls them */
const studies = new Map();
/** @type {Promise<unknown> | undefined} */
let ready;
let presets = '{}';
let queue = Promise.resolve();

port.onmessage = (event) => {
  const request = /** @type {Request} */ (event.data);
  queue = queue.then(() => answer(request));
};

/** @param {Request} request */
async function answer(request) {
  try {
    ready ??= init(request.module && { module_or_path: request.module });
    await ready;
    port.postMessage({ id: request.id, type: request.type, ...ANSWERS[request.type](request) });
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    const refused = REFUSES.has(request.type) && !(error instanceof WebAssembly.RuntimeError) && !/panicked at/.test(message);
    port.postMessage({ id: request.id, type: 'error', message, fatal: !refused });
  }
}

/** Requests that may fail because of what was asked; any other failure means that the engine is broken. */
const REFUSES = new Set(['open', 'report']);

/** @type {Record<string, (request: Request) => object>} */
const ANSWERS = {
  hello(request) {
    presets = JSON.stringify(request.presets);
    return { version: version(), schema: JSON.parse(schema()), metrics: JSON.parse(metrics()) };
  },
  check: ({ spec }) => JSON.parse(check(spec, presets)),
  open({ as, spec, size }) {
    const study = new Study(spec, presets, size);
    studies.get(as)?.free();
    studies.set(as, study);
    return { complete: study.complete(), plan: JSON.parse(study.plan()) };
  },
  failed: ({ as, run, reason }) => ({ line: known(as).failed(run, reason) }),
  report: ({ as, results }) => JSON.parse(known(as).report(results)),
};

/** @param {string} as */
function known(as) {
  const study = studies.get(as);
  if (!study) throw new Error(`no study is open as ${as}`);
  return study;
}
