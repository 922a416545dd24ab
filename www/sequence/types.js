/**
 * Shapes that cross the boundary between the engine of sequencing, its worker and the page. Types only, no code.
 *
 * @typedef {import('../types.js').Scenario} Scenario
 * @typedef {{ disc: [x: number, y: number, radius: number] }} Disc
 * @typedef {{ box: [left: number, bottom: number, right: number, top: number] }} Box
 * @typedef {{ polygon: [number, number][] }} Polygon convex
 * @typedef {Disc | Box | Polygon} Form an obstacle; map metres, y up
 *
 * @typedef {{ target: [x: number, y: number, radius: number] }} Reach
 * @typedef {{ cells: { origin: [number, number], side: number, columns: number, rows: number }, ratio: number }} Cover
 *
 * @typedef {object} Task what is to be planned
 * @property {[left: number, right: number, bottom: number, top: number]} map
 * @property {Form[]} obstacles
 * @property {Reach | Cover} goal
 * @property {{ letter: string, name: string }[]} library
 * @property {[x: number, y: number, heading: number][]} start
 * @property {number} decisions
 * @property {number} interval seconds
 * @property {number} steps of 0.1 s in one interval
 *
 * @typedef {object} Progress where a search stands
 * @property {string | null} outcome null while it goes on
 * @property {string | null} plan letters
 * @property {number | null} cost metres
 * @property {number | null} lower_bound
 * @property {number | null} proven_ratio
 * @property {number} weight
 * @property {number | null} proven_weight
 * @property {boolean} stop_last
 * @property {number} expanded
 * @property {number} integrated
 * @property {number} collided
 * @property {number} late
 * @property {number} missed
 * @property {number} alike
 * @property {number} open
 * @property {number} nodes
 * @property {number} bytes
 *
 * @typedef {object} Replay a sequence carried out
 * @property {number[]} costs metres of each interval that was carried out to its end
 * @property {number} charges for time and switches
 * @property {number} total
 * @property {number[]} visited cells at the start and after each of these intervals
 * @property {boolean} goal
 * @property {boolean} feasible
 * @property {{ interval: number, step: number, robot: number, obstacle: number | null } | null} collision `obstacle` is null at
 *   the edge of the map
 *
 * @typedef {object} Path a sequence with every pose it leads through
 * @property {string} letters
 * @property {Replay} replay
 * @property {Float32Array} poses x, y, heading of each robot, frame after frame
 * @property {number} frames one for each step of 0.1 s, the start included
 * @property {Uint32Array} visits for each cell the step after which it counts as visited; 4294967295 never
 *
 * @typedef {object} Slice a part of a search
 * @property {Progress} progress
 * @property {Float32Array} rows of the frontier that are new: x and y before and after, key, fate (0 open, 1 collided,
 *   2 dropped, 3 goal)
 * @property {Path | null} found the best plan, when it is another than before
 * @property {string[]} blocked once a search has ended without a plan: what each behaviour runs into when it is the first
 * @property {number} ms computing time
 *
 * @typedef {{ feasible: boolean, cost: number, frames: number, hit: [number, number] | null }} Ray one replay of a fan
 *
 * Requests to the worker (`www/sequence/worker.js`), each answered once, in order:
 *
 * | request | answer |
 * |---|---|
 * | `hello {}` | `{ version, schema }` |
 * | `complete { scenario }` | `{ scenario }` with every field; refused with a message |
 * | `open { scenario, budgetMs }` | `{ task, slice }`; searches until the first plan, at most so long; refused with a message |
 * | `search { budgetMs }` | `{ slice }` |
 * | `cancel {}` | `{ slice }`; the search ends as cancelled |
 * | `extend { integrations, megabytes }` | `{ slice }`; a search that gave up or was cancelled may go on |
 * | `follow { letters }` | `{ path }`; refused for a letter that no behaviour has |
 * | `fan { letters, jitter, first, count }` | `{ rays, middles }`; x and y of the swarm's middle every second, ray after ray |
 */
export {};
