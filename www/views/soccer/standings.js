import { h } from '../../ui/dom.js';
import { soccerText } from '../../ui/strings.soccer.en.js';

const words = soccerText.tournament;

/** Table 4 of the paper as it is printed; it has no column of ties. @type {[string, ...number[]][]} */
const IRONCUP = [
  ['RobôCIn', 18, 6, 6, 0, 68, 17, 51],
  ['ThunderVolt', 15, 6, 5, 1, 32, 3, 29],
  ['Robotbulls', 12, 6, 4, 2, 34, 23, 11],
  ['ITAndroids', 9, 6, 3, 3, 36, 17, 19],
  ['Red Dragons', 6, 6, 2, 4, 36, 36, 0],
  ['Rinobot', 3, 6, 1, 5, 14, 54, -40],
  ['Neon', 0, 6, 0, 6, 7, 46, -39],
];
const [SCORED, CONCEDED] = [5, 6];

/**
 * A table with the columns of the league.
 *
 * @param {string} caption
 * @param {string} id
 */
export function createStandingsTable(caption, id) {
  const body = h('tbody', {});
  const element = h('div', { class: 'wide-table' }, h('table', { class: 'standings', id }, h('caption', {}, caption), head(words.columns), body));
  return {
    element,
    /** @param {(string | number)[][]} rows */
    show: (rows) => body.replaceChildren(...rows.map(row)),
  };
}

/** The paper's table, with its fault beside it. */
export function paperTable() {
  const columns = words.columns.filter((column) => column !== 'Ties');
  const sum = (/** @type {number} */ at) => IRONCUP.reduce((all, line) => all + Number(line[at]), 0);
  return h(
    'div',
    {},
    h('div', { class: 'wide-table' }, h('table', { class: 'standings' }, h('caption', {}, words.paper), head(columns), h('tbody', {}, ...IRONCUP.map(row)))),
    h('p', { class: 'said small faulty' }, words.paperFault(sum(SCORED), sum(CONCEDED))),
    h('p', { class: 'status-key' }, words.paperNote),
  );
}

/** @param {string[]} columns */
const head = (columns) => h('thead', {}, h('tr', {}, ...columns.map((column) => h('th', { scope: 'col' }, column))));

/** @param {(string | number)[]} cells */
const row = ([name, ...numbers]) => h('tr', {}, h('th', { scope: 'row' }, name), ...numbers.map((cell) => h('td', {}, String(cell).replace('-', '−'))));
