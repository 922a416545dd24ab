import { spotOf, ballOf, teamOf, ROBOTS } from './film.js';

/** @import { SoccerMatch } from './match.js' */
/** @import { Scenario } from './types.js' */

const EVERY = 6; // ticks between two rows of poses

/** A field of CSV. @param {string | number} value */
const field = (value) => (/[",\n]/.test(String(value)) ? `"${String(value).replaceAll('"', '""')}"` : String(value));

/** @param {(string | number)[][]} rows */
const csv = (rows) => `${rows.map((row) => row.map(field).join(',')).join('\n')}\n`;

/** Places of robots and ball ten times a second. @param {SoccerMatch} match @param {string[]} roles by number */
export function posesCsv({ film }, roles) {
  /** @type {(string | number)[][]} */
  const rows = [['tick', 'seconds', 'thing', 'role', 'x', 'y', 'heading']];
  for (let tick = 0; tick < film.count; tick += EVERY) {
    const frame = film.frame(tick);
    const time = (tick / 60).toFixed(2);
    for (let robot = 0; robot < ROBOTS; robot += 1) {
      const [x, y, heading] = spotOf(frame, robot);
      rows.push([tick, time, `${teamOf(robot)} ${(robot % 3) + 1}`, roles[film.role(tick, robot)], x.toFixed(4), y.toFixed(4), heading.toFixed(4)]);
    }
    const [x, y] = ballOf(frame);
    rows.push([tick, time, 'ball', '', x.toFixed(4), y.toFixed(4), '']);
  }
  return csv(rows);
}

/** What referee and coaches did, in the order of time. @param {SoccerMatch} match */
export function logCsv({ log, deeds }) {
  const lines = [
    ...log.map(({ frame, phase, seconds, elapsed, command, team, quadrant, reason }) => ({ frame, row: [frame, (frame / 60).toFixed(2), phase, seconds.toFixed(2), elapsed.toFixed(2), 'referee', team ?? '', command, quadrant ?? '', reason] })),
    ...deeds.map(({ frame, team, kind, text }) => ({ frame, row: [frame, (frame / 60).toFixed(2), '', '', '', 'coach', team, kind, '', text] })),
  ];
  lines.sort((a, b) => a.frame - b.frame);
  return csv([['tick', 'seconds', 'phase', 'seconds_in_phase', 'elapsed', 'who', 'team', 'what', 'quadrant', 'why'], ...lines.map(({ row }) => row)]);
}

/** The log with the scenario that it is of: opened again, the match is played anew and compared by its fingerprint. @param {string} version @param {Scenario} scenario @param {SoccerMatch} match */
export function logJson(version, scenario, { log, deeds, outcome, over, fingerprint }) {
  return `${JSON.stringify({ version, scenario, complete: over, fingerprint: over ? fingerprint : null, outcome, referee: log, coaches: deeds }, null, 1)}\n`;
}
