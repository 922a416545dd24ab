// Owns the engine of sequencing and never runs by itself: it answers requests, one at a time, in order. See types.js.

import { answerRequests } from '../answering.js';
import init, { Sequence, sequence_complete as complete, sequence_schema as schema, version } from './engine/swarm_playground.js';

/** @import { Answers } from '../answering.js' */

const ROW = 6;
const AT_ONCE = 4; // integrations between two looks at the clock: a few milliseconds

/** @type {WebAssembly.Memory} */
let memory;
/** @type {Sequence | null} */
let sequence = null;
let sent = 0; // rows of the frontier that the page has
let known = ''; // the plan that the page has

/** @type {Answers} */
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

answerRequests({
  start: async () => ({ memory } = await init()),
  answers: ANSWERS,
  refuses: new Set(['complete', 'open', 'follow', 'fan']),
});

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
