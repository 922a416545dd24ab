/** @import { Arrangement, Spot, Team } from './types.js' */

export const FRAME = 30; // reals, see FRAME in src/soccer/moment.rs
export const ROBOTS = 6; // blue's, then yellow's
export const FRAMES_PER_SECOND = 60;
const BALL = 18;
const ROLES = 20;
const GOALS = 21;
const PHASE = 22;
const SECONDS = 23;
const COUNTS = 24;

/** The frames of a match, one for each tick that was computed. */
export function createFilm() {
  let reals = new Float32Array(0);
  const film = {
    /** Frames that are there; the last one is that of tick `count - 1`. */
    count: 0,

    /** Puts frames behind those that are there, or in place of some. @param {Float32Array} frames @param {number} front the tick of the last of them */
    put(frames, front) {
      const from = front + 1 - frames.length / FRAME;
      const end = (front + 1) * FRAME;
      if (end > reals.length) {
        const larger = new Float32Array(Math.max(2 * reals.length, end));
        larger.set(reals.subarray(0, from * FRAME));
        reals = larger;
      }
      reals.set(frames, from * FRAME);
      film.count = front + 1;
    },

    clear: () => void (film.count = 0),

    /** The reals of a frame. @param {number} tick @returns {Float32Array} */
    frame(tick) {
      const at = film.within(tick) * FRAME;
      return reals.subarray(at, at + FRAME);
    },

    /** @param {number} tick */
    within: (tick) => Math.min(Math.max(tick, 0), Math.max(film.count - 1, 0)),

    /** The role of a robot, by number. @param {number} tick @param {number} robot */
    role: (tick, robot) => (reals[film.within(tick) * FRAME + ROLES] >> (3 * robot)) & 7,

    /** All roles in one number, to see whether anything changed. @param {number} tick */
    roles: (tick) => reals[film.within(tick) * FRAME + ROLES],

    /** @param {number} tick */
    goals(tick) {
      const packed = reals[film.within(tick) * FRAME + GOALS];
      return [packed & 255, packed >> 8];
    },

    /** The part of the match, from 0, and the seconds of play in it. @param {number} tick */
    clock(tick) {
      const at = film.within(tick) * FRAME;
      return { phase: reals[at + PHASE], seconds: reals[at + SECONDS] };
    },

    /** Frames with the ball, shots and swaps of both teams. @param {number} tick */
    counts(tick) {
      const at = film.within(tick) * FRAME + COUNTS;
      const pair = (/** @type {number} */ index) => [reals[at + 2 * index], reals[at + 2 * index + 1]];
      return { possession: pair(0), shots: pair(1), swaps: pair(2) };
    },

    /** @param {number} tick @returns {[number, number]} */
    ball(tick) {
      const at = film.within(tick) * FRAME + BALL;
      return [reals[at], reals[at + 1]];
    },

    /** Whether robots and ball stand at the same places in another film. @param {{ frame: (tick: number) => Float32Array }} other @param {number} tick @returns {boolean} */
    same(other, tick) {
      const [mine, theirs] = [film.frame(tick), other.frame(tick)];
      for (let at = 0; at < ROLES; at += 1) if (mine[at] !== theirs[at]) return false;
      return true;
    },
  };
  return film;
}

/** @typedef {ReturnType<typeof createFilm>} Film */

/** Where a robot stands in a frame. @param {Float32Array} frame @param {number} robot @returns {Spot} */
export const spotOf = (frame, robot) => [frame[3 * robot], frame[3 * robot + 1], frame[3 * robot + 2]];

/** The ball in a frame. @param {Float32Array} frame */
export const ballOf = (frame) => /** @type {[number, number]} */ ([frame[BALL], frame[BALL + 1]]);

/** A frame with robots and ball put elsewhere. @param {Float32Array} frame @param {Arrangement} arrangement */
export function arranged(frame, { ball, blue, yellow }) {
  const changed = frame.slice();
  [...blue, ...yellow].forEach((spot, robot) => changed.set(spot, 3 * robot));
  changed.set(ball.slice(0, 2), BALL);
  return changed;
}

/** @param {number} robot 0 to 5 @returns {Team} */
export const teamOf = (robot) => (robot < ROBOTS / 2 ? 'blue' : 'yellow');
