/** @import { BenchNode, ScriptEvent, Status } from '../trees/types.js' */
/** @import { NodeState } from '../draw/benchstate.js' */
/** @import { Difference } from '../draw/benchcompare.js' */

const plural = (/** @type {number} */ count, /** @type {string} */ one, /** @type {string} */ many = `${one}s`) => `${count} ${count === 1 ? one : many}`;

/** @param {string[]} names */
const list = (names) => (names.length < 2 ? names.join('') : `${names.slice(0, -1).join(', ')} and ${names[names.length - 1]}`);

/** @type {Record<string, string>} */
const STATUS = { S: 'SUCCESS', F: 'FAILURE', R: 'RUNNING', K: 'SKIPPED', H: 'halted', E: 'ERROR' };

/** @type {Record<BenchNode['category'], string>} */
const CATEGORY = { action: 'action', condition: 'condition', control: 'control node', decorator: 'decorator', subtree: 'subtree' };

/** @type {Record<string, string>} */
const CORNER = {
  R: 'reactive: asks from the first child in every tick',
  '*': 'with memory: goes on with the child that was RUNNING',
  '**': 'with memory: keeps its place after a FAILURE and a halt too',
};

/** @param {{ running: number, then: Status, done?: number }} answer */
function answers({ running, then, done = 0 }) {
  if (then === 'RUNNING') return 'RUNNING for ever';
  if (running === 0) return then;
  return `${then} after ${running} × RUNNING${done > 0 ? `, ${done} of them done` : ''}`;
}

