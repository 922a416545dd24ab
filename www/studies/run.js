import { studiesText as text } from '../ui/strings.studies.en.js';
import { messageOf } from '../session.js';
import { createPool } from './pool.js';
import { slowest, timeLeft } from './speed.js';
import { keyOf } from './store.js';

/** @import { Engine } from '../engine.js' */
/** @import { State } from '../state.js' */
/** @import { Speed, Timed } from './speed.js' */
/** @import { Store } from './store.js' */
/** @import { Plan, Reported, Size } from './types.js' */

const REPORT_MS = 1000;
const AS = 'own';

/**
 * @typedef {object} StudyRunEvents
 * @property {() => void} plan another study is there
 * @property {() => void} progress a run has gone on or ended
 * @property {() => void} report the results are told anew
 * @property {(what: 'started' | 'paused' | 'stopped' | 'finished') => void} moved
 */

/**
 * The runs of the study on screen: which are there, which are made, and what they say together. Results are kept by the
 * number of the run, so neither the number of workers nor the order in which they end shows.
 *
 * @param {{ desk: Engine, store: Store, state: State, speed: Speed, spawn: () => Worker, module: () => Promise<WebAssembly.Module>,
 *   say: (message: string, kind?: 'note' | 'problem', offers?: { label: string, press: () => void }[]) => void }} parts
 */
