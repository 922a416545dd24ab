/** @typedef {'a' | 'b'} Side */

/**
 * Finds the tick at which two runs part, from the fingerprints of every tick of both. Every tick counts: two runs may
 * differ for a moment and be the same again, so the ends of a stretch say nothing of what lies between.
 */
export function createParting() {
  /** @type {Record<Side, string[]>} fingerprints by tick, from tick 0 on */
  const marks = { a: [], b: [] };
  /** Ticks compared and found the same. */
  let same = 0;

  const parting = {
    /** @type {number | null} the first tick at which they differ */
    parted: null,

    /** Last tick compared. */
    compared: () => same - 1,

    /** The number of the first fingerprint still wanted of a side; undefined once they have parted. @param {Side} side */
    known: (side) => (parting.parted === null ? marks[side].length : undefined),

    /** @param {Side} side @param {string[] | undefined} fresh the fingerprints that follow the known ones */
    add(side, fresh) {
      if (!fresh || parting.parted !== null) return;
      for (const mark of fresh) marks[side].push(mark);
      const end = Math.min(marks.a.length, marks.b.length);
      while (same < end && marks.a[same] === marks.b[same]) same += 1;
      if (same < end) parting.parted = same;
    },

    /** One side will run otherwise after a tick. @param {number} tick */
    cut(tick) {
      if (parting.parted !== null && parting.parted <= tick) return;
      parting.parted = null;
      for (const side of /** @type {const} */ (['a', 'b'])) marks[side].length = Math.min(marks[side].length, tick + 1);
      same = Math.min(same, tick + 1);
    },

    /** Begins with new runs. */
    reset() {
      Object.assign(marks, { a: [], b: [] });
      same = 0;
      parting.parted = null;
    },
  };
  return parting;
}

/** @typedef {ReturnType<typeof createParting>} Parting */
