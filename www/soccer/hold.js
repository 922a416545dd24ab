import { soccerText } from '../ui/strings.soccer.en.js';
import { spotOf, ballOf, teamOf } from './film.js';

/** @import { SoccerMatch } from './match.js' */
/** @import { SoccerPlayback } from './playback.js' */
/** @import { SoccerSession } from './session.js' */
/** @import { Arrangement } from './types.js' */

export const BALL = 6;
const THINGS = 7;
const DEGREES = Math.PI / 180;

/** @typedef {{ x: number, y: number, heading: number }} Place `heading` in degrees; of the ball it says nothing */

/** What a thing of the pitch is called. @param {number} thing 0 to 5 are robots, 6 is the ball */
export const thingName = (thing) => (thing === BALL ? soccerText.pitch.ball : soccerText.pitch.thing(soccerText.teams[teamOf(thing)], (thing % 3) + 1));

/**
 * What is chosen on the pitch and put elsewhere. What is dragged is shown where it is; the engine judges where it is
 * dropped, and says why when it cannot be there.
 *
 * @param {{ match: SoccerMatch, playback: SoccerPlayback, session: SoccerSession, changed: () => void, announce: (message: string) => void }} parts
 */
export function createHold({ match, playback, session, changed, announce }) {
  /** @type {Place | null} what is under the pointer */
  let shown = null;

  const hold = {
    /** @type {number | null} */
    chosen: null,
    /** Why the chosen thing cannot stand where it was put; empty when nothing is wrong. */
    refusal: '',
    /** Where the chosen thing is shown while it is dragged; null when it is not. */
    dragged: () => shown,

    /** @param {number | null} thing */
    choose(thing) {
      hold.chosen = thing;
      hold.refusal = '';
      shown = null;
      if (thing !== null) {
        playback.pause();
        const { x, y } = /** @type {Place} */ (hold.place());
        announce(soccerText.said.chosen(thingName(thing), x, y));
      }
      changed();
    },

    /** @param {1 | -1 | 'first' | 'last'} where */
    step(where) {
      const at = hold.chosen ?? (where === -1 ? THINGS : -1);
      const next = where === 'first' ? 0 : where === 'last' ? THINGS - 1 : (at + where + THINGS) % THINGS;
      hold.choose(next);
    },

    /** Where the chosen thing stands. @returns {Place | null} */
    place() {
      if (hold.chosen === null) return null;
      if (shown) return shown;
      const frame = match.film.frame(playback.tick);
      const [x, y, heading] = hold.chosen === BALL ? [...ballOf(frame), 0] : spotOf(frame, hold.chosen);
      return { x, y, heading: heading / DEGREES };
    },

    /** Shows the chosen thing elsewhere. @param {Place} place */
    drag(place) {
      shown = place;
      hold.refusal = '';
      changed();
    },

    /** Puts the chosen thing where it is shown. */
    drop: () => (shown ? hold.put(shown) : undefined),

    /** Puts the chosen thing elsewhere; the match goes on from there. @param {Partial<Place>} to */
    async put(to) {
      const { chosen } = hold;
      const from = hold.place();
      if (chosen === null || !from) return;
      const place = { ...from, ...to };
      shown = place;
      const refusal = await session.act('soccer.arrangement', moved(await match.arrangement(playback.tick), chosen, place));
      shown = null;
      hold.refusal = refusal;
      if (refusal) announce(soccerText.situation.refused(refusal));
      else announce(soccerText.situation.moved(thingName(chosen), place.x, place.y));
      changed();
    },

    /** Moves and turns the chosen thing. @param {number} dx metres @param {number} dy @param {number} [turn] degrees */
    nudge(dx, dy, turn = 0) {
      const place = hold.place();
      if (place) void hold.put({ x: place.x + dx, y: place.y + dy, heading: place.heading + turn });
    },
  };
  return hold;
}

/** An arrangement with one thing put elsewhere; a ball that is put somewhere lies still. @param {Arrangement} arrangement @param {number} thing @param {Place} place @returns {Arrangement} */
export function moved(arrangement, thing, { x, y, heading }) {
  const [px, py] = [x, y].map((value) => Math.round(value * 1e4) / 1e4);
  if (thing === BALL) return { ...arrangement, ball: [px, py] };
  const team = teamOf(thing);
  const turned = Math.round(Math.atan2(Math.sin(heading * DEGREES), Math.cos(heading * DEGREES)) * 1e6) / 1e6;
  const robots = arrangement[team].map((spot, robot) => (robot === thing % 3 ? /** @type {[number, number, number]} */ ([px, py, turned]) : spot));
  return { ...arrangement, [team]: robots };
}

/** @typedef {ReturnType<typeof createHold>} SoccerHold */
