import { EngineError } from '../engine.js';
import { messageOf } from '../session.js';

/** @import { Engine } from '../engine.js' */
/** @import { Path, Progress, Ray, Scenario, Slice, Task } from './types.js' */

const FIRST_MS = 80; // the longest that a placement is searched for a first plan before the page hears of it
const SLICE_MS = 14; // the longest that a newer placement waits
const ROW = 6;

/** @typedef {'searching' | 'held' | 'ended'} Status a held search was left and can go on as it is */

/** @typedef {{ integrated: number[], cost: (number | null)[], bound: (number | null)[], ms: number[] }} Curve incumbent and bound */

/**
 * The search on screen. It asks for the next slice when the last one was answered; of scenarios only the latest counts.
 *
 * @param {Pick<Engine, 'request'>} engine
 */
export function createPlanner(engine) {
  /** @type {Record<'task' | 'slice' | 'ended', (() => void)[]>} */
  const listeners = { task: [], slice: [], ended: [] };
  /** @type {{ scenario: Scenario, settle: (refusal: string) => void } | null} */
  let wanted = null;
  /** @type {Promise<void> | null} */
  let driving = null;
  let epoch = 0; // raised when the worker has ended

  const planner = {
    /** @type {Scenario | null} the last one that the engine took */
    scenario: null,
    /** @type {Task | null} */
    task: null,
    /** @type {Progress | null} */
    progress: null,
    /** @type {Path | null} the best plan */
    found: null,
    /** Whether `found` belongs to an earlier placement, the search for this one having found none yet. */
    stale: false,
    /** @type {string[]} what each behaviour runs into at once, where there is no plan */
    blocked: [],
    /** @type {Status} */
    status: 'held',
    /** Milliseconds of computing. */
    ms: 0,
    /** @type {Curve} */
    curve: { integrated: [], cost: [], bound: [], ms: [] },
    /** Rows of the frontier, the first `rowCount` of them. */
    rows: new Float32Array(64 * ROW),
    rowCount: 0,

    /** @param {'task' | 'slice' | 'ended'} name @param {() => void} listener */
    on: (name, listener) => void listeners[name].push(listener),

    /**
     * Plans for another scenario; the present one goes on when it is refused.
     *
     * @param {Scenario} scenario
     * @returns {Promise<string>} why it was refused; empty when it was taken, or when a later one came first
     */
    open(scenario) {
      wanted?.settle('');
      const taken = new Promise((resolve) => (wanted = { scenario, settle: resolve }));
      void drive();
      return /** @type {Promise<string>} */ (taken);
    },

    /** Ends the search; best plan and bound stay. */
    async cancel() {
      if (planner.status !== 'searching') return;
      planner.status = 'held'; // asks for nothing more
      await driving;
      if (planner.status === 'held' && planner.task) take((await engine.request('cancel')).slice);
    },

    /** Stops asking. */
    hold() {
      if (planner.status === 'searching') planner.status = 'held';
    },

    /** Goes on, after a limit with as much again as the scenario grants. */
    async resume() {
      if (!planner.task || !planner.scenario || planner.status === 'searching') return;
      if (planner.status === 'ended') {
        const { budget, memory } = planner.scenario;
        take((await engine.request('extend', { integrations: budget, megabytes: memory })).slice);
        if (planner.progress?.outcome) return; // one that ended otherwise stays ended
      }
      planner.status = 'searching';
      tell('slice');
      void drive();
    },

    /** Carries out a sequence. @param {string} letters @returns {Promise<Path>} */
    follow: async (letters) => (await engine.request('follow', { letters })).path,

    /**
     * Carries out a sequence from moved starts.
     *
     * @param {string} letters
     * @param {number} jitter metres
     * @param {number} first
     * @param {number} count
     * @returns {Promise<{ rays: Ray[], middles: Float32Array }>}
     */
    fan: (letters, jitter, first, count) => engine.request('fan', { letters, jitter, first, count }),

    /** Forgets what was asked; for a worker that has ended. */
    abandon() {
      epoch += 1;
      wanted?.settle('');
      wanted = null;
      driving = null;
      planner.hold();
    },
  };

  /** @param {'task' | 'slice' | 'ended'} name */
  function tell(name) {
    for (const listener of listeners[name]) listener();
  }

  function drive() {
    driving ??= work(epoch).finally(() => (driving = null));
    return driving;
  }

  /** @param {number} mine */
  async function work(mine) {
    try {
      while (mine === epoch && (wanted !== null || planner.status === 'searching')) {
        if (wanted !== null) await openWanted(wanted);
        else {
          const { slice } = await engine.request('search', { budgetMs: SLICE_MS });
          if (mine === epoch && wanted === null) take(slice);
        }
      }
    } catch (error) {
      if (!(error instanceof EngineError && error.fatal)) throw error; // the tab tells of an engine that ended
    }
  }

  /** @param {NonNullable<typeof wanted>} asked */
  async function openWanted(asked) {
    try {
      /** @type {{ task: Task, slice: Slice }} */
      const { task, slice } = await engine.request('open', { scenario: JSON.stringify(asked.scenario), budgetMs: FIRST_MS });
      if (wanted === asked) wanted = null;
      begin(asked.scenario, task);
      take(slice);
      asked.settle('');
    } catch (error) {
      if (wanted === asked) wanted = null;
      asked.settle(messageOf(error));
      if (error instanceof EngineError && error.fatal) throw error;
    }
  }

  /** @param {Scenario} scenario @param {Task} task */
  function begin(scenario, task) {
    Object.assign(planner, { scenario, task, progress: null, stale: planner.found !== null, blocked: [], status: 'searching', ms: 0, rowCount: 0 });
    planner.curve = { integrated: [], cost: [], bound: [], ms: [] };
    tell('task');
  }

  /** @param {Slice} slice */
  function take({ progress, rows, found, blocked, ms }) {
    planner.progress = progress;
    planner.ms += ms;
    planner.blocked = blocked;
    keepRows(rows);
    if (found) {
      planner.found = found;
      planner.stale = false;
    }
    if (progress.outcome !== null) {
      planner.status = 'ended';
      if (progress.plan === null) planner.found = null;
      planner.stale = false;
    }
    const { curve } = planner;
    const last = curve.integrated.length - 1;
    if (last < 0 || curve.integrated[last] !== progress.integrated || curve.bound[last] !== progress.lower_bound) {
      curve.integrated.push(progress.integrated);
      curve.cost.push(progress.cost);
      curve.bound.push(progress.lower_bound);
      curve.ms.push(planner.ms);
    }
    tell('slice');
    if (progress.outcome !== null) tell('ended');
  }

  /** @param {Float32Array} rows */
  function keepRows(rows) {
    const used = planner.rowCount * ROW;
    if (used + rows.length > planner.rows.length) {
      const larger = new Float32Array(Math.max(planner.rows.length * 2, used + rows.length));
      larger.set(planner.rows.subarray(0, used));
      planner.rows = larger;
    }
    planner.rows.set(rows, used);
    planner.rowCount += Math.floor(rows.length / ROW);
  }

  return planner;
}

/** @typedef {ReturnType<typeof createPlanner>} Planner */
