import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { h, write } from '../../ui/dom.js';
import { soccerText } from '../../ui/strings.soccer.en.js';

/** @import { PitchTheme } from '../../draw/soccer.js' */
/** @import { SoccerMatch } from '../../soccer/match.js' */
/** @import { SoccerPlayback } from '../../soccer/playback.js' */

const words = soccerText.charts;
const EVERY = 30; // ticks between two points
const ROW_TICKS = 1800;
const HEIGHT = 132;
const EVERY_MS = 200; // at most five redraws a second while it is computed

/**
 * Ball, goals, shots and possession over the whole match, with their numbers as a table.
 *
 * @param {{ match: SoccerMatch, playback: SoccerPlayback, theme: () => PitchTheme & { yellowLine: string }, onTheme: (listener: () => void) => void }} parts
 */
export function createChartsTab({ match, playback, theme, onTheme }) {
  const frames = [words.ball, words.score, words.shots, words.possession].map((title) => {
    const place = h('div', { class: 'chart', 'aria-hidden': 'true' });
    return { place, element: h('figure', {}, h('figcaption', {}, h('h2', {}, title)), place) };
  });
  const said = h('p', { class: 'said small' });
  const rows = h('tbody', {});
  const numbers = h(
    'details',
    { class: 'numbers' },
    h('summary', {}, words.table),
    h('table', {}, h('caption', {}, words.caption), h('thead', {}, h('tr', {}, ...words.columns.map((column) => h('th', { scope: 'col' }, column)))), rows),
  );
  const element = h('div', { class: 'tab-body' }, said, ...frames.map(({ element: figure }) => figure), h('p', { class: 'status-key' }, words.ballSaid), numbers);
  numbers.addEventListener('toggle', tabulate);
  /** @type {uPlot[]} */
  let plots = [];
  let drawn = ''; // of what
  let at = 0;
  let later = 0;

  function build() {
    for (const plot of plots) plot.destroy();
    drawn = '';
    const width = frames[0].place.clientWidth;
    if (width === 0) {
      plots = [];
      return;
    }
    const colours = theme();
    const pair = [
      { label: words.blue, stroke: colours.robot, width: 2 },
      { label: words.yellow, stroke: colours.yellowLine, width: 2, dash: [5, 3] },
    ];
    plots = [
      plot(frames[0].place, width, colours, [{ label: words.x, stroke: colours.ink, width: 1 }], () => [-0.85, 0.85]),
      plot(frames[1].place, width, colours, pair, (high) => [0, Math.max(high + 1, 3)], true),
      plot(frames[2].place, width, colours, pair, (high) => [0, Math.max(high * 1.1, 5)], true),
      plot(frames[3].place, width, colours, [{ label: words.percent, stroke: colours.robot, width: 2 }], () => [0, 100]),
    ];
    draw();
  }

  function draw() {
    at = performance.now();
    const key = `${match.front()} ${match.fingerprint} ${match.calls.length}`;
    if (key !== drawn) {
      drawn = key;
      const { film } = match;
      const ticks = Array.from({ length: Math.floor(match.front() / EVERY) + 1 }, (_, index) => index * EVERY);
      const seconds = ticks.map((tick) => tick / 60);
      const counts = ticks.map((tick) => film.counts(tick));
      const goals = ticks.map((tick) => film.goals(tick));
      plots[0]?.setData([seconds, ticks.map((tick) => film.ball(tick)[0])]);
      plots[1]?.setData([seconds, goals.map(([blue]) => blue), goals.map(([, yellow]) => yellow)]);
      plots[2]?.setData([seconds, counts.map(({ shots }) => shots[0]), counts.map(({ shots }) => shots[1])]);
      plots[3]?.setData([seconds, counts.map(({ possession }) => 100 * shareOf(possession))]);
      tabulate();
    } else for (const each of plots) each.redraw(false, false); // the line of the present moment
    const { shots, possession } = match.film.counts(playback.tick);
    write(said, words.said(match.film.goals(playback.tick), shots, shareOf(possession)));
  }

  function tabulate() {
    if (!numbers.open) return;
    const { film } = match;
    const ticks = Array.from({ length: Math.floor(match.front() / ROW_TICKS) + 1 }, (_, index) => index * ROW_TICKS);
    rows.replaceChildren(
      ...ticks.map((tick) => {
        const { shots, possession, swaps } = film.counts(tick);
        const pair = (/** @type {number[]} */ [blue, yellow]) => h('td', {}, `${blue} : ${yellow}`);
        return h('tr', {}, h('th', { scope: 'row' }, soccerText.clock(tick / 60)), pair(film.goals(tick)), pair(shots), h('td', {}, soccerText.share(shareOf(possession))), pair(swaps));
      }),
    );
  }

  /**
   * @param {HTMLElement} place
   * @param {number} width
   * @param {PitchTheme} colours
   * @param {uPlot.Series[]} lines
   * @param {(high: number) => [number, number]} range
   * @param {boolean} [steps] whether values stay until they change
   */
  function plot(place, width, colours, lines, range, steps = false) {
    /** @type {uPlot.Axis} */
    const axis = { stroke: colours.secondary, font: `11px ${colours.font}`, grid: { stroke: colours.hairline, width: 1 }, ticks: { stroke: colours.hairline, width: 1, size: 4 }, gap: 4 };
    const paths = steps ? uPlot.paths.stepped?.({ align: 1 }) : undefined;
    return new uPlot(
      {
        width,
        height: HEIGHT,
        padding: [8, 20, 0, 0],
        scales: { x: { time: false }, y: { range: (_, __, high) => range(high ?? 0) } },
        series: [{ label: words.time, value: (_, value) => (value === null ? '' : soccerText.clock(value)) }, ...lines.map((line) => ({ points: { show: false }, paths, value: (/** @type {uPlot} */ _, /** @type {number | null} */ value) => (value === null ? '' : String(Math.round(value * 100) / 100)), ...line }))],
        axes: [
          { ...axis, size: 24, values: (_, splits) => splits.map((value) => soccerText.clock(value)) },
          { ...axis, size: 34 },
        ],
        cursor: { y: false, points: { size: 6 } },
        legend: { live: true },
        hooks: {
          draw: [
            ({ ctx, bbox, valToPos }) => {
              const x = valToPos(playback.tick / 60, 'x', true);
              if (x < bbox.left || x > bbox.left + bbox.width) return;
              ctx.save();
              ctx.strokeStyle = colours.accent;
              ctx.lineWidth = 1.5 * devicePixelRatio;
              ctx.beginPath();
              ctx.moveTo(x, bbox.top);
              ctx.lineTo(x, bbox.top + bbox.height);
              ctx.stroke();
              ctx.restore();
            },
          ],
        },
      },
      [[], ...lines.map(() => [])],
      place,
    );
  }

  new ResizeObserver(build).observe(frames[0].place);
  onTheme(build);

  return {
    element,
    show() {
      const wait = at + EVERY_MS - performance.now();
      if (wait <= 0) draw();
      else later ||= window.setTimeout(() => ((later = 0), draw()), wait);
    },
  };
}

/** Blue's share of the time in which anybody had the ball. @param {number[]} possession */
const shareOf = ([blue, yellow]) => (blue + yellow > 0 ? blue / (blue + yellow) : 0.5);
