import { studiesText as text } from '../ui/strings.studies.en.js';

/**
 * @typedef {{ type: 'study', module: WebAssembly.Module, spec: string } | { type: 'run', run: number } | { type: 'pause' } | { type: 'resume' }} ToWorker
 *
 * @typedef {{ type: 'ready' } | { type: 'alive' }
 *   | { type: 'done', run: number, line: string, seconds: number } | { type: 'error', message: string }} FromWorker
 *
 * @typedef {object} Hand a worker of the pool
 * @property {Worker} worker
 * @property {number | null} run what it works on
 * @property {boolean} ready whether it has started
 * @property {number} silent seconds without a word
 *
 * @typedef {object} PoolEvents
 * @property {(run: number, line: string, seconds: number) => void} done
 * @property {(run: number, reason: string) => void} failed a run broke its worker too often
 * @property {(message: string) => void} broken no worker can be started
 * @property {() => void} idle nothing is left to do
 */

const ATTEMPTS = 3; // of one run
const STARTS = 3; // of a worker that never got ready
const SILENT_SECONDS = 10; // a worker tells four times a second that it is at work

/**
 * Workers that make the runs of one study, in their order. A worker that dies is replaced and its run made again. When it
 * is paused, every run stands still where it is; when it is stopped, runs under way are made again later.
 *
 * @param {{ spawn: () => Worker, module: () => Promise<WebAssembly.Module>, on: PoolEvents }} parts
 */
export function createPool({ spawn, module, on }) {
  /** @type {Hand[]} */
  let hands = [];
  /** @type {number[]} runs that nobody works on, in order */
  let queue = [];
  /** @type {Map<number, number>} how often a run broke its worker */
  let deaths = new Map();
  /** @type {WebAssembly.Module | null} */
  let compiled = null;
  let spec = '';
  let size = 1;
  let going = false;
  let badStarts = 0;
  let round = 0; // rises with every stop, so that late answers are not taken

  setInterval(listen, 1000);

  /** Notices workers that have died without a word. The page's own beats count, so a computer that slept kills nobody. */
  function listen() {
    if (!going) return;
    for (const hand of [...hands]) {
      hand.silent += 1;
      if (hand.silent > SILENT_SECONDS && (hand.run !== null || !hand.ready)) died(hand, text.pool.silent(SILENT_SECONDS));
    }
  }

  /** As many workers as are wanted and have something to do. */
  function staff() {
    if (!going || !compiled) return;
    const busy = hands.filter(({ run }) => run !== null).length;
    while (hands.length < Math.min(size, busy + queue.length)) hire(compiled);
    for (const hand of [...hands]) {
      if (hand.run === null && hands.length > size) dismiss(hand);
      else if (hand.run === null && hand.ready) give(hand);
    }
    if (queue.length === 0 && hands.every(({ run }) => run === null)) {
      stop();
      on.idle();
    }
  }

  /** @param {WebAssembly.Module} wasm */
  function hire(wasm) {
    const worker = spawn();
    /** @type {Hand} */
    const hand = { worker, run: null, ready: false, silent: 0 };
    worker.onmessage = (event) => hear(hand, event.data);
    worker.onerror = (event) => {
      event.preventDefault();
      died(hand, event.message || text.pool.noReason);
    };
    hands.push(hand);
    send(hand, { type: 'study', module: wasm, spec });
  }

  /** @param {Hand} hand @param {ToWorker} message */
  function send(hand, message) {
    hand.worker.postMessage(message);
  }

  /** @param {Hand} hand */
  function dismiss(hand) {
    hand.worker.terminate();
    hand.worker.onmessage = null;
    hand.worker.onerror = null;
    hands = hands.filter((other) => other !== hand);
  }

  /** @param {Hand} hand */
  function give(hand) {
    const run = queue.shift();
    if (run === undefined) return;
    hand.run = run;
    hand.silent = 0;
    send(hand, { type: 'run', run });
  }

  /** @param {Hand} hand @param {FromWorker} message */
  function hear(hand, message) {
    hand.silent = 0;
    switch (message.type) {
      case 'ready':
        hand.ready = true;
        badStarts = 0;
        staff();
        break;
      case 'alive':
        break;
      case 'done':
        hand.run = null;
        on.done(message.run, message.line, message.seconds);
        staff();
        break;
      case 'error':
        died(hand, message.message);
        break;
    }
  }

  /** @param {Hand} hand @param {string} why */
  function died(hand, why) {
    dismiss(hand);
    const { run } = hand;
    if (run !== null) {
      const times = (deaths.get(run) ?? 0) + 1;
      deaths.set(run, times);
      if (times >= ATTEMPTS) on.failed(run, text.pool.died(times, why));
      else takeBack(run);
    } else if (!hand.ready && (badStarts += 1) >= STARTS) {
      stop();
      on.broken(why);
      return;
    }
    staff();
  }

  /** @param {number} run */
  function takeBack(run) {
    queue.push(run);
    queue.sort((a, b) => a - b);
  }

  /** Ends every worker; runs under way go back to those that wait. */
  function stop() {
    going = false;
    round += 1;
    for (const hand of [...hands]) {
      if (hand.run !== null) takeBack(hand.run);
      dismiss(hand);
    }
  }

  return {
    /** How many runs stand or go on in workers. */
    underWay: () => hands.filter(({ run }) => run !== null).length,

    /**
     * Begins anew.
     *
     * @param {string} complete the study, which needs no presets
     * @param {number[]} runs what there is to do, in order
     */
    load(complete, runs) {
      stop();
      spec = complete;
      queue = [...runs];
      deaths = new Map();
      badStarts = 0;
    },

    /** Starts, or goes on where it was paused. */
    async go() {
      if (going) return;
      going = true;
      const mine = round;
      try {
        compiled ??= await module();
      } catch (error) {
        if (mine !== round) return;
        stop();
        on.broken(error instanceof Error ? error.message : String(error));
        return;
      }
      if (!going || mine !== round) return;
      for (const hand of hands) {
        hand.silent = 0;
        send(hand, { type: 'resume' });
      }
      staff();
    },

    pause() {
      going = false;
      for (const hand of hands) send(hand, { type: 'pause' });
    },

    stop,

    /** @param {number} count workers wanted; those too many end after their run */
    resize(count) {
      size = count;
      staff();
    },
  };
}

/** @typedef {ReturnType<typeof createPool>} Pool */
