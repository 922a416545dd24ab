import { EngineError } from '../engine.js';
import { messageOf } from '../session.js';
import { createFilm } from './film.js';

/** @import { Engine } from '../engine.js' */
/** @import { Arrangement, Call, Deed, Moment, Outcome, Scenario, Slice } from './types.js' */

const SLICE_MS = 24;
/** Commands that are answers to a call, not calls. */
const FOLLOWING = new Set(['stop', 'game-on']);

/**
 * A match that is computed ahead to full time, and what was computed of it. The worker answers in order, so what is taken
 * is always of the match that is there.
 *
 * @param {Pick<Engine, 'request'>} engine
 */
export function createMatch(engine) {
  /** @type {Record<'opened' | 'grown' | 'cut' | 'over', (() => void)[]>} */
  const listeners = { opened: [], grown: [], cut: [], over: [] };
  const film = createFilm();
  let driving = false;
  let live = false;

  const match = {
    film,
    /** @type {Scenario | null} what is computed, with everything done to it */
    scenario: null,
    /** @type {Call[]} */
    log: [],
    /** @type {Call[]} the lines of the log that are calls */
    calls: [],
    /** @type {Deed[]} */
    deeds: [],
    /** @type {Outcome | null} at the front */
    outcome: null,
    /** Whether blue defends the right goal. */
    exchanged: false,
    /** Whether the match was computed to its end. */
    over: false,
    /** Why it ended. */
    finished: '',
    /** Of the whole match, once it is over. */
    fingerprint: '',
    /** Whether computing ahead is interrupted. */
    held: false,

    /** @param {keyof typeof listeners} name @param {() => void} listener */
    on: (name, listener) => void listeners[name].push(listener),

    /** The last tick that is there. */
    front: () => Math.max(film.count - 1, 0),

    /** The tick of full time, as far as it can be known before. */
    end() {
      if (match.over || !match.scenario) return match.front();
      const { 'half-seconds': half, knockout, 'extra-seconds': extra } = match.scenario;
      return Math.max(60 * (2 * half + (knockout ? 2 * extra + 400 : 0)), match.front());
    },

    /** Opens a scenario and computes it to its end. @param {Scenario} scenario @returns {Promise<string>} why it is refused; empty when it is not */
    async open(scenario) {
      try {
        /** @type {{ slice: Slice }} */
        const { slice } = await engine.request('open', { scenario: JSON.stringify(scenario) });
        film.clear();
        Object.assign(match, { scenario, log: [], calls: [], deeds: [], over: false, finished: '', fingerprint: '', held: false });
        live = false;
        take(slice);
        tell('opened');
        void drive();
        return '';
      } catch (error) {
        if (error instanceof EngineError && error.fatal) throw error;
        return messageOf(error);
      }
    },

    /**
     * Does something to the match at a tick; what was later is computed anew.
     *
     * @param {number} tick
     * @param {string} key
     * @param {unknown} value
     * @returns {Promise<string>} why it is refused; empty when it is not
     */
    async set(tick, key, value) {
      try {
        /** @type {{ slice: Slice, scenario: Scenario }} */
        const { slice, scenario } = await engine.request('set', { tick, key, value });
        Object.assign(match, { scenario, log: [], calls: [], deeds: [], over: false, finished: '', fingerprint: '' });
        take(slice);
        tell('cut');
        void drive();
        return '';
      } catch (error) {
        if (error instanceof EngineError && error.fatal) throw error;
        return messageOf(error);
      }
    },

    /** From now on only `step` computes. @param {boolean} on */
    live(on) {
      live = on;
      if (!on) void drive();
    },

    /** Computes a few ticks at the front, with a command for the robot that is driven if it is another one. @param {number} ticks @param {unknown} [command] */
    async step(ticks, command) {
      /** @type {{ slice: Slice }} */
      const { slice } = await engine.request('live', { ticks, drive: command });
      take(slice);
      tell('grown');
    },

    /** Everything that there is to see at a tick. @param {number} tick @returns {Promise<Moment>} */
    look: async (tick) => (await engine.request('look', { tick })).moment,

    /** Where everything is at a tick. @param {number} tick @returns {Promise<Arrangement>} */
    arrangement: async (tick) => (await engine.request('arrangement', { tick })).arrangement,

    /** Interrupts computing ahead. */
    hold() {
      if (match.over || live) return;
      match.held = true;
    },

    resume() {
      if (!match.held) return;
      match.held = false;
      void drive();
    },

    /** Forgets what was asked; for a worker that has ended. */
    abandon() {
      live = false;
      match.held = false;
    },
  };

  /** @param {keyof typeof listeners} name */
  function tell(name) {
    for (const listener of listeners[name]) listener();
  }

  async function drive() {
    if (driving || live) return;
    driving = true;
    try {
      while (!match.over && !match.held && !live) {
        /** @type {{ slice: Slice }} */
        const { slice } = await engine.request('ahead', { budgetMs: SLICE_MS });
        take(slice);
        tell('grown');
        if (match.over) tell('over');
      }
    } catch (error) {
      if (!(error instanceof EngineError && error.fatal)) throw error; // the tab tells of an engine that ended
    } finally {
      driving = false;
    }
  }

  /** @param {Slice} slice */
  function take({ frames, front, more, news, finished, fingerprint }) {
    if (frames.length > 0) film.put(frames, front);
    match.log.push(...news.log);
    match.calls.push(...news.log.filter(({ command }) => !FOLLOWING.has(command)));
    match.deeds.push(...news.events);
    Object.assign(match, { outcome: news.outcome, exchanged: news.exchanged, over: !more, finished: finished ?? '', fingerprint });
  }

  return match;
}

/** @typedef {ReturnType<typeof createMatch>} SoccerMatch */
