// Makes runs of one study, one at a time, in slices: between two of them it hears what the page says, so that a pause
// stands at a tick and goes on from there.

import init, { Study } from './engine/swarm_playground.js';

/** @import { Job } from './engine/swarm_playground.js' */
/** @import { FromWorker, ToWorker } from './pool.js' */

const SLICE_MS = 40;
const TELL_MS = 250;

const port = /** @type {{ postMessage(message: FromWorker): void, onmessage: ((event: MessageEvent<ToWorker>) => void) | null }} */ (/** @type {unknown} */ (self));
const channel = new MessageChannel();

/** @type {Study | null} */
let study = null;
/** @type {{ run: number, job: Job, seconds: number } | null} */
let current = null;
let paused = false;
let working = false;
let slice = 8; // steps
let told = 0;

port.onmessage = ({ data }) => void hear(data).catch(broke);
channel.port1.onmessage = () => void work();

/** @param {ToWorker} message */
async function hear(message) {
  switch (message.type) {
    case 'study':
      await init({ module_or_path: message.module });
      study = new Study(message.spec, '{}', 'paper');
      port.postMessage({ type: 'ready' });
      break;
    case 'run':
      if (!study) throw new Error('no study was given');
      current = { run: message.run, job: study.start(message.run), seconds: 0 };
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

/** Makes a slice as soon as the messages that wait have been heard. */
function next() {
  if (working || paused || !current) return;
  working = true;
  channel.port2.postMessage(null);
}

function work() {
  working = false;
  if (paused || !current) return;
  try {
    const { run, job } = current;
    const start = performance.now();
    const over = job.advance(slice);
    const took = performance.now() - start;
    current.seconds += took / 1000;
    slice = Math.max(1, Math.min(4096, Math.round((slice * SLICE_MS) / Math.max(took, 1))));
    if (over) {
      const { seconds } = current;
      const line = job.line();
      job.free();
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
