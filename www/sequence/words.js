import { sequenceText } from '../ui/strings.sequence.en.js';

/** @import { Planner } from './planner.js' */
/** @import { Path, Task } from './types.js' */

const { verdict } = sequenceText;

/** Metres as people read them. @param {number} metres */
export const metres = (metres) => `${metres >= 100 ? metres.toFixed(0) : metres.toFixed(1)} m`;

/** A ratio, rounded up: it is a promise. @param {number} ratio */
export const ratioOf = (ratio) => (Math.ceil(ratio * 1000 - 1e-9) / 1000).toFixed(3);

/**
 * What a search came to so far, in words.
 *
 * @param {Pick<Planner, 'progress' | 'status' | 'blocked' | 'task' | 'found'>} planner
 */
export function verdictOf({ progress, status, blocked, task, found }) {
  if (!progress || !task) return verdict.none;
  const { outcome, cost, proven_ratio: ratio, lower_bound: bound, integrated } = progress;
  const known = cost === null ? '' : ratio === null ? verdict.noProof(metres(cost)) : ratio <= 1 ? verdict.best(metres(cost)) : verdict.within(metres(cost), ratioOf(ratio), metres(bound ?? 0));
  if (outcome === null) {
    const doing = status === 'held' ? verdict.held : verdict.searching;
    return cost === null ? doing(verdict.noPlanYet(integrated)) : doing(known);
  }
  if (outcome === 'proved infeasible') return verdict.infeasible(reasonOf(integrated, blocked, task.library.length));
  if (outcome === 'solved') return ratio !== null && ratio <= 1 ? verdict.optimal(metres(cost ?? 0), found !== null && !/[^.]/.test(found.letters)) : verdict.solved(known);
  if (outcome === 'cancelled') return verdict.cancelled(known || verdict.noPlan);
  return verdict.gaveUp(outcome, known || verdict.noPlan);
}

/** Why there is no plan. @param {number} integrated @param {string[]} blocked @param {number} library */
function reasonOf(integrated, blocked, library) {
  if (integrated === 0) return verdict.outOfReach;
  if (blocked.length >= library - 1 && blocked.length > 0) return verdict.blocked(blocked[0]);
  return verdict.exhausted(integrated);
}

/**
 * What a plan made by hand comes to.
 *
 * @param {Path} path
 * @param {Task} task
 * @param {number | null} best the planner's cost
 */
export function handWords({ letters, replay }, task, best) {
  const { collision, goal, total } = replay;
  if (collision) {
    const name = task.library.find(({ letter }) => letter === letters[collision.interval])?.name ?? '';
    const seconds = collision.interval * task.interval + collision.step / 10;
    return sequenceText.hand.collides(name, collision.robot + 1, collision.obstacle === null ? null : collision.obstacle + 1, seconds);
  }
  if (!goal) return sequenceText.hand.misses(metres(total));
  if (best === null) return sequenceText.hand.reaches(metres(total));
  return sequenceText.hand.against(metres(total), total / best - 1);
}

/** The kind of result, for styles and tests. @param {Pick<Planner, 'progress'>} planner */
export function kindOf({ progress }) {
  const { outcome = null, proven_ratio: ratio = null } = progress ?? {};
  if (outcome === null) return 'searching';
  if (outcome === 'solved') return ratio !== null && ratio <= 1 ? 'optimal' : 'solved';
  if (outcome === 'proved infeasible') return 'infeasible';
  return outcome === 'cancelled' ? 'cancelled' : 'gave-up';
}
