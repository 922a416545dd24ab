/** @import { BenchNode, Moment, Status } from '../trees/types.js' */

/**
 * @typedef {object} NodeState how a node stands
 * @property {'' | 'S' | 'F' | 'R' | 'K' | 'E'} letter what it returned; `E` for the node at fault
 * @property {'now' | 'kept' | 'earlier' | 'never'} when in this tick; not ticked now but still RUNNING; before; never
 * @property {number | null} tick in which it last returned
 * @property {number} count returns in this tick
 * @property {boolean} halted while RUNNING in this tick
 * @property {string} error message, when it is the node at fault
 * @property {{ running: number, then: Status, done: number } | null} answer of a scripted leaf; `done` RUNNING of those
 */

/** @type {NodeState} */
const BLANK = { letter: '', when: 'never', tick: null, count: 0, halted: false, error: '', answer: null };

/**
 * What a moment says about each node.
 *
 * @param {BenchNode[]} nodes
 * @param {Moment | null} moment
 * @returns {(id: number) => NodeState}
 */
export function readMoment(nodes, moment) {
  if (!moment) return () => BLANK;
  const counts = new Map();
  for (const [id] of moment.trace) counts.set(id, (counts.get(id) ?? 0) + 1);
  const halted = new Set(moment.halted);
  const progress = new Map(moment.progress);
  const answers = new Map(moment.answers.map((answer) => [answer.leaf, answer]));
  return (id) => {
    const node = nodes[id];
    const answer = node.scripted ? answers.get(node.name) : undefined;
    return {
      ...statusOf(moment, id),
      tick: moment.last[id] ?? null,
      count: counts.get(id) ?? 0,
      halted: halted.has(id),
      error: moment.error?.node === id ? moment.error.message : '',
      answer: answer ? { running: answer.running, then: answer.then, done: progress.get(id) ?? 0 } : null,
    };
  };
}

/** @param {Moment} moment @param {number} id @returns {Pick<NodeState, 'letter' | 'when'>} */
function statusOf(moment, id) {
  if (moment.error?.node === id) return { letter: 'E', when: 'now' };
  if (ticked(moment, id)) return { letter: letterOf(moment.ticked[id]), when: 'now' };
  if (moment.kept[id] === 'R') return { letter: 'R', when: 'kept' };
  const letter = letterOf(moment.lastStatus[id]);
  return { letter, when: letter ? 'earlier' : 'never' };
}

/** Whether a node was ticked in this tick, or stopped it. @param {Moment} moment @param {number} id */
export const ticked = (moment, id) => (moment.ticked[id] ?? '.') !== '.' || moment.error?.node === id;

/** @param {string | undefined} letter @returns {NodeState['letter']} */
const letterOf = (letter) => (letter && letter !== '.' ? /** @type {NodeState['letter']} */ (letter) : '');
