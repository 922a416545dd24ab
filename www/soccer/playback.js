import { createMotion } from '../motion.js';
import { FRAMES_PER_SECOND } from './film.js';

/** @import { SoccerMatch } from './match.js' */

const WAIT_SECONDS = 8; // from a call to the start of play
const WAIT_AFTER_GOAL = 12;

/**
 * The moment of a match that is on screen, in ticks, and how it moves on.
 *
 * @param {SoccerMatch} match
 */
export function createPlayback(match) {
  let waited = 0; // ticks of the wait that is under way
  /** @type {{ tick: number, resolve: () => void } | null} */
  let aim = null;

  const motion = createMotion(FRAMES_PER_SECOND, {
    begin() {
      if (match.over && playback.tick >= match.front()) playback.tick = 0;
      return true;
    },
    advance,
  });

  const playback = Object.assign(motion, {
    tick: 0,
    /** Whether the waits of the referee are left out. */
    skips: true,

    /** @param {number} tick */
    seek(tick) {
      const next = Math.min(Math.max(Math.round(tick), 0), match.front());
      waited = 0;
      playback.tick = next;
      playback.tell();
    },

    /** Goes to a tick as soon as it is computed. @param {number} tick @returns {Promise<void>} */
    reach: (tick) =>
      new Promise((resolve) => {
        aim = { tick, resolve };
        arrive();
      }),
  });

  function arrive() {
    if (!aim || (aim.tick > match.front() && !match.over)) return;
    const { tick, resolve } = aim;
    aim = null;
    playback.seek(tick);
    resolve();
  }

  /** Ticks that the referee waits at the moment on screen. @param {number} tick */
  function waitAt(tick) {
    const call = playback.skips ? undefined : match.calls.find(({ frame, command }) => frame === tick && command !== 'halt');
    if (!call) return 0;
    const goal = typeof call.rule === 'object' && 'goal' in call.rule;
    return (goal ? WAIT_AFTER_GOAL : WAIT_SECONDS) * FRAMES_PER_SECOND;
  }

  /** @param {number} ticks */
  function advance(ticks) {
    let left = ticks;
    while (left > 0) {
      const wait = waitAt(playback.tick) - waited;
      if (wait > 0) {
        const part = Math.min(wait, left);
        waited += part;
        left -= part;
      } else if (playback.tick < match.front()) {
        playback.tick += 1;
        waited = 0;
        left -= 1;
      } else {
        return !match.over; // what is not computed yet is waited for
      }
    }
    return true;
  }

  match.on('opened', () => {
    playback.tick = 0;
    waited = 0;
    playback.tell();
  });
  match.on('grown', arrive);
  match.on('cut', () => {
    playback.tick = Math.min(playback.tick, match.front());
    playback.tell();
  });
  return playback;
}

/** @typedef {ReturnType<typeof createPlayback>} SoccerPlayback */
