import { createPace } from '../pace.js';
import { button, h, write } from '../ui/dom.js';
import { soccerText } from '../ui/strings.soccer.en.js';
import { FRAMES_PER_SECOND, ROBOTS, teamOf } from './film.js';
import { thingName } from './hold.js';

/** @import { SoccerMatch } from './match.js' */
/** @import { SoccerPlayback } from './playback.js' */
/** @import { SoccerSession } from './session.js' */

const AHEAD = 34; // radians a second of both wheels
const TURN = 11; // more on one side, less on the other
const LEVELS = 8; // steps of a stick to one side: fewer events than every tremble would make
const DEAD = 0.12; // of a stick
const MOST_EVENTS = 9_500; // a scenario holds 10,000
const KEYS = /** @type {Record<string, 'ahead' | 'back' | 'left' | 'right'>} */ ({ ArrowUp: 'ahead', ArrowDown: 'back', ArrowLeft: 'left', ArrowRight: 'right' });
const words = soccerText.drive;

/**
 * One robot driven by hand, live, from the moment on screen. What the wheels are told is an event of the scenario each time
 * it changes, so that the match can be played again.
 *
 * @param {{ match: SoccerMatch, playback: SoccerPlayback, session: SoccerSession, announce: (message: string) => void, say: (message: string) => void,
 *   changed: () => void, keys: HTMLElement }} parts `keys` is where keys are listened to
 */
export function createDrive({ match, playback, session, announce, say, changed, keys }) {
  const robot = h('select', { id: 'soccer-driven', 'aria-label': words.choose }, ...Array.from({ length: ROBOTS }, (_, index) => h('option', { value: index, selected: index === 1 }, thingName(index))));
  const start = button(words.start, () => void (on ? end() : begin()), { title: words.how });
  const said = h('span', { class: 'drive-said', role: 'status' });
  const element = h('span', { class: 'joined drive' }, robot, start, said);
  const pace = createPace(FRAMES_PER_SECOND);
  const held = { ahead: false, back: false, left: false, right: false };
  let on = false;
  let told = ''; // the last command
  let asking = false;
  let commands = 0;

  async function begin() {
    if (match.over && playback.tick >= match.front()) return say(soccerText.situation.refused(soccerText.situation.over));
    playback.pause();
    Object.assign(held, { ahead: false, back: false, left: false, right: false });
    match.live(true);
    on = true;
    commands = 0;
    told = JSON.stringify(command());
    const refusal = await match.set(playback.tick, 'soccer.drive', command());
    if (refusal) {
      on = false;
      match.live(false);
      return say(refusal);
    }
    commands += 1;
    write(start, words.stop);
    write(said, words.on(thingName(Number(robot.value))));
    announce(words.on(thingName(Number(robot.value))));
    robot.disabled = true;
    start.focus();
    changed();
    pace.start(performance.now());
    requestAnimationFrame(loop);
  }

  /** Gives the robot back to its coach, and computes to full time. */
  async function end() {
    if (!on) return;
    on = false;
    while (asking) await new Promise((resolve) => requestAnimationFrame(resolve));
    write(start, words.start);
    write(said, '');
    robot.disabled = false;
    await match.set(match.front(), 'soccer.drive', null);
    match.live(false);
    say(words.kept(commands + 1));
    await session.refetch();
    changed();
  }

  /** What the wheels are told now. */
  function command() {
    const index = Number(robot.value);
    const { ahead, turn } = wish();
    const wheel = (/** @type {number} */ side) => Math.min(Math.max(AHEAD * ahead + side * TURN * turn, -46), 46);
    return { team: teamOf(index), robot: (index % 3) + 1, wheels: [wheel(-1), wheel(1)] };
  }

  /** Forward and to the left, from -1 to 1 each: keys, or the stick of a gamepad. */
  function wish() {
    const pad = navigator.getGamepads?.().find((candidate) => candidate?.connected);
    const axis = (/** @type {number} */ index) => {
      const value = pad?.axes[index] ?? 0;
      return Math.abs(value) < DEAD ? 0 : Math.round(value * LEVELS) / LEVELS;
    };
    const pressed = (/** @type {number} */ index) => Number(pad?.buttons[index]?.pressed ?? false);
    const ahead = Number(held.ahead) - Number(held.back) + pressed(12) - pressed(13) - axis(1);
    const turn = Number(held.left) - Number(held.right) + pressed(14) - pressed(15) - axis(0);
    return { ahead: Math.min(Math.max(ahead, -1), 1), turn: Math.min(Math.max(turn, -1), 1) };
  }

  /** @param {number} now */
  function loop(now) {
    if (!on) return;
    requestAnimationFrame(loop);
    if (asking) return;
    const ticks = pace.owed(now);
    if (ticks < 1) return;
    pace.paid(ticks);
    const next = command();
    const written = JSON.stringify(next);
    const changes = written !== told;
    told = written;
    commands += Number(changes);
    asking = true;
    match
      .step(ticks, changes ? next : undefined)
      .then(() => {
        asking = false;
        playback.seek(match.front());
        if (match.over) void end();
        else if (commands + (match.scenario?.events?.length ?? 0) > MOST_EVENTS) {
          say(words.tooMany);
          void end();
        }
      })
      .catch(() => {
        asking = false; // the engine has ended; the tab says so
        on = false;
      });
  }

  keys.addEventListener(
    'keydown',
    (event) => {
      if (!on || event.ctrlKey || event.altKey || event.metaKey) return;
      if (event.key === 'Escape') void end();
      else if (KEYS[event.key]) held[KEYS[event.key]] = true;
      else return;
      event.preventDefault();
      event.stopPropagation();
    },
    true,
  );
  keys.addEventListener('keyup', (event) => {
    if (KEYS[event.key]) held[KEYS[event.key]] = false;
  });
  window.addEventListener('blur', () => Object.assign(held, { ahead: false, back: false, left: false, right: false }));

  return {
    element,
    driving: () => on,
    end,
    /** The engine has ended. */
    abandon() {
      on = false;
      write(start, words.start);
      write(said, '');
      robot.disabled = false;
    },
  };
}
