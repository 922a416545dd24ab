import { sequenceText } from '../ui/strings.sequence.en.js';

/** @import { Planner } from './planner.js' */
/** @import { SequenceSession } from './session.js' */
/** @import { Ray } from './types.js' */

const AT_ONCE = 5; // replays a request: a newer placement waits no longer
const RUNS = 50;

/**
 * The robustness of the plan on screen: replays from moved starts, the share that still succeeds.
 *
 * @param {{ planner: Planner, session: SequenceSession, changed: () => void, announce: (message: string) => void }} parts
 */
export function createFan({ planner, session, changed, announce }) {
  /** @type {Ray[]} */
  let rays = [];
  let middles = new Float32Array(0);
  let of = ''; // the plan they are of
  let jitter = 0;
  let ticket = 0;
  let running = false;

  const fan = {
    running: () => running,
    /** What to draw; null when nothing was tried for the plan on screen. */
    drawn: () => (rays.length > 0 && of === key() ? { rays, middles } : null),

    words() {
      if (rays.length === 0 || of !== key()) return '';
      const feasible = rays.filter((ray) => ray.feasible);
      const mean = feasible.reduce((sum, { cost }) => sum + cost, 0) / Math.max(feasible.length, 1);
      return sequenceText.robust.share(feasible.length, rays.length, jitter, feasible.length > 0 ? mean / planned() - 1 : null);
    },

    /** @param {number} metres how far each robot starts elsewhere */
    async run(metres) {
      const path = session.path();
      if (!path) return;
      const mine = ++ticket;
      [rays, middles, of, jitter, running] = [[], new Float32Array(0), key(), metres, true];
      changed();
      while (rays.length < RUNS && mine === ticket && of === key()) {
        const more = await planner.fan(path.letters, metres, rays.length, AT_ONCE).catch(() => null);
        if (mine !== ticket) return;
        if (!more) break;
        rays.push(...more.rays);
        const joined = new Float32Array(middles.length + more.middles.length);
        joined.set(middles);
        joined.set(more.middles, middles.length);
        middles = joined;
        changed();
      }
      running = false;
      changed();
      announce(fan.words());
    },
  };

  const planned = () => session.path()?.replay.costs.reduce((sum, cost) => sum + cost, 0) ?? 1;
  /** What a fan is of: the plan and where it starts. */
  const key = () => `${session.path()?.letters} ${JSON.stringify(planner.task?.start[0])} ${session.path()?.replay.total}`;

  return fan;
}

/** @typedef {ReturnType<typeof createFan>} Fan */
