import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { h, write } from '../../ui/dom.js';
import { abText } from '../../ui/strings.ab.en.js';

/** @import { Theme } from '../../draw/theme.js' */
/** @import { Engine } from '../../engine.js' */
/** @import { History } from '../../types.js' */

const EVERY_MS = 100; // at most ten redraws a second
const TABLE_ROWS = 24;

/**
 * What A and B have delivered, as two lines in one chart: solid and dashed, each named at its end, with the numbers as a table.
 *
 * @param {{ engines: () => { a: Pick<Engine, 'request'>, b: Pick<Engine, 'request'> } | null, tick: () => number, theme: () => Theme }} parts
 */
export function createPairChart({ engines, tick, theme }) {
  const said = h('p', { class: 'said small' });
  const place = h('div', { class: 'ab-plot', 'aria-hidden': 'true' });
  const rows = h('tbody', {});
  const head = h('tr', {}, ...abText.chart.columns.map((column) => h('th', { scope: 'col' }, column)));
  const numbers = h('details', { class: 'numbers' }, h('summary', {}, abText.chart.table), h('table', {}, h('caption', {}, abText.chart.caption), h('thead', {}, head), rows));
  const element = h('figure', { class: 'ab-chart' }, h('figcaption', {}, said, numbers), place);
  numbers.addEventListener('toggle', tabulate);

  /** @type {uPlot | null} */
  let plot = null;
  /** @type {{ every: number, a: number[], b: number[] }} delivered, by the number of the sample */
  let series = { every: 1, a: [], b: [] };
  let asking = false;
  let drawn = -Infinity;
  let later = 0;

  const ticks = () => (series.a.length > series.b.length ? series.a : series.b).map((_, index) => index * series.every);
  /** @param {number[]} values @param {number} index @returns {number | null} a run that ended has no later samples */
  const valueAt = (values, index) => values[index] ?? null;

  function build() {
    plot?.destroy();
    const colours = theme();
    /** @type {uPlot.Axis} */
    const axis = { stroke: colours.secondary, font: `11px ${colours.font}`, grid: { stroke: colours.hairline, width: 1 }, ticks: { stroke: colours.hairline, width: 1, size: 4 }, gap: 4 };
    plot = new uPlot(
      {
        width: Math.max(place.clientWidth, 200),
        height: place.clientHeight || 132,
        padding: [8, 28, 0, 0],
        scales: { x: { time: false }, y: { range: (_, low, high) => [Math.min(0, low), Math.max(high * 1.08, 5)] } },
        series: [
          { label: abText.chart.tick },
          { label: 'A', stroke: colours.robot, width: 2, points: { show: false } },
          { label: 'B', stroke: colours.load, width: 2, dash: [6, 4], points: { show: false } },
        ],
        axes: [{ ...axis, size: 24 }, { ...axis, size: 34 }],
        cursor: { show: false },
        legend: { show: false },
        hooks: { draw: [label] },
      },
      [[], [], []],
      place,
    );
    draw();
  }

  /** Writes A and B at the ends of their lines. @param {uPlot} drawing */
  function label(drawing) {
    const { ctx: context } = drawing;
    const ratio = devicePixelRatio;
    const ends = [series.a, series.b].map((values) => ({ x: drawing.valToPos((values.length - 1) * series.every, 'x', true), y: drawing.valToPos(values[values.length - 1] ?? 0, 'y', true) }));
    if (series.a.length === 0 || series.b.length === 0) return;
    const apart = 12 * ratio;
    const near = Math.abs(ends[0].y - ends[1].y) < apart && Math.abs(ends[0].x - ends[1].x) < apart;
    const middle = (ends[0].y + ends[1].y) / 2;
    const above = ends[0].y <= ends[1].y ? 0 : 1;
    context.save();
    context.fillStyle = theme().ink;
    context.font = `600 ${12 * ratio}px ${theme().font}`;
    context.textBaseline = 'middle';
    ends.forEach(({ x, y }, index) => context.fillText(index === 0 ? 'A' : 'B', x + 5 * ratio, near ? middle + (index === above ? -0.5 : 0.5) * apart : y));
    context.restore();
  }

  function draw() {
    drawn = performance.now();
    const x = ticks();
    plot?.setData([x, x.map((_, index) => valueAt(series.a, index)), x.map((_, index) => valueAt(series.b, index))]);
    const last = (/** @type {number[]} */ values) => values[values.length - 1] ?? 0;
    write(said, abText.chart.said(tick(), last(series.a), last(series.b)));
    tabulate();
  }

  function tabulate() {
    if (!numbers.open) return;
    const x = ticks();
    const every = Math.max(1, Math.ceil(x.length / TABLE_ROWS));
    const chosen = x.map((_, index) => index).filter((index) => index % every === 0 || index === x.length - 1);
    rows.replaceChildren(...chosen.map((at) => h('tr', {}, h('th', { scope: 'row' }, x[at]), h('td', {}, valueAt(series.a, at) ?? '–'), h('td', {}, valueAt(series.b, at) ?? '–'))));
  }

  async function refresh() {
    const wait = drawn + EVERY_MS - performance.now();
    const both = engines();
    if (!both) return;
    if (asking || wait > 0) {
      later ||= window.setTimeout(() => ((later = 0), void refresh()), Math.max(wait, EVERY_MS));
      return;
    }
    asking = true;
    try {
      if (Math.max(series.a.length, series.b.length) * series.every > tick() + series.every) clear();
      const asked = series;
      const answers = await Promise.all([both.a.request('history', { from: asked.a.length }), both.b.request('history', { from: asked.b.length })]);
      const [a, b] = answers.map((answer) => /** @type {History} */ (answer.history));
      if (asked !== series) return; // of other runs
      series.every = a.every;
      series.a.push(...a.delivered);
      series.b.push(...b.delivered);
      draw();
    } catch {
      drawn = performance.now(); // an engine has ended; the page says so elsewhere
    } finally {
      asking = false;
    }
  }

  function clear() {
    series = { every: series.every, a: [], b: [] };
  }

  new ResizeObserver(() => {
    if (place.clientWidth > 0) build();
  }).observe(place);

  return {
    element,
    refresh: () => void refresh(),
    restyle: () => plot && build(),
    forget() {
      clear();
      void refresh();
    },
  };
}
