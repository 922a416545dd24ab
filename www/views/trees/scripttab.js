import { button, h, write } from '../../ui/dom.js';
import { benchText } from '../../ui/strings.trees.en.js';

/** @import { Moment, ScriptEvent, Status } from '../../trees/types.js' */
/** @import { Answer } from '../../trees/script.js' */

const STATUSES = /** @type {const} */ (['SUCCESS', 'FAILURE', 'RUNNING', 'SKIPPED']);

/**
 * All leaves with what they answer now, and the whole script by tick.
 *
 * @param {{ answer: (leaf: string, answer: Answer) => void, remove: (index: number) => void, halt: () => void, seek: (tick: number) => void,
 *   selectLeaf: (leaf: string) => void }} parts
 */
export function createScriptTab({ answer, remove, halt, seek, selectLeaf }) {
  const leaves = h('tbody', {});
  const leafTable = table('answers', benchText.script.leaves, benchText.script.columns, leaves);
  const noLeaves = h('p', { class: 'empty' }, benchText.script.noLeaves);
  const events = h('tbody', {});
  const eventTable = table('events', '', benchText.script.eventColumns, events);
  const none = h('p', { class: 'empty' }, benchText.script.none);
  const stop = button(benchText.script.halt, halt);
  stop.id = 'trees-halt';
  const element = h('div', { class: 'tab-body' }, h('div', { class: 'row' }, stop), leafTable, noLeaves, eventTable, none);
  let shownEvents = '';

  /** @param {string} leaf */
  function leafRow(leaf) {
    /** @type {Answer} */
    let present = { running: 0, then: 'SUCCESS', writes: {} };
    const then = h('select', { 'aria-label': benchText.script.returns(leaf) }, ...STATUSES.map((status) => h('option', {}, status)));
    then.addEventListener('change', () => {
      const status = /** @type {Status} */ (then.value);
      answer(leaf, { ...present, then: status, running: status === 'RUNNING' ? 0 : present.running });
    });
    const running = h('input', { type: 'number', min: 0, max: 1_000_000, step: 1, inputmode: 'numeric', 'aria-label': benchText.script.after(leaf) });
    running.addEventListener('change', () => answer(leaf, { ...present, running: Math.max(Math.round(Number(running.value) || 0), 0) }));
    const row = h('tr', { 'data-leaf': leaf }, h('th', { scope: 'row' }, button(leaf, () => selectLeaf(leaf), { class: 'link' })), h('td', {}, then), h('td', {}, running));
    return {
      row,
      /** @param {Answer} next */
      show(next) {
        present = next;
        then.value = next.then;
        if (document.activeElement !== running) running.value = String(next.running);
        running.disabled = next.then === 'RUNNING';
      },
    };
  }
  /** @type {Map<string, ReturnType<typeof leafRow>>} */
  let rows = new Map();

  /** @param {Moment['answers']} answers */
  function showLeaves(answers) {
    if (answers.length !== rows.size || answers.some(({ leaf }) => !rows.has(leaf))) {
      rows = new Map(answers.map(({ leaf }) => [leaf, leafRow(leaf)]));
      leaves.replaceChildren(...[...rows.values()].map(({ row }) => row));
    }
    for (const { leaf, ...present } of answers) rows.get(leaf)?.show(present);
    leafTable.hidden = answers.length === 0;
    noLeaves.hidden = answers.length > 0;
  }

  /** @param {ScriptEvent[]} script */
  function showEvents(script) {
    const json = JSON.stringify(script);
    if (json === shownEvents) return;
    shownEvents = json;
    write(/** @type {Element} */ (eventTable.caption), benchText.script.events(script.length));
    eventTable.hidden = script.length === 0;
    none.hidden = script.length > 0;
    const focused = [...events.querySelectorAll('button')].findIndex((place) => place === document.activeElement);
    const ordered = script.map((event, index) => ({ event, index })).sort((a, b) => a.event.tick - b.event.tick);
    events.replaceChildren(
      ...ordered.map(({ event, index }) => {
        const what = benchText.script.what(event);
        const go = button(String(event.tick), () => seek(event.tick), { class: 'link', title: benchText.script.goTo(event.tick) });
        return h('tr', {}, h('th', { scope: 'row' }, go), h('td', {}, what), h('td', {}, button(benchText.script.remove(what), () => remove(index), { glyph: '×', class: 'quiet' })));
      }),
    );
    const places = [...events.querySelectorAll('button')];
    if (focused >= 0) (places[Math.min(focused, places.length - 1)] ?? stop).focus(); // the row that was removed had the focus
  }

  return {
    element,
    /** @param {Moment | null} moment @param {ScriptEvent[]} script */
    show(moment, script) {
      stop.disabled = moment === null;
      stop.title = benchText.script.haltLong(moment?.tick ?? 0);
      showLeaves(moment?.answers ?? []);
      showEvents(script);
      for (const row of events.rows) row.classList.toggle('past', Number(row.cells[0].textContent) < (moment?.tick ?? 0));
    },
  };
}

/** @param {string} name @param {string} caption @param {string[]} columns @param {HTMLTableSectionElement} body */
function table(name, caption, columns, body) {
  const head = columns.map((column) => (column ? h('th', { scope: 'col' }, column) : h('td', {})));
  return h('table', { class: name }, h('caption', {}, caption), h('thead', {}, h('tr', {}, ...head)), body);
}
