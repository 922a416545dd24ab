import '../style/soccer.css';
import { createEngine } from '../engine.js';
import { createSoccerBoard } from '../soccer/board.js';
import { readPresets } from '../soccer/library.js';
import { createMatch } from '../soccer/match.js';
import { createPlayback } from '../soccer/playback.js';
import { createSoccerSession } from '../soccer/session.js';
import { createState } from '../state.js';
import { createNotices } from '../ui/notices.js';
import { text } from '../ui/strings.en.js';
import { soccerText } from '../ui/strings.soccer.en.js';
import { createFault } from '../views/fault.js';
import { createSoccerFrame } from '../views/soccer/frame.js';
import { createOpening } from './opening.js';

/** @import { Address, Tab } from '../router.js' */
/** @import { SoccerBoard } from '../soccer/board.js' */
/** @import { SoccerSession } from '../soccer/session.js' */
/** @import { ThemeSwitch } from '../ui/theme.js' */

/**
 * The tab Soccer: a match of three against three, every decision of coaches and referee explained.
 *
 * @param {{ element: HTMLElement, address: Address, built: () => void, live: HTMLElement, themes: ThemeSwitch, openTree: (xml: string, title: string) => Promise<void> }} parts
 *   `openTree` shows a tree in the workbench
 * @returns {Tab & { playCoach: (xml: string) => Promise<void> }}
 */
export function createSoccer({ element, address, built, live, themes, openTree }) {
  const frame = createSoccerFrame(element);
  const state = createState(element);
  const notices = createNotices(frame.pane, live);
  const fault = createFault(frame.pane, notices.say);
  const spawn = () => new Worker(new URL('../soccer/worker.js', import.meta.url), { type: 'module' });
  const engine = createEngine(broke, spawn);
  const match = createMatch(engine);
  const playback = createPlayback(match);
  /** @type {Record<string, () => void>} */
  const actions = {};
  /** @type {SoccerSession | null} */
  let session = null;
  /** @type {SoccerBoard | null} */
  let board = null;

  /** @param {string} hash */
  async function begin(hash) {
    engine.start();
    const { version, schema, setting } = await engine.request('hello');
    session = createSoccerSession({ engine, match, playback, address, schema, setting, version, presets: readPresets(), say: notices.say });
    board = createSoccerBoard({ element, frame, state, engine, match, playback, session, themes, spawn, broke, openTree, say: notices.say, announce: notices.announce });
    Object.assign(actions, board.actions);
    built();
    await session.openLink(hash);
    board.show();
  }

  /** The engine failed: its worker is ended; a new one plays the same scenario. @param {string} message */
  function broke(message) {
    const ready = session;
    const { tick } = playback;
    playback.pause();
    state.to('error', message);
    match.abandon();
    board?.abandon();
    const again = async () => {
      state.to('loading');
      engine.start();
      await ready?.reload();
      await playback.reach(tick);
      await board?.besideAsAsked();
      board?.show();
    };
    fault.broke(message, { version: ready?.version ?? '', tick, again: ready && match.scenario ? () => void again() : null, words: soccerText.broken });
  }

  const back = () => {
    if (element.hidden || document.hidden) return;
    match.resume();
    board?.resume();
  };
  new MutationObserver(back).observe(element, { attributes: true, attributeFilter: ['hidden'] });
  document.addEventListener('visibilitychange', back);

  return {
    state,
    actions,
    regions: [frame.pane, frame.transport],
    async share() {
      if (!session) throw new Error(text.fault.noWasm);
      const { preset, version } = session;
      const scenario = session.scenario();
      return {
        hash: await session.link(),
        title: String(scenario.title ?? preset),
        version,
        seed: scenario.seed,
        tick: playback.tick,
        fingerprint: match.fingerprint,
        file: { name: `soccer-${preset}-seed${scenario.seed}.json`, text: JSON.stringify(scenario, null, 2) },
        world: 'soccer',
      };
    },
    pause() {
      playback.pause();
      match.hold();
      board?.pause();
    },
    open: createOpening({ state, broke, begin, again: async (hash) => (notices.clear(), session?.openLink(hash)) }),
    async playCoach(xml) {
      if (await session?.give('blue', 'coach', xml)) notices.say(soccerText.coach.applied);
    },
  };
}

/** @typedef {ReturnType<typeof createSoccer>} SoccerTab */
