import { createPace } from './pace.js';

/** @import { Engine } from './engine.js' */
/** @import { State } from './state.js' */
/** @import { Scenario, Layout, Value, FrameAnswer } from './types.js' */

const FRAME_BUDGET_MS = 12;

/**
 * @typedef {object} RunEvents
 * @property {() => void} loaded a new world stands at tick 0
 * @property {() => void} frame another moment is on screen
 * @property {() => void} settled the world stands still: paused, stepped, sought, finished
 * @property {(tick: number, target: number) => void} progress
 * @property {() => void} scenario the running scenario has one more event
 */

/**
 * The run on screen: asks the engine for the next moment once per animation frame and only when nothing is
 * outstanding, which is all the back-pressure needed. Pausing is not asking.
 *
 * @param {Pick<Engine, 'request' | 'cancel'>} engine
 * @param {State} state
 */
export function createRun(engine, state) {
  /** @type {{ [K in keyof RunEvents]: RunEvents[K][] }} */
  const listeners = { loaded: [], frame: [], settled: [], progress: [], scenario: [] };
  /** @type {ArrayBuffer[]} two buffers travel: one on screen, one with the worker */
  let spare = [];
  let outstanding = false;
  let looping = false;
  /** @type {Promise<unknown>} */
  let queue = Promise.resolve();
  /** @type {number | null} the tick the scrubber asked for last */
  let wanted = null;
  const pace = createPace(30);

  const run = {
    /** @type {Scenario} */
    scenario: { world: 'geese', seed: 0 },
    /** @type {Layout | null} */
    layout: null,
    /** @type {Float32Array} */
    frame: new Float32Array(0),
    tick: 0,
    /** Last tick of the run. */
    steps: 0,
    /** @type {string | null} how the run finished */
    finished: null,
    fingerprint: '',
    fingerprintTick: 0,
    msPerTick: 0,
    /** Animation frames seen while running. */
    beats: 0,
    pace,

    /** @template {keyof RunEvents} K @param {K} name @param {RunEvents[K]} listener */
    on: (name, listener) => void listeners[name].push(listener),

    /**
     * Replaces the world; when the scenario is refused the present one goes on and the promise rejects.
     *
     * @param {Scenario} scenario
     */
    load(scenario) {
      if (wanted !== null) run.cancel();
      return enqueue(async () => {
        const answer = await engine.request('load', { scenario: JSON.stringify(scenario) });
        state.to('loading');
        run.scenario = answer.scenario;
        run.layout = answer.layout;
        run.steps = Number(answer.steps ?? answer.scenario.steps ?? 0);
        run.msPerTick = 0;
        note(answer.fingerprint, answer.tick);
        spare = [];
        run.frame = new Float32Array(answer.layout.length);
        const first = await engine.request('advance', { ticks: 0, budgetMs: 0 });
        show(first);
        state.to('paused');
        tell('loaded');
        tell('settled');
      });
    },

    play() {
      if (run.finished || !state.to('running')) return;
      pace.start(performance.now());
      if (!looping) requestAnimationFrame(loop);
      looping = true;
    },

    pause() {
      if (state.name === 'running' && state.to('paused')) void settle();
    },

    toggle: () => (state.name === 'running' ? run.pause() : run.play()),

    /**
     * Goes to a tick, from the nearest keyframe before it; a later wish replaces one under way.
     *
     * @param {number} tick
     */
    seek(tick) {
      const target = Math.min(Math.max(Math.round(tick), 0), run.steps);
      if (state.name === 'error' || state.name === 'loading') return Promise.resolve();
      if (state.name === 'running') state.to('paused');
      const underWay = wanted !== null;
      wanted = target;
      if (underWay) {
        engine.cancel();
        return Promise.resolve();
      }
      return enqueue(goToWanted);
    },

    /** @param {number} ticks forward, or back when negative */
    step: (ticks) => run.seek((wanted ?? run.tick) + ticks),

    cancel() {
      wanted = null;
      engine.cancel();
    },

    /**
     * Changes the running world; the change becomes an event of the scenario.
     *
     * @param {string} key
     * @param {Value} value
     */
    change: (key, value) =>
      enqueue(async () => {
        const answer = await engine.request('event', { key, value });
        run.scenario = answer.scenario;
        note(answer.fingerprint, answer.tick);
        tell('scenario');
      }),

    /** Takes the fingerprint of this moment. */
    mark: () =>
      enqueue(async () => {
        const answer = await engine.request('fingerprint');
        note(answer.hash, answer.tick);
      }),

    /** Forgets every request under way; for a worker that has ended. */
    abandon() {
      queue = Promise.resolve();
      wanted = null;
      outstanding = false;
      spare = [];
    },
  };

  /** @param {() => Promise<void>} work @returns {Promise<void>} */
  function enqueue(work) {
    const next = queue.then(work);
    queue = next.catch(() => {});
    return next;
  }

  /** @param {'loaded' | 'frame' | 'settled' | 'scenario'} name */
  function tell(name) {
    for (const listener of listeners[name]) listener();
  }

  /** @param {string} hash @param {number} tick */
  function note(hash, tick) {
    run.fingerprint = hash;
    run.fingerprintTick = tick;
  }

  /** @param {FrameAnswer} answer */
  function show(answer) {
    if (run.frame.byteLength === answer.buffer.byteLength) spare.push(/** @type {ArrayBuffer} */ (run.frame.buffer));
    run.frame = new Float32Array(answer.buffer);
    run.tick = answer.tick;
    run.finished = answer.finished;
    if (answer.fingerprint) note(answer.fingerprint, answer.fingerprintTick ?? answer.tick);
    if (answer.done > 0) run.msPerTick += (answer.ms / answer.done - run.msPerTick) * (run.msPerTick ? 0.1 : 1);
    tell('frame');
  }

  /** @returns {{ buffer: ArrayBuffer | undefined, transfer: Transferable[] }} */
  function takeBuffer() {
    const buffer = spare.pop();
    return { buffer, transfer: buffer ? [buffer] : [] };
  }

  /** @param {number} now */
  function loop(now) {
    looping = state.name === 'running';
    if (!looping) return;
    requestAnimationFrame(loop);
    run.beats += 1;
    if (outstanding) return;
    const ticks = pace.owed(now);
    if (ticks < 1) return;
    outstanding = true;
    enqueue(() => advance(ticks)).catch(() => {});
  }

  /** @param {number} ticks */
  async function advance(ticks) {
    try {
      if (state.name !== 'running') return;
      const { buffer, transfer } = takeBuffer();
      /** @type {FrameAnswer} */
      const answer = await engine.request('advance', { ticks, budgetMs: FRAME_BUDGET_MS, buffer }, transfer);
      pace.paid(answer.done);
      show(answer);
      if (answer.finished && state.to('finished', answer.finished)) void settle();
    } finally {
      outstanding = false;
    }
  }

  async function goToWanted() {
    try {
      while (wanted !== null) {
        const target = wanted;
        const { buffer, transfer } = takeBuffer();
        /** @type {FrameAnswer} */
        const answer = await engine.request('seek', { tick: target, buffer }, transfer, (tick) => {
          if (wanted !== null) state.to('busy');
          for (const listener of listeners.progress) listener(tick, wanted ?? target);
        });
        show(answer);
        if (wanted === target) wanted = null;
      }
      stand();
      tell('settled');
    } finally {
      wanted = null;
    }
  }

  function stand() {
    if (run.finished) state.to('finished', run.finished);
    else state.to('paused');
  }

  async function settle() {
    try {
      await run.mark();
      tell('settled');
    } catch {
      // the engine has ended; the page says so elsewhere
    }
  }

  return run;
}

/** @typedef {ReturnType<typeof createRun>} Run */
