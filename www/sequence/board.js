import { createFan } from './fan.js';
import { createGame } from './game.js';
import { createHold } from './hold.js';
import { kindOf, metres, verdictOf } from './words.js';
import { messageOf } from '../session.js';
import { button } from '../ui/dom.js';
import { sequenceText } from '../ui/strings.sequence.en.js';
import { text } from '../ui/strings.en.js';
import { createScenarioFiles } from '../views/scenariofiles.js';
import { createSequenceControls } from '../views/sequence/controls.js';
import { createSequenceFoot } from '../views/sequence/foot.js';
import { createGameTab } from '../views/sequence/gametab.js';
import { createHandles } from '../views/sequence/handles.js';
import { createSequenceInspector } from '../views/sequence/inspector.js';
import { createSequenceLegend } from '../views/sequence/legend.js';
import { createMap } from '../views/sequence/map.js';
import { createPlanTab } from '../views/sequence/plantab.js';
import { createRibbon } from '../views/sequence/ribbon.js';
import { createRobotTab } from '../views/sequence/robottab.js';
import { createSearchTab } from '../views/sequence/searchtab.js';
import { bindMapKeys, createTools } from '../views/sequence/tools.js';
import { createSequenceTransport } from '../views/sequence/transport.js';

/** @import { PlanTheme } from '../draw/sequence.js' */
/** @import { State } from '../state.js' */
/** @import { ThemeSwitch } from '../ui/theme.js' */
/** @import { SequenceFrame } from '../views/sequence/frame.js' */
/** @import { SequenceCompare } from './compare.js' */
/** @import { Planner } from './planner.js' */
/** @import { Playback } from './playback.js' */
/** @import { SequenceSession } from './session.js' */
/** @import { Task } from './types.js' */

const TABLE_MS = 100; // a table is written at most ten times a second while it plays

/**
 * Everything of the tab put together: what is on screen follows from scenario, search, plan and moment.
 *
 * @param {{ element: HTMLElement, frame: SequenceFrame, state: State, planner: Planner, playback: Playback, session: SequenceSession, themes: ThemeSwitch,
 *   spawn: () => Worker, broke: (message: string) => void, say: (message: string, kind?: 'note' | 'problem', offers?: { label: string, press: () => void }[]) => void,
 *   announce: (message: string) => void }} parts
 */
