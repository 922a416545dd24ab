import { benchText } from '../ui/strings.trees.en.js';
import { followNodes } from '../views/trees/figurekeys.js';
import { createComparison } from './compare.js';
import { createMarks } from './marks.js';
import { withAnswer, withHalt, withWrite, without } from './script.js';

/** @import { Engine } from '../engine.js' */
/** @import { Editor } from '../views/trees/editor.js' */
/** @import { Answer } from './script.js' */
/** @import { TreeRun } from './run.js' */
/** @import { TreeSession } from './session.js' */
/** @import { Compare } from '../views/trees/compare.js' */
/** @import { BenchNode, Status } from './types.js' */

/** @type {Record<Status, Status>} what a press on an answer makes of it */
const NEXT = { SUCCESS: 'FAILURE', FAILURE: 'RUNNING', RUNNING: 'SKIPPED', SKIPPED: 'SUCCESS' };
const COMPLETED = 'SFK';
const COMPARED = /(Sequence|SequenceWithMemory|Fallback)$/;

/**
 * What can be done at the bench: everything that a press, a key or the engine sets off.
 *
 * @param {{ engine: Engine, run: TreeRun, session: TreeSession, editor: Editor, compareView: Compare, changed: () => void,
 *   say: (message: string, kind?: 'note' | 'problem') => void }} parts `changed` is told that something else is to be shown
 */
export function createBench({ engine, run, session, editor, compareView, changed, say }) {
  const marks = createMarks();
  const comparison = createComparison({ engine, run, view: compareView });
  let atCompletion = false;
  let sent = false; // whether the engine knows of a breakpoint
  /** @type {BenchNode[]} the tree that the marks belong to */
  let nodes = [];

  const bench = {
    marks,
    comparing: () => comparison.node !== null,
    /** Where the node stands that is compared. */
    compared: () => (comparison.node ? { line: comparison.node.line, column: comparison.node.column } : null),
    canCompare: () => run.moment !== null && nodes.some(({ type }) => COMPARED.test(type)),

    /** Selects a node and shows its line. @param {number | null} id */
    select(id) {
      marks.select(id);
      const node = id === null ? null : nodes[id];
      editor.mark(node ? { line: node.line, column: node.column } : null);
    },

    /** Selects the node whose element the cursor is in, if there is one. @param {{ line: number, column: number } | null} place @returns {number | null} */
    pointed(place) {
      const here = (/** @type {BenchNode} */ { line, column }) => line === place?.line && column === place.column;
      const present = marks.selected === null ? undefined : nodes[marks.selected];
      const node = present && here(present) ? present : nodes.find(here); // a tree that is used twice has two nodes for a line
      if (node) bench.select(node.id);
      return node?.id ?? null;
    },

    /** Another answer of a leaf from the tick on screen on. @param {string} leaf @param {Answer} answer */
    answer(leaf, answer) {
      session.change({ script: withAnswer(session.rest().script, leaf, run.tick, answer) });
    },

    /** @param {number} id @param {Status | 'next'} wanted */
    answerNode(id, wanted) {
      const found = run.moment?.answers.find(({ leaf }) => leaf === nodes[id]?.name);
      if (!found || !nodes[id].scripted) return;
      const then = wanted === 'next' ? NEXT[found.then] : wanted;
      bench.answer(found.leaf, { running: then === 'RUNNING' ? 0 : found.running, then, writes: found.writes });
    },

    /** @param {string} name @param {string} value */
    write: (name, value) => session.change({ script: withWrite(session.rest().script, run.tick, name, value) }),
    halt: () => session.change({ script: withHalt(session.rest().script, run.tick) }),
    /** @param {number} index of a script event */
    remove: (index) => session.change({ script: without(session.rest().script, index) }),

    /** @param {number} id @param {string} letters */
    pauseAt(id, letters) {
      marks.pauseAt(id, letters);
      void sendBreakpoints();
    },

    /** @param {boolean} pause whether playing ends when the root completes */
    pauseAtCompletion(pause) {
      atCompletion = pause;
      void sendBreakpoints();
    },

    /** Back to the start; the timeline beyond is forgotten. */
    restart: () => void session.refresh({ length: 0, at: 0 }),

    /**
     * Shows the kinds of a sequence or fallback side by side, or the one tree again.
     *
     * @param {{ line: number, column: number } | null} [place]
     * @returns {Promise<boolean>} false when there is none
     */
    async compare(place = null) {
      if (bench.comparing() && !place) {
        comparison.stop();
        changed();
        void session.writeAddress();
        return true;
      }
      const chosen = nodes.filter((node) => (place ? node.line === place.line && node.column === place.column : node.id === marks.selected && COMPARED.test(node.type)));
      const others = place ? [] : nodes.filter(({ type }) => COMPARED.test(type));
      const found = await startComparison([...chosen, ...others]);
      if (!found && !place) say(benchText.compare.none);
      void session.writeAddress();
      return found;
    },

    /** The engine ended: what ran beside the run is gone. */
    abandon: comparison.stop,

    /** What to say when playing ended by itself. @param {'breakpoint' | 'error'} why */
    stopped(why) {
      const { moment } = run;
      if (why === 'breakpoint' && moment?.stopped) {
        const { node, status } = moment.stopped;
        bench.select(node);
        return benchText.said.breakpoint(nodes[node]?.name ?? '', status, moment.tick);
      }
      if (!moment?.error) return '';
      bench.select(moment.error.node);
      return bench.fault();
    },

    /** The error that ended the tick on screen; empty when none did. */
    fault() {
      const { moment } = run;
      return moment?.error ? benchText.said.error(nodes[moment.error.node]?.name ?? '', moment.error.message, moment.tick) : '';
    },
  };

  /** @param {BenchNode[]} candidates */
  async function startComparison(candidates) {
    const { xml, script, mode, ms } = session.running();
    try {
      return await comparison.start(candidates, { xml, script, mode, ms }, ({ name, line }) => benchText.compare.note(name, line));
    } catch (error) {
      comparison.stop();
      say(benchText.compare.failed(error instanceof Error ? error.message : String(error)), 'problem');
      return true;
    } finally {
      changed();
    }
  }

  async function sendBreakpoints() {
    changed();
    if (!run.moment) return;
    /** @type {Map<number, string>} */
    const list = new Map(marks.breakpoints);
    if (atCompletion) list.set(0, `${list.get(0) ?? ''}${COMPLETED}`);
    if (list.size === 0 && !sent) return;
    sent = list.size > 0;
    await engine.request('breakpoints', { bench: 0, list: [...list] });
  }

  run.on('opened', ({ tree }) => {
    if (!tree) return;
    const compared = comparison.node;
    const there = compared && followNodes(nodes, tree.nodes)(compared.id);
    marks.follow(nodes, tree.nodes, !session.opening);
    nodes = tree.nodes;
    void sendBreakpoints();
    if (!compared) {
      if (session.opening) comparison.stop(); // also one that is about to begin
      return;
    }
    const same = there !== null && !session.opening && nodes[there].name === compared.name; // another tree is not compared unasked
    if (same) void startComparison([nodes[there]]).then(session.writeAddress);
    else comparison.stop();
  });
  run.on('moment', comparison.follow);
  return bench;
}

/** @typedef {ReturnType<typeof createBench>} Bench */
