// Owns the engine of soccer and never runs by itself: it answers requests, one at a time, in order. See types.js.

import { answerRequests } from '../answering.js';
import init, { Match, soccer_complete as complete, soccer_schema as schema, soccer_setting as setting, soccer_trees as trees, version } from './engine/swarm_playground.js';

/** @import { Answers } from '../answering.js' */

const AT_ONCE = 120; // ticks between two looks at the clock: about two milliseconds

/** @type {WebAssembly.Memory} */
let memory;
/** @type {Match | null} */
let match = null;
let known = { log: 0, events: 0 }; // what the page has

/** @type {Answers} */
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

answerRequests({
  start: async () => ({ memory } = await init()),
  answers: ANSWERS,
  refuses: new Set(['complete', 'open', 'set']),
});

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
