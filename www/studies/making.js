// The worker's half of www/studies/pool.js: makes runs one at a time, in slices, so that between two of them it hears what
// the page says and a pause stands at a tick and goes on from there.

/** @import { FromWorker, ToWorker } from './pool.js' */

const TELL_MS = 250;

/**
 * A run that is being made.
 *
 * @typedef {object} Making
 * @property {() => boolean} advance makes a slice; returns whether the run is over
 * @property {() => string} line what came out, when it is over
 * @property {() => void} free
 */

/**
 * Serves a pool from inside a worker.
 *
 * @param {object} kind
 * @param {(module: WebAssembly.Module, spec: string) => Promise<void>} kind.open what the runs are of; comes first
 * @param {(run: number) => Making} kind.start
 */
export function makeRuns({ open, start }) {
  const port = /** @type {{ postMessage(message: FromWorker): void, onmessage: ((event: MessageEvent<ToWorker>) => void) | null }} */ (/** @type {unknown} */ (self));
  const channel = new MessageChannel();
  /** @type {{ run: number, making: Making, seconds: number } | null} */
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
        await open(message.module, message.spec);
        port.postMessage({ type: 'ready' });
        break;
      case 'run':
        current = { run: message.run, making: start(message.run), seconds: 0 };
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
      const { run, making } = current;
      const began = performance.now();
      const over = making.advance();
      current.seconds += (performance.now() - began) / 1000;
      if (over) {
        const { seconds } = current;
        const line = making.line();
        making.free();
        current = null;
        port.postMessage({ type: 'done', run, line, seconds });
      } else if (began - told > TELL_MS) {
        told = began;
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
}
