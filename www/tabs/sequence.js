import '../style/sequence.css';
import { createEngine } from '../engine.js';
import { createPlanner } from '../sequence/planner.js';
import { createPlayback } from '../sequence/playback.js';
import { createBoard } from '../sequence/board.js';
import { readPresets } from '../sequence/library.js';
import { createSequenceSession } from '../sequence/session.js';
import { createState } from '../state.js';
import { text } from '../ui/strings.en.js';
import { createNotices } from '../ui/notices.js';
import { sequenceText } from '../ui/strings.sequence.en.js';
import { createFault } from '../views/fault.js';
import { createSequenceFrame } from '../views/sequence/frame.js';
import { createOpening } from './opening.js';

/** @import { Address, Tab } from '../router.js' */
/** @import { Board } from '../sequence/board.js' */
/** @import { SequenceSession } from '../sequence/session.js' */
/** @import { ThemeSwitch } from '../ui/theme.js' */

const FIELDS = 'input:not([type=range]):not([type=checkbox]), textarea';

/**
 * The tab Sequence: the best order of swarm behaviours, found while one drags the obstacles.
 *
 * @param {{ element: HTMLElement, address: Address, built: () => void, live: HTMLElement, themes: ThemeSwitch }} parts
 * @returns {Tab}
 */
export function createSequence({ element, address, built, live, themes }) {
  const frame = createSequenceFrame(element);
  const state = createState(element);
  const notices = createNotices(frame.pane, live);
  const fault = createFault(frame.pane, notices.say);
  const spawn = () => new Worker(new URL('../sequence/worker.js', import.meta.url), { type: 'module' });
  const engine = createEngine(broke, spawn);
  const planner = createPlanner(engine);
  const playback = createPlayback();
  /** @type {Record<string, () => void>} */
  const actions = {};
  /** @type {SequenceSession | null} */
  let session = null;
  /** @type {Board | null} */
  let board = null;

  /** @param {string} hash */
  async function begin(hash) {
    engine.start();
    const { version, schema } = await engine.request('hello');
    session = createSequenceSession({ engine, planner, playback, address, schema, version, presets: readPresets(), say: notices.say });
    board = createBoard({ element, frame, state, planner, playback, session, themes, spawn, broke, say: notices.say, announce: notices.announce });
    Object.assign(actions, board.actions);
    built();
    await session.openLink(hash);
    board.begin();
  }

  /** The engine failed: its worker is ended; a new one plans for the same scenario. @param {string} message */
  function broke(message) {
    const ready = session;
    playback.pause();
    state.to('error', message);
    planner.abandon();
    board?.abandon();
    const again = async () => {
      state.to('loading');
      engine.start();
      await ready?.reload();
      await board?.besideAsAsked();
    };
    fault.broke(message, { version: ready?.version ?? '', tick: 0, again: ready && planner.task ? () => void again() : null, words: sequenceText.broken });
  }

  document.addEventListener('keydown', (event) => {
    const undoes = /^z$/i.test(event.key) && !event.shiftKey;
    const redoes = /^y$/i.test(event.key) || (/^z$/i.test(event.key) && event.shiftKey);
    if (element.hidden || event.defaultPrevented || event.altKey || !(event.ctrlKey || event.metaKey) || !(undoes || redoes)) return;
    if (!session || document.activeElement?.matches(FIELDS)) return; // a field takes back what was typed in it
    event.preventDefault();
    if (undoes) void session.undo();
    else void session.redo();
  });

  let rested = false; // whether the search was interrupted because the page was left
  const back = () => {
    if (element.hidden || document.hidden || !rested) return;
    rested = false;
    void planner.resume().catch(() => {}); // an engine that broke has said so itself
  };
  new MutationObserver(back).observe(element, { attributes: true, attributeFilter: ['hidden'] });
  document.addEventListener('visibilitychange', back);

  return {
    state,
    actions,
    regions: [frame.pane, frame.transport],
    async share() {
      if (!session) throw new Error(text.fault.noWasm);
      const { scenario, preset, version } = session;
      return {
        hash: await session.link(),
        title: String(scenario.title ?? preset),
        version,
        seed: scenario.seed,
        tick: playback.step,
        fingerprint: '',
        file: { name: `sequence-${preset}-seed${scenario.seed}.json`, text: JSON.stringify(scenario, null, 2) },
        world: 'sequencing',
        plan: board?.own() ?? session.hand,
      };
    },
    pause() {
      playback.pause();
      rested ||= planner.status === 'searching';
      planner.hold();
      board?.pause();
    },
    open: createOpening({ state, broke, begin, again: async (hash) => (notices.clear(), session?.openLink(hash)) }),
  };
}
