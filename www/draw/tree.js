import { cluster, hierarchy } from 'd3-hierarchy';

/** @import { TreeNode } from '../types.js' */

/**
 * @typedef {object} Box a place for a node: its mark stands at (x, y), its label to the right
 * @property {number} id
 * @property {number} x
 * @property {number} y
 * @property {number} level 1 for the root
 * @property {number} position among its siblings, from 1
 * @property {number} siblings
 * @property {number} children
 * @property {boolean} hidden inside a collapsed subtree
 */

/** @typedef {{ boxes: Box[], links: string[], width: number, height: number }} Drawing */

export const ROW = 28;
const INDENT = 14;
const TIGHT_INDENT = 10; // where room is short
const TIGHT = 310;
const COLUMN = 52;
const MARGIN = 12;

/** Symbols of the control nodes; a leaf has none. @param {string} kind */
export const symbolOf = (kind) => /** @type {Record<string, string>} */ ({ Sequence: '→', Fallback: '?', Parallel: '⇒' })[kind] ?? '';

/**
 * A row for each node, indented by depth: the form for narrow places.
 *
 * @param {TreeNode[]} nodes preorder
 * @param {Set<number>} collapsed
 * @param {(node: TreeNode) => number} widthOf width of a node's mark and label, pixels
 * @param {number} room pixels
 * @returns {Drawing}
 */
export function indented(nodes, collapsed, widthOf, room) {
  const indent = room < TIGHT ? TIGHT_INDENT : INDENT;
  const boxes = relations(nodes, collapsed);
  const links = [];
  let row = 0;
  let width = 0;
  for (const box of boxes) {
    if (box.hidden) continue;
    box.x = MARGIN + (box.level - 1) * indent;
    box.y = row * ROW + ROW / 2;
    row += 1;
    width = Math.max(width, box.x + widthOf(nodes[box.id]));
    const parent = nodes[box.id].parent;
    if (parent !== null) links.push(`M${boxes[parent].x} ${boxes[parent].y + 9}V${box.y}H${box.x - 9}`);
  }
  return { boxes, links, width, height: row * ROW };
}

/**
 * A drawing that grows to the right: the form for wide places.
 *
 * @param {TreeNode[]} nodes preorder
 * @param {Set<number>} collapsed
 * @param {(node: TreeNode) => number} widthOf
 * @returns {Drawing}
 */
export function tidy(nodes, collapsed, widthOf) {
  const boxes = relations(nodes, collapsed);
  const children = (/** @type {Box} */ box) => (collapsed.has(box.id) ? [] : boxes.filter((other) => nodes[other.id].parent === box.id));
  // every leaf has a row of its own, since names run to the right; the depth of a node is its own, not its height
  const root = cluster()
    .nodeSize([ROW, COLUMN])
    .separation(() => 1)(/** @type {any} */ (hierarchy(boxes[0], children)));
  let least = Infinity;
  root.each((place) => (least = Math.min(least, place.x)));
  const links = [];
  let width = 0;
  let height = 0;
  for (const place of root.descendants()) {
    const box = /** @type {Box} */ (/** @type {unknown} */ (place.data));
    box.x = MARGIN + place.depth * COLUMN;
    box.y = place.x - least + ROW / 2;
    width = Math.max(width, box.x + widthOf(nodes[box.id]));
    height = Math.max(height, box.y + ROW / 2);
    if (!place.parent) continue;
    const parent = /** @type {Box} */ (/** @type {unknown} */ (place.parent.data));
    const middle = box.x - COLUMN / 2 + 4;
    links.push(`M${parent.x + 9} ${parent.y}H${middle}V${box.y}H${box.x - 9}`);
  }
  return { boxes, links, width, height };
}

/** @param {TreeNode[]} nodes @param {Set<number>} collapsed @returns {Box[]} */
function relations(nodes, collapsed) {
  /** @type {Box[]} */
  const boxes = [];
  for (const { id, parent } of nodes) {
    const above = parent === null ? null : boxes[parent];
    if (above) above.children += 1;
    boxes.push({
      id,
      x: 0,
      y: 0,
      level: above ? above.level + 1 : 1,
      position: above ? above.children : 1,
      siblings: 1,
      children: 0,
      hidden: above !== null && (above.hidden || collapsed.has(above.id)),
    });
  }
  for (const { id, parent } of nodes) if (parent !== null) boxes[id].siblings = boxes[parent].children;
  return boxes;
}

/**
 * A program in one line: the leaves of a tree without the shape, actions first, since they tell most; of a machine the
 * states that its rules go to.
 *
 * @param {string} written such as `Sel[Post(IsCarrying Food) Seq[Pre(IsVisitedBefore Hub) Act(Explore)]]`
 */
export function gist(written) {
  const states = new Set([...written.matchAll(/Goto\([^,]+, ([^)]+)\)/g)].map(([, state]) => state));
  if (states.size > 0) return [...states].join(' · ');
  const leaves = [...written.matchAll(/(\w+)\(([^)]*)\)/g)];
  if (leaves.length === 0) return written;
  leaves.sort((a, b) => Number(b[1] === 'Act') - Number(a[1] === 'Act'));
  return leaves.map(([, , leaf]) => leaf).join(' · ');
}
