/** @import { Layout } from '../types.js' */

/**
 * Where each number of a frame stands: looked up once per world, so that drawing only adds and reads.
 *
 * @param {Layout} layout
 */
export function locate(layout) {
  const { agents, items, counts } = layout;
  /** @param {string} name */
  const count = (name) => counts.offset + counts.fields.indexOf(name);
  return {
    agents: agents.count,
    agentStart: agents.offset,
    agentStride: agents.stride,
    x: agents.fields.indexOf('x'),
    y: agents.fields.indexOf('y'),
    heading: agents.fields.indexOf('heading'),
    carrying: agents.fields.indexOf('carrying'),
    action: agents.fields.indexOf('action'),
    alive: agents.fields.indexOf('alive'),
    items: items.count,
    itemStart: items.offset,
    itemStride: items.stride,
    itemX: items.fields.indexOf('x'),
    itemY: items.fields.indexOf('y'),
    itemState: items.fields.indexOf('state'),
    delivered: count('delivered'),
    carried: count('carried'),
    free: count('free'),
    total: count('items'),
    programs: count('programs'),
    aliveCount: count('alive'),
  };
}

/** @typedef {ReturnType<typeof locate>} Places */

/**
 * Robots within `radius` of a point, nearest first, the lower number first where they share a spot.
 *
 * @param {Float32Array} frame
 * @param {Places} at
 * @param {number} x
 * @param {number} y
 * @param {number} radius
 */
export function agentsNear(frame, at, x, y, radius) {
  /** @type {{ id: number, distance: number }[]} */
  const found = [];
  for (let id = 0; id < at.agents; id += 1) {
    const base = at.agentStart + id * at.agentStride;
    const distance = Math.hypot(frame[base + at.x] - x, frame[base + at.y] - y);
    if (distance <= radius) found.push({ id, distance });
  }
  found.sort((a, b) => a.distance - b.distance || a.id - b.id);
  return found.map(({ id }) => id);
}

/**
 * The nearest robot in a direction, within 45 degrees of it; null when there is none.
 *
 * @param {Float32Array} frame
 * @param {Places} at
 * @param {number} from robot to start from
 * @param {number} dx direction, one of -1, 0, 1
 * @param {number} dy
 */
export function agentTowards(frame, at, from, dx, dy) {
  const start = at.agentStart + from * at.agentStride;
  let best = null;
  let bestDistance = Infinity;
  for (let id = 0; id < at.agents; id += 1) {
    const base = at.agentStart + id * at.agentStride;
    const x = frame[base + at.x] - frame[start + at.x];
    const y = frame[base + at.y] - frame[start + at.y];
    const along = x * dx + y * dy;
    const across = Math.abs(x * dy - y * dx);
    if (id === from || along <= 0 || across > along) continue;
    const distance = along * along + across * across;
    if (distance < bestDistance) {
      bestDistance = distance;
      best = id;
    }
  }
  return best;
}