export function createBoard({ element, frame, state, planner, playback, session, themes, spawn, broke, say, announce }) {
  const layers = { robots: true, plan: true, frontier: true, fan: true };
  const theme = () => /** @type {PlanTheme} */ ({ ...themes.theme(), plan: getComputedStyle(element).getPropertyValue('--plan').trim() });
  let told = '';

  const hold = createHold({ session, task, changed: show });
  const game = createGame({
    planner,
    playback,
    session,
    changed: show,
    announce,
    words: { ended: (result) => sequenceText.game.result(result.goal, result.collided, metres(result.cost), result.letters), chosen: sequenceText.game.chosen },
  });
  const fan = createFan({ planner, session, changed: show, announce });
  const map = createMap({
    label: sequenceText.map.label,
    scene: () => {
      const now = task();
      const stale = planner.stale && session.hand === null && game.stage === 'off';
      return now && { task: now, path: playback.path, step: playback.step, stale, start: now.start, layers: game.hides() ? { ...layers, frontier: false, plan: false, fan: false } : layers };
    },
    frontier: () => planner,
    fan: fan.drawn,
    theme,
    drawn: () => handles.show(),
  });
  const redraw = () => (map.invalidate(), compare?.redraw());
  const tools = createTools({ hold, session, task, finish: () => handles.finish(), changed: () => (handles.forget(), map.invalidate()) });
  const handles = createHandles({
    map,
    hold,
    task,
    tool: tools.tool,
    drawn: (form) => {
      tools.choose(null);
      void hold.add(form);
    },
  });
  const ribbon = createRibbon({ planner, playback, session, announce });
  const legend = createSequenceLegend({ layers, changed: redraw });
  const files = createScenarioFiles({ element, id: 'sequence-file', open: session.openFile, say });
  createSequenceControls({ pane: frame.controls, session, open: files.choose });
  const plan = createPlanTab({ planner, session, fan, kind: () => kindOf(planner) });
  const search = createSearchTab({ planner, theme, onTheme: themes.on });
  const robots = createRobotTab({ planner, playback, hold });
  const inspector = createSequenceInspector({
    pane: frame.inspector,
    playing: game.hides,
    panels: [
      { name: 'plan', label: sequenceText.inspector.plan, panel: { ...plan, secret: true } },
      { name: 'search', label: sequenceText.inspector.search, panel: { ...search, secret: true } },
      { name: 'robots', label: sequenceText.inspector.robots, panel: robots },
      { name: 'game', label: sequenceText.inspector.game, panel: createGameTab({ game, planner, playback }) },
    ],
  });
  const transport = createSequenceTransport({ pane: frame.transport, planner, playback, session, say });
  createSequenceFoot({ pane: frame.foot, planner, playback, session, map, theme, say });

  map.canvas.tabIndex = 0;
  map.canvas.setAttribute('role', 'application');
  map.canvas.setAttribute('aria-describedby', 'sequence-summary');
  bindMapKeys(map.canvas, hold, { escape: () => hold.choose(null) });
  frame.stages.append(map.stage);
  frame.pane.insertBefore(tools.element, frame.stages);
  frame.pane.append(legend.element, ribbon.element);
  themes.on(map.invalidate);

  /** A | B, loaded when it is first asked for. @type {Promise<SequenceCompare> | null} */
  let loading = null;
  /** @type {SequenceCompare | null} */
  let compare = null;
  const comparing = button(sequenceText.compare.label, toggleCompare, { action: 'compare', title: sequenceText.compare.title });
  comparing.setAttribute('aria-pressed', 'false');
  frame.head.append(comparing);

  let rested = false; // whether the search was interrupted for A | B
  /** Opens A | B. @param {string | null} wanted in what the two differ; null for what was compared last */
  async function showCompare(wanted = null) {
    try {
      loading ??= import('./compare.js').then(({ createCompare }) => createCompare({ frame, session, playback, layers, spawn, theme, onTheme: themes.on, broke, announce }));
      compare = await loading;
    } catch (error) {
      loading = null; // a later wish tries again
      say(sequenceText.compare.missing(messageOf(error)), 'problem');
      session.compare(null);
      return;
    }
    if (!compare.on()) {
      if (game.stage !== 'off') game.end();
      rested = planner.status === 'searching';
      planner.hold(); // two searches are enough
    }
    compare.open(wanted);
    showSides();
  }

  /** Closes A | B. @param {boolean} [again] whether the search of the page goes on */
  function closeCompare(again = true) {
    compare?.close();
    if (again && rested) void planner.resume();
    showSides();
  }

  function toggleCompare() {
    if (!compare?.on()) return void showCompare();
    session.compare(null);
    closeCompare();
  }

  /** A | B as the session asks for it: after a link, and after an engine that had ended. */
  async function besideAsAsked() {
    if (session.beside !== null) await showCompare(session.beside);
    else if (compare?.on()) closeCompare();
  }

  function showSides() {
    const on = compare?.on() ?? false;
    comparing.setAttribute('aria-pressed', String(on));
    frame.pane.classList.toggle('comparing', on);
    settle();
    show();
  }

  /** The task on screen: a placement that is being dragged stands where it is dragged to. @returns {Task | null} */
  function task() {
    const shown = hold?.shown();
    if (!planner.task || !shown) return planner.task;
    const goal = 'target' in planner.task.goal ? { target: /** @type {[number, number, number]} */ ([shown['target-x'], shown['target-y'], shown['target-radius']]) } : planner.task.goal;
    return { ...planner.task, goal, obstacles: shown['obstacle-list'], start: shown['start-list'] };
  }

  /** State and words follow from what goes on. */
  function settle() {
    if (state.name === 'error' || !planner.task) return;
    const searching = planner.status === 'searching';
    const ended = planner.status === 'ended' && !playback.playing;
    const name = playback.playing ? 'running' : searching ? 'busy' : ended ? 'finished' : 'paused';
    if (state.name !== name && (name === 'running' || state.name === 'running' || state.name === 'finished')) state.to('paused');
    state.to(name, ended ? kindOf(planner) : '');
    element.dataset.result = kindOf(planner);
  }

  function show() {
    const words = game.hides() ? sequenceText.game.hidden : verdictOf(planner);
    frame.pane.classList.toggle('gaming', game.hides());
    const tag = state.name === 'paused' ? text.tag('paused', '') : ''; // that it searches is said in words
    frame.show({ verdict: words, tag, refusal: session.refusal === '' ? '' : sequenceText.refused(sequenceText.plain(session.refusal)) });
    tools.show();
    inspector.show();
    showMoment();
    if (hold.chosen) tellChosen();
  }

  function showMoment() {
    map.invalidate();
    const now = planner.task;
    if (!now) return;
    const { path, step } = playback;
    const letter = path ? [...path.letters][Math.min(Math.floor(step / now.steps), path.letters.length - 1)] : '';
    const behaviour = now.library.find((entry) => entry.letter === letter)?.name ?? '';
    const { goal } = now;
    const visited = 'cells' in goal && path ? path.visits.reduce((count, visit) => count + Number(visit <= step), 0) : 0;
    const wanted = 'cells' in goal ? Math.ceil(goal.ratio * goal.cells.columns * goal.cells.rows) : 0;
    const covered = 'cells' in goal ? sequenceText.map.covered(visited, wanted) : '';
    legend.show({ frontier: String(planner.rowCount || ''), robots: String(now.start.length) }, fan.drawn() !== null, `${sequenceText.map.summary(step / 10, now.start.length, now.obstacles.length, behaviour)} ${covered}`);
  }

  let chosen = '';
  function tellChosen() {
    const place = hold.place();
    if (!hold.chosen || !place || hold.shown()) return;
    const said = sequenceText.said.chosen(sequenceText.tools.thing(hold.chosen.kind, hold.chosen.index), place.x, place.y);
    if (said !== chosen) announce(said);
    chosen = said;
  }

  session.on('path', () => {
    const path = session.path();
    if (game.stage === 'off' && path !== playback.path) playback.show(path);
    map.invalidate();
  });
  session.on('change', show);
  session.on('link', () => void besideAsAsked());
  planner.on('task', () => {
    if (game.stage !== 'off') game.end(); // it was of another task
    if (compare?.on()) {
      rested = true;
      planner.hold(); // A and B plan for it
    }
    if (hold.chosen && !hold.place()) hold.chosen = null;
    show();
  });
  planner.on('slice', () => {
    settle();
    show();
    if (planner.found && !planner.stale && hold.shown()) measure();
  });
  planner.on('ended', () => {
    const words = verdictOf(planner);
    if (words !== told && !hold.shown()) announce(words);
    told = words;
  });
  let tabulated = 0;
  playback.on(() => {
    settle();
    showMoment();
    if (inspector.current() !== 'robots' || (playback.playing && performance.now() - tabulated < TABLE_MS)) return;
    tabulated = performance.now();
    robots.show();
  });
  state.on((name) => {
    show();
    if (name === 'running') announce(sequenceText.said.playing);
  });
  playback.on(() => {
    if (!playback.playing) void later();
  });

  let writing = 0;
  /** Writes the moment into the address once it rests. */
  function later() {
    clearTimeout(writing);
    writing = window.setTimeout(() => void session.writeAddress(), 250);
  }

  inspector.begin();

  /** How long a placement took to its first plan, of which `detail` is the search: what the tests read. */
  function measure() {
    if (performance.getEntriesByName('placement asked').length === 0) return;
    performance.measure('first plan', { start: 'placement asked', detail: planner.ms });
    performance.clearMarks('placement asked');
  }

  return {
    besideAsAsked,
    /** The first scenario is there. */
    begin() {
      settle();
      show();
    },
    /** Letters of the game that was played last; null when none was. */
    own: () => game.result()?.letters ?? null,
    pause() {
      compare?.hold();
      settle();
      show();
    },
    /** The engine has ended. */
    abandon() {
      if (game.stage !== 'off') game.end();
      if (compare?.on()) closeCompare(false);
    },
    actions: {
      compare: toggleCompare,
      toggle: playback.toggle,
      forward: () => transport.step(1),
      back: () => transport.step(-1),
      'far-forward': () => transport.far(1),
      'far-back': () => transport.far(-1),
      restart: () => playback.seek(0),
      'new-seed': transport.newLayout,
      faster: transport.faster,
      slower: transport.slower,
      clear: () => (inspector.spread(false), tools.choose(null), hold.choose(null)),
    },
  };
}

/** @typedef {ReturnType<typeof createBoard>} Board */
