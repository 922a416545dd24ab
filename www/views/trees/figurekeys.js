/** @import { BenchNode, Status } from '../../trees/types.js' */
/** @import { Layout, Way } from '../../draw/benchlayout.js' */

/** @type {Record<Way, Record<string, 'parent' | 'child' | 'before' | 'after'>>} */
const ARROWS = {
  down: { ArrowUp: 'parent', ArrowDown: 'child', ArrowLeft: 'before', ArrowRight: 'after' },
  right: { ArrowLeft: 'parent', ArrowRight: 'child', ArrowUp: 'before', ArrowDown: 'after' },
};

/** @type {Record<string, Status>} */
const ANSWERS = { s: 'SUCCESS', f: 'FAILURE', r: 'RUNNING', k: 'SKIPPED' };

/**
 * @typedef {object} KeyMeaning what a key on a node asks for
 * @property {number} [go] node to focus
 * @property {boolean} [fold] fold, or unfold
 * @property {Status} [answer]
 * @property {boolean} [press]
 * @property {boolean} [clear]
 */

/**
 * What a key on the focused node means; null when it means nothing here.
 *
 * @param {string} key
 * @param {{ nodes: BenchNode[], layout: Layout, folded: Set<number>, way: Way, focused: number }} at
 * @returns {KeyMeaning | null}
 */
export function meaningOf(key, { nodes, layout, folded, way, focused }) {
  const spot = layout.spots[focused];
  const node = nodes[focused];
  const inner = spot.children.length > 0;
  const closed = inner && folded.has(focused);
  if (key === 'Enter' || key === ' ') return { press: true };
  if (key === 'Escape') return { clear: true };
  if (key === 'Home') return { go: 0 };
  if (key === 'End') return { go: layout.shown[layout.shown.length - 1].id };
  if (key === '+' || key === '=') return closed ? { fold: false } : {};
  if (key === '-') return inner && !closed ? { fold: true } : {};
  const answer = node.scripted ? ANSWERS[key.toLowerCase()] : undefined;
  if (answer) return { answer };
  const move = ARROWS[way][key];
  if (!move) return null;
  if (move === 'child') return closed ? { fold: false } : inner ? { go: spot.children[0] } : {};
  if (node.parent === null) return {};
  if (move === 'parent') return { go: node.parent };
  const beside = layout.spots[node.parent].children[spot.position - 1 + (move === 'after' ? 1 : -1)];
  return beside === undefined ? {} : { go: beside };
}

/**
 * Two names for each node by which an edited tree is compared with the one before: by names, and by places.
 *
 * @param {BenchNode[]} nodes
 */
export function pathsOf(nodes) {
  /** @type {string[]} */
  const named = [];
  /** @type {string[]} */
  const placed = [];
  /** @type {Map<string, number>[]} */
  const counts = [];
  for (const { id, parent, type, name } of nodes) {
    counts[id] = new Map();
    const above = parent === null ? new Map() : counts[parent];
    const own = `${type} ${name}`;
    const nth = above.get(own) ?? 0;
    const place = above.get('') ?? 0;
    above.set(own, nth + 1);
    above.set('', place + 1);
    named[id] = `${parent === null ? '' : named[parent]}/${own}#${nth}`;
    placed[id] = `${parent === null ? '' : placed[parent]}/${place}`;
  }
  return { named, placed };
}

/**
 * Where nodes of one tree are in another: the node of the same path by names, or else the one at the same place if it
 * is of the same category.
 *
 * @param {BenchNode[]} before
 * @param {BenchNode[]} after
 * @returns {(id: number) => number | null}
 */
export function followNodes(before, after) {
  const [from, to] = [pathsOf(before), pathsOf(after)];
  const byName = new Map(to.named.map((path, id) => [path, id]));
  const byPlace = new Map(to.placed.map((path, id) => [path, id]));
  return (id) => {
    const same = byName.get(from.named[id]);
    if (same !== undefined) return same;
    const there = byPlace.get(from.placed[id]);
    return there !== undefined && after[there].category === before[id].category ? there : null;
  };
}
