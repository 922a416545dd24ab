import '../style/trees.css';
import { createEngine } from '../engine.js';
import { createState } from '../state.js';
import { createTreeRun } from '../trees/run.js';
import { createWorkbench } from '../trees/workbench.js';
import { text } from '../ui/strings.en.js';
import { createNotices } from '../ui/notices.js';
import { createFault } from '../views/fault.js';
import { createBenchFrame } from '../views/trees/frame.js';
import { createOpening } from './opening.js';

/** @import { Address, Tab } from '../router.js' */
/** @import { Workbench } from '../trees/workbench.js' */

const FIELDS = 'input:not([type=range]):not([type=checkbox]):not([type=radio]), textarea';

/**
 * The tab Trees: a workbench for behaviour trees.
 *
 * @param {{ element: HTMLElement, address: Address, built: () => void, live: HTMLElement, playCoach: (xml: string) => Promise<void> }} parts
 *   `playCoach` lets a tree coach a team in the tab Soccer
 * @returns {Tab & { openTree: (xml: string, title: string) => void }}
 */
export function createTrees({ element, address, built, live, playCoach }) {
  const frame = createBenchFrame(element);
  const state = createState(element);
  const notices = createNotices(frame.drawing, live);
  const fault = createFault(frame.drawing, notices.say);
  const engine = createEngine(broke, () => new Worker(new URL('../trees/worker.js', import.meta.url), { type: 'module' }));
  const run = createTreeRun(engine, state);
  /** @type {Record<string, () => void>} */
  const actions = {};
  const regions = [frame.drawing, frame.transport];
  /** @type {Workbench | null} */
  let workbench = null;

  /** @param {string} hash */
  async function begin(hash) {
    engine.start();
    const { version, models } = await engine.request('hello');
    workbench = createWorkbench({ engine, run, state, address, frame, version, models, playCoach, say: notices.say, announce: notices.announce });
    Object.assign(actions, workbench.actions);
    regions.push(workbench.afterText);
    built();
    await workbench.session.openLink(hash);
  }

  /** The engine failed: its worker is ended; a new one takes the setup to the tick it had reached. @param {string} message */
  function broke(message) {
    const { tick, length } = run;
    const ready = workbench;
    state.to('error', message);
    run.abandon();
    ready?.bench.abandon();
    const again = async () => {
      state.to('loading');
      engine.start();
      await ready?.session.reload({ length, at: tick });
    };
    fault.broke(message, { version: ready?.session.version ?? '', tick, again: ready && run.tree ? again : null });
  }

  document.addEventListener('keydown', (event) => {
    const undoes = /^z$/i.test(event.key) && !event.shiftKey;
    const redoes = /^y$/i.test(event.key) || (/^z$/i.test(event.key) && event.shiftKey);
    if (element.hidden || event.defaultPrevented || event.altKey || !(event.ctrlKey || event.metaKey) || !(undoes || redoes)) return;
    if (!workbench || document.activeElement?.matches(FIELDS)) return; // a field takes back what was typed in it
    event.preventDefault();
    if (undoes) workbench.session.undo();
    else workbench.session.redo();
  });

  return {
    state,
    actions,
    regions,
    pause: run.pause,
    async share() {
      if (!workbench) throw new Error(text.fault.noWasm);
      run.pause();
      const { session } = workbench;
      const { xml, ...rest } = session.setup();
      const name = session.entry()?.name ?? 'tree';
      return {
        hash: await session.link(),
        title: session.entry()?.title || session.rest().title || run.tree?.main || name,
        version: session.version,
        seed: null,
        tick: run.tick,
        fingerprint: session.stale ? '' : (run.moment?.fingerprint ?? ''),
        file: { name: `${name}.json`, text: JSON.stringify({ version: session.version, xml, ...rest, length: run.length, at: run.tick }, null, 2) },
        world: 'trees',
      };
    },
    open: createOpening({ state, broke, begin, again: async (hash) => (notices.clear(), workbench?.session.openLink(hash)) }),
    openTree: (xml, title) => void workbench?.session.openText(xml, title),
  };
}

/** @typedef {ReturnType<typeof createTrees>} TreesTab */
