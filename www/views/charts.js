import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { h, write } from '../ui/dom.js';
import { text } from '../ui/strings.en.js';

/** @import { Engine } from '../engine.js' */
/** @import { SeenRun } from '../lens.js' */
/** @import { Theme } from '../draw/theme.js' */
/** @import { History } from '../types.js' */

const EVERY_MS = 100; // at most ten redraws a second
const HEIGHT = 168;
const TABLE_ROWS = 24;

/**
 * Delivered food and distinct trees over time, each with its numbers as a table. Loaded when first shown.
 *
 * @param {{ pane: HTMLElement, engine: Pick<Engine, 'request'>, run: SeenRun, theme: () => Theme }} parts
 */
export function createCharts({ pane, engine, run, theme }) {
  /** @type {number[]} */
  let ticks = [];
  /** @type {Record<'delivered' | 'carrying' | 'programs' | 'swaps', number[]>} */
  let series = { delivered: [], carrying: [], programs: [], swaps: [] };
  let asking = false;
  let drawn = -Infinity;
  let later = 0;

  const food = chartFrame(text.charts.food);
  const trees = chartFrame(text.charts.trees);
  const rows = h('tbody', {});
  const numbers = h(
    'details',
    { class: 'numbers' },
    h('summary', {}, text.charts.table),
    h('table', {}, h('caption', {}, text.charts.caption), h('thead', {}, h('tr', {}, ...text.charts.columns.map((column) => h('th', { scope: 'col' }, column)))), rows),
  );
  pane.append(food.element, trees.element, numbers);
  numbers.addEventListener('toggle', tabulate);

  /** @type {uPlot[]} */
  let plots = [];

  function build() {
    for (const plot of plots) plot.destroy();
    const width = Math.max(food.place.clientWidth, 200);
    const colours = theme();
    plots = [
      plot(food.place, width, colours, [
        { label: text.charts.delivered, stroke: colours.food, width: 2 },
        { label: text.charts.carrying, stroke: colours.load, width: 1.25, dash: [4, 3] },
      ]),
      plot(trees.place, width, colours, [{ label: text.charts.programs, stroke: colours.robot, width: 2 }]),
    ];
    draw();
  }

  function draw() {
    drawn = performance.now();
    plots[0]?.setData([ticks, series.delivered, series.carrying]);
    plots[1]?.setData([ticks, series.programs]);
    const end = ticks.length - 1;
    if (end < 0) return;
    write(food.said, text.charts.saidFood(ticks[end], series.delivered[end], series.carrying[end]));
    write(trees.said, text.charts.saidTrees(series.programs[end], ticks[end]));
    tabulate();
  }

  function tabulate() {
    if (!numbers.open) return;
    const every = Math.max(1, Math.ceil(ticks.length / TABLE_ROWS));
    const chosen = ticks.map((_, index) => index).filter((index) => index % every === 0 || index === ticks.length - 1);
    rows.replaceChildren(...chosen.map((at) => h('tr', {}, h('th', { scope: 'row' }, ticks[at]), h('td', {}, series.delivered[at]), h('td', {}, series.carrying[at]), h('td', {}, series.programs[at]), h('td', {}, series.swaps[at]))));
  }

  /** Fetches what is new; after a step back everything. */
  async function refresh() {
    const wait = drawn + EVERY_MS - performance.now();
    if (asking || wait > 0) {
      later ||= window.setTimeout(() => ((later = 0), void refresh()), Math.max(wait, EVERY_MS));
      return;
    }
    asking = true;
    try {
      if (ticks.length > 0 && ticks[ticks.length - 1] > run.tick) clear();
      const asked = ticks;
      /** @type {History} */
      const history = (await engine.request('history', { from: ticks.length })).history;
      if (asked !== ticks) return; // it was of another run
      history.delivered.forEach((_, index) => ticks.push((history.from + index) * history.every));
      for (const name of /** @type {const} */ (['delivered', 'carrying', 'programs', 'swaps'])) series[name].push(...history[name]);
      draw();
    } catch {
      drawn = performance.now(); // the engine has ended; the page says so elsewhere
    } finally {
      asking = false;
    }
  }

  function clear() {
    ticks = [];
    series = { delivered: [], carrying: [], programs: [], swaps: [] };
  }

  new ResizeObserver(() => {
    if (food.place.clientWidth > 0) build();
  }).observe(food.place);

  return {
    refresh: () => void refresh(),
    restyle: build,
    forget() {
      clear();
      void refresh();
    },
  };
}

/** @param {string} title */
function chartFrame(title) {
  const place = h('div', { class: 'chart', 'aria-hidden': 'true' });
  const said = h('p', { class: 'said small' });
  return { element: h('figure', {}, h('figcaption', {}, h('h2', {}, title), said), place), place, said };
}

/**
 * @param {HTMLElement} place
 * @param {number} width
 * @param {Theme} colours
 * @param {uPlot.Series[]} lines
 */
function plot(place, width, colours, lines) {
  /** @type {uPlot.Axis} */
  const axis = { stroke: colours.secondary, font: `11px ${colours.font}`, grid: { stroke: colours.hairline, width: 1 }, ticks: { stroke: colours.hairline, width: 1, size: 4 }, gap: 4 };
  const value = (/** @type {uPlot} */ _, /** @type {number | null} */ at) => String(at ?? '');
  return new uPlot(
    {
      width,
      height: HEIGHT,
      padding: [8, 16, 0, 0],
      scales: { x: { time: false }, y: { range: (_, low, high) => [Math.min(0, low), Math.max(high * 1.08, 5)] } },
      series: [{ label: text.charts.tick, value }, ...lines.map((line) => ({ points: { show: false }, value, ...line }))],
      axes: [
        { ...axis, size: 26 },
        { ...axis, size: 34 },
      ],
      cursor: { y: false, points: { size: 6 } },
      legend: { live: true },
    },
    [[], ...lines.map(() => [])],
    place,
  );
}

/** @typedef {ReturnType<typeof createCharts>} Charts */