export function createStudyRun({ desk, store, state, speed, spawn, module, say }) {
  /** @type {{ [K in keyof StudyRunEvents]: StudyRunEvents[K][] }} */
  const listeners = { plan: [], progress: [], report: [], moved: [] };
  const pool = createPool({ spawn, module, on: { done, failed, broken, idle } });
  /** @type {Map<number, string>} lines of the results file */
  let lines = new Map();
  /** @type {Timed[]} */
  let timed = [];
  /** @type {number[] | null} runs that have no row; null until they are counted again */
  let remaining = null;
  let complete = '';
  let opened = 0; // rises with every study, so that late answers are not taken
  let stale = false; // whether rows came since the last report was asked for
  let reporting = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let later;

  const run = {
    /** @type {Plan | null} */
    plan: null,
    /** @type {Reported | null} */
    reported: null,
    /** Workers wanted. */
    workers: 1,

    /** @template {keyof StudyRunEvents} K @param {K} name @param {StudyRunEvents[K]} listener */
    on: (name, listener) => void listeners[name].push(listener),

    /** The study without presets, as it goes beside results. */
    complete: () => complete,
    done: () => Math.min(lines.size, run.plan?.runs ?? 0),
    /** Runs that stand or go on in workers. */
    underWay: () => pool.underWay(),
    /** Runs that have no row, in order. */
    missing() {
      remaining ??= Array.from({ length: run.plan?.runs ?? 0 }, (_, number) => number).filter((number) => !lines.has(number));
      return remaining;
    },
    timeLeft: () => run.plan && timeLeft({ plan: run.plan, missing: run.missing(), timed, workers: run.workers }),
    slowest: () => run.plan && slowest(run.plan, timed),

    /**
     * Puts a valid study on screen, with the rows that are kept of it. When only its words, tests or figure differ from
     * the present one, the runs go on.
     *
     * @param {string} spec
     * @param {Size} size
     */
    async open(spec, size) {
      const mine = (opened += 1);
      const before = run.plan;
      const answer = await desk.request('open', { as: AS, spec, size });
      if (mine !== opened) return;
      complete = answer.complete;
      const same = before !== null && before.hash === answer.plan.hash && before.runs === answer.plan.runs;
      run.plan = answer.plan;
      if (!same) {
        run.reported = null;
        pool.stop();
        timed = [];
        lines = new Map();
        remaining = null;
        const kept = await store.load(key());
        if (mine !== opened) return;
        lines = kept;
        remaining = null;
        state.to('paused');
        settle();
      }
      for (const listener of listeners.plan) listener();
      await report();
    },

    play() {
      const missing = run.missing();
      if (!run.plan || state.name !== 'paused' || missing.length === 0) return;
      state.to('busy');
      if (pool.underWay() === 0) pool.load(complete, missing);
      pool.resize(run.workers);
      void pool.go();
      moved('started');
    },

    pause() {
      if (state.name !== 'busy') return;
      pool.pause();
      state.to('paused');
      moved('paused');
    },

    toggle: () => (state.name === 'busy' ? run.pause() : run.play()),

    /** Ends the workers; the runs they were at are made again later. */
    stop() {
      if (state.name === 'busy') state.to('paused');
      pool.stop();
      moved('stopped');
    },

    /** @param {number} count */
    resize(count) {
      run.workers = count;
      pool.resize(count);
      tell('progress');
    },

    /** Forgets the rows of this study; they can be taken back until another study is opened. */
    async clear() {
      run.stop();
      const [mine, before] = [opened, lines];
      const under = key();
      lines = new Map();
      remaining = null;
      timed = [];
      settle();
      await store.clear(under);
      await report();
      const restore = async () => {
        await Promise.all([...before].map(([number, line]) => store.keep(under, number, line)));
        if (mine !== opened) return;
        run.stop();
        lines = new Map([...before, ...lines]);
        remaining = null;
        settle();
        await report();
      };
      say(text.said.cleared(before.size), 'note', [{ label: text.said.restore, press: () => void restore() }]);
    },

    /** The results so far as the command line writes them. */
    async results() {
      await report();
      return run.reported;
    },

    /** Takes the study off the screen; its rows stay kept. Also for a desk that has ended. */
    close() {
      pool.stop();
      opened += 1;
      reporting = false;
      lines = new Map();
      remaining = null;
      timed = [];
      complete = '';
      run.plan = null;
      run.reported = null;
      if (state.name !== 'error') state.to('paused');
      tell('plan');
    },
  };

  const key = () => keyOf(run.plan?.version ?? '', run.plan?.hash ?? '');

  /** @param {'plan' | 'progress' | 'report'} name */
  function tell(name) {
    for (const listener of listeners[name]) listener();
  }

  /** @param {'started' | 'paused' | 'stopped' | 'finished'} what */
  function moved(what) {
    for (const listener of listeners.moved) listener(what);
    tell('progress');
    if (what !== 'started') void report();
  }

  /** Whether everything is there decides between paused and finished. */
  function settle() {
    if (run.plan && run.missing().length === 0) state.to('finished', text.state.all);
    else state.to('paused');
    tell('progress');
  }

  /** @param {number} number @param {string} line */
  function take(number, line) {
    lines.set(number, line);
    remaining = null;
    void store.keep(key(), number, line);
    stale = true;
    later ??= setTimeout(() => void report(), REPORT_MS);
    tell('progress');
  }

  /** @param {number} number @param {string} line @param {number} seconds */
  function done(number, line, seconds) {
    if (!run.plan) return;
    const cell = number % run.plan.cells.length;
    timed.push({ cell, seconds });
    speed.note(run.plan.world, run.plan.robot_steps[cell], seconds);
    take(number, line);
  }

  /** @param {number} number @param {string} reason */
  async function failed(number, reason) {
    const mine = opened;
    const { line } = await desk.request('failed', { as: AS, run: number, reason });
    if (mine !== opened) return;
    say(text.said.failed(number, reason), 'problem');
    take(number, line);
    if (run.missing().length === 0) idle();
  }

  /** @param {string} message */
  function broken(message) {
    run.stop();
    say(text.said.noWorker(message), 'problem');
  }

  function idle() {
    if (state.name !== 'busy' || run.missing().length > 0) return; // a row of a run that failed is still to come
    state.to('finished', text.state.all);
    moved('finished');
  }

  /** Asks for the report on the rows so far; one at a time, and seldom enough that runs have the processor. */
  async function report() {
    clearTimeout(later);
    later = undefined;
    if (reporting || !run.plan) {
      stale = true;
      return;
    }
    reporting = true;
    stale = false;
    const [mine, start] = [opened, performance.now()];
    try {
      const rows = [...lines].sort(([a], [b]) => a - b).map(([, line]) => line);
      const reported = await desk.request('report', { as: AS, results: run.plan.header + rows.join('') });
      if (mine === opened) {
        run.reported = reported;
        tell('report');
      }
    } catch (error) {
      if (mine === opened) say(text.said.unreadable(messageOf(error)), 'problem', [{ label: text.clear.do, press: () => void run.clear() }]);
    } finally {
      reporting = false;
    }
    const busy = state.name === 'busy' && mine === opened;
    if (stale) later ??= setTimeout(() => void report(), busy ? Math.max(REPORT_MS, 4 * (performance.now() - start)) : 0);
  }

  return run;
}

/** @typedef {ReturnType<typeof createStudyRun>} StudyRun */
