/**
 * Shapes that cross the boundary between the tree engine, its worker and the page. Types only, no code.
 *
 * @typedef {'SUCCESS' | 'FAILURE' | 'RUNNING' | 'SKIPPED'} Status what a node may return
 *
 * @typedef {object} LeafAnswer what all leaves of one instance name do from a tick on
 * @property {number} tick takes effect after so many ticks: 0 is from the start
 * @property {string} leaf instance name
 * @property {number} running ticks it returns RUNNING after each start, before it returns `then`
 * @property {Status} then RUNNING here means for ever
 * @property {Record<string, string>} [writes] what it writes to its output ports when it completes
 *
 * @typedef {{ tick: number, set: string, value: string }} EntryWrite an entry of the main tree's board (`@name`: the
 *   global one) written by hand after so many ticks; the value is read as a number where it is one
 * @typedef {{ tick: number, halt: true }} HaltEvent the whole tree halted after so many ticks
 * @typedef {LeafAnswer | EntryWrite | HaltEvent} ScriptEvent
 *
 * @typedef {object} Setup everything that decides a run of a tree
 * @property {string} xml
 * @property {ScriptEvent[]} script in any order; of two answers for one leaf at one tick the later counts
 * @property {'once' | 'exactly_once'} mode `tickOnce` or `tickExactlyOnce`
 * @property {number} ms simulated time that passes before each tick, whole milliseconds, 0 to 3600000
 * @property {number} length ticks to run at once, 0 to 100000
 * @property {number} at the tick to show, 0 to `length`
 *
 * @typedef {object} Problem
 * @property {string} code such as `unknown-node`
 * @property {number} line from 1
 * @property {number} column from 1, in characters (not UTF-16 units)
 * @property {string} message without the place
 * @property {boolean} warning
 *
 * @typedef {object} BenchNode a node of the main tree with all subtrees expanded, in preorder; the index is the id
 * @property {number} id
 * @property {number | null} parent
 * @property {number} end one past the last descendant
 * @property {string} type registered name, such as `Sequence`; `SubTree` for subtrees
 * @property {string} name instance name; the registered name (of a SubTree: the tree's) when none was given
 * @property {'action' | 'condition' | 'control' | 'decorator' | 'subtree'} category
 * @property {boolean} scripted a leaf that answers as the script says; built-in leaves act by themselves
 * @property {[string, string][]} ports name and value as written
 * @property {[string, string][]} conditions such as `_skipIf` and its script
 * @property {string[]} outputs output ports of a scripted leaf that are connected to an entry
 * @property {number} line of the element in the text
 * @property {number} column
 * @property {string} definition ID of the tree in which the element stands; empty when it has none
 *
 * @typedef {object} BoardEntry
 * @property {string} board `@` for the global board, the main tree's ID for its board, a path for a subtree's
 * @property {string} name
 * @property {string | null} value as text; null when it has none
 * @property {'number' | 'text' | 'queue' | 'none'} type
 * @property {number} writes
 * @property {number | null} writer node; null when by hand, or from the start
 * @property {number | null} written number of the tick in which it was written last; null when never, 0 before the first
 *
 * @typedef {object} Moment how things stand after `tick` ticks
 * @property {number} tick
 * @property {number} length ticks known
 * @property {number} now simulated time, milliseconds
 * @property {Status | 'ERROR' | null} root what the root returned in this tick; null at 0
 * @property {{ node: number, message: string } | null} error the fault that ended this tick; the tree was halted
 * @property {string} ticked a letter for each node: what it returned last in this tick (S F R K), or `.` not ticked
 * @property {string} kept a letter for each node: the status remembered now (S F R), or `I` idle
 * @property {[number, Status][]} trace every return of this tick, in order; a node may return several times
 * @property {number} passes passes from the root in this tick (more than 1 only with `once`)
 * @property {number[]} halted nodes halted while RUNNING in this tick, in order
 * @property {(number | null)[]} last for each node the number of the tick in which it last returned, up to this one
 * @property {string} lastStatus a letter for each node: what it returned then, or `.`
 * @property {{ leaf: string, running: number, then: Status, writes: Record<string, string> }[]} answers what each
 *   scripted leaf name does now, in order of first appearance
 * @property {[number, number][]} progress for scripted leaves under way: node, times it has returned RUNNING since it started
 * @property {BoardEntry[]} entries
 * @property {{ node: number, status: Status | 'HALTED' } | null} stopped the breakpoint that ended an `advance`
 * @property {boolean} full true when no further tick can be recorded
 * @property {string} fingerprint 16 hex digits of the tree's whole state
 *
 * @typedef {object} Opened answer to `open`
 * @property {Problem[]} problems faults and warnings; with a fault (`warning` false) there is no new tree
 * @property {{ nodes: BenchNode[], main: string, runnable: boolean } | null} tree null when the text has a fault: the
 *   last valid tree goes on; not `runnable` (control nodes or decorators that only a model declares): it can be shown only
 * @property {Moment | null} moment null without a runnable tree
 *
 * @typedef {object} Timeline answer to `timeline`
 * @property {number} from first tick shown, from 1
 * @property {string[]} columns for each tick a letter for each node: what it returned last (S F R K), `H` halted while
 *   RUNNING and not ticked since, `.` neither
 * @property {string[]} roots for each tick S F R K, or E for an error
 *
 * @typedef {object} Variant one form of a tree for the comparison side by side
 * @property {string} type such as `ReactiveSequence`
 * @property {string} xml the document with that one node exchanged
 *
 * @typedef {object} NodeModel a node that can stand in a tree
 * @property {string} name
 * @property {string} category
 * @property {{ name: string, direction: 'in' | 'out' | 'inout', type: string, default: string | null, description: string }[]} ports
 *
 * Requests to the worker (`www/trees/worker.js`), each answered once, in order:
 *
 * | request | answer |
 * |---|---|
 * | `hello {}` | `{ version: string, models: NodeModel[] }` the 42 built-in nodes |
 * | `open { bench, setup: Setup }` | `{ opened: Opened }`; `bench` (0 to 3) is one of four independent workbenches |
 * | `advance { bench, ticks }` | `{ moment }`; goes up to `ticks` further, stops behind a tick in which a breakpoint was met |
 * | `seek { bench, tick }` | `{ moment }`; a tick beyond `length` is computed |
 * | `timeline { bench, from, to }` | `{ timeline }` for the ticks `from` to `to`, both included, at most 512 at once |
 * | `breakpoints { bench, list: [node, letters][] }` | `{}`; letters from S F R K and H (halted); replaces all |
 * | `variants { xml, line, column }` | `{ variants: Variant[] }` of the sequence or fallback that stands there; none elsewhere |
 * | `format { xml }` | `{ xml }` canonical, with models of all custom nodes; refused with the first fault as message |
 */
export {};
