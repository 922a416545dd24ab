/** @import { Places } from './frame.js' */

/**
 * The last places of every robot, as they were at the ticks that were drawn: nothing between them is made up.
 *
 * @param {number} agents
 * @param {number} length places kept for each robot
 */
export function createTrail(agents, length) {
  const points = new Float32Array(agents * length * 2);
  const ticks = new Float64Array(length).fill(-1);
  const trail = {
    points,
    length,
    /** Number of places stored, at most `length`. */
    filled: 0,
    /** Where the next one goes. */
    head: 0,

    /** @param {Float32Array} frame @param {Places} at @param {number} tick */
    push(frame, at, tick) {
      const last = ticks[(trail.head + length - 1) % length];
      if (trail.filled > 0 && tick === last) return;
      if (tick < last) trail.filled = 0;
      const row = trail.head * agents * 2;
      for (let id = 0; id < agents; id += 1) {
        const base = at.agentStart + id * at.agentStride;
        points[row + id * 2] = frame[base + at.x];
        points[row + id * 2 + 1] = frame[base + at.y];
      }
      ticks[trail.head] = tick;
      trail.head = (trail.head + 1) % length;
      trail.filled = Math.min(trail.filled + 1, length);
    },
  };
  return trail;
}

/** @typedef {ReturnType<typeof createTrail>} Trail */
