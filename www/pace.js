const LONGEST_GAP_MS = 250; // after a stall the world goes on from where it was, it does not catch up
const UNBOUNDED = 1_000_000;

/**
 * Turns time into ticks: fractions add up, so a screen of 120 Hz does not run the world twice as fast.
 *
 * @param {number} ticksPerSecond
 */
export function createPace(ticksPerSecond) {
  let debt = 0;
  let last = 0;
  const pace = {
    ticksPerSecond,
    /** As fast as the engine can. */
    max: false,

    /** @param {number} now milliseconds */
    start(now) {
      last = now;
      debt = 1; // the first tick comes at once
    },

    /**
     * Whole ticks to run now.
     *
     * @param {number} now milliseconds
     */
    owed(now) {
      if (pace.max) return UNBOUNDED;
      const gap = Math.max(0, Math.min(now - last, LONGEST_GAP_MS));
      last = now;
      debt = Math.min(debt + (gap * pace.ticksPerSecond) / 1000, (LONGEST_GAP_MS * pace.ticksPerSecond) / 1000 + 1);
      return Math.floor(debt);
    },

    /** @param {number} ticks run since; what the budget left undone stays owed */
    paid(ticks) {
      debt = pace.max ? 0 : Math.max(0, debt - ticks);
    },
  };
  return pace;
}
