import { messageOf } from '../session.js';
import { text } from '../ui/strings.en.js';

/** @import { State } from '../state.js' */

/**
 * What every tab does when its address is opened: the first time it starts, later it shows what the address says.
 *
 * @param {{ state: State, broke: (message: string) => void, begin: (hash: string) => Promise<void>, again: (hash: string) => Promise<unknown> }} parts
 *   `broke` is told why the tab cannot start
 * @returns {(hash: string) => Promise<void>}
 */
export function createOpening({ state, broke, begin, again }) {
  /** @type {Promise<void> | null} */
  let started = null;

  /** @param {string} hash */
  async function start(hash) {
    if (typeof WebAssembly !== 'object') {
      broke(text.fault.noWasm);
      return;
    }
    try {
      await begin(hash);
    } catch (error) {
      if (state.name !== 'error') broke(messageOf(error)); // an engine that broke has said so itself
    }
  }

  return async (hash) => {
    if (!started) {
      started = start(hash);
      return started;
    }
    await started;
    await again(hash);
  };
}
