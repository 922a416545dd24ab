import { h, write } from '../ui/dom.js';
import { machineText as text } from '../ui/strings.machines.en.js';

/** @import { Machine, MachineRule } from '../types.js' */

/**
 * A state machine as three tables: its states, its tests, its rules in order. The rows are made once; after that only
 * what happened changes.
 *
 * @param {{ select?: (rule: number | null) => void, plain?: boolean }} options `select` is called when a rule is chosen; a `plain` machine is one that nobody runs
 */
export function createMachineFigure({ select, plain = false }) {
  const states = table('states', text.states, text.stateColumns);
  const tests = table('tests', text.tests, text.testColumns);
  const rules = table('rules', text.rules, plain ? text.ruleColumns.slice(0, 2) : text.ruleColumns);
  const key = h('p', { class: 'status-key' });
  const seen = plain ? [] : [states.element, tests.element, key];
  const element = h('div', { class: 'machine' }, rules.element, ...seen, h('p', { class: 'said small' }, text.reading));
  let shape = '';
  /** @type {number | null} */
  let selected = null;

  /** @param {Machine} machine */
  function build(machine) {
    states.body.replaceChildren(
      ...machine.states.map(({ label }, index) => h('tr', {}, h('th', { scope: 'row' }, label, index === 0 ? h('span', { class: 'machine-start' }, text.start) : null), h('td', {}))),
    );
    tests.body.replaceChildren(...machine.tests.map(({ label }) => h('tr', {}, h('th', { scope: 'row' }, label), h('td', {}))));
    rules.body.replaceChildren(...machine.rules.map((rule, index) => h('tr', {}, h('th', { scope: 'row' }, number(index)), h('td', {}, said(rule)), plain ? null : h('td', {}))));
  }

  /** @param {number} index */
  function number(index) {
    if (!select) return String(index + 1);
    const choose = () => select(index === selected ? null : index);
    return h('button', { type: 'button', class: 'chip', 'aria-pressed': 'false', 'aria-label': text.choose(index + 1), onclick: choose }, index + 1);
  }

  /**
   * @param {Machine} machine
   * @param {{ shape: string, group: boolean, selected?: number | null }} how `shape` names the machine: while it stays, no row is made
   */
  function show(machine, how) {
    selected = how.selected ?? null;
    if (how.shape !== shape) {
      shape = how.shape;
      build(machine);
    }
    if (plain) return;
    const { group } = how;
    machine.states.forEach(({ now, succeeded }, index) => {
      const row = states.body.rows[index];
      row.classList.toggle('chosen', !group && now > 0);
      row.dataset.status = !group && succeeded > 0 ? 'SUCCESS' : '';
      write(row.cells[1], group ? text.share(now) : now > 0 ? text.here : text.away);
    });
    machine.tests.forEach(({ now }, index) => write(tests.body.rows[index].cells[1], group ? text.share(now) : now > 0 ? text.yes : text.no));
    machine.rules.forEach(({ reached_now: now, reached_recently: recently }, index) => {
      const row = rules.body.rows[index];
      row.dataset.reached = now > 0 ? 'now' : recently > 0 ? 'recent' : 'never';
      row.classList.toggle('chosen', index === selected);
      row.querySelector('button')?.setAttribute('aria-pressed', String(index === selected));
      write(row.cells[2], group ? text.share(now) : now > 0 ? text.now : recently > 0 ? text.recent : '');
    });
    write(key, group ? text.groupKey : text.robotKey);
  }

  return {
    element,
    show,

    /** @param {number | null} rule to point at from outside */
    point(rule) {
      [...rules.body.rows].forEach((row, index) => row.classList.toggle('chosen', index === rule));
    },
  };
}

/** @param {string} name @param {string} caption @param {string[]} columns */
function table(name, caption, columns) {
  const body = h('tbody', {});
  const head = h('thead', {}, h('tr', {}, ...columns.map((column) => h('th', { scope: 'col' }, column))));
  return { element: h('table', { class: `machine-${name}` }, h('caption', {}, caption), head, body), body };
}

/** A rule in words. @param {MachineRule} rule */
function said({ from, wanted, equals, goto, goto_probability: likely, set }) {
  const part = (/** @type {string} */ name, /** @type {string} */ what) => [h('dt', {}, name), h('dd', {}, what)];
  const tests = wanted.join(' · ') || text.always;
  return h(
    'dl',
    { class: 'machine-rule' },
    ...part(text.parts.from, from.join(' · ')),
    ...part(equals ? text.parts.when : text.parts.unless, tests),
    ...part(text.parts.goto, text.likely(goto, likely)),
    ...(set ? part(text.parts.set, text.likely(set[0].replace(',', ' ='), set[1])) : []),
  );
}
