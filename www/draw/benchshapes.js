/** @import { BenchNode } from '../trees/types.js' */

/**
 * @typedef {object} Sign what a control node carries beside its name
 * @property {'sequence' | 'fallback' | 'parallel' | 'word'} kind
 * @property {string} word for `word`: what is written
 * @property {'R' | '*' | '**' | ''} corner R asks from the first child in every tick, * goes on with the child that was
 *   RUNNING, ** keeps its place after a FAILURE and a halt too
 */

/** Statuses about the origin, 10 wide, in relative steps; `R` and `H` are filled, the others are lines. @type {Record<string, string>} */
export const GLYPHS = {
  S: 'm-4.5 .5l3 3l6 -7',
  F: 'm-3.5 -3.5l7 7m0 -7l-7 7',
  R: 'm-3 -4.5l8 4.5l-8 4.5z',
  K: 'm-4 0h8',
  H: 'm-3.5 -3.5h7v7h-7z',
  E: 'm0 -5v6m0 2.5v1.5',
};

/** Arrows of the control nodes, about the origin, in relative steps. @type {Record<string, string>} */
export const ARROWS = {
  sequence: 'm-7 0h13m-4 -4l4.5 4l-4.5 4',
  parallel: 'm-7 -2h11m-11 4h11m-2 -7.5l5.5 5.5l-5.5 5.5',
};

/** A path of relative steps, larger. @param {string} path @param {number} factor */
export const enlarged = (path, factor) => path.replace(/-?[\d.]+/g, (number) => String(Number(number) * factor));

/** @type {Record<string, [Sign['kind'], string, Sign['corner']]>} */
const SIGNS = {
  Sequence: ['sequence', '', '*'],
  AsyncSequence: ['sequence', '', '*'],
  SequenceWithMemory: ['sequence', '', '**'],
  ReactiveSequence: ['sequence', '', 'R'],
  Fallback: ['fallback', '', '*'],
  AsyncFallback: ['fallback', '', '*'],
  ReactiveFallback: ['fallback', '', 'R'],
  Parallel: ['parallel', '', ''],
  ParallelAll: ['parallel', '', ''],
  IfThenElse: ['word', 'if', '*'],
  WhileDoElse: ['word', 'if', 'R'],
  TryCatch: ['word', 'try', ''],
};

/** The sign of a control node; null for all others and for control nodes that only a model declares. @param {BenchNode} node @returns {Sign | null} */
export function signOf(node) {
  const [kind, word, corner] = SIGNS[node.type] ?? (/^Switch[2-6]$/.test(node.type) ? ['word', 'case', ''] : []);
  return node.category === 'control' && kind ? { kind, word: word ?? '', corner: corner ?? '' } : null;
}

const POINT = 9; // length of a decorator's points

/** Room that the ends of a shape take from its text. @param {BenchNode['category']} category */
export const endsOf = (category) => (category === 'condition' ? 5 : category === 'decorator' ? POINT - 3 : 0);

/**
 * The outline of a node as path data: boxes for actions and control nodes, round ends for conditions, points for
 * decorators.
 *
 * @param {BenchNode['category']} category
 * @param {number} x
 * @param {number} y
 * @param {number} w
 * @param {number} h
 */
export function outline(category, x, y, w, h) {
  if (category === 'decorator') {
    const middle = y + h / 2;
    return `M${x + POINT} ${y}H${x + w - POINT}L${x + w} ${middle}L${x + w - POINT} ${y + h}H${x + POINT}L${x} ${middle}Z`;
  }
  const r = category === 'condition' ? h / 2 : category === 'action' ? 4 : 1;
  const turn = (/** @type {number} */ dx, /** @type {number} */ dy) => `a${r} ${r} 0 0 1 ${dx} ${dy}`;
  return `M${x + r} ${y}H${x + w - r}${turn(r, r)}V${y + h - r}${turn(-r, r)}H${x + r}${turn(-r, -r)}V${y + r}${turn(r, -r)}Z`;
}
