import { recall, remember } from '../ui/storage.js';

/** @import { Planner } from './planner.js' */
/** @import { Playback } from './playback.js' */
/** @import { SequenceSession } from './session.js' */
/** @import { Path, Scenario } from './types.js' */

const KEPT = 'plan-games';
const MOST_KEPT = 50;

/**
 * @typedef {object} Result a game that has ended
 * @property {string} letters
 * @property {number} cost metres; what was gone before a collision when it failed
 * @property {boolean} goal
 * @property {boolean} collided
 *
 * @typedef {'off' | 'ready' | 'on' | 'over'} Stage
 */

/**
 * Beat the planner: one chooses a behaviour for every interval while the swarm moves on, and sees what an operator would
 * see: the map and the robots. Who chooses nothing keeps the behaviour; the first interval waits for a choice.
 *
 * @param {{ planner: Planner, playback: Playback, session: SequenceSession, changed: () => void, announce: (message: string) => void,
 *   words: { ended: (result: Result) => string, chosen: (name: string, interval: number) => string } }} parts
 */
export function createGame({ planner, playback, session, changed, announce, words }) {
  let pace = 4; // seconds of the player for one interval; 0 waits for every choice
  /** @type {string[]} */
  let letters = [];
  /** @type {string | null} the choice for the next interval */
  let next = null;
  /** @type {Path | null} what was carried out so far, and the interval under way */
  let path = null;
  /** @type {Result | null} */
  let result = null;
  let asking = false;

  const game = {
    /** @type {Stage} */
    stage: 'off',
    /** Seconds that the player has for each choice; 0 is as long as wanted. */
    pace: () => pace,
    path: () => path,
    result: () => result,
    chosen: () => next,
    /** The interval under way, from 0. */
    interval: () => Math.max(0, letters.length - 1),
    letters: () => letters.join(''),
    /** Whether what the search found is hidden. */
    hides: () => game.stage === 'ready' || game.stage === 'on',
    /** Whether the swarm waits for the player. */
    waits: () => game.stage === 'ready' || (game.stage === 'on' && !playback.playing && playback.step >= playback.end()),

    /** @param {number} seconds */
    setPace(seconds) {
      pace = seconds;
      changed();
    },

    /** Takes the plan off the screen and waits for the first choice. */
    begin() {
      letters = [];
      next = null;
      path = null;
      result = null;
      game.stage = 'ready';
      planner.hold();
      playback.pause();
      playback.show(null);
      playback.step = 0;
      changed();
    },

    /** The plan is shown again. */
    end() {
      game.stage = 'off';
      playback.pause();
      playback.show(session.path());
      playback.seek(0);
      changed();
    },

    /** @param {string} letter */
    async choose(letter) {
      if (!game.hides() || asking) return;
      next = letter;
      const name = planner.task?.library.find((behaviour) => behaviour.letter === letter)?.name ?? letter;
      announce(words.chosen(name, letters.length + 1));
      if (game.waits()) await go();
      else changed();
    },

    /** The best result for this layout and these behaviours; null when there is none. @returns {Result | null} */
    best: () => read().find(({ key }) => key === keyOf(session.scenario))?.result ?? null,
  };

  /** Carries out the next interval. */
  async function go() {
    const { task } = planner;
    if (!task) return;
    const letter = next ?? letters[letters.length - 1];
    if (letter === undefined) return;
    asking = true;
    letters.push(letter);
    next = null;
    try {
      path = await planner.follow(letters.join(''));
    } catch {
      game.stage = 'off'; // the engine has ended; the tab says so
      return;
    } finally {
      asking = false;
    }
    if (game.stage === 'ready') game.stage = 'on';
    playback.pace.ticksPerSecond = pace === 0 ? task.steps / 2 : task.steps / pace;
    const from = (letters.length - 1) * task.steps;
    playback.path = path;
    playback.step = from;
    if (playback.end() > from) playback.play();
    else over();
    changed();
  }

  /** An interval has ended: the next one, or the end. */
  function moved() {
    if (game.stage !== 'on' || playback.playing || asking || !planner.task || path === null) return;
    if (playback.step < playback.end()) return; // somebody has paused
    const { replay } = path;
    if (replay.collision || replay.goal || letters.length >= planner.task.decisions) over();
    else if (next !== null || pace > 0) void go();
    else changed();
  }

  function over() {
    if (!path) return;
    const { replay } = path;
    result = { letters: letters.join(''), cost: replay.total, goal: replay.goal && !replay.collision, collided: replay.collision !== null };
    game.stage = 'over';
    if (result.goal) keep(session.scenario, result);
    announce(words.ended(result));
    changed();
    if (planner.status === 'held') void planner.resume(); // now the planner may show what it can
  }

  playback.on(moved);
  return game;
}

/** @typedef {ReturnType<typeof createGame>} Game */

/** @returns {{ key: string, result: Result }[]} */
function read() {
  try {
    const list = JSON.parse(recall(KEPT) ?? '[]');
    return Array.isArray(list) ? list.filter((entry) => typeof entry?.key === 'string' && typeof entry.result?.cost === 'number') : [];
  } catch {
    return [];
  }
}

/** Keeps a result that is the best of its task. @param {Scenario} scenario @param {Result} result */
function keep(scenario, result) {
  const key = keyOf(scenario);
  const list = read();
  const known = list.find((entry) => entry.key === key);
  if (known && known.result.cost <= result.cost) return;
  remember(KEPT, JSON.stringify([{ key, result }, ...list.filter((entry) => entry !== known)].slice(0, MOST_KEPT)));
}

const NOT_OF_THE_TASK = /^(title|about|method|weight|anchor-weight|second-weight|rounding|eager|geodesic|forecast|batch|budget|memory|prefix|jitter|jitter-runs|events|.*-margin)$/;

/** @type {WeakMap<Scenario, string>} */
const keys = new WeakMap();

/** What a game is of: everything but how the planner searches. @param {Scenario} scenario */
function keyOf(scenario) {
  const known = keys.get(scenario);
  if (known !== undefined) return known;
  const text = JSON.stringify(Object.entries(scenario).filter(([field]) => !NOT_OF_THE_TASK.test(field)));
  let hash = 0xcbf29ce484222325n;
  for (let at = 0; at < text.length; at += 1) hash = BigInt.asUintN(64, (hash ^ BigInt(text.charCodeAt(at))) * 0x100000001b3n);
  keys.set(scenario, hash.toString(16));
  return hash.toString(16);
}
