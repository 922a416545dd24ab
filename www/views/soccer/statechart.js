import { CHART, STATE, stationsOf, waysOf } from '../../draw/statechart.js';
import { h, s, write } from '../../ui/dom.js';
import { soccerText } from '../../ui/strings.soccer.en.js';

/** @import { Setting, TeamMoment } from '../../soccer/types.js' */

const words = soccerText.coach;
const RECENT = 120; // frames for which the last transition stays marked

/**
 * The state machine as a chart with the state it is in and the edge it took last, and the guards of that state in order.
 *
 * @param {Setting} setting
 */
export function createStateChart({ states, edges }) {
  const inputs = new Set(states.filter(([, input]) => input).map(([name]) => name));
  const svg = s('svg', { class: 'statechart', viewBox: `0 0 ${CHART.width} ${CHART.height}`, role: 'img' });
  const title = s('title', {});
  const ways = waysOf(edges).map(({ d, head, mark }, index) =>
    s(
      'g',
      { class: 'way', 'data-edge': index },
      s('path', { class: 'way-line', d }),
      s('path', { class: 'way-head', d: head }),
      s('circle', { class: 'way-mark', cx: mark[0], cy: mark[1], r: 7 }),
      s('text', { class: 'way-number', x: mark[0], y: mark[1], dy: '0.35em', 'text-anchor': 'middle' }, String(index + 1)),
    ),
  );
  const boxes = stationsOf(states.map(([name]) => name)).map(({ name, x, y }) =>
    s(
      'g',
      { class: `state ${inputs.has(name) ? 'input' : 'swap'}`, 'data-state-name': name },
      s('rect', { x: x - STATE.width / 2, y: y - STATE.height / 2, width: STATE.width, height: STATE.height, rx: 8 }),
      s('text', { x, y, dy: '0.35em', 'text-anchor': 'middle' }, words.stateNames[name]),
    ),
  );
  svg.append(title, ...ways, ...boxes);
  const last = h('p', { class: 'said small' });
  const rows = h('tbody', {});
  const table = h(
    'table',
    { class: 'guards' },
    h('caption', {}, words.guards),
    h('thead', {}, h('tr', {}, ...words.guardColumns.map((column) => h('th', { scope: 'col' }, column || h('span', { class: 'unseen' }, '#'))))),
    rows,
  );
  let listed = '';

  return {
    svg,
    element: h('div', { class: 'chart-of-states' }, svg, last, table),

    /** @param {TeamMoment} team @param {number} tick */
    show({ state, last: taken, guards }, tick) {
      const now = state ?? '';
      write(title, words.chartLabel(words.stateNames[now] ?? now));
      for (const box of boxes) box.classList.toggle('now', box.dataset.stateName === now);
      const recent = taken && tick - taken[1] <= RECENT ? taken[0] : -1;
      ways.forEach((way, index) => way.classList.toggle('taken', index === recent));
      const name = (/** @type {string} */ long) => words.stateNames[long] ?? long;
      write(last, taken ? words.last(name(edges[taken[0]].from), name(edges[taken[0]].to), (tick - taken[1]) / 60) : words.noLast);
      const key = JSON.stringify(guards);
      if (key === listed) return;
      listed = key;
      rows.replaceChildren(
        ...guards.map(([index, open]) =>
          h(
            'tr',
            { class: open ? 'chosen' : '' },
            h('th', { scope: 'row' }, index + 1),
            h('td', {}, h('code', {}, edges[index].guard), ' ', h('span', { class: 'guard-verdict' }, open ? `✓ ${words.open}` : `✗ ${words.shut}`)),
            h('td', {}, name(edges[index].to)),
            h('td', {}, edges[index].function),
          ),
        ),
      );
    },
  };
}
