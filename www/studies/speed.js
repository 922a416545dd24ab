import { recall, remember } from '../ui/storage.js';

/** @import { Plan } from './types.js' */

const KEPT = 60;
const ENOUGH = 4; // runs, before a time is named
const NAME = 'studies-speed';

/** @typedef {[low: number, high: number]} Range seconds */
/** @typedef {{ cell: number, seconds: number }} Timed a run that was made here */

/**
 * What this computer's workers have made per second, in robots times steps, one number a run, for each world.
 */
export function createSpeed() {
  /** @type {Map<string, number[]>} */
  const worlds = new Map();

  /** @param {string} world */
  function ratesOf(world) {
    const rates = worlds.get(world) ?? (recall(`${NAME}-${world}`) ?? '').split(' ').map(Number).filter((rate) => Number.isFinite(rate) && rate > 0);
    worlds.set(world, rates);
    return rates;
  }

  return {
    /** @param {string} world @param {number} robotSteps @param {number} seconds */
    note(world, robotSteps, seconds) {
      if (seconds <= 0 || robotSteps <= 0) return;
      const kept = ratesOf(world);
      kept.push(Math.round(robotSteps / seconds));
      kept.splice(0, kept.length - KEPT);
      remember(`${NAME}-${world}`, kept.join(' '));
    },

    /** Whether times can be named for a world. @param {string} world */
    knows: (world) => ratesOf(world).length >= ENOUGH,

    /**
     * How long so much takes with so many workers; null before enough runs of that world were made here.
     *
     * @param {string} world
     * @param {number} robotSteps
     * @param {number} workers
     * @returns {Range | null}
     */
    estimate(world, robotSteps, workers) {
      const kept = ratesOf(world);
      if (kept.length < ENOUGH) return null;
      const [slow, fast] = spread(kept);
      return [robotSteps / (fast * workers), robotSteps / (slow * workers)];
    },
  };
}

/** @typedef {ReturnType<typeof createSpeed>} Speed */

/**
 * The seconds that are left, as a range from the runs so far: runs that are missing take as long as those of their cell
 * took, from the quicker to the slower of them. Null before enough runs were made.
 *
 * @param {{ plan: Plan, missing: number[], timed: Timed[], workers: number }} what
 * @returns {Range | null}
 */
export function timeLeft({ plan, missing, timed, workers }) {
  if (timed.length < ENOUGH || missing.length === 0) return null;
  const perStep = timed.map(({ cell, seconds }) => seconds / plan.robot_steps[cell]);
  const cells = plan.cells.map((_, cell) => {
    const own = timed.filter((run) => run.cell === cell).map(({ seconds }) => seconds / plan.robot_steps[cell]);
    const [low, high] = spread(own.length >= ENOUGH ? own : perStep);
    return [low * plan.robot_steps[cell], high * plan.robot_steps[cell]];
  });
  const sum = (/** @type {number} */ end) => missing.reduce((all, run) => all + cells[run % cells.length][end], 0) / Math.min(workers, missing.length);
  return [sum(0), sum(1)];
}

/**
 * The cell whose runs took longest on average; null while only one cell has runs.
 *
 * @param {Plan} plan
 * @param {Timed[]} timed
 */
export function slowest(plan, timed) {
  const cells = plan.cells.map((name, cell) => {
    const own = timed.filter((run) => run.cell === cell);
    return { name, seconds: own.length > 0 ? own.reduce((all, { seconds }) => all + seconds, 0) / own.length : 0 };
  });
  const known = cells.filter(({ seconds }) => seconds > 0).sort((a, b) => b.seconds - a.seconds);
  return known.length > 1 ? known[0] : null;
}

/** The values that a tenth lies below and above. @param {number[]} values @returns {Range} */
function spread(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const at = (/** @type {number} */ share) => sorted[Math.round((sorted.length - 1) * share)];
  return [at(0.1), at(0.9)];
}
