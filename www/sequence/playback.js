import { createMotion } from '../motion.js';

/** @import { Path } from './types.js' */

const STEPS_PER_SECOND = 10;
const SPEED = 10; // simulated seconds per second

/**
 * The moment of a path that is on screen, in steps of 0.1 s, and how it moves on.
 */
export function createPlayback() {
  const motion = createMotion(SPEED * STEPS_PER_SECOND, {
    begin() {
      if (playback.path === null || playback.end() === 0) return false;
      if (playback.step >= playback.end()) playback.step = 0;
      return true;
    },
    advance(steps) {
      playback.step = Math.min(playback.step + steps, playback.end());
      return playback.step < playback.end();
    },
  });

  const playback = Object.assign(motion, {
    path: /** @type {Path | null} */ (null),
    /** Steps since the start. */
    step: 0,

    /** The last step of the path. */
    end: () => Math.max((playback.path?.frames ?? 1) - 1, 0),

    /** Another path; the moment stays where it can. @param {Path | null} path */
    show(path) {
      playback.path = path;
      playback.step = Math.min(playback.step, playback.end());
      if (path === null) playback.playing = false;
      playback.tell();
    },

    /** @param {number} step */
    seek(step) {
      playback.step = Math.min(Math.max(Math.round(step), 0), playback.end());
      playback.tell();
    },
  });
  return playback;
}

/** @typedef {ReturnType<typeof createPlayback>} Playback */
