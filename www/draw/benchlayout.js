import { hierarchy, tree } from 'd3-hierarchy';
import { endsOf, signOf } from './benchshapes.js';

/** @import { BenchNode } from '../trees/types.js' */
/** @import { Sign } from './benchshapes.js' */

/** @typedef {'down' | 'right'} Way top-down as in papers, or left to right with a row for each leaf */
/** @typedef {(text: string, size: 'name' | 'small' | 'word') => number} Measure width of a text, pixels */

/**
 * @typedef {object} Label what is written in a node, and the room it takes
 * @property {Sign | null} sign
 * @property {{ text: string, size: 'name' | 'small', x: number, y: number }[]} lines baselines, from the node's corner
 * @property {number} signWidth
 * @property {number} w
 * @property {number} h
 * @property {boolean} whole false when something was shortened
 */

/**
 * @typedef {object} Spot a place for a node: (x, y) is its upper left corner
 * @property {number} id
 * @property {number} x
 * @property {number} y
 * @property {number} w
 * @property {number} h
 * @property {number} level 1 for the root
 * @property {number} position among its siblings, from 1
 * @property {number} siblings
 * @property {number[]} children shown or not
 * @property {boolean} shown false inside a folded node
 * @property {string} edge path data from its parent
 */

/** @typedef {{ spots: Spot[], shown: Spot[], links: string, width: number, height: number }} Layout links: all edges, no line twice */

export const SLOT = 22; // room for the status at the right end
export const BADGE = { width: 68, height: 24, gap: 5 };
const PAD = 10;
const SIGN = 28;
export const CORNER = { '': 0, R: 10, '*': 6, '**': 12 }; // room for what is raised beside a sign
const NAME_ROOM = 168;
const SMALL_ROOM = 132;
const LEAST = 72;
const LINE = 14;
const ROW_HEIGHT = 26;
const SIBLING_GAP = 18;
const COUSIN_GAP = 28;
const LEVEL_GAP = 42;
const COLUMN_GAP = 32;
const STEP = 6; // pixels, see `straighten`
export const MARGIN = 28;

/**
 * What is written in each node: the name, the type where it differs, the ports where there is room.
 *
 * @param {BenchNode[]} nodes
 * @param {Way} way
 * @param {Measure} measure
 * @returns {Label[]}
 */
export function labelsOf(nodes, way, measure) {
  return nodes.map((node) => {
    const sign = signOf(node);
    const ends = endsOf(node.category);
    const signWidth = sign ? (sign.kind === 'word' ? Math.ceil(measure(sign.word, 'word')) + 14 : SIGN) + CORNER[sign.corner] : 0;
    const left = (sign ? signWidth + 7 : PAD) + ends;
    const name = shorten(node.name, NAME_ROOM, (text) => measure(text, 'name'));
    const small = (/** @type {string} */ text, /** @type {number} */ room) => shorten(text, room, (part) => measure(part, 'small'));
    const nameWidth = measure(name, 'name');
    const type = small(typeOf(node, nodes), SMALL_ROOM);
    const typeWidth = type ? measure(type, 'small') : 0;
    const ports = small(portsOf(node), way === 'down' ? Math.max(nameWidth, typeWidth, SMALL_ROOM) : SMALL_ROOM);
    const texts = [name, type, ports].filter((text) => text !== '');
    const whole = name === node.name && !texts.slice(1).some((text) => text.endsWith('…'));
    /** @type {Label['lines']} */
    const lines = [];
    let x = left;
    texts.forEach((text, row) => {
      const size = row === 0 ? 'name' : 'small';
      lines.push(way === 'down' ? { text, size, x: left, y: (texts.length === 1 ? 20.5 : 18) + row * LINE } : { text, size, x, y: 17.5 });
      x += measure(text, size) + 8;
    });
    const inner = way === 'down' ? Math.max(...texts.map((text, row) => measure(text, row === 0 ? 'name' : 'small'))) : x - left - 8;
    const w = Math.max(2 * Math.ceil((left + inner + 6 + SLOT + ends) / 2), LEAST);
    return { sign, lines, signWidth, w, h: way === 'down' ? 18 + LINE * texts.length : ROW_HEIGHT, whole };
  });
}