/** Texts of the tree drawing, the timeline and the comparison. */
export const figureText = {
  status: STATUS,
  category: CATEGORY,
  corner: CORNER,

  figure: {
    empty: 'There is no tree to draw.',
    halted: 'halted',
    error: 'error',
    times: (/** @type {number} */ count) => `×${count}`,
    folded: (/** @type {number} */ count) => `+${count}`,
    running: (/** @type {number} */ running, /** @type {number} */ done) => {
      if (done > 0 && running < 100) return `${done}/${running}`;
      return running < 10_000 ? `${running}×` : `${Math.floor(running / 1000)}k×`;
    },
    fold: (/** @type {string} */ name) => `Fold ${name}`,
    unfold: (/** @type {string} */ name, /** @type {number} */ count) => `Unfold ${name}: ${plural(count, 'node')}`,
    answer: (/** @type {string} */ name, /** @type {{ running: number, then: Status, done: number }} */ answer) =>
      `${name} answers ${answers(answer)}. Press for the next answer; on the node the keys S, F, R and K.`,

    /**
     * What the pointer and a screen reader are told of a node: also what was shortened or has only a sign.
     *
     * @param {BenchNode} node @param {NodeState} state @param {string} corner @param {string | undefined} letters @param {number} hidden
     */
    said: (node, state, corner, letters, hidden) =>
      [
        [node.name, ...(node.name === node.type ? [] : [node.type]), CATEGORY[node.category]].join(', '),
        figureText.figure.stands(state),
        state.halted ? 'halted in this tick' : '',
        state.answer ? `answers ${answers(state.answer)}` : '',
        hidden > 0 ? `${plural(hidden, 'node')} folded` : '',
        corner ? CORNER[corner] : '',
        node.ports.map(([name, value]) => `${name}=${value}`).join(', '),
        ...node.conditions.map(([name, script]) => `${name}: ${script}`),
        letters ? figureText.figure.stops(letters) : '',
      ]
        .filter((part) => part !== '')
        .join('.\n'),

    /** @param {NodeState} state */
    stands: ({ letter, when, tick, count, error }) => {
      if (error) return `ERROR in this tick: ${error}`;
      if (when === 'now') return `${STATUS[letter]} in this tick${count > 1 ? `, ${count} returns` : ''}`;
      if (when === 'kept') return `still RUNNING${tick === null ? '' : ` since tick ${tick}`}, not ticked in this one`;
      return when === 'earlier' ? `${STATUS[letter]}${tick === null ? '' : ` in tick ${tick}`}` : '';
    },

    stops: (/** @type {string} */ letters) => `stops at ${list([...letters].map((letter) => STATUS[letter] ?? letter))}`,
  },

  timeline: {
    rows: 'Rows',
    filters: { ticked: 'Ticked', leaves: 'Leaves', all: 'All' },
    none: 'No tick yet: step or play, and every tick becomes a column.',
    noTree: 'There is no tree to follow.',
    tick: 'tick',
    keys: 'Arrow keys move through the ticks, Enter goes to one.',
    failed: 'The ticks could not be read.',

    /** @param {string} label @param {number} nodes @param {number} ticks @param {number} tick @param {string} root */
    summary: (label, nodes, ticks, tick, root) =>
      [`${label}: ${plural(nodes, 'node')}, ${plural(ticks, 'tick')}.`, tick > 0 ? `Tick ${tick} is shown, the root returned ${root || 'nothing'}.` : '', figureText.timeline.keys].join(' '),
    /** @param {string} name @param {number} tick @param {string} letter @param {string[]} events */
    cell: (name, tick, letter, events) => [`Tick ${tick}, ${name}: ${letter === '' ? 'not read yet' : (STATUS[letter] ?? 'not ticked')}`, ...events].join('. '),
    column: (/** @type {number} */ tick, /** @type {string[]} */ events) => [`Tick ${tick}`, ...events].join('. '),
    more: (/** @type {number} */ count) => `${count} more`,
    /** @param {ScriptEvent} event */
    event: (event) => {
      const from = event.tick === 0 ? 'from the start' : `after tick ${event.tick}`;
      if ('halt' in event) return `The whole tree is halted ${from}`;
      if ('set' in event) return `${event.set} is set to ${event.value} ${from}`;
      const writes = Object.entries(event.writes ?? {}).map(([port, value]) => `${port}=${value}`);
      return `${event.leaf} answers ${answers(event)} ${from}${writes.length > 0 ? `, writes ${writes.join(', ')}` : ''}`;
    },
  },

  compare: {
    rootIs: (/** @type {string} */ status) => `Root: ${status}`,
    noRoot: 'Root: not ticked',
    leaves: (/** @type {number} */ tick) => `Leaves in tick ${tick}`,
    noLeaf: 'no leaf was ticked',
    figure: (/** @type {string} */ type) => `Tree with ${type}`,
    table: 'Ticks side by side',
    tableHint: 'Cells in which the forms differ are underlined; ≠ stands over the first such tick.',
    differing: (/** @type {string} */ cell) => `${cell}; the forms differ here`,
    before: 'No tick yet: step or play, and every form runs along.',
    equal: (/** @type {number} */ from, /** @type {number} */ to) => `In ${from === to ? `tick ${from}` : `ticks ${from} to ${to}`} every leaf and the root return the same in all forms.`,

    /** One sentence from the data. @param {Difference} difference @param {number} from first tick known */
    differ: ({ tick, leaf, groups }, from) => {
      const where = from > 1 ? `From tick ${from} on they differ first in tick ${tick}` : `They differ first in tick ${tick}`;
      return `${where}: ${groups.map((group) => figureText.compare.clause(leaf, group)).join('; ')}.`;
    },

    /** @param {string | null} leaf null for the root @param {Difference['groups'][number]} group */
    clause: (leaf, { types, letter, again }) => {
      const one = types.length === 1;
      if (leaf === null) return `in ${list(types)} the root returns ${STATUS[letter] ?? 'nothing'}`;
      if (letter === '.') return `${list(types)} ${one ? 'does' : 'do'} not tick ${leaf}${again ? ' again' : ''}`;
      if (letter === 'H') return `${list(types)} ${one ? 'halts' : 'halt'} ${leaf}`;
      return `${list(types)} ${one ? 'ticks' : 'tick'} ${leaf}${again ? ' again' : ''}, which returns ${STATUS[letter]}`;
    },
  },
};
