// Plays games of a tournament, one at a time, in slices: between two of them it hears what the page says, so that a pause
// stands at a tick and goes on from there. Speaks with www/studies/pool.js as the worker of studies does; its study is the
// list of scenarios, its runs are games, and the line of a run is the outcome.

import init, { Match } from './engine/swarm_playground.js';

/** @import { FromWorker, ToWorker } from '../studies/pool.js' */

const SLICE_TICKS = 1200; // about 20 milliseconds
const TELL_MS = 250;

const port = /** @type {{ postMessage(message: FromWorker): void, onmessage: ((event: MessageEvent<ToWorker>) => void) | null }} */ (/** @type {unknown} */ (self));
const channel = new MessageChannel();

/** @type {object[]} */
let scenarios = [];
/** @type {{ run: number, match: Match, seconds: number } | null} */
let current = null;
let paused = false;
let working = false;
let told = 0;

port.onmessage = ({ data }) => void hear(data).catch(broke);
channel.port1.onmessage = () => work();

/** @param {ToWorker} message */
async function hear(message) {
  switch (message.type) {
    case 'study':
      await init({ module_or_path: message.module });
      scenarios = JSON.parse(message.spec);
      port.postMessage({ type: 'ready' });
      break;
    case 'run':
      current = { run: message.run, match: new Match(JSON.stringify(scenarios[message.run])), seconds: 0 };
      next();
      break;
    case 'pause':
      paused = true;
      break;
    case 'resume':
      paused = false;
      next();
      break;
  }
}

/** Plays a slice as soon as the messages that wait have been heard. */
function next() {
  if (working || paused || !current) return;
  working = true;
  channel.port2.postMessage(null);
}

function work() {
  working = false;
  if (paused || !current) return;
  try {
    const { run, match } = current;
    const start = performance.now();
    const more = match.skip(SLICE_TICKS);
    current.seconds += (performance.now() - start) / 1000;
    if (!more) {
      const { seconds } = current;
      const line = match.outcome();
      match.free();
      current = null;
      port.postMessage({ type: 'done', run, line, seconds });
    } else if (start - told > TELL_MS) {
      told = start;
      port.postMessage({ type: 'alive' });
    }
    next();
  } catch (error) {
    broke(error);
  }
}

/** @param {unknown} error */
function broke(error) {
  current = null;
  port.postMessage({ type: 'error', message: error instanceof Error ? error.message : String(error) });
}
