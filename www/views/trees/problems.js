import { button, h, write } from '../../ui/dom.js';
import { benchText } from '../../ui/strings.trees.en.js';

/** @import { Fix } from './fixes.js' */
/** @import { Problem } from '../../trees/types.js' */

const MOST = 100;

/**
 * Under the text: its problems, each a button that goes to its place, with what can be done about it.
 *
 * @param {{ find: () => void, go: (problem: Problem) => void, fixes: (problem: Problem) => Fix[], apply: (problem: Problem, label: string) => void }} parts
 */
export function createProblems({ find, go, fixes, apply }) {
  const head = h('p', { class: 'problems-head', role: 'status' });
  const search = button(benchText.open.find, find, { title: benchText.open.findLong, class: 'quiet' });
  const list = h('ol', { class: 'problems-list' });
  const element = h('section', { class: 'problems', 'aria-label': benchText.problems.label }, h('div', { class: 'problems-bar' }, head, search), list);

  /** @param {Problem} problem */
  function row(problem) {
    const kind = problem.warning ? benchText.problems.warning : benchText.problems.fault;
    const label = h('span', { class: 'problem-text' }, h('span', { class: 'unseen' }, `${kind}: `), benchText.problems.place(problem));
    const where = h('button', { type: 'button', class: 'problem', onclick: () => go(problem) }, h('i', { class: 'problem-mark', 'aria-hidden': 'true' }, problem.warning ? '!' : '✗'), label);
    const ways = fixes(problem).map(({ label: words }) => button(words, () => apply(problem, words), { class: 'fix' }));
    return h('li', { class: problem.warning ? 'problem-row slight' : 'problem-row', 'data-code': problem.code }, where, ...(ways.length > 0 ? [h('div', { class: 'fixes' }, ...ways)] : []));
  }

  return {
    element,
    focus: () => search.focus(),

    /** @param {Problem[]} problems */
    show(problems) {
      const warnings = problems.filter(({ warning }) => warning).length;
      write(head, problems.length === 0 ? benchText.problems.none : benchText.problems.count(problems.length - warnings, warnings));
      element.classList.toggle('clean', problems.length === 0);
      const ordered = [...problems].sort((a, b) => Number(a.warning) - Number(b.warning) || a.line - b.line || a.column - b.column);
      const rows = ordered.slice(0, MOST).map(row);
      if (problems.length > MOST) rows.push(h('li', {}, benchText.problems.more(problems.length - MOST)));
      const focused = [...list.querySelectorAll('button')].findIndex((place) => place === document.activeElement);
      list.replaceChildren(...rows);
      const places = [...list.querySelectorAll('button')];
      if (focused >= 0) (places[Math.min(focused, places.length - 1)] ?? search).focus(); // a fix takes its own button away
    },
  };
}
