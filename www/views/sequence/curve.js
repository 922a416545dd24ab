import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { metres } from '../../sequence/words.js';
import { h, write } from '../../ui/dom.js';
import { sequenceText } from '../../ui/strings.sequence.en.js';
import { text } from '../../ui/strings.en.js';

/** @import { PlanTheme } from '../../draw/sequence.js' */
/** @import { Curve } from '../../sequence/planner.js' */

const EVERY_MS = 100; // at most ten redraws a second
const HEIGHT = 180;
const TABLE_ROWS = 24;

/**
 * The best plan's cost and the proven bound over the integrations made, with the numbers as a table.
 *
 * @param {{ curve: () => Curve, theme: () => PlanTheme }} parts
 */
export function createCurve({ curve, theme }) {
  const place = h('div', { class: 'chart', 'aria-hidden': 'true' });
  const said = h('p', { class: 'said small' });
  const rows = h('tbody', {});
  const numbers = h(
    'details',
    { class: 'numbers' },
    h('summary', {}, text.charts.table),
    h('table', {}, h('caption', {}, sequenceText.curve.caption), h('thead', {}, h('tr', {}, ...sequenceText.curve.columns.map((column) => h('th', { scope: 'col' }, column)))), rows),
  );
  const element = h('figure', { class: 'curve' }, h('figcaption', {}, h('h2', {}, sequenceText.curve.title), said), place, numbers);
  numbers.addEventListener('toggle', tabulate);
  /** @type {uPlot | null} */
  let plot = null;
  let later = 0;
  let drawn = -Infinity;

  function build() {
    plot?.destroy();
    const colours = theme();
    /** @type {uPlot.Axis} */
    const axis = { stroke: colours.secondary, font: `11px ${colours.font}`, grid: { stroke: colours.hairline, width: 1 }, ticks: { stroke: colours.hairline, width: 1, size: 4 }, gap: 4 };
    const value = (/** @type {uPlot} */ _, /** @type {number | null} */ at) => (at === null || at === undefined ? '' : String(Math.round(at)));
    plot = new uPlot(
      {
        width: Math.max(place.clientWidth, 200),
        height: HEIGHT,
        padding: [8, 12, 0, 0],
        scales: { x: { time: false }, y: { range: (_, low, high) => (low === null || high === null ? [0, 1] : [low - (high - low || high || 1) * 0.1, high + (high - low || high || 1) * 0.1]) } },
        series: [
          { label: sequenceText.curve.columns[0], value },
          { label: sequenceText.curve.columns[1], value, stroke: colours.accent, width: 2, points: { show: false }, paths: uPlot.paths.stepped?.({ align: 1 }) },
          { label: sequenceText.curve.columns[2], value, stroke: colours.ink, width: 1.5, dash: [4, 3], points: { show: false }, paths: uPlot.paths.stepped?.({ align: 1 }) },
        ],
        axes: [
          { ...axis, size: 26 },
          { ...axis, size: 44 },
        ],
        cursor: { y: false, points: { size: 6 } },
        legend: { live: true },
      },
      [[], [], []],
      place,
    );
    draw();
  }

  function draw() {
    drawn = performance.now();
    const { integrated, cost, bound } = curve();
    plot?.setData([integrated, cost, bound]);
    const end = integrated.length - 1;
    const [best, least] = end < 0 ? [null, null] : [cost[end], bound[end]];
    write(said, end < 0 ? '' : sequenceText.curve.said(integrated[end], best === null ? '–' : metres(best), least === null ? '–' : metres(least)));
    tabulate();
  }

  function tabulate() {
    if (!numbers.open) return;
    const { integrated, cost, bound, ms } = curve();
    const every = Math.max(1, Math.ceil(integrated.length / TABLE_ROWS));
    const chosen = integrated.map((_, index) => index).filter((index) => index % every === 0 || index === integrated.length - 1);
    const number = (/** @type {number | null} */ value) => (value === null ? '–' : value.toFixed(1));
    rows.replaceChildren(...chosen.map((at) => h('tr', {}, h('th', { scope: 'row' }, integrated[at]), h('td', {}, number(cost[at])), h('td', {}, number(bound[at])), h('td', {}, Math.round(ms[at])))));
  }

  function refresh() {
    if (place.clientWidth === 0) return; // its tab is closed
    const wait = drawn + EVERY_MS - performance.now();
    if (wait <= 0) draw();
    else later ||= window.setTimeout(() => ((later = 0), refresh()), wait);
  }

  new ResizeObserver(() => {
    if (place.clientWidth > 0) build();
  }).observe(place);

  return { element, refresh, restyle: () => plot && build() };
}