/** The second line: the type where the name does not say it; of a subtree the tree's ID. @param {BenchNode} node @param {BenchNode[]} nodes */
function typeOf(node, nodes) {
  if (node.category !== 'subtree') return node.name === node.type ? '' : node.type;
  const definition = nodes[node.id + 1]?.parent === node.id ? nodes[node.id + 1].definition : '';
  return definition === '' || definition === node.name ? node.type : `${node.type} ${definition}`;
}

/** Ports in short. @param {BenchNode} node */
export const portsOf = (node) => node.ports.map(([name, value]) => `${name}=${value}`).join(' ');

/**
 * The longest beginning that fits, with an ellipsis when something is missing.
 *
 * @param {string} text
 * @param {number} room
 * @param {(text: string) => number} width
 */
export function shorten(text, room, width) {
  if (width(text) <= room) return text;
  let fits = 0;
  let over = text.length;
  while (over - fits > 1) {
    const middle = (fits + over) >> 1;
    if (width(`${text.slice(0, middle)}…`) <= room) fits = middle;
    else over = middle;
  }
  return `${text.slice(0, fits).trimEnd()}…`;
}

/**
 * Places for all nodes that no folded node hides.
 *
 * @param {BenchNode[]} nodes preorder
 * @param {Label[]} labels
 * @param {Set<number>} folded
 * @param {Way} way
 * @param {number} row least height of a row of `right`
 * @returns {Layout}
 */
export function place(nodes, labels, folded, way, row) {
  const spots = relations(nodes, labels, folded);
  const shown = spots.filter((spot) => spot.shown);
  if (shown.length === 0) return { spots, shown, links: '', width: 0, height: 0 };
  if (way === 'down') placeDown(nodes, spots, shown, folded);
  else placeRight(nodes, spots, shown, row);
  let width = 0;
  let height = 0;
  for (const { id, x, y, w, h } of shown) {
    const badge = nodes[id].scripted ? BADGE : { width: 0, height: 0, gap: 0 };
    width = Math.max(width, x + w + (way === 'right' ? badge.width + badge.gap : 0));
    height = Math.max(height, y + h + (way === 'down' ? badge.height + badge.gap : 0));
  }
  const open = shown.filter((spot) => spot.children.length > 0 && !folded.has(spot.id));
  const links = open.map((spot) => linksBelow(spot, spot.children.map((id) => spots[id]), way));
  return { spots, shown, links: links.join(''), width: width + MARGIN, height: height + MARGIN };
}

/** The edges of one node: lines drawn over each other would look heavier. @param {Spot} spot @param {Spot[]} children @param {Way} way */
function linksBelow(spot, children, way) {
  const [first, last] = [children[0], children[children.length - 1]];
  if (way === 'right') {
    const x = spot.x + spot.w;
    const stubs = children.slice(1).map((child) => `M${x + COLUMN_GAP / 2} ${child.y + child.h / 2}H${child.x}`);
    const bus = stubs.length > 0 ? `M${x + COLUMN_GAP / 2} ${spot.y + spot.h / 2}V${last.y + last.h / 2}` : '';
    return `M${x} ${spot.y + spot.h / 2}H${first.x}${bus}${stubs.join('')}`;
  }
  const y = busOf(first);
  const middle = (/** @type {Spot} */ child) => child.x + child.w / 2;
  return `M${middle(spot)} ${spot.y + spot.h}V${y}M${middle(first)} ${y}H${middle(last)}${children.map((child) => `M${middle(child)} ${y}V${child.y}`).join('')}`;
}

/** Height of the line that joins a node and those beside it. @param {Spot} spot */
const busOf = (spot) => spot.y - LEVEL_GAP / 2 + 4;

