// Owns the engine and never runs by itself: it answers requests, one at a time, in order.
// The handler is set before wasm is initialised, or the first request would be lost.

import init, { World, complete, rules, version } from './engine/swarm_playground.js';

/** @typedef {{ id: number, type: string } & Record<string, any>} Request */

const KEYFRAME_TICKS = 64;
const KEYFRAME_MS = 50;
const PROGRESS_MS = 60;

const port = /** @type {{ postMessage(message: object, transfer?: Transferable[]): void, onmessage: ((event: MessageEvent) => void) | null }} */ (
  /** @type {unknown} */ (self)
);

/** @type {WebAssembly.Memory} */
let memory;
/** @type {World | null} */
let world = null;
let sinceKeyframe = 0;
/** Fingerprints by tick, from tick 0 on without a gap, while somebody compares this run with another. @type {string[]} */
let marks = [];
let cancelled = false;
/** @type {Promise<unknown> | undefined} */
let ready;
/** @type {Promise<void>} */
let queue = Promise.resolve();

port.onmessage = (event) => {
  const request = /** @type {Request} */ (event.data);
  if (request.type === 'cancel') {
    cancelled = true;
    return;
  }
  if (request.type === 'seek') cancelled = false; // here and not when it starts: a cancel may overtake it
  queue = queue.then(() => answer(request));
};

/** @param {Request} request */
async function answer(request) {
  try {
    ready ??= init().then((exports) => (memory = exports.memory));
    await ready;
    const [message, transfer] = await ANSWERS[request.type](request);
    port.postMessage({ id: request.id, ...message }, transfer ?? []);
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    const refused = error instanceof NoWorld || (REFUSES.has(request.type) && !(error instanceof WebAssembly.RuntimeError) && !/panicked at/.test(message));
    port.postMessage({ id: request.id, type: 'error', message, fatal: !refused });
  }
}

/** Requests that may fail because of what was asked; any other failure means that the engine is broken. */
const REFUSES = new Set(['load', 'event', 'complete', 'inspect', 'export', 'derive']);

/** @type {Record<string, (request: Request) => [object, Transferable[]?] | Promise<[object, Transferable[]?]>>} */
const ANSWERS = {
  async hello() {
    // What is said of parameters lies beside the engine, which has no room for it.
    const response = await fetch(new URL('./schema.json', import.meta.url));
    if (!response.ok) throw new Error(`the parameters could not be loaded: ${response.status} ${response.statusText}`);
    return [{ type: 'hello', version: version(), schema: await response.json() }];
  },

  load({ scenario, keyframes }) {
    const next = new World(scenario, keyframes); // when it throws, the last valid world stays
    world?.free();
    world = next;
    keep();
    const fingerprint = world.fingerprint();
    marks = [fingerprint];
    return [{ type: 'loaded', tick: world.tick(), fingerprint, layout: JSON.parse(world.layout()), scenario: JSON.parse(world.scenario()), marks }];
  },

  advance({ ticks, budgetMs, buffer, known }) {
    const start = performance.now();
    let done = 0;
    let fingerprint;
    let fingerprintTick;
    while (done < ticks && running().advance(1) === 1) {
      done += 1;
      if (known !== undefined) mark();
      const elapsed = performance.now() - start;
      if (running().tick() % KEYFRAME_TICKS === 0 || sinceKeyframe + elapsed > KEYFRAME_MS) {
        keep(elapsed);
        fingerprint = running().fingerprint();
        fingerprintTick = running().tick();
      }
      if (elapsed >= budgetMs) break;
    }
    const ms = performance.now() - start;
    sinceKeyframe += ms;
    return frame(buffer, done, ms, { fingerprint, fingerprintTick, known });
  },

  async seek({ id, tick, buffer, known }) {
    const start = performance.now();
    const from = running().tick();
    let reported = start;
    let now = from;
    while (now !== tick && !cancelled) {
      const before = now;
      if (known === undefined) now = running().seek(tick, KEYFRAME_TICKS - (now % KEYFRAME_TICKS));
      else now = seekMarking(tick, now);
      if (now % KEYFRAME_TICKS === 0) keep();
      if (now === before) break; // the run ended before the tick asked for
      if (performance.now() - reported > PROGRESS_MS) {
        reported = performance.now();
        port.postMessage({ id, type: 'progress', tick: now, target: tick });
        await new Promise((resume) => setTimeout(resume)); // lets a cancel through
      }
    }
    return frame(buffer, Math.abs(now - from), performance.now() - start, { fingerprint: running().fingerprint(), known });
  },

  event({ key, value }) {
    running().set(key, JSON.stringify(value));
    keep();
    marks.length = Math.min(marks.length, running().tick() + 1);
    return [{ type: 'event', tick: running().tick(), scenario: JSON.parse(running().scenario()), fingerprint: running().fingerprint() }];
  },

  inspect: ({ query }) => [{ type: 'detail', detail: JSON.parse(running().inspect(JSON.stringify(query))) }],
  rules: ({ grammar, task }) => [{ type: 'rules', rules: rules(grammar, task) }],
  export: ({ query }) => [{ type: 'exported', xml: running().export(JSON.stringify(query)) ?? null }],
  derive: ({ codons }) => [{ type: 'derived', derived: JSON.parse(running().derive(JSON.stringify(codons))) }],
  population: () => [{ type: 'population', population: running().population() ?? null }],
  history: ({ from }) => [{ type: 'history', history: JSON.parse(running().history(from)) }],
  complete: ({ scenario }) => [{ type: 'completed', scenario: JSON.parse(complete(scenario)) }],
  fingerprint: () => [{ type: 'fingerprint', tick: running().tick(), hash: running().fingerprint() }],
};

