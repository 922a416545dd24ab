import { followNodes } from '../views/trees/figurekeys.js';

/** @import { BenchNode } from './types.js' */

/**
 * What the visitor has marked in the tree: the node that is looked at, and where to pause.
 */
export function createMarks() {
  /** @type {(() => void)[]} */
  const listeners = [];
  const marks = {
    /** @type {number | null} */
    selected: null,
    /** @type {Map<number, string>} letters by node: S F R K returned, H halted */
    breakpoints: new Map(),

    /** @param {number | null} id */
    select(id) {
      if (id === marks.selected) return;
      marks.selected = id;
      tell();
    },

    /** @param {number} id @param {string} letters none: no pause there */
    pauseAt(id, letters) {
      if (letters) marks.breakpoints.set(id, letters);
      else marks.breakpoints.delete(id);
      tell();
    },

    /**
     * Finds the marks again in an edited tree.
     *
     * @param {BenchNode[]} before
     * @param {BenchNode[]} now
     * @param {boolean} keep false when it is another tree
     */
    follow(before, now, keep) {
      const to = keep ? followNodes(before, now) : () => null;
      const { selected, breakpoints } = marks;
      marks.selected = selected === null ? null : to(selected);
      marks.breakpoints = new Map();
      for (const [id, letters] of breakpoints) {
        const there = to(id);
        if (there !== null) marks.breakpoints.set(there, letters);
      }
    },

    /** @param {() => void} listener */
    on: (listener) => void listeners.push(listener),
  };

  function tell() {
    for (const listener of listeners) listener();
  }

  return marks;
}

/** @typedef {ReturnType<typeof createMarks>} Marks */
