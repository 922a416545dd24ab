import { text } from '../ui/strings.en.js';
import { benchText } from '../ui/strings.trees.en.js';
import { createBar } from '../views/trees/bar.js';
import { createCompare } from '../views/trees/compare.js';
import { createEditor } from '../views/trees/editor.js';
import { createBenchFigure } from '../views/trees/figure.js';
import { createBenchFoot } from '../views/trees/foot.js';
import { createBenchInspector } from '../views/trees/inspector.js';
import { createOpenPane } from '../views/trees/openpane.js';
import { createProblems } from '../views/trees/problems.js';
import { createTimeline } from '../views/trees/timeline.js';
import { createBenchTransport } from '../views/trees/transport.js';
import { createBench } from './bench.js';
import { readLibrary } from './library.js';
import { createTreeSession } from './session.js';
import { setupState } from './setup.js';

/** @import { Engine } from '../engine.js' */
/** @import { Address } from '../router.js' */
/** @import { State } from '../state.js' */
/** @import { BenchFrame } from '../views/trees/frame.js' */
/** @import { TreeRun } from './run.js' */
/** @import { NodeModel, Problem } from './types.js' */

/** What only trees that coach a soccer team have. */
const COACH = /<AssignStartRoles\b|ID="AssignStartRoles"/;

/**
 * Puts the tab together: session, editor, drawing and all panes, and who tells whom.
 *
 * @param {{ engine: Engine, run: TreeRun, state: State, address: Address, frame: BenchFrame, version: string, models: NodeModel[], playCoach: (xml: string) => Promise<void>,
 *   say: (message: string, kind?: 'note' | 'problem') => void, announce: (message: string) => void }} parts
 */
