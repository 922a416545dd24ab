import { wordsOf } from '../../learn/lessons.js';
import { h, write } from '../../ui/dom.js';
import { learnText } from '../../ui/strings.learn.en.js';

/** @import { Lesson } from '../../learn/lessons.js' */
/** @import { Finding, Found } from '../../learn/examiner.js' */

/** What the engine found: the verdict, and a row for each option. */
export function createFindings() {
  const verdict = h('p', { class: 'learn-verdict', id: 'learn-verdict' });
  const table = h('div', {});
  const element = h('div', { class: 'learn-findings', hidden: true }, verdict, table);

  return {
    element,
    verdict: () => verdict.textContent ?? '',

    clear() {
      element.hidden = true;
      write(verdict, '');
      table.replaceChildren();
    },

    /** A sentence in place of a verdict. @param {string} message */
    say(message) {
      element.hidden = false;
      delete element.dataset.right;
      write(verdict, message);
      table.replaceChildren();
    },

    /** @param {Lesson} lesson @param {Finding} finding @param {string} choice */
    show(lesson, finding, choice) {
      const row = finding.rows.find(({ option }) => option === choice) ?? finding.rows[0];
      element.hidden = false;
      element.dataset.right = String(row.right);
      write(verdict, verdictOf(lesson, row));
      table.replaceChildren(tableOf(lesson, finding));
    },
  };
}

/** @param {Lesson} lesson @param {Found} row */
function verdictOf({ check }, row) {
  if (check.kind === 'goal') return learnText.goal(row.right, row.number ?? 0, check.least, check.tick);
  if (check.kind === 'plan') return learnText.plan(row.right, row.letters ?? '', row.collided === true);
  return row.right ? learnText.right : learnText.wrong;
}

/** @param {Lesson} lesson @param {Finding} finding */
export function tableOf(lesson, { rows, version }) {
  const { options } = wordsOf(lesson);
  const name = (/** @type {string} */ option) => options[option] ?? learnText.whose[option] ?? learnText.whose.screen;
  return h(
    'table',
    { class: 'learn-table' },
    h('caption', {}, learnText.table.caption(version)),
    h('thead', {}, h('tr', {}, ...learnText.table.columns.map((column) => h('th', { scope: 'col' }, column)))),
    h('tbody', {}, ...rows.map((row) => h('tr', { 'data-right': String(row.right) }, h('th', { scope: 'row' }, name(row.option)), h('td', {}, foundText(lesson, row)), h('td', {}, row.right ? learnText.table.right : '')))),
  );
}

/** What was found, in words. @param {Lesson} lesson @param {Found} row */
function foundText({ check }, { number, of, right, letters, goal, collided, program, fingerprints }) {
  const { table } = learnText;
  switch (check.kind) {
    case 'runs':
    case 'number':
    case 'goal':
      return table.measure[check.measure](number ?? 0);
    case 'wins':
      return table.wins(number ?? 0, of ?? 0);
    case 'orders':
      return table.orders(number ?? 0, of ?? 0);
    case 'twins':
      return table.twins(right, fingerprints ?? []);
    case 'derive':
      return program ?? '';
    case 'tree':
      return right ? table.happened : table.not;
    case 'plan':
      return letters === '' ? table.noPlan : table.carried(letters ?? '', goal === true, collided === true, number ?? 0);
  }
}
