import { h, write } from '../ui/dom.js';
import { text } from '../ui/strings.en.js';
import { createTabs } from '../ui/tabs.js';
import { EngineError } from '../engine.js';
import { messageOf } from '../session.js';
import { save, standalone } from '../ui/share.js';
import { createTreeTab } from './treetab.js';
import { createAgentTab } from './agenttab.js';

/** @import { Engine } from '../engine.js' */
/** @import { SeenRun } from '../lens.js' */
/** @import { State } from '../state.js' */
/** @import { Selection } from '../selection.js' */
/** @import { Detail } from '../types.js' */
/** @import { Theme } from '../draw/theme.js' */

const EVERY_MS = 120;

/**
 * The right pane. Asks the engine only for what its open tab shows, one question at a time.
 *
 * @param {{ pane: HTMLElement, engine: Pick<Engine, 'request'>, run: SeenRun, state: State, selection: Selection, theme: () => Theme, onTheme: (listener: () => void) => void, ringed: () => void,
 *   openTree: (xml: string, title: string) => Promise<void>, say: (message: string, kind?: 'note' | 'problem') => void }} parts
 *   `ringed` is called when other robots are to be ringed, `openTree` shows a tree in the workbench
 */
export function createInspector({ pane, engine, run, state, selection, theme, onTheme, ringed, openTree, say }) {
  const tree = createTreeTab({ selection, take: (bench) => void take(bench) });
  const agent = createAgentTab(run, selection);
  const genomePanel = h('div', { class: 'tab-body' });
  const chartsPanel = h('div', { class: 'tab-body' });
  /** @type {ReturnType<typeof import('./genometab.js').createGenomeTab> | null} */
  let genome = null;
  /** @type {import('./charts.js').Charts | null} */
  let charts = null;

  const tabs = createTabs({
    label: text.inspector.title,
    tabs: [
      { name: 'tree', label: text.inspector.tree, panel: tree.element },
      { name: 'agent', label: text.inspector.agent, panel: agent.element },
      { name: 'genome', label: text.inspector.genome, panel: genomePanel },
      { name: 'charts', label: text.inspector.charts, panel: chartsPanel },
    ],
    changed: (name) => void opened(name),
  });
  const sheet = h('button', { type: 'button', class: 'sheet-handle', 'aria-expanded': 'false', 'aria-controls': 'sheet-body' }, text.inspector.open);
  const problem = h('p', { class: 'field-error' });
  sheet.addEventListener('click', () => spread(!pane.classList.contains('open')));
  pane.setAttribute('aria-label', text.inspector.title);
  pane.append(sheet, h('div', { class: 'sheet-body', id: 'sheet-body' }, tabs.list, problem, ...tabs.panels));

  let asking = false;
  let again = false;
  let last = -Infinity;

  /** @param {boolean} open on phones the pane is a sheet over the world's foot */
  function spread(open) {
    pane.classList.toggle('open', open);
    sheet.setAttribute('aria-expanded', String(open));
    write(sheet, open ? text.inspector.close : text.inspector.open);
  }

  /** @param {string} name */
  async function opened(name) {
    if (name === 'genome' && !genome) {
      const { createGenomeTab } = await import('./genometab.js');
      genome ??= createGenomeTab({ pane: genomePanel, engine, run, selection });
    }
    if (name === 'charts' && !charts) {
      const { createCharts } = await import('./charts.js');
      charts ??= createCharts({ pane: chartsPanel, engine, run, theme });
      onTheme(charts.restyle);
    }
    void refresh();
  }

  function query() {
    const { scope, program, node } = selection;
    const withNode = node === null ? {} : { node };
    if (tabs.current() !== 'tree') return selection.agent === null ? {} : { agent: selection.agent };
    if (scope === 'agent' && selection.agent !== null) return { agent: selection.agent, tree: true, ...withNode };
    if (scope === 'program' && program) return { program, tree: true, ...withNode };
    return { tree: true, ...withNode };
  }

  /** Takes the program on screen away: a tree as XML, a machine as rules. @param {boolean} bench into the workbench, else as a file */
  async function take(bench) {
    const { scope, agent } = selection;
    const title = scope === 'agent' ? text.world.robot(agent ?? 0) : text.scope.program;
    try {
      const { xml } = await engine.request('export', { query: query() });
      if (bench) await openTree(xml, title);
      else {
        const [ending, type] = xml.startsWith('<?xml') ? ['xml', 'application/xml'] : ['bnf', 'text/plain'];
        save(`${title.toLowerCase().replaceAll(' ', '-')}-tick${run.tick}.${ending}`, new Blob([xml], { type }));
      }
    } catch (error) {
      if (!(error instanceof EngineError && error.fatal)) say(text.tree.notExported(messageOf(error)), 'problem');
    }
  }

  async function refresh() {
    if (!run.layout || state.name === 'error') return;
    if (tabs.current() === 'charts') {
      charts?.refresh();
      return;
    }
    if (asking) {
      again = true;
      return;
    }
    asking = true;
    last = performance.now();
    try {
      const asked = query();
      /** @type {Detail} */
      const detail = (await engine.request('inspect', { query: asked })).detail;
      if (JSON.stringify(asked) === JSON.stringify(query())) show(detail);
      write(problem, '');
    } catch (error) {
      if (!(error instanceof EngineError && error.fatal)) write(problem, messageOf(error));
    } finally {
      asking = false;
      if (again) {
        again = false;
        void refresh();
      }
    }
  }

  /** @param {Detail} detail */
  function show(detail) {
    const { node } = selection;
    if (node !== null && detail.tree && node >= (detail.tree.machine?.rules ?? detail.tree.nodes).length) selection.selectNode(null);
    selection.ring(selection.node === null ? [] : (detail.reached ?? []));
    ringed();
    if (tabs.current() === 'tree') tree.show(detail);
    else if (tabs.current() === 'agent') agent.show(detail);
    else genome?.show(detail);
  }

  run.on('frame', () => {
    if (performance.now() - last > EVERY_MS) void refresh();
  });
  run.on('loaded', () => {
    charts?.forget();
    void refresh();
  });
  run.on('settled', () => void refresh());
  let seen = /** @type {number | null} */ (null);
  selection.on(() => {
    if (selection.agent !== null && selection.agent !== seen) spread(true);
    seen = selection.agent;
    void refresh();
  });
  tabs.open('tree');

  return {
    /** The tree on screen as a file, null when there is none. */
    treeSvg() {
      const { width, height } = tree.figure.size();
      if (tabs.current() !== 'tree' || height === 0) return null;
      return standalone(tree.figure.svg, { title: text.tree.label, width, height, ground: theme().ground });
    },
    close: () => spread(false),
    /** @param {string} name of a tab */
    open: (name) => tabs.open(name),
  };
}
