// Owns the engine of soccer and never runs by itself: it answers requests, one at a time, in order. See types.js.
// The handler is set before wasm is initialised, or the first request would be lost.

import init, { Match, soccer_complete as complete, soccer_schema as schema, soccer_setting as setting, soccer_trees as trees, version } from './engine/swarm_playground.js';

/** @typedef {{ id: number, type: string } & Record<string, any>} Request */

const AT_ONCE = 120; // ticks between two looks at the clock: about two milliseconds

const port = /** @type {{ postMessage(message: object, transfer?: Transferable[]): void, onmessage: ((event: MessageEvent) => void) | null }} */ (
  /** @type {unknown} */ (self)
);

/** @type {WebAssembly.Memory} */
let memory;
/** @type {Match | null} */
let match = null;
let known = { log: 0, events: 0 }; // what the page has
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
    ready ??= init().then((exports) => (memory = exports.memory));
    await ready;
    const [message, transfer = []] = ANSWERS[request.type](request);
    port.postMessage({ id: request.id, type: request.type, ...message }, transfer);
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    const refused = REFUSES.has(request.type) && !(error instanceof WebAssembly.RuntimeError) && !/panicked at/.test(message);
    port.postMessage({ id: request.id, type: 'error', message, fatal: !refused });
  }
}

/** Requests that may fail because of what was asked; any other failure means that the engine is broken. */
const REFUSES = new Set(['complete', 'open', 'set']);

/** @type {Record<string, (request: Request) => [object, Transferable[]?]>} */
const ANSWERS = {
  hello: () => [{ version: version(), schema: JSON.parse(schema()), setting: JSON.parse(setting()) }],
  complete: ({ scenario }) => [{ scenario: JSON.parse(complete(scenario)) }],
  trees: ({ what, xml }) => [JSON.parse(trees(what, xml))],

  open({ scenario }) {
    const next = new Match(scenario);
    match?.free();
    match = next;
    known = { log: 0, events: 0 };
    return given(next, true);
  },

  ahead({ budgetMs }) {
    const start = performance.now();
    const now = opened();
    let more = true;
    while (more && performance.now() - start < budgetMs) more = now.ahead(AT_ONCE);
    return given(now, more);
  },

  live({ ticks, drive }) {
    const now = opened();
    if (drive !== undefined) now.set(now.front(), 'soccer.drive', JSON.stringify(drive));
    return given(now, now.ahead(ticks));
  },

  set({ tick, key, value }) {
    const now = opened();
    now.set(tick, key, JSON.stringify(value));
    known = { log: 0, events: 0 };
    const [slice, transfer] = given(now, true);
    return [{ ...slice, scenario: JSON.parse(now.scenario()) }, transfer];
  },

  look: ({ tick }) => [{ moment: JSON.parse(opened().look(tick)) }],
  arrangement: ({ tick }) => [{ arrangement: JSON.parse(opened().arrangement(tick)) }],
  scenario: () => [{ scenario: JSON.parse(opened().scenario()) }],
};

function opened() {
  if (!match) throw new Error('no scenario was opened');
  return match;
}

/**
 * What is new of a match.
 *
 * @param {Match} now
 * @param {boolean} more whether there is more to film
 * @returns {[object, Transferable[]]}
 */
function given(now, more) {
  now.ahead(0); // back to the front, if something else was looked at
  const news = JSON.parse(now.news(known.log, known.events));
  known = { log: known.log + news.log.length, events: known.events + news.events.length };
  const frames = new Float32Array(memory.buffer, now.frames_pointer(), now.frames_length()).slice(); // growth of the memory detaches older views
  now.clear();
  const slice = { frames, front: now.front(), more, news, finished: now.finished() ?? null, fingerprint: more ? '' : now.fingerprint(now.front()) };
  return [{ slice }, [frames.buffer]];
}
