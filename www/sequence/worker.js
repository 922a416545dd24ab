// Owns the engine of sequencing and never runs by itself: it answers requests, one at a time, in order. See types.js.
// The handler is set before wasm is initialised, or the first request would be lost.

import init, { Sequence, sequence_complete as complete, sequence_schema as schema, version } from './engine/swarm_playground.js';

/** @typedef {{ id: number, type: string } & Record<string, any>} Request */

const ROW = 6;
const AT_ONCE = 4; // integrations between two looks at the clock: a few milliseconds

const port = /** @type {{ postMessage(message: object, transfer?: Transferable[]): void, onmessage: ((event: MessageEvent) => void) | null }} */ (
  /** @type {unknown} */ (self)
);

/** @type {WebAssembly.Memory} */
let memory;
/** @type {Sequence | null} */
let sequence = null;
let sent = 0; // rows of the frontier that the page has
let known = ''; // the plan that the page has
/** @type {Promise<unknown> | undefined} */
let ready;
/** @type {Promise<void>} */
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
const REFUSES = new Set(['complete', 'open', 'follow', 'fan']);

/** @type {Record<string, (request: Request) => [object, Transferable[]?]>} */
const ANSWERS = {
  hello: () => [{ version: version(), schema: JSON.parse(schema()) }],
  complete: ({ scenario }) => [{ scenario: JSON.parse(complete(scenario)) }],

  open({ scenario, budgetMs }) {
    const next = new Sequence(scenario);
    sequence?.free();
    sequence = next;
    sent = 0;
    known = '';
    const [slice, transfer] = search(next, budgetMs, true);
    return [{ task: JSON.parse(next.task()), slice }, transfer];
  },

  search({ budgetMs }) {
    const [slice, transfer] = search(opened(), budgetMs, false);
    return [{ slice }, transfer];
  },

  cancel() {
    opened().cancel();
    return ANSWERS.search({ id: 0, type: 'search', budgetMs: 0 });
  },

  extend({ integrations, megabytes }) {
    opened().extend(integrations, megabytes);
    return ANSWERS.search({ id: 0, type: 'search', budgetMs: 0 });
  },

  follow({ letters }) {
    const path = follow(opened(), letters);
    return [{ path }, [path.poses.buffer, path.visits.buffer]];
  },

  fan({ letters, jitter, first, count }) {
    const rays = JSON.parse(opened().fan(letters, jitter, first, count));
    const middles = copied(opened().trajectory_pointer(), opened().trajectory_length());
    return [{ rays, middles }, [middles.buffer]];
  },
};

function opened() {
  if (!sequence) throw new Error('no scenario was opened');
  return sequence;
}

/**
 * Goes on with the search.
 *
 * @param {Sequence} task
 * @param {number} budgetMs
 * @param {boolean} first whether the first plan ends it
 * @returns {[object, Transferable[]]}
 */
function search(task, budgetMs, first) {
  const start = performance.now();
  let goes = true;
  while (goes && performance.now() - start < budgetMs && !(first && task.cost() < Infinity)) goes = task.advance(AT_ONCE);
  const ms = performance.now() - start;
  const progress = JSON.parse(task.progress());
  const rows = copied(task.frontier_pointer() + sent * 4, task.frontier_length() - sent);
  sent += rows.length - (rows.length % ROW);
  const found = progress.plan !== null && progress.plan !== known ? follow(task, progress.plan) : null;
  known = progress.plan ?? '';
  const blocked = progress.outcome !== null && progress.plan === null ? JSON.parse(task.first_interval()) : [];
  return [{ progress, rows, found, blocked, ms }, [rows.buffer, ...(found ? [found.poses.buffer, found.visits.buffer] : [])]];
}

/** @param {Sequence} task @param {string} letters */
function follow(task, letters) {
  const { frames, ...replay } = JSON.parse(task.trajectory(letters, 1, 0, undefined));
  const poses = copied(task.trajectory_pointer(), task.trajectory_length());
  return { letters, replay, poses, frames, visits: task.visits() };
}

/** A copy of reals in wasm memory; the view is made now, since growth of the memory detaches older ones. @param {number} pointer @param {number} length */
function copied(pointer, length) {
  return new Float32Array(memory.buffer, pointer, length).slice();
}