/** @param {BenchNode[]} nodes @param {Label[]} labels @param {Set<number>} folded @returns {Spot[]} */
function relations(nodes, labels, folded) {
  /** @type {Spot[]} */
  const spots = [];
  for (const { id, parent } of nodes) {
    const above = parent === null ? null : spots[parent];
    above?.children.push(id);
    const { w, h } = labels[id];
    const shown = above === null || (above.shown && !folded.has(above.id));
    const [level, position] = above ? [above.level + 1, above.children.length] : [1, 1];
    spots.push({ id, x: 0, y: 0, w, h, level, position, siblings: 1, children: [], shown, edge: '' });
  }
  for (const { id, parent } of nodes) if (parent !== null) spots[id].siblings = spots[parent].children.length;
  return spots;
}

/** @param {BenchNode[]} nodes @param {Spot[]} spots @param {Spot[]} shown @param {Set<number>} folded */
function placeDown(nodes, spots, shown, folded) {
  const children = (/** @type {Spot} */ spot) => (folded.has(spot.id) ? null : spot.children.map((id) => spots[id]));
  const root = tree()
    .nodeSize([1, 1])
    .separation((a, b) => {
      const [one, other] = /** @type {[Spot, Spot]} */ (/** @type {unknown} */ ([a.data, b.data]));
      return (one.w + other.w) / 2 + (a.parent === b.parent ? SIBLING_GAP : COUSIN_GAP);
    })(/** @type {any} */ (hierarchy(spots[0], children)));
  let least = Infinity;
  root.each((point) => {
    const spot = /** @type {Spot} */ (/** @type {unknown} */ (point.data));
    spot.x = Math.round(point.x) - spot.w / 2;
    least = Math.min(least, spot.x);
  });
  /** @type {number[]} */
  const heights = [];
  for (const { id, level, h } of shown) heights[level] = Math.max(heights[level] ?? 0, h + (nodes[id].scripted ? BADGE.height + BADGE.gap : 0));
  const tops = [0, MARGIN];
  for (let level = 1; level < heights.length; level += 1) tops[level + 1] = tops[level] + heights[level] + LEVEL_GAP;
  straighten(nodes, spots, shown, folded);
  for (const spot of shown) {
    spot.x += MARGIN - least;
    spot.y = tops[spot.level];
    const { parent } = nodes[spot.id];
    if (parent === null) continue;
    const above = spots[parent];
    spot.edge = `M${above.x + above.w / 2} ${above.y + above.h}V${busOf(spot)}H${spot.x + spot.w / 2}V${spot.y}`;
  }
}

/**
 * Moves children that stand almost under their parent right under it: a tiny step in an edge looks like a mistake.
 *
 * @param {BenchNode[]} nodes
 * @param {Spot[]} spots
 * @param {Spot[]} shown
 * @param {Set<number>} folded
 */
function straighten(nodes, spots, shown, folded) {
  for (const spot of shown) {
    if (spot.children.length < 3 || folded.has(spot.id)) continue;
    for (const id of spot.children.slice(1, -1)) {
      const by = spot.x + spot.w / 2 - spots[id].x - spots[id].w / 2;
      if (by !== 0 && Math.abs(by) <= STEP) for (let below = id; below < nodes[id].end; below += 1) spots[below].x += by;
    }
  }
}

/**
 * A node stands in the row of its first leaf, so that the drawing is read from its upper left corner in the order of
 * the ticks, and a parent is never far above its first child.
 *
 * @param {BenchNode[]} nodes
 * @param {Spot[]} spots
 * @param {Spot[]} shown
 * @param {number} row
 */
function placeRight(nodes, spots, shown, row) {
  let rows = 0;
  for (const spot of shown) {
    const { parent } = nodes[spot.id];
    const above = parent === null ? null : spots[parent];
    spot.x = above ? above.x + above.w + COLUMN_GAP : MARGIN;
    if (above && spot.position > 1) rows += 1;
    spot.y = MARGIN + rows * row;
    if (!above) continue;
    const middle = spot.y + spot.h / 2;
    const bend = spot.position > 1 ? `H${above.x + above.w + COLUMN_GAP / 2}V${middle}` : '';
    spot.edge = `M${above.x + above.w} ${above.y + above.h / 2}${bend}H${spot.x}`;
  }
}
