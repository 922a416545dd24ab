import { createPace } from './pace.js';

/**
 * What moves on by itself: whether it does, at which pace, and who hears of it.
 *
 * @param {number} ticksPerSecond
 * @param {object} what
 * @param {() => boolean} what.begin asked when it is to move; false where there is nothing to show
 * @param {(ticks: number) => boolean} what.advance moves on by so many whole ticks; returns whether it goes on moving
 */
export function createMotion(ticksPerSecond, { begin, advance }) {
  /** @type {(() => void)[]} */
  const listeners = [];
  const pace = createPace(ticksPerSecond);
  let looping = false;

  const motion = {
    playing: false,
    pace,

    /** @param {() => void} listener told when the moment or whether it moves has changed */
    on: (listener) => void listeners.push(listener),

    tell() {
      for (const listener of listeners) listener();
    },

    play() {
      if (!begin()) return;
      motion.playing = true;
      pace.start(performance.now());
      if (!looping) requestAnimationFrame(loop);
      looping = true;
      motion.tell();
    },

    pause() {
      if (!motion.playing) return;
      motion.playing = false;
      motion.tell();
    },

    toggle: () => (motion.playing ? motion.pause() : motion.play()),
  };

  /** @param {number} now */
  function loop(now) {
    looping = motion.playing;
    if (!looping) return;
    requestAnimationFrame(loop);
    const ticks = pace.owed(now);
    if (ticks < 1) return;
    pace.paid(ticks);
    motion.playing = advance(ticks);
    motion.tell();
  }

  return motion;
}
