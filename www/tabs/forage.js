import { EngineError, createEngine } from '../engine.js';
import { createLens } from '../lens.js';
import { createRun } from '../run.js';
import { createSelection } from '../selection.js';
import { createSession, messageOf } from '../session.js';
import { createState } from '../state.js';
import { button, find } from '../ui/dom.js';
import { createNotices } from '../ui/notices.js';
import { onStorageBlocked } from '../ui/storage.js';
import { text } from '../ui/strings.en.js';
import { createControls } from '../views/controls.js';
import { createFiles } from '../files/files.js';
import { createFault } from '../views/fault.js';
import { createFoot } from '../views/foot.js';
import { createInspector } from '../views/inspector.js';
import { createLanding, openingOf } from '../views/landing.js';
import { createLegend } from '../views/legend.js';
import { createTransport } from '../views/transport.js';
import { createWorldView } from '../views/world.js';
import { createOpening } from './opening.js';

/** @import { Address, Tab } from '../router.js' */
/** @import { Compare } from '../ab/compare.js' */
/** @import { Beside, Preset, Session } from '../session.js' */
/** @import { ThemeSwitch } from '../ui/theme.js' */

const OPENING_PRESET = 'foraging';

/**
 * The tab Forage: the swarm, its world and its inspector.
 *
 * @param {{ address: Address, built: () => void, live: HTMLElement, themes: ThemeSwitch, openTree: (xml: string, title: string) => Promise<void> }} parts
 *   `openTree` shows a tree in the workbench
 * @returns {Tab}
 */
