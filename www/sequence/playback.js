import { createPace } from '../pace.js';

/** @import { Path } from './types.js' */

const STEPS_PER_SECOND = 10;
const SPEED = 10; // simulated seconds per second

/**
 * The moment of a path that is on screen, in steps of 0.1 s, and how it moves on.
 */
export function createPlayback() {
  /** @type {(() => void)[]} */
  const listeners = [];
  const pace = createPace(SPEED * STEPS_PER_SECOND);
  let looping = false;

  const playback = {
    /** @type {Path | null} */
    path: null,
    /** Steps since the start. */
    step: 0,
    playing: false,
    pace,

    /** @param {() => void} listener told when the moment or whether it moves has changed */
    on: (listener) => void listeners.push(listener),

    /** The last step of the path. */
    end: () => Math.max((playback.path?.frames ?? 1) - 1, 0),

    /** Another path; the moment stays where it can. @param {Path | null} path */
    show(path) {
      playback.path = path;
      playback.step = Math.min(playback.step, playback.end());
      if (path === null) playback.playing = false;
      tell();
    },

    /** @param {number} step */
    seek(step) {
      playback.step = Math.min(Math.max(Math.round(step), 0), playback.end());
      tell();
    },

    play() {
      if (playback.path === null || playback.end() === 0) return;
      if (playback.step >= playback.end()) playback.step = 0;
      playback.playing = true;
      pace.start(performance.now());
      if (!looping) requestAnimationFrame(loop);
      looping = true;
      tell();
    },

    pause() {
      if (!playback.playing) return;
      playback.playing = false;
      tell();
    },

    toggle: () => (playback.playing ? playback.pause() : playback.play()),
  };

  function tell() {
    for (const listener of listeners) listener();
  }

  /** @param {number} now */
  function loop(now) {
    looping = playback.playing;
    if (!looping) return;
    requestAnimationFrame(loop);
    const steps = pace.owed(now);
    if (steps < 1) return;
    pace.paid(steps);
    playback.step = Math.min(playback.step + steps, playback.end());
    if (playback.step >= playback.end()) playback.playing = false;
    tell();
  }

  return playback;
}

/** @typedef {ReturnType<typeof createPlayback>} Playback */