export function createWorkbench({ engine, run, state, address, frame, version, models, playCoach, say, announce }) {
  const editor = createEditor({ state: setupState, edited: (update) => session.edited(update), pointed, leave: () => problems.focus() });
  const session = createTreeSession({ run, address, version, library: readLibrary(), view: editor.view, compared: () => bench.compared(), say });
  const compareView = createCompare({ label: benchText.compare.label });
  const bench = createBench({ engine, run, session, editor, compareView, changed: show, say });
  const figure = createBenchFigure({ label: benchText.drawing.label, select: (id) => select(id), answer: bench.answerNode });
  const timeline = createTimeline({
    label: benchText.drawing.timeline,
    seek: (tick) => void run.seek(tick),
    select: (id) => select(id, true),
    fetch: async (from, to) => (await engine.request('timeline', { bench: 0, from, to })).timeline,
  });
  const bar = createBar({ figure, undo: session.undo, redo: session.redo, hit: (id) => select(id, true), compare: () => void bench.compare() });
  const openPane = createOpenPane({
    library: session.library,
    drafts: session.drafts,
    openEntry: (name) => void session.openEntry(name),
    restore: (draft) => void session.restore(draft),
    openFile: (name, content) => void session.openFile(name, content),
    refused: (message) => say(message, 'problem'),
  });
  const problems = createProblems({ find: editor.find, go: ({ line, column }) => editor.goTo(line, column), fixes: editor.fixes, apply: editor.fix });
  const inspector = createBenchInspector({
    pane: frame.inspector,
    standing: () => ({
      nodes: run.tree?.nodes ?? [],
      main: run.tree?.main ?? '',
      moment: run.moment,
      script: session.rest().script,
      selected: bench.marks.selected,
      breakpoints: bench.marks.breakpoints,
    }),
    select: (id) => select(id, true),
    answer: bench.answer,
    write: bench.write,
    remove: bench.remove,
    halt: bench.halt,
    seek: (tick) => void run.seek(tick),
    pauseAt: bench.pauseAt,
    goTo: editor.goTo,
  });
  const transport = createBenchTransport({ pane: frame.transport, run, state, restart: bench.restart, change: session.change, complete: bench.pauseAtCompletion });
  const foot = createBenchFoot({ pane: frame.foot, run, session, format, picture, title, playCoach, say });

  frame.stage.prepend(figure.element, compareView.element);
  frame.timeline.append(timeline.element);
  frame.text.append(openPane.element, editor.element, problems.element);
  openPane.dropOn(frame.text);
  frame.narrow.addEventListener('change', place);
  place();
  editor.know(models);

  /** On phones the drawing comes first, and the transport bar holds only what is needed at every tick. */
  function place() {
    if (frame.narrow.matches) frame.stage.after(bar.element);
    else frame.stage.before(bar.element);
    (frame.narrow.matches ? frame.drawing : frame.transport).append(transport.kind);
  }

  /** Selects a node, from the drawing or from elsewhere. @param {number | null} id @param {boolean} [reveal] whether the drawing moves to it */
  function select(id, reveal = false) {
    bench.select(id);
    if (id !== null && reveal) figure.reveal(id);
  }

  /** @param {{ line: number, column: number } | null} place */
  function pointed(place) {
    const id = session.stale ? null : bench.pointed(place);
    if (id !== null) figure.reveal(id);
  }

  /** @param {string} xml */
  async function format(xml) {
    return String((await engine.request('format', { xml })).xml);
  }

  function picture() {
    if (run.tree && !bench.comparing()) return figure.picture();
    say(run.tree ? benchText.foot.noCompare : benchText.foot.noDrawing);
    return null;
  }

  /** What the tree on screen is called. */
  function title() {
    return session.entry()?.title || session.rest().title || run.tree?.main || benchText.open.own;
  }

  let lesson = '';

  /** What to watch; of an edited tree it may no longer hold. */
  function watch() {
    const entry = session.entry();
    if (!entry) return session.rest().title || benchText.open.own;
    return session.pristine() ? entry.watch : benchText.open.edited(entry.title);
  }

  /** Everything that stands beside the moment. */
  function show() {
    const comparing = bench.comparing();
    figure.element.hidden = comparing;
    compareView.element.hidden = !comparing;
    frame.timeline.hidden = comparing; // the comparison has ticks of its own
    lesson = run.moment || !run.tree ? watch() : benchText.drawing.notRunnable;
    bar.show({ undo: session.canUndo(), redo: session.canRedo(), compare: bench.canCompare() }, comparing);
    openPane.show(session.rest().entry, session.rest().title);
    showMoment();
  }

  /** Everything that changes with the tick. */
  function showMoment() {
    frame.show({
      watch: lesson,
      tag: text.tag(state.name, state.reason),
      stale: session.stale && run.tree !== null,
      fault: bench.comparing() ? '' : bench.fault(),
    });
    transport.show(session.rest());
    foot.show(run.tree !== null && COACH.test(session.running().xml));
    inspector.show();
  }

  let drawn = '';
  /** @type {Problem[] | null} */
  let marked = null;
  run.on('opened', ({ tree }) => {
    if (tree) {
      const next = JSON.stringify(tree.nodes);
      if (next !== drawn || session.opening) {
        figure.show(tree.nodes, { keep: !session.opening && drawn !== '' });
        bar.again();
      }
      drawn = next;
      figure.select(bench.marks.selected);
      figure.mark(bench.marks.breakpoints);
      figure.paint(run.moment);
      timeline.show(tree.nodes, session.rest().script);
      timeline.select(bench.marks.selected);
      timeline.paint(run.moment);
      timeline.refresh();
    }
    if (editor.focused()) pointed(editor.pointedAt());
    show();
    performance.measure('tree shown', 'tree asked'); // from the request to everything drawn
  });
  session.on('change', () => {
    if (session.problems !== marked) {
      marked = session.problems; // while one types, the editor moves the marks along
      editor.problems(marked);
      problems.show(marked);
    }
    show();
  });
  session.onOpened(async (compare, asked) => {
    const entry = session.entry();
    if (entry?.select !== null && entry?.select !== undefined && run.tree?.nodes[entry.select]) select(entry.select, true);
    if (!compare) return void (asked && session.writeAddress());
    const found = !session.stale && (await bench.compare(compare));
    if (!found && asked) say(text.link.bad('compare', benchText.link.noCompare(compare.line, compare.column)), 'problem');
  });
  run.on('moment', () => {
    figure.paint(run.moment);
    timeline.paint(run.moment);
    showMoment();
  });
  let told = -1; // the tick that was read out last
  run.on('settled', () => {
    void session.writeAddress();
    show();
    if (run.tick === told || state.name !== 'paused' || !run.moment) return;
    told = run.tick;
    announce(run.moment.root ? benchText.said.root(run.tick, run.moment.root) : benchText.said.paused(run.tick));
  });
  run.on('stopped', (why) => {
    const said = bench.stopped(why);
    if (bench.marks.selected !== null) figure.reveal(bench.marks.selected);
    if (said) announce(said);
    if (said && why === 'breakpoint') say(said); // an error is told over the drawing
    told = run.tick;
  });
  bench.marks.on(() => {
    figure.select(bench.marks.selected);
    timeline.select(bench.marks.selected);
    figure.mark(bench.marks.breakpoints);
    inspector.show();
  });
  state.on((name) => {
    show();
    if (name === 'running') announce(benchText.said.running);
    if (name === 'finished') announce(benchText.said.finished(run.tick));
  });
  show();

  return {
    session,
    bench,
    /** Where single keys act beside drawing and transport: Escape brings the focus there. */
    afterText: problems.element,
    actions: {
      toggle: run.toggle,
      forward: () => void run.step(1),
      back: () => void run.step(-1),
      restart: bench.restart,
      faster: transport.faster,
      slower: transport.slower,
      search: bar.focusSearch,
      clear: () => (inspector.spread(false), select(null)),
    },
  };
}

/** @typedef {ReturnType<typeof createWorkbench>} Workbench */
