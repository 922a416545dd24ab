/** @import { Edge } from '../soccer/types.js' */

/**
 * @typedef {{ name: string, x: number, y: number }} Station the middle of a state
 * @typedef {{ d: string, head: string, mark: [number, number] }} Way an edge: its line, its arrowhead, where its number stands
 */

export const STATE = { width: 92, height: 30 };
export const CHART = { width: 316, height: 330 };
const APART = 7; // pixels between the two edges of a pair

/** Where each state stands: attack above, defence below, swaps to the right, what play starts with to the left. @type {Station[]} */
const STATIONS = [
  { name: 'AttackTwoStrikers', x: 56, y: 24 },
  { name: 'PenaltyKick', x: 204, y: 24 },
  { name: 'Attack', x: 130, y: 104 },
  { name: 'SwapStrikerAssistant', x: 264, y: 104 },
  { name: 'Defense', x: 130, y: 210 },
  { name: 'SwapFullbackWingback', x: 264, y: 176 },
  { name: 'SwapGoalkeeperWingback', x: 264, y: 250 },
  { name: 'PenaltyDefense', x: 56, y: 300 },
];

/** The stations of the states that there are. @param {string[]} names */
export const stationsOf = (names) => STATIONS.filter(({ name }) => names.includes(name));

/**
 * The ways of edges between stations. Of two states with an edge each way, either is drawn to the right of its direction.
 *
 * @param {Edge[]} edges
 * @returns {Way[]}
 */
export function waysOf(edges) {
  const of = (/** @type {string} */ name) => /** @type {Station} */ (STATIONS.find((station) => station.name === name));
  return edges.map(({ from, to }) => {
    const [a, b] = [of(from), of(to)];
    const paired = edges.some((other) => other.from === to && other.to === from);
    const [dx, dy] = [b.x - a.x, b.y - a.y];
    const length = Math.hypot(dx, dy);
    const [ux, uy] = [dx / length, dy / length];
    const aside = paired ? APART : 0;
    const [sx, sy] = [-uy * aside, ux * aside];
    const [fromAt, toAt] = [rim(ux, uy), rim(ux, uy)];
    const start = [a.x + ux * fromAt + sx, a.y + uy * fromAt + sy];
    const end = [b.x - ux * toAt + sx, b.y - uy * toAt + sy];
    const wing = (/** @type {number} */ turn) => `${round(end[0] - 7 * ux + turn * 4 * uy)} ${round(end[1] - 7 * uy - turn * 4 * ux)}`;
    const part = 0.34;
    return {
      d: `M${round(start[0])} ${round(start[1])}L${round(end[0])} ${round(end[1])}`,
      head: `M${round(end[0])} ${round(end[1])}L${wing(1)}L${wing(-1)}Z`,
      mark: [start[0] + (end[0] - start[0]) * part, start[1] + (end[1] - start[1]) * part],
    };
  });
}

/** How far from the middle of a state a line in this direction leaves it. @param {number} ux @param {number} uy */
function rim(ux, uy) {
  const across = Math.abs(ux) > 1e-9 ? STATE.width / 2 / Math.abs(ux) : Infinity;
  const up = Math.abs(uy) > 1e-9 ? STATE.height / 2 / Math.abs(uy) : Infinity;
  return Math.min(across, up) + 1;
}

/** @param {number} value */
const round = (value) => Math.round(value * 10) / 10;