/** A chart may ask an engine that was just started again before its world is there: that breaks nothing. */
class NoWorld extends Error {}

function running() {
  if (!world) throw new NoWorld('no scenario is loaded');
  return world;
}

/** Stores the present state in the timeline. @param {number} [elapsed] computing time already counted */
function keep(elapsed = 0) {
  running().keyframe();
  sinceKeyframe = -elapsed;
}

/** Notes the fingerprint of a tick that is reached for the first time; after that, every tick before it is noted too. */
function mark() {
  if (running().tick() === marks.length) marks.push(running().fingerprint());
}

/**
 * One stride of a seek that notes every tick: in large strides where the ticks are noted already, else one by one.
 *
 * @param {number} tick
 * @param {number} now
 */
function seekMarking(tick, now) {
  const noted = marks.length - 1;
  const stride = KEYFRAME_TICKS - (now % KEYFRAME_TICKS);
  const reached = now >= noted && tick > now ? running().seek(tick, 1) : running().seek(Math.min(tick, noted), stride);
  mark();
  return reached;
}

/**
 * Copies the frame into a buffer that travels back to the page.
 *
 * @param {ArrayBuffer | undefined} buffer
 * @param {number} done
 * @param {number} ms
 * @param {{ fingerprint?: string, fingerprintTick?: number, known?: number }} said `fingerprintTick` where it is another tick's;
 *   with `known`, the fingerprints of all ticks from that one on go along
 * @returns {[object, Transferable[]]}
 */
function frame(buffer, done, ms, { fingerprint, fingerprintTick, known }) {
  const pointer = running().frame_pointer();
  const length = running().frame_length();
  const source = new Float32Array(memory.buffer, pointer, length); // memory growth detaches older views
  const target = buffer?.byteLength === source.byteLength ? buffer : new ArrayBuffer(source.byteLength);
  new Float32Array(target).set(source);
  const fresh = known === undefined ? undefined : marks.slice(known);
  const answered = { type: 'frame', tick: running().tick(), done, finished: running().finished() ?? null, buffer: target, ms, fingerprint, fingerprintTick, marks: fresh };
  return [answered, [target]];
}
