/**
 * Shapes that cross the boundary between the engine of soccer, its worker and the page. Types only, no code.
 *
 * @typedef {import('../types.js').Scenario} Scenario
 * @typedef {import('../types.js').TreeNode} TreeNode
 * @typedef {'blue' | 'yellow'} Team
 * @typedef {[number, number, number]} Spot x, y and heading in the frame of the pitch, metres and radians
 * @typedef {{ ball: number[], blue: Spot[], yellow: Spot[] }} Arrangement the value of an event `soccer.arrangement`
 *
 * @typedef {object} Edge of the state machine
 * @property {string} from
 * @property {string} to
 * @property {string} guard
 * @property {string} function
 *
 * @typedef {object} Organisation MOISE+, as `src/soccer/team/organisation/moise.json` has it
 * @property {{ groups: Group[], compatibilities: Compatibility[], links: { kind: string, from: string[], to: string[], both_ways: boolean }[] }} structural
 * @property {{ goals: { id: string, title: string, plan?: string, parts?: string[] }[], missions: { id: string, title: string, goals: string[], least: number, most: number }[] }} functional
 * @property {{ role: string, relation: string, mission: string, when?: string }[]} deontic
 *
 * @typedef {{ mode: string, roles: { role: string, least: number, most: number }[], formations: { name: string, roles: string[] }[] }} Group
 * @typedef {{ scope: 'intra_group' | 'inter_group', from: string, to: string, both_ways: boolean }} Compatibility
 *
 * @typedef {object} Setting what does not change
 * @property {number} frame reals of a frame
 * @property {[number, number][][]} walls
 * @property {string[]} roles by number
 * @property {[name: string, input: boolean][]} states of the machine
 * @property {Edge[]} edges in the order in which guards are tried
 * @property {Organisation} organisation
 * @property {string} coach built-in trees
 * @property {string} coach_without_swaps
 * @property {string} role_trees
 * @property {string} chase_trees
 *
 * @typedef {object} Call a line of the referee's log
 * @property {number} frame
 * @property {string} phase
 * @property {number} seconds of play in that part
 * @property {number} elapsed seconds with the waits
 * @property {string} command
 * @property {Team | null} team
 * @property {number | null} quadrant
 * @property {string | Record<string, any>} rule
 * @property {string} reason
 *
 * @typedef {{ frame: number, team: Team, kind: string, text: string }} Deed what a coach did
 *
 * @typedef {{ team: string, possession: number, shots: number, swaps: number, 'group-changes': number, calls: number[], violations: number, faults: number }} Report
 * @typedef {{ goals: [number, number], shoot_out?: [number, number], seconds: number, blue: Report, yellow: Report, finished: string | null }} Outcome
 *
 * @typedef {object} News
 * @property {Call[]} log
 * @property {Deed[]} events
 * @property {Outcome} outcome
 * @property {boolean} exchanged
 *
 * @typedef {object} Slice a part of a match
 * @property {Float32Array} frames the last of them is that of `front`
 * @property {number} front
 * @property {boolean} more
 * @property {News} news
 * @property {string | null} finished
 * @property {string} fingerprint of the whole match, once it is over
 *
 * @typedef {object} TeamMoment
 * @property {string} kind
 * @property {{ roles: string[], mode: string, formation: string, swap_last: string | null, swap_time: number, swap_count: number }} duties
 * @property {number | null} first_striker
 * @property {number} violations
 * @property {string | null} refused
 * @property {string | null} fault
 * @property {'tree' | 'machine' | 'nobody'} coach
 * @property {string[]} statuses
 * @property {string[]} call
 * @property {[string, string][]} board
 * @property {string | null} state
 * @property {[number, number] | null} last
 * @property {[number, boolean][]} guards
 * @property {string[][]} roles
 *
 * @typedef {{ tick: number, teams: [TeamMoment, TeamMoment], outcome: Outcome }} Moment
 * @typedef {{ code: string, line: number, column: number, message: string, warning: boolean }} Problem
 * @typedef {{ problems: Problem[], trees: Record<string, TreeNode[]> | null }} Trees
 *
 * Requests to the worker (`www/soccer/worker.js`), each answered once, in order:
 *
 * | request | answer |
 * |---|---|
 * | `hello {}` | `{ version, schema, setting }` |
 * | `complete { scenario }` | `{ scenario }` with every field; refused with a message |
 * | `trees { what, xml }` | `Trees`; `what` is `coach` or `roles` |
 * | `open { scenario }` | `{ slice }`, with the frame of tick 0; refused with a message |
 * | `ahead { budgetMs }` | `{ slice }` |
 * | `live { ticks, drive }` | `{ slice }`; `drive`, if it is given, is the value of an event at the front |
 * | `set { tick, key, value }` | `{ slice, scenario }`; everything later is cut off, and the log comes whole; refused with a message |
 * | `look { tick }` | `{ moment }` |
 * | `arrangement { tick }` | `{ arrangement }` |
 * | `scenario {}` | `{ scenario }` with everything done to the match |
 */
export {};
