/** @import { Engine } from './engine.js' */
/** @import { Run, RunEvents } from './run.js' */
/** @import { Layout, Scenario } from './types.js' */
/** @import { WorldView } from './views/world.js' */

/**
 * @typedef {object} Seen a run as far as it is looked at
 * @property {Layout | null} layout
 * @property {Float32Array} frame
 * @property {number} tick
 * @property {Scenario} scenario
 *
 * @typedef {Seen & { on: (name: 'loaded' | 'frame' | 'settled', listener: () => void) => void }} SeenRun
 *
 * @typedef {object} Eye
 * @property {Engine['request']} request
 * @property {Seen} run
 * @property {() => WorldView} world
 * @property {string} side empty while there is only one run, else `a` or `b`
 */

/**
 * What inspector, table and files look at: the one run on screen, or in A | B one of the two.
 *
 * @param {Run} run tells when there is something new; the other run of a pair is never ahead of it
 * @param {Eye} own
 */
export function createLens(run, own) {
  let eye = own;
  /** @type {Record<'loaded' | 'frame' | 'settled', (() => void)[]>} */
  const listeners = { loaded: [], frame: [], settled: [] };
  const names = /** @type {const} */ (['loaded', 'frame', 'settled']);
  for (const name of names) run.on(/** @type {keyof RunEvents} */ (name), () => tell(name));

  /** @param {typeof names[number]} name */
  function tell(name) {
    for (const listener of listeners[name]) listener();
  }

  return {
    /** @type {Pick<Engine, 'request'>} */
    engine: { request: (...asked) => eye.request(...asked) },

    /** @type {SeenRun} */
    run: {
      get layout() {
        return eye.run.layout;
      },
      get frame() {
        return eye.run.frame;
      },
      get tick() {
        return eye.run.tick;
      },
      get scenario() {
        return eye.run.scenario;
      },
      on: (name, listener) => void listeners[name].push(listener),
    },

    world: () => eye.world(),
    side: () => eye.side,

    /** Looks at another run; at the page's own when none is given. @param {Eye} [next] */
    look(next = own) {
      eye = next;
      tell('loaded');
    },
  };
}

/** @typedef {ReturnType<typeof createLens>} Lens */
