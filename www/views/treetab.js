import { button, h, write } from '../ui/dom.js';
import { text } from '../ui/strings.en.js';
import { machineText } from '../ui/strings.machines.en.js';
import { gist } from '../draw/tree.js';
import { createMachineSlot } from './machineslot.js';
import { createTreeFigure } from './treefigure.js';

/** @import { Selection } from '../selection.js' */
/** @import { Detail } from '../types.js' */

/** What the words of a machine are for a tree. */
const treeText = { noun: 'tree', scope: text.scope.program, programs: text.tree.programs, behaviours: text.tree.behaviours, file: text.tree.xml, fileLong: text.tree.xmlLong, reached: text.tree.reached };

/**
 * The programs of the swarm: everyone's, one group's, one robot's.
 *
 * @param {{ selection: Selection, take: (bench: boolean) => void }} parts `take` gives the program on screen away: a tree as XML into the workbench or as a file, a machine as a file
 */
export function createTreeTab({ selection, take }) {
  const scopes = /** @type {const} */ (['everyone', 'program', 'agent']);
  const scopeButtons = scopes.map((scope) => button(text.scope[scope], () => choose(scope)));
  const said = h('p', { class: 'said' });
  const found = h('output', { class: 'found-count' });
  const search = h('input', { type: 'search', placeholder: text.tree.search, 'aria-label': text.tree.search });
  search.addEventListener('input', () => write(found, text.tree.found(figure.search(search.value))));
  const figure = createTreeFigure({ label: text.tree.label, select: (id) => selection.selectNode(id) });
  const frame = h('div', { class: 'tree-frame' }, figure.svg);
  const machine = createMachineSlot({ select: (rule) => selection.selectNode(rule) });
  const bench = button(text.tree.openInBench, () => take(true), { title: text.tree.openInBenchLong });
  const file = button(text.tree.xml, () => take(false), { title: text.tree.xmlLong });
  const away = h('div', { class: 'row' }, bench, file);
  const searching = h('div', { class: 'search' }, search, found);
  const reached = h('p', { class: 'said small' });
  const key = h('p', { class: 'status-key', 'aria-hidden': 'true' });
  const programs = h('ol', { class: 'programs' });
  const programsTitle = h('h2', {}, text.tree.programs);
  const behaviours = h('tbody', {});
  const behavioursTitle = h('caption', {}, text.tree.behaviours);
  const behaviourTable = h(
    'table',
    { class: 'behaviours' },
    behavioursTitle,
    h('thead', {}, h('tr', {}, ...text.tree.behaviourColumns.map((column) => h('th', { scope: 'col' }, column)))),
    behaviours,
  );
  const element = h(
    'div',
    { class: 'tab-body' },
    h('div', { class: 'scopes', role: 'group', 'aria-label': text.scope.label }, ...scopeButtons),
    said,
    searching,
    frame,
    machine.element,
    away,
    reached,
    key,
    programsTitle,
    programs,
    behaviourTable,
  );
  let lastTop = '';

  /** @param {'everyone' | 'program' | 'agent'} scope */
  function choose(scope) {
    if (scope === 'agent' && selection.agent === null) selection.selectAgent(0);
    else selection.look(scope, scope === 'program' ? (selection.program ?? lastTop) : selection.program);
  }

  /** @param {Detail} detail */
  function show(detail) {
    const { scope } = selection;
    lastTop = detail.programs.top[0]?.id ?? '';
    const shown = detail.tree?.machine;
    const words = shown ? machineText : treeText;
    scopes.forEach((name, index) => scopeButtons[index].setAttribute('aria-pressed', String(name === scope)));
    write(scopeButtons[1], words.scope);
    write(scopeButtons[2], selection.agent === null ? text.scope.agent : text.world.robot(selection.agent));
    away.hidden = scope === 'everyone' || !detail.tree;
    const group = scope !== 'agent';
    const holders = detail.tree?.agents.length ?? 0;
    if (scope === 'everyone') write(said, text.tree.everyone(detail.programs.count, detail.programs.top[0]?.agents ?? 0, words.noun));
    else if (!detail.tree) write(said, scope === 'program' ? text.tree.gone : text.tree.none);
    else write(said, scope === 'program' ? text.tree.group(holders) : text.tree.agent(selection.agent ?? 0, holders - 1, words.noun));
    if (detail.tree || scope !== 'program') {
      const how = { shape: `${detail.tree?.program ?? 'none'}`, group, selected: selection.node };
      figure.show(detail.tree?.nodes ?? null, how);
      machine.show(shown, how);
      for (const part of [frame, searching, key]) part.hidden = Boolean(shown);
      bench.hidden = Boolean(shown);
      write(file, words.file);
      file.title = words.fileLong;
    }
    write(reached, selection.node === null || !detail.reached ? '' : words.reached(detail.reached.length));
    write(key, group ? text.tree.groupKey : text.tree.statusKey);
    write(programsTitle, words.programs);
    write(behavioursTitle, words.behaviours);
    for (const part of [programsTitle, programs, behaviourTable]) part.hidden = scope !== 'everyone';
    if (scope === 'everyone') {
      showPrograms(detail);
      showBehaviours(detail);
    }
  }

  /** @param {Detail} detail */
  function showPrograms({ programs: { top } }) {
    const most = top[0]?.agents ?? 1;
    while (programs.children.length < top.length) programs.append(programRow());
    while (programs.children.length > top.length) programs.lastElementChild?.remove();
    top.forEach(({ id, agents, text: written }, index) => {
      const row = /** @type {HTMLButtonElement} */ (programs.children[index].firstChild);
      row.dataset.program = id;
      row.style.setProperty('--share', String(agents / most));
      row.title = written;
      write(row.children[0], agents);
      write(row.children[1], gist(written));
    });
  }

  function programRow() {
    const row = h('button', { type: 'button', class: 'program' }, h('span', { class: 'held' }), h('span', { class: 'gist' }));
    row.addEventListener('click', () => selection.look('program', row.dataset.program));
    return h('li', {}, row);
  }

  /** @param {Detail} detail */
  function showBehaviours(detail) {
    const most = Math.max(1, ...detail.behaviours.map((behaviour) => behaviour.agents));
    while (behaviours.rows.length < detail.behaviours.length) {
      const bars = h('div', { class: 'bars', 'aria-hidden': 'true' }, h('i', { class: 'held' }), h('i', { class: 'ticked' }), h('i', { class: 'ok' }));
      behaviours.append(h('tr', {}, h('th', { scope: 'row' }, h('span', {}), bars), h('td', {}), h('td', {}), h('td', {})));
    }
    while (behaviours.rows.length > detail.behaviours.length) behaviours.deleteRow(-1);
    detail.behaviours.forEach(({ name, agents, ticked, succeeded }, index) => {
      const { cells } = behaviours.rows[index];
      write(/** @type {Element} */ (cells[0].firstElementChild), name);
      const bars = /** @type {HTMLElement} */ (cells[0].lastElementChild);
      [agents, ticked, succeeded].forEach((count, bar) => {
        /** @type {HTMLElement} */ (bars.children[bar]).style.width = `${(100 * count) / most}%`;
        write(cells[bar + 1], count);
      });
    });
  }

  new ResizeObserver(() => figure.fit(frame.clientWidth)).observe(frame);
  return { element, show, figure };
}
