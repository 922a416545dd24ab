import '../style/studies.css';
import { createEngine } from '../engine.js';
import { createState } from '../state.js';
import { createCommitted } from '../studies/committed.js';
import { readPresets, readStudies } from '../studies/library.js';
import { LIST } from '../studies/link.js';
import { createStudyRun } from '../studies/run.js';
import { createStudySession } from '../studies/session.js';
import { createSpeed } from '../studies/speed.js';
import { createStore, keyOf } from '../studies/store.js';
import { text } from '../ui/strings.en.js';
import { createNotices } from '../ui/notices.js';
import { studiesText } from '../ui/strings.studies.en.js';
import { createFault } from '../views/fault.js';
import { createStudyBar } from '../views/studies/bar.js';
import { createStudyFoot } from '../views/studies/foot.js';
import { createStudyForm } from '../views/studies/form.js';
import { createStudiesFrame } from '../views/studies/frame.js';
import { createStudyList } from '../views/studies/list.js';
import { createStudyResults } from '../views/studies/results.js';
import { createStudyText } from '../views/studies/text.js';
import { createOpening } from './opening.js';

/** @import { Address, Tab } from '../router.js' */
/** @import { StudySession } from '../studies/session.js' */

const ANNOUNCE_MS = 30_000;

/**
 * The tab Studies: many runs of a scenario and its variants, and what they say together.
 *
 * @param {{ element: HTMLElement, address: Address, built: () => void, live: HTMLElement }} parts
 * @returns {Tab}
 */
export function createStudies({ element, address, built, live }) {
  const frame = createStudiesFrame(element);
  const state = createState(element);
  const notices = createNotices(frame.notes, live);
  const fault = createFault(frame.notes, notices.say);
  const speed = createSpeed();
  const store = createStore((full) => notices.say(full ? studiesText.said.full : studiesText.said.notKept, 'problem'));
  const desk = createEngine(broke, () => new Worker(new URL('../studies/desk.js', import.meta.url), { type: 'module' }));
  const cores = navigator.hardwareConcurrency || 2;
  const run = createStudyRun({
    desk,
    store,
    state,
    speed,
    module: () => WebAssembly.compileStreaming(fetch(new URL('../studies/engine/swarm_playground_bg.wasm', import.meta.url))),
    spawn: () => new Worker(new URL('../studies/worker.js', import.meta.url), { type: 'module' }),
    say: notices.say,
  });
  run.workers = Math.max(1, cores - 1);
  const presets = readPresets();
  /** @type {Record<string, () => void>} */
  const actions = {};
  /** @type {StudySession | null} */
  let session = null;
  let announced = 0;

  frame.show(true);

  /** @param {string} hash */
  async function begin(hash) {
    desk.start();
    const { version, schema, metrics } = await desk.request('hello', { presets });
    session = createStudySession({ desk, run, address, files: readStudies(), version, schema, metrics, say: notices.say });
    build(session);
    await session.openLink(hash);
  }

  /** Puts the tab together. @param {StudySession} ready */
  function build(ready) {
    const files = readStudies();
    const original = () => files.find(({ name }) => name === ready.name)?.json ?? null;
    const list = createStudyList({ pane: frame.list, element, session: ready, store, speed, workers: () => run.workers, say: notices.say });
    const results = createStudyResults({ pane: frame.results, run, session: ready, state, speed, committed: createCommitted(desk), say: notices.say });
    createStudyForm({ pane: frame.form, session: ready, presets });
    createStudyText({ pane: frame.words, session: ready, original, unfold: frame.unfold });
    createStudyBar({ pane: frame.bar, run, session: ready, state, speed, cores });
    createStudyFoot({ pane: frame.foot, run, session: ready, shown: results.shown, origin: results.origin, say: notices.say });
    Object.assign(actions, { toggle: () => !ready.list && run.toggle() });
    built();

    let listed = false;
    ready.on(() => {
      frame.show(ready.list);
      if (ready.list && !listed) {
        if (state.name === 'loading') state.to('paused');
        void list.show().catch(() => {}); // a desk that broke has said so itself
      }
      if (!ready.list && ready.fault && state.name === 'loading') state.to('paused');
      listed = ready.list;
    });
    run.on('plan', () => void findOthers().catch(() => {}));
    run.on('moved', (what) => {
      const [done, all] = [run.done(), run.plan?.runs ?? 0];
      announced = performance.now();
      if (what === 'started') notices.announce(studiesText.said.started(all - done));
      if (what === 'paused') notices.announce(studiesText.said.paused(done, all));
      if (what === 'stopped') notices.announce(studiesText.said.stopped(done, all));
      if (what === 'finished') notices.announce(studiesText.said.finished(all));
    });
    run.on('progress', () => {
      if (state.name !== 'busy' || performance.now() - announced < ANNOUNCE_MS) return;
      announced = performance.now();
      notices.announce(studiesText.said.progress(run.done(), run.plan?.runs ?? 0));
    });
  }

  let found = ''; // of which study it was told what is kept

  /** Tells once for each study what is kept of it, also by other versions. */
  async function findOthers() {
    const { plan } = run;
    if (!plan || found === plan.hash) return;
    found = plan.hash;
    if (run.done() > 0 && run.done() < plan.runs) notices.say(studiesText.said.found(run.done(), plan.runs));
    const counts = [...(await store.counts())].filter(([study]) => study.endsWith(`/${plan.hash}`) && study !== keyOf(plan.version, plan.hash));
    if (counts.length === 0) return;
    const rows = counts.reduce((sum, [, count]) => sum + count, 0);
    const versions = counts.map(([study]) => study.slice(0, study.indexOf('/'))).join(', ');
    const press = () => counts.forEach(([study]) => void store.clear(study));
    notices.say(studiesText.results.otherVersions(rows, versions), 'note', [{ label: studiesText.results.clearOther, press }]);
  }

  /** The desk failed: its worker is ended; a new one reads the same text. @param {string} message */
  function broke(message) {
    const ready = session;
    state.to('error', message);
    run.close();
    const again = async () => {
      state.to('loading');
      desk.start();
      await desk.request('hello', { presets });
      await ready?.reload();
      if (state.name === 'loading') state.to('paused');
    };
    fault.broke(message, { version: ready?.version ?? '', tick: 0, again: ready && (() => void again().catch(() => {})), words: studiesText.broken });
  }

  return {
    state,
    actions,
    regions: [frame.results, frame.bar],
    async share() {
      if (!session) throw new Error(text.fault.noWasm);
      const name = session.name ?? session.outline?.name ?? 'studies';
      return {
        hash: session.list ? LIST : await session.link(),
        title: session.outline?.name ?? name,
        version: session.version,
        seed: null,
        tick: null,
        fingerprint: session.list ? '' : (run.plan?.hash ?? ''),
        file: { name: `${name}.study.json`, text: session.list ? '' : session.text },
        world: 'studies',
      };
    },
    // Workers go on while the browser shows another page; another tab of this page gets the processor.
    pause: () => void (document.hidden || run.pause()),
    open: createOpening({ state, broke, begin, again: async (hash) => (notices.clear(), session?.openLink(hash)) }),
  };
}
