import { button, h, write } from '../ui/dom.js';
import { measureText as text } from '../ui/strings.measure.en.js';
import { median } from '../measure/measures.js';

/** @import { Measured, Row } from '../measure/types.js' */

/**
 * The page as it is seen: what is measured, the results so far, and other programs beside.
 *
 * @param {{ element: HTMLElement, toggle: () => void, csv: () => void }} parts
 */
export function createMeasurePage({ element, toggle, csv }) {
  const main = button(text.run, toggle, { class: 'primary', action: 'toggle' });
  const short = h('input', { type: 'checkbox', id: 'bench-short' });
  const take = button(text.csv, csv, { title: text.csvLong });
  const said = h('p', { class: 'secondary', id: 'bench-said' });
  const body = h('tbody', {});
  main.id = 'bench-run';
  const table = h('table', { class: 'measure-table' }, h('caption', {}, text.caption), h('thead', {}, h('tr', {}, ...text.columns.map((name) => h('th', { scope: 'col' }, name)))), body);
  element.append(
    h(
      'main',
      { class: 'measure-page' },
      h('h2', {}, text.title),
      h('p', { class: 'lines' }, text.lede),
      h('div', { class: 'row' }, main, h('label', { class: 'check' }, short, text.short), take),
      said,
      h('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': text.caption }, table),
      h('p', { class: 'secondary' }, text.honest),
    ),
  );

  return {
    short: () => short.checked,

    /** @param {string} message */
    say: (message) => write(said, message),

    /** @param {Row[]} rows @param {string} state */
    show(rows, state) {
      const made = Math.max(...rows.map(({ rounds }) => rounds.length));
      write(main, state === 'busy' ? text.stop : made > 0 ? text.again : text.run);
      take.disabled = made === 0;
      short.disabled = state === 'busy';
      body.replaceChildren(...rows.map(line));
    },
  };
}

/** @param {Row} row */
function line({ name, rounds }) {
  const { title, file, peer = '', source = '' } = text.measures[name];
  const last = rounds.at(-1);
  return h(
    'tr',
    {},
    h('th', { scope: 'row' }, title, h('small', {}, file)),
    h('td', {}, last ? result(name, rounds) : ''),
    h('td', {}, rounds.length || ''),
    h('td', {}, last?.fingerprint ?? (last?.integrated === undefined ? '' : text.integrated(last.integrated))),
    h('td', {}, peer, h('small', {}, source)),
  );
}

/** @param {string} name @param {Measured[]} rounds */
function result(name, rounds) {
  const whole = (/** @type {number} */ value) => Math.round(value).toLocaleString('en');
  const middle = (/** @type {(round: Measured) => number} */ of) => median(rounds.map(of));
  if (name === 'memory') return text.memory((rounds[0].amount / 1e6).toFixed(1));
  const parts = [text.rate(whole(middle(({ amount, seconds }) => amount / seconds)), text.measures[name].unit)];
  if (rounds[0].each !== undefined) parts.unshift(text.each((1000 * middle(({ each = 0 }) => each)).toFixed(1)));
  if (name === 'match') parts.unshift(text.whole(middle(({ amount, seconds }) => (36_000 * seconds) / amount).toFixed(2)));
  return parts.join(', ');
}