export function createForage({ address, built, live, themes, openTree }) {
  const pane = find('#world');
  const transportPane = find('#transport');
  const state = createState(find('#forage'));
  const notices = createNotices(pane, live);
  const fault = createFault(pane, notices.say);
  const selection = createSelection();
  const landing = createLanding();
  const spawn = () => new Worker(new URL('../worker.js', import.meta.url), { type: 'module' });
  const engine = createEngine(broke, spawn);
  /** Where the requests of the run go; in A | B to both engines. */
  const desk = { request: engine.request, cancel: engine.cancel };
  const run = createRun(desk, state);
  /** A | B, loaded when it is first asked for. @type {Promise<Compare> | null} */
  let loading = null;
  /** @type {Compare | null} */
  let compare = null;
  /** @type {Beside} */
  const beside = {
    async open(parts, scenario) {
      try {
        if (parts.beside.length > 0 || compare) return await (await loadCompare()).open(parts, scenario);
      } catch (error) {
        if (error instanceof EngineError) throw error;
        parts.problems.push(text.compare.missing(messageOf(error))); // A is there without it
      }
      return async () => {};
    },
    verdict: (parts) => compare?.verdict(parts) ?? '',
    link: async () => compare?.link() ?? [],
  };
  /** @type {() => Promise<Compare>} */
  let loadCompare = () => Promise.reject(new Error());
  /** @type {Record<string, () => void>} */
  const actions = {};
  /** @type {Session | null} */
  let session = null;
  let waiting = true; // whether the still is seen
  let invalidate = () => {};

  pane.setAttribute('aria-label', text.world.region);
  onStorageBlocked(() => notices.say(text.notSaved));

  /** @param {string} hash */
  async function begin(hash) {
    engine.start();
    const hello = await engine.request('hello');
    session = createSession({ engine, run, state, address, beside, schema: hello.schema, version: hello.version, presets: readPresets(), say: notices.say });
    build(session);
    const opening = openingOf(hash);
    if (!opening || landing.wished()) shown();
    const mayMove = await session.open(landing.wished() ? opening.replace(/&t=.*/, '') : opening || hash, opening !== '');
    shown();
    if (landing.wished()) landing.now();
    else if ((mayMove || opening) && !matchMedia('(prefers-reduced-motion: reduce)').matches) run.play();
  }

  /** From now on the live world is seen. */
  function shown() {
    if (!waiting) return;
    waiting = false;
    invalidate();
  }

  /** Puts the tab together. @param {Session} ready */
  function build(ready) {
    const { theme } = themes;
    const world = createWorldView({
      pane,
      run,
      state,
      selection,
      theme,
      drawn: () => (foot.drew(), compare?.drew()),
      rings: () => compare?.rings() ?? true,
      covered: () => waiting,
    });
    invalidate = world.invalidate;
    const lens = createLens(run, { request: engine.request, run, world: () => world, side: '' });
    const files = createFiles({ element: find('#forage'), engine: lens.engine, lens, run, session: ready, say: notices.say });
    createLegend({ pane, run, lens, state, selection, world });
    createControls({ pane: find('#controls'), engine, run, session: ready, files });
    const comparing = button(text.compare.label, () => void toggleCompare(), { action: 'compare', title: text.compare.title });
    comparing.setAttribute('aria-pressed', 'false');
    world.head.append(comparing);
    const inspector = createInspector({
      pane: find('#inspector'),
      engine: lens.engine,
      run: lens.run,
      state,
      selection,
      theme,
      onTheme: themes.on,
      ringed: world.showRinged,
      openTree,
      say: notices.say,
    });
    const transport = createTransport({ pane: transportPane, run, state, session: ready, say: notices.say });
    const foot = createFoot({
      pane: find('#foot'),
      run,
      lens,
      state,
      session: ready,
      theme,
      open: files.choose,
      treeSvg: inspector.treeSvg,
      say: notices.say,
    });
    themes.on(world.invalidate);
    landing.ready({ ready, run, fastest: transport.fastest, charts: () => inspector.open('charts') });
    loadCompare = async () => {
      loading ??= import('../ab/compare.js').then(({ createCompare }) =>
        createCompare({
          engine,
          desk,
          lens,
          run,
          state,
          session: ready,
          selection,
          world,
          theme,
          onTheme: themes.on,
          pane,
          controls: find('#controls'),
          inspector: find('#inspector'),
          broke,
          spawn,
          pressed: (on) => comparing.setAttribute('aria-pressed', String(on)),
          say: notices.say,
          announce: notices.announce,
        }),
      );
      try {
        compare = await loading;
      } catch (error) {
        loading = null; // a later wish tries again
        throw error;
      }
      return compare;
    };
    const toggleCompare = async () => {
      try {
        await (await loadCompare()).toggle();
      } catch (error) {
        if (state.name !== 'error') notices.say(text.compare.missing(messageOf(error)), 'problem');
      }
    };
    Object.assign(actions, {
      toggle: run.toggle,
      forward: () => void run.step(1),
      back: () => void run.step(-1),
      'far-forward': () => void run.step(100),
      'far-back': () => void run.step(-100),
      restart: () => void ready.restart(),
      'new-seed': transport.newSeed,
      faster: transport.faster,
      slower: transport.slower,
      follow: selection.toggleFollow,
      compare: () => void toggleCompare(),
      clear: () => (inspector.close(), selection.clear()),
    });
    built();

    run.on('settled', () => void ready.writeAddress());
    run.on('scenario', () => void ready.writeAddress());
    state.on((name, reason) => {
      if (name === 'running') notices.announce(text.said.running);
      if (name === 'paused') notices.announce(text.said.paused(run.tick));
      if (name === 'finished') notices.announce(text.said.finished(reason, run.tick));
    });
  }

  /** The engine failed: its worker is ended; a new one takes the scenario to the tick it had reached. @param {string} message */
  function broke(message) {
    const { tick, scenario } = run;
    const ready = session;
    state.to('error', message);
    run.abandon();
    const again = async () => {
      engine.start();
      compare?.revive();
      try {
        await run.load(scenario);
        await run.seek(tick);
      } catch (error) {
        // An engine that broke once more has said so itself; whatever else it is, there must be a way on.
        if (state.name !== 'error' || !(error instanceof EngineError && error.fatal)) broke(messageOf(error));
      }
    };
    fault.broke(message, { version: ready?.version ?? '', tick, again: ready && run.layout ? again : null });
  }

  return {
    state,
    actions,
    regions: [pane, transportPane],
    pause: run.pause,
    async share() {
      if (!session) throw new Error(text.fault.noWasm);
      await run.mark();
      const { scenario, fingerprintTick, fingerprint } = run;
      return {
        hash: await session.link(),
        title: String(scenario.title ?? session.preset),
        version: session.version,
        seed: scenario.seed,
        tick: fingerprintTick,
        fingerprint,
        file: { name: `swarm-${session.preset}-seed${scenario.seed}.json`, text: JSON.stringify(scenario, null, 2) },
        world: 'geese',
      };
    },
    open: createOpening({ state, broke, begin, again: async (hash) => (notices.clear(), session?.open(hash)) }),
  };
}

/** Presets are files, read alike by the page, the command line and the tests; those of other worlds are left out. @returns {Preset[]} the opening one first */
function readPresets() {
  const files = /** @type {Record<string, string>} */ (import.meta.glob(['/scenarios/*.json', '!/scenarios/{navigation,coverage,plan-*,match*}.json'], { query: '?raw', import: 'default', eager: true }));
  return Object.entries(files)
    .map(([path, json]) => {
      const name = path.replace(/^.*\/|\.json$/g, '');
      const { title, about } = JSON.parse(json);
      return { name, title: String(title ?? name), about: String(about ?? ''), json };
    })
    .sort((a, b) => Number(b.name === OPENING_PRESET) - Number(a.name === OPENING_PRESET) || a.name.localeCompare(b.name));
}
