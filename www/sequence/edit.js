/** @import { Form, Scenario, Task } from './types.js' */

/**
 * A thing on the map that can be moved.
 *
 * @typedef {{ kind: 'swarm' | 'target', index: 0 } | { kind: 'obstacle' | 'robot', index: number }} Thing
 *
 * @typedef {object} Place where a thing stands, and its sizes where it has some; metres and radians
 * @property {number} x
 * @property {number} y
 * @property {number} [heading]
 * @property {number} [radius]
 * @property {number} [width]
 * @property {number} [height]
 */

const CENTI = 100;

/** To whole centimetres, which is finer than anybody places by hand. @param {number} metres */
export const rounded = (metres) => Math.round(metres * CENTI) / CENTI;

/** @param {Thing | null} a @param {Thing | null} b */
export const same = (a, b) => a?.kind === b?.kind && a?.index === b?.index;

/** Everything on the map that can be moved, in the order of the keyboard. @param {Task} task @returns {Thing[]} */
export function things({ goal, obstacles, start }) {
  return [
    { kind: 'swarm', index: 0 },
    ...('target' in goal ? [/** @type {Thing} */ ({ kind: 'target', index: 0 })] : []),
    ...obstacles.map((_, index) => /** @type {Thing} */ ({ kind: 'obstacle', index })),
    ...start.map((_, index) => /** @type {Thing} */ ({ kind: 'robot', index })),
  ];
}

/**
 * A scenario whose layout stands in lists, so that moving one thing leaves the others where they are: random obstacles
 * keep away from start and target, and random starts from obstacles.
 *
 * @param {Scenario} scenario
 * @param {Task} task what the engine made of it
 * @returns {Scenario}
 */
export function frozen(scenario, { obstacles, start }) {
  return { ...scenario, obstacles: 0, 'obstacle-list': structuredClone(obstacles), 'start-list': structuredClone(start) };
}

/** The middle of points. @param {number[][]} points */
export function middleOf(points) {
  const sum = points.reduce(([x, y], point) => [x + point[0], y + point[1]], [0, 0]);
  return { x: sum[0] / points.length, y: sum[1] / points.length };
}

/** Where a thing of a frozen scenario stands. @param {Scenario} scenario @param {Thing} thing @returns {Place | null} null when there is none */
export function placeOf(scenario, { kind, index }) {
  if (kind === 'target') return { x: scenario['target-x'], y: scenario['target-y'], radius: scenario['target-radius'] };
  if (kind === 'swarm') return middleOf(scenario['start-list']);
  if (kind === 'robot') {
    const pose = scenario['start-list'][index];
    return pose ? { x: pose[0], y: pose[1], heading: pose[2] } : null;
  }
  const form = /** @type {Form | undefined} */ (scenario['obstacle-list'][index]);
  return form ? formPlace(form) : null;
}

/** @param {Form} form @returns {Place} */
export function formPlace(form) {
  if ('disc' in form) return { x: form.disc[0], y: form.disc[1], radius: form.disc[2] };
  if ('polygon' in form) return middleOf(form.polygon);
  const [left, bottom, right, top] = form.box;
  return { x: (left + right) / 2, y: (bottom + top) / 2, width: right - left, height: top - bottom };
}

/**
 * The scenario with a thing elsewhere or of another size.
 *
 * @param {Scenario} scenario frozen
 * @param {Thing} thing
 * @param {Partial<Place>} to what it is to be; the rest stays
 * @returns {Scenario}
 */
export function placed(scenario, thing, to) {
  const from = placeOf(scenario, thing);
  if (!from) return scenario;
  const dx = (to.x ?? from.x) - from.x;
  const dy = (to.y ?? from.y) - from.y;
  const { kind, index } = thing;
  if (kind === 'target') {
    return { ...scenario, 'target-x': rounded(from.x + dx), 'target-y': rounded(from.y + dy), 'target-radius': to.radius ?? from.radius };
  }
  if (kind === 'obstacle') {
    const list = scenario['obstacle-list'].map((/** @type {Form} */ form, /** @type {number} */ at) => (at === index ? movedForm(form, dx, dy, to) : form));
    return { ...scenario, 'obstacle-list': list };
  }
  const list = scenario['start-list'].map((/** @type {number[]} */ [x, y, heading], /** @type {number} */ at) => {
    const moves = kind === 'swarm' || at === index;
    return moves ? [rounded(x + dx), rounded(y + dy), kind === 'robot' ? (to.heading ?? heading) : heading] : [x, y, heading];
  });
  return { ...scenario, 'start-list': list };
}

/** @param {Form} form @param {number} dx @param {number} dy @param {Partial<Place>} to @returns {Form} */
function movedForm(form, dx, dy, to) {
  if ('disc' in form) {
    const [x, y, radius] = form.disc;
    return { disc: [rounded(x + dx), rounded(y + dy), to.radius ?? radius] };
  }
  if ('polygon' in form) return { polygon: form.polygon.map(([x, y]) => [rounded(x + dx), rounded(y + dy)]) };
  const [left, bottom, right, top] = form.box;
  const x = (left + right) / 2 + dx;
  const y = (bottom + top) / 2 + dy;
  const width = to.width ?? right - left;
  const height = to.height ?? top - bottom;
  return { box: [rounded(x - width / 2), rounded(y - height / 2), rounded(x + width / 2), rounded(y + height / 2)] };
}

/** @param {Scenario} scenario frozen @param {Form} form @returns {Scenario} */
export const added = (scenario, form) => ({ ...scenario, 'obstacle-list': [...scenario['obstacle-list'], form] });

/** @param {Scenario} scenario frozen @param {number} index @returns {Scenario} */
export const removed = (scenario, index) => ({ ...scenario, 'obstacle-list': scenario['obstacle-list'].filter((/** @type {Form} */ _, /** @type {number} */ at) => at !== index) });

/**
 * The convex hull of points, counter-clockwise; what was drawn by hand may have a dent.
 *
 * @param {[number, number][]} points
 * @returns {[number, number][]} fewer than three when they have no inside
 */
export function hull(points) {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const turns = (/** @type {number[]} */ o, /** @type {number[]} */ a, /** @type {number[]} */ b) => (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
  /** @param {[number, number][]} from */
  const half = (from) => {
    /** @type {[number, number][]} */
    const chain = [];
    for (const point of from) {
      while (chain.length > 1 && turns(chain[chain.length - 2], chain[chain.length - 1], point) <= 0) chain.pop();
      chain.push(point);
    }
    return chain.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}
