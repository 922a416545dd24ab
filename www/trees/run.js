import { createPace } from '../pace.js';
import { benchText } from '../ui/strings.trees.en.js';

/** @import { Engine } from '../engine.js' */
/** @import { State } from '../state.js' */
/** @import { BenchNode, Moment, Opened, Setup } from './types.js' */

const SPEED = 2;
const BENCH = 0;

/** @typedef {{ nodes: BenchNode[], main: string, runnable: boolean }} Tree */

/**
 * @typedef {object} TreeRunEvents
 * @property {(opened: Opened, setup: Setup) => void} opened a text was read; its tree, if it has one, is the one that runs now
 * @property {() => void} moment another moment is on screen
 * @property {() => void} settled the run stands still
 * @property {(why: 'breakpoint' | 'error') => void} stopped playing ended by itself
 */

/**
 * The run on screen: asks the engine for the next moment once per animation frame and only when nothing is
 * outstanding. Of texts to open and ticks to go to only the latest counts.
 *
 * @param {Engine} engine
 * @param {State} state
 */
export function createTreeRun(engine, state) {
  /** @type {{ [K in keyof TreeRunEvents]: TreeRunEvents[K][] }} */
  const listeners = { opened: [], moment: [], settled: [], stopped: [] };
  const pace = createPace(SPEED);
  /** @type {Setup | null} */
  let wantedSetup = null;
  /** @type {number | null} */
  let wantedTick = null;
  /** @type {Promise<void> | null} what was asked for last */
  let driving = null;
  /** @type {Promise<void> | null} the next moments while playing */
  let advancing = null;
  let looping = false;

  const run = {
    /** @type {Tree | null} the last valid tree */
    tree: null,
    /** @type {Moment | null} null without a tree that runs */
    moment: null,
    tick: 0,
    /** Ticks known. */
    length: 0,
    pace,

    /** @template {keyof TreeRunEvents} K @param {K} name @param {TreeRunEvents[K]} listener */
    on: (name, listener) => void listeners[name].push(listener),

    /**
     * Computes the timeline of a setup; when the text has a fault, the present tree goes on. Rejects when the engine
     * refuses the setup.
     *
     * @param {Omit<Setup, 'length' | 'at'> & { length?: number, at?: number }} setup the present length and tick, unless it names others
     */
    open(setup) {
      const at = setup.at ?? wantedSetup?.at ?? wantedTick ?? run.tick;
      const length = Math.max(at, setup.length ?? wantedSetup?.length ?? run.length);
      wantedSetup = { ...setup, length, at };
      wantedTick = null;
      return drive();
    },

    play() {
      if (!run.moment || !state.to('running')) return;
      pace.start(performance.now());
      if (!looping) requestAnimationFrame(loop);
      looping = true;
    },

    pause() {
      if (state.name === 'running' && state.to('paused')) tell('settled');
    },

    toggle: () => (state.name === 'running' ? run.pause() : run.play()),

    /** @param {number} tick one beyond the length is computed */
    seek(tick) {
      if (!run.moment || state.name === 'error' || state.name === 'loading') return Promise.resolve();
      if (state.name === 'running') state.to('paused');
      wantedTick = Math.max(Math.round(tick), 0);
      return drive();
    },

    /** @param {number} ticks forward, or back when negative */
    step: (ticks) => run.seek((wantedTick ?? run.tick) + ticks),

    /** Forgets every request under way; for a worker that has ended. */
    abandon() {
      wantedSetup = null;
      wantedTick = null;
      driving = null;
      advancing = null;
    },
  };

  /** @param {'moment' | 'settled'} name */
  function tell(name) {
    for (const listener of listeners[name]) listener();
  }

  /** Does what is wanted until nothing is. */
  function drive() {
    driving ??= work().finally(() => (driving = null));
    return driving;
  }

  async function work() {
    await advancing;
    while (wantedSetup !== null || wantedTick !== null) {
      if (wantedSetup !== null) await openWanted(wantedSetup);
      else if (wantedTick !== null) await seekWanted(wantedTick);
    }
    if (state.name === 'running') return;
    if (run.moment?.full && run.tick === run.length) state.to('finished', benchText.said.finishedWhy);
    else state.to('paused');
    tell('settled');
  }

  /** @param {Setup} setup */
  async function openWanted(setup) {
    try {
      /** @type {Opened} */
      performance.mark('tree asked');
      const opened = (await engine.request('open', { bench: BENCH, setup })).opened;
      if (wantedSetup !== setup) return; // a later text waits
      if (opened.tree) {
        run.tree = opened.tree;
        run.moment = opened.moment;
        run.tick = opened.moment?.tick ?? setup.at;
        run.length = opened.moment?.length ?? setup.length;
        if (!opened.moment && state.name === 'running') state.to('paused');
      }
      for (const listener of listeners.opened) listener(opened, setup);
      if (opened.moment) tell('moment');
    } finally {
      if (wantedSetup === setup) wantedSetup = null;
    }
  }

  /** @param {number} tick */
  async function seekWanted(tick) {
    try {
      show((await engine.request('seek', { bench: BENCH, tick })).moment);
    } finally {
      if (wantedTick === tick) wantedTick = null;
    }
  }

  /** @param {Moment | null} moment */
  function show(moment) {
    if (!moment) return;
    run.moment = moment;
    run.tick = moment.tick;
    run.length = moment.length;
    tell('moment');
  }

  /** @param {number} now */
  function loop(now) {
    looping = state.name === 'running';
    if (!looping) return;
    requestAnimationFrame(loop);
    if (advancing || driving) return;
    const ticks = pace.owed(now);
    if (ticks >= 1) advancing = advance(ticks).finally(() => (advancing = null));
  }

  /** @param {number} ticks */
  async function advance(ticks) {
    try {
      const before = run.tick;
      /** @type {Moment | null} */
      const moment = (await engine.request('advance', { bench: BENCH, ticks })).moment;
      if (state.name !== 'running') {
        show(moment); // it was paused meanwhile
        if (!driving) tell('settled');
        return;
      }
      pace.paid((moment?.tick ?? before) - before);
      show(moment);
      if (!moment || moment.stopped || moment.error) end(moment?.stopped ? 'breakpoint' : 'error');
      else if (moment.full && moment.tick === moment.length && state.to('finished', benchText.said.finishedWhy)) tell('settled');
    } catch {
      // the engine has ended; the tab says so
    }
  }

  /** @param {'breakpoint' | 'error'} why */
  function end(why) {
    state.to('paused');
    for (const listener of listeners.stopped) listener(why);
    tell('settled');
  }

  return run;
}

/** @typedef {ReturnType<typeof createTreeRun>} TreeRun */
