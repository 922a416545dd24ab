import { button, h, write } from '../../ui/dom.js';
import { benchText } from '../../ui/strings.trees.en.js';

/** @import { BenchNode, BoardEntry, Moment } from '../../trees/types.js' */

/**
 * The blackboards: every entry with its value, who wrote it and when. Entries of the main tree and the global board
 * can be written by hand.
 *
 * @param {{ write: (name: string, value: string) => void, select: (id: number) => void }} parts
 */
export function createBoardTab({ write: put, select }) {
  const caption = h('p', { class: 'said small' });
  const none = h('p', { class: 'empty' }, benchText.board.none);
  const tables = h('div', { class: 'boards' });
  const name = h('input', { type: 'text', id: 'trees-entry-name', autocomplete: 'off', autocapitalize: 'off', spellcheck: 'false', required: true, 'aria-describedby': 'trees-entry-hint' });
  const value = h('input', { type: 'text', id: 'trees-entry-value', autocomplete: 'off', autocapitalize: 'off', spellcheck: 'false' });
  const add = h(
    'form',
    { class: 'add-entry' },
    h('h2', {}, benchText.board.add),
    h('div', { class: 'field' }, h('label', { for: name.id }, benchText.board.name), name),
    h('div', { class: 'field' }, h('label', { for: value.id }, benchText.board.newValue), value),
    h('p', { class: 'said small', id: 'trees-entry-hint' }, benchText.board.hint),
    h('div', { class: 'row' }, h('button', { type: 'submit' }, benchText.board.put)),
  );
  const element = h('div', { class: 'tab-body' }, caption, none, tables, add);
  add.addEventListener('submit', (event) => {
    event.preventDefault();
    if (name.value.trim() === '') return;
    put(name.value.trim(), value.value);
    name.value = '';
    value.value = '';
    name.focus();
  });
  let shape = '';
  /** @type {((entry: BoardEntry, nodes: BenchNode[]) => void)[]} */
  let rows = [];

  /** @param {BoardEntry} entry @param {boolean} editable */
  function createRow({ board, name: entryName }, editable) {
    const called = board === '@' && !entryName.startsWith('@') ? `@${entryName}` : entryName;
    const field = h('input', { type: 'text', autocomplete: 'off', spellcheck: 'false', 'aria-label': benchText.board.value(called) });
    field.addEventListener('change', () => put(called, field.value));
    const plain = h('code', {});
    const type = h('td', { class: 'type' });
    const writer = h('td', {});
    let by = '';
    return {
      row: h('tr', { 'data-entry': called }, h('th', { scope: 'row' }, entryName), h('td', {}, editable ? field : plain), type, writer),
      /** @param {BoardEntry} entry @param {BenchNode[]} nodes */
      show(entry, nodes) {
        const shown = entry.value ?? benchText.board.noValue;
        if (!editable) write(plain, shown);
        else if (document.activeElement !== field) field.value = entry.value ?? '';
        field.placeholder = entry.value === null ? benchText.board.noValue : '';
        write(type, entry.type === 'none' ? '–' : entry.type);
        const node = entry.writer === null ? null : nodes[entry.writer];
        const next = `${entry.writer} ${node?.name} ${entry.written}`;
        if (next === by) return;
        by = next;
        const when = entry.written === null || entry.written === 0 ? '' : benchText.board.when(entry.written);
        const hand = entry.written === null || entry.written === 0 ? benchText.board.start : benchText.board.byHand;
        writer.replaceChildren(node ? button(node.name, () => select(node.id), { class: 'link' }) : h('span', {}, hand), ' ', h('span', { class: 'when' }, when));
      },
    };
  }

  /** @param {BoardEntry[]} entries @param {string} main */
  function build(entries, main) {
    rows = [];
    const boards = [...new Set(entries.map(({ board }) => board))];
    tables.replaceChildren(
      ...boards.map((board) => {
        const own = entries.filter((entry) => entry.board === board).map((entry) => ({ entry, made: createRow(entry, board === '@' || board === main) }));
        for (const { entry, made } of own) rows[entries.indexOf(entry)] = made.show;
        const head = h('thead', {}, h('tr', {}, ...benchText.board.columns.map((column) => h('th', { scope: 'col' }, column))));
        const title = h('caption', {}, board === '@' ? benchText.board.global : benchText.board.local(board));
        return h('table', { class: 'board' }, title, head, h('tbody', {}, ...own.map(({ made }) => made.row)));
      }),
    );
  }

  return {
    element,
    /** @param {Moment | null} moment @param {BenchNode[]} nodes @param {string} main ID of the main tree */
    show(moment, nodes, main) {
      const entries = moment?.entries ?? [];
      write(caption, moment ? benchText.board.caption(moment.tick) : '');
      none.hidden = entries.length > 0;
      add.hidden = moment === null;
      const next = JSON.stringify([main, entries.map(({ board, name: entryName }) => [board, entryName])]);
      if (next !== shape) build(entries, main);
      shape = next;
      entries.forEach((entry, index) => rows[index](entry, nodes));
    },
  };
}
