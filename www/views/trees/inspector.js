import { h, write } from '../../ui/dom.js';
import { text } from '../../ui/strings.en.js';
import { benchText } from '../../ui/strings.trees.en.js';
import { createTabs } from '../../ui/tabs.js';
import { createBoardTab } from './boardtab.js';
import { createLogTab } from './logtab.js';
import { createNodeTab } from './nodetab.js';
import { createScriptTab } from './scripttab.js';

/** @import { Answer } from '../../trees/script.js' */
/** @import { BenchNode, Moment, ScriptEvent } from '../../trees/types.js' */

/**
 * @typedef {object} Standing everything the inspector shows
 * @property {BenchNode[]} nodes
 * @property {string} main ID of the main tree
 * @property {Moment | null} moment
 * @property {ScriptEvent[]} script
 * @property {number | null} selected
 * @property {Map<number, string>} breakpoints
 */

/**
 * The right pane; writes only the tab that is open.
 *
 * @param {{ pane: HTMLElement, standing: () => Standing, select: (id: number) => void, answer: (leaf: string, answer: Answer) => void,
 *   write: (name: string, value: string) => void, remove: (index: number) => void, halt: () => void, seek: (tick: number) => void,
 *   pauseAt: (id: number, letters: string) => void, goTo: (line: number, column: number) => void }} parts
 */
export function createBenchInspector({ pane, standing, select, answer, write: put, remove, halt, seek, pauseAt, goTo }) {
  /** @param {string} leaf */
  const selectLeaf = (leaf) => {
    const node = standing().nodes.find(({ name, scripted }) => scripted && name === leaf);
    if (node) select(node.id);
  };
  const node = createNodeTab({ answer, pauseAt, goTo });
  const script = createScriptTab({ answer, remove, halt, seek, selectLeaf });
  const board = createBoardTab({ write: put, select });
  const log = createLogTab({ select });
  const tabs = createTabs({
    label: benchText.pane.inspector,
    tabs: [
      { name: 'node', label: benchText.inspector.node, panel: node.element },
      { name: 'script', label: benchText.inspector.script, panel: script.element },
      { name: 'board', label: benchText.inspector.board, panel: board.element },
      { name: 'log', label: benchText.inspector.log, panel: log.element },
    ],
    changed: () => show(),
  });
  const sheet = h('button', { type: 'button', class: 'sheet-handle', 'aria-expanded': 'false', 'aria-controls': 'trees-sheet' }, text.inspector.open);
  sheet.addEventListener('click', () => spread(!pane.classList.contains('open')));
  pane.append(sheet, h('div', { class: 'sheet-body', id: 'trees-sheet' }, tabs.list, ...tabs.panels));

  /** @param {boolean} open on phones the pane is a sheet over the drawing's foot */
  function spread(open) {
    pane.classList.toggle('open', open);
    sheet.setAttribute('aria-expanded', String(open));
    nameHandle();
  }

  /** On phones the handle says what would be shown. */
  function nameHandle() {
    const { nodes, selected } = standing();
    const name = selected === null ? undefined : nodes[selected]?.name;
    write(sheet, pane.classList.contains('open') ? text.inspector.close : name ? benchText.pane.inspect(name) : text.inspector.open);
  }

  function show() {
    nameHandle();
    const { nodes, main, moment, script: events, selected, breakpoints } = standing();
    if (tabs.current() === 'script') script.show(moment, events);
    else if (tabs.current() === 'board') board.show(moment, nodes, main);
    else if (tabs.current() === 'log') log.show(moment, nodes);
    else node.show(selected === null ? null : shownNode(nodes, moment, selected, breakpoints));
  }

  tabs.open('node');
  return { show, spread, open: tabs.open };
}

/** @param {BenchNode[]} nodes @param {Moment | null} moment @param {number} id @param {Map<number, string>} breakpoints */
function shownNode(nodes, moment, id, breakpoints) {
  const node = nodes[id];
  if (!node) return null;
  const found = moment?.answers.find(({ leaf }) => leaf === node.name);
  return {
    node,
    moment,
    letters: breakpoints.get(id) ?? '',
    answer: node.scripted && found ? { running: found.running, then: found.then, writes: found.writes } : null,
    sharing: node.scripted ? nodes.filter(({ name, scripted }) => scripted && name === node.name).length : 1,
    progress: moment?.progress.find(([other]) => other === id)?.[1] ?? null,
  };
}

/** @typedef {ReturnType<typeof createBenchInspector>} BenchInspector */
