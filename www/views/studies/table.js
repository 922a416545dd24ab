import { h, write } from '../../ui/dom.js';

/** @import { Section } from '../../studies/types.js' */

/** Columns of words; all but the first of the others hold numbers. */
const WORDS = new Set(['metric', 'test', 'verdict', 'size', 'statistic']);

/**
 * One table of a report. Showing it again writes only what changed, so that it stays where it was scrolled to.
 *
 * @param {string} name of the section
 */
export function createReportTable(name) {
  const title = h('h3', { id: `studies-${name}` });
  const head = h('thead', {});
  const body = h('tbody', {});
  const note = h('p', { class: 'secondary' });
  const box = h('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-labelledby': title.id }, h('table', { 'aria-labelledby': title.id }, head, body));
  const element = h('section', { class: 'report-section', 'data-section': name }, title, box, note);
  let shape = '';
  const classOf = (/** @type {string} */ column) => (WORDS.has(column) ? 'words' : undefined);

  return {
    element,

    /** @param {Section} section */
    show(section) {
      write(title, section.title);
      write(note, section.note);
      const wanted = `${section.columns.join('|')}/${section.rows.length}`;
      if (shape !== wanted) {
        head.replaceChildren(h('tr', {}, ...section.columns.map((column) => h('th', { scope: 'col', class: classOf(column) }, column))));
        body.replaceChildren(...section.rows.map((row) => h('tr', {}, ...row.map((_, column) => (column === 0 ? h('th', { scope: 'row' }) : h('td', { class: classOf(section.columns[column]) }))))));
      }
      shape = wanted;
      section.rows.forEach((row, index) => row.forEach((word, column) => write(body.rows[index].cells[column], word)));
    },
  };
}
