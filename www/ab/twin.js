/** @import { FrameAnswer, Layout, Scenario } from '../types.js' */

/**
 * The run of B as the page sees it. It asks nothing: the pair fills it, always to the tick of A.
 */
export function createTwin() {
  /** @type {Record<'loaded' | 'frame', (() => void)[]>} */
  const listeners = { loaded: [], frame: [] };
  /** @type {ArrayBuffer[]} */
  let spare = [];
  let fresh = false;

  const twin = {
    /** @type {Scenario} */
    scenario: { world: 'geese', seed: 0 },
    /** @type {Layout | null} */
    layout: null,
    /** @type {Float32Array} */
    frame: new Float32Array(0),
    tick: 0,
    /** @type {string | null} */
    finished: null,
    fingerprint: '',
    fingerprintTick: 0,

    /** @param {'loaded' | 'frame'} name @param {() => void} listener */
    on: (name, listener) => void listeners[name].push(listener),

    /** @param {{ scenario: Scenario, layout: Layout, fingerprint: string, tick: number }} answer a new world, of which a frame follows */
    load({ scenario, layout, fingerprint, tick }) {
      Object.assign(twin, { scenario, layout, fingerprint, tick, fingerprintTick: tick, finished: null, frame: new Float32Array(layout.length) });
      spare = [];
      fresh = true;
    },

    /** @param {FrameAnswer} answer */
    show(answer) {
      if (twin.frame.byteLength === answer.buffer.byteLength) spare.push(/** @type {ArrayBuffer} */ (twin.frame.buffer));
      twin.frame = new Float32Array(answer.buffer);
      twin.tick = answer.tick;
      twin.finished = answer.finished;
      if (answer.fingerprint) twin.note(answer.fingerprint, answer.fingerprintTick ?? answer.tick);
      for (const listener of listeners[fresh ? 'loaded' : 'frame']) listener();
      fresh = false;
    },

    /** @param {string} fingerprint @param {number} tick */
    note(fingerprint, tick) {
      twin.fingerprint = fingerprint;
      twin.fingerprintTick = tick;
    },

    /** A buffer that is not on screen. */
    takeBuffer: () => spare.pop(),
  };
  return twin;
}

/** @typedef {ReturnType<typeof createTwin>} Twin */
