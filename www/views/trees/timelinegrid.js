import '../../style/trees/timeline.css';
import { createCells, createFitting, readColours } from '../../draw/benchcells.js';
import { HEAD, drawGrid, indentOf, ticksSeen } from '../../draw/benchgrid.js';
import { h, write, zoomOf } from '../../ui/dom.js';
import { figureText as text } from '../../ui/strings.figures.en.js';

/** @import { GridFrame, GridRow, MarkKind } from '../../draw/benchgrid.js' */

const SIDE = { fine: 24, coarse: 32 };
const LABELS = { least: 96, most: 220, share: 0.4 };
const MEASURED = 400; // rows that decide how wide the names' column is

/**
 * A grid of rows and ticks on a canvas that stays in place while its frame scrolls, with a cell cursor for the keys.
 *
 * @param {object} how
 * @param {(row: GridRow, tick: number) => string | null} how.letter null while it is not known
 * @param {(row: GridRow, tick: number) => boolean} [how.differs]
 * @param {(row: GridRow | null, tick: number) => string} how.describe a cell, or of a tick its marks
 * @param {(row: GridRow | null, tick: number | null) => void} how.press a cell, a name or a number was pressed
 * @param {(from: number, to: number) => void} [how.seen] the ticks in view
 */
export function createTickGrid({ letter, differs = () => false, describe, press, seen = () => {} }) {
  const canvas = h('canvas', { 'aria-hidden': 'true' });
  const size = h('div', { class: 'ticks-size' }, canvas);
  const scroller = h('div', { class: 'ticks', tabindex: 0, role: 'application' }, size);
  const said = h('p', { class: 'unseen', 'aria-live': 'polite' });
  const element = h('div', { class: 'ticks-frame' }, scroller, said);
  const pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  const side = matchMedia('(pointer: coarse)').matches ? SIDE.coarse : SIDE.fine;
  const fit = createFitting();
  /** @type {GridFrame} */
  const frame = {
    rows: [],
    length: 0,
    present: 0,
    chosen: null,
    cursor: null,
    marks: new Map(),
    flag: null,
    left: 0,
    top: 0,
    width: 0,
    height: 0,
    labels: LABELS.least,
    side,
    word: text.timeline.tick,
  };
  let colours = readColours(document.documentElement);
  let cell = createCells(colours, side, 1);
  let ratio = 0;
  let following = true;
  let planned = 0;

  function redraw() {
    planned ||= requestAnimationFrame(() => ((planned = 0), draw()));
  }

  function draw() {
    if (frame.width === 0 || frame.height === 0) return;
    if (ratio !== devicePixelRatio || canvas.width !== Math.round(frame.width * ratio) || canvas.height !== Math.round(frame.height * ratio)) fitCanvas();
    const { from, to } = ticksSeen(frame);
    if (from <= to) seen(from, to);
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    const cursor = scroller.matches(':focus-visible') ? frame.cursor : null;
    drawGrid(pen, { ...frame, cursor }, colours, { letter, differs, cell, fit });
  }

  function fitCanvas() {
    if (ratio !== devicePixelRatio) cell = createCells(colours, side, devicePixelRatio);
    ratio = devicePixelRatio;
    canvas.width = Math.round(frame.width * ratio);
    canvas.height = Math.round(frame.height * ratio);
    canvas.style.width = `${frame.width}px`;
    canvas.style.height = `${frame.height}px`;
  }

  /** Colours may have changed with the theme. */
  function recolour() {
    colours = readColours(document.documentElement);
    cell = createCells(colours, side, devicePixelRatio);
    redraw();
  }

  function measure() {
    frame.width = scroller.clientWidth;
    frame.height = scroller.clientHeight;
    pen.font = `12px ${colours.font}`;
    // headings are bold; in narrow places they run on over the cells
    const wish = (/** @type {GridRow} */ row) =>
      row.heading && frame.width < LABELS.most * 2 ? 0 : pen.measureText(row.name).width * (row.heading ? 1.15 : 1) + indentOf(row) + 14;
    const widest = frame.rows.slice(0, MEASURED).reduce((most, row) => Math.max(most, wish(row)), LABELS.least);
    frame.labels = Math.round(Math.min(widest, LABELS.most, Math.max(frame.width * LABELS.share, LABELS.least)));
    stretch();
  }

  /** The frame scrolls over as much as there is. */
  function stretch() {
    size.style.width = `${Math.max(frame.labels + frame.length * side + 8, frame.width)}px`;
    size.style.height = `${Math.max(HEAD + frame.rows.length * side + 4, frame.height)}px`;
  }

  /** Scrolls as little as shows a cell. @param {number} tick @param {number | null} row */
  function bring(tick, row) {
    if (frame.width === 0) return;
    const [x, room] = [(tick - 1) * side, frame.width - frame.labels];
    if (tick > 0 && x < scroller.scrollLeft) scroller.scrollLeft = x;
    else if (tick > 0 && x + side + 8 > scroller.scrollLeft + room) scroller.scrollLeft = x + side + 8 - room;
    if (row === null) return;
    const [y, height] = [row * side, frame.height - HEAD];
    if (y < scroller.scrollTop) scroller.scrollTop = y;
    else if (y + side > scroller.scrollTop + height) scroller.scrollTop = y + side - height;
  }

  function inView() {
    const left = (frame.present - 1) * side;
    return frame.present === 0 || (left + side > scroller.scrollLeft && left < scroller.scrollLeft + frame.width - frame.labels);
  }

  /** The row and tick under the pointer; null for names, numbers and what is outside. @param {MouseEvent} event */
  function under(event) {
    const box = canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top].map((place) => place / zoomOf(canvas));
    const row = y < HEAD ? null : (frame.rows[Math.floor((y - HEAD + frame.top) / side)] ?? null);
    const tick = Math.floor((x - frame.labels + frame.left) / side) + 1;
    return { row: row?.heading ? null : row, tick: x < frame.labels || tick > frame.length ? null : tick, head: y < HEAD };
  }

  /** @param {number} row @param {number} tick */
  function point(row, tick) {
    frame.cursor = { row, tick };
    bring(tick, row);
    write(said, describe(frame.rows[row], tick));
    redraw();
  }

  /** The next row with cells. @param {number} from @param {number} by */
  function rowFrom(from, by) {
    const to = Math.min(Math.max(from + by, 0), frame.rows.length - 1);
    if (!frame.rows[to]?.heading) return to;
    const beyond = to + Math.sign(by || 1);
    return frame.rows[beyond] ? beyond : from;
  }

  scroller.addEventListener('scroll', () => {
    frame.left = scroller.scrollLeft;
    frame.top = scroller.scrollTop;
    if (frame.width > 0) following = inView();
    redraw();
  });
  scroller.addEventListener('click', (event) => {
    const { row, tick, head } = under(event);
    if (!row && (tick === null || !head)) return;
    if (row && tick !== null) frame.cursor = { row: frame.rows.indexOf(row), tick };
    press(row, tick);
    redraw();
  });
  scroller.addEventListener('pointermove', (event) => {
    const { row, tick, head } = under(event);
    const title = tick !== null && (row || head) ? describe(row, tick) : (row?.name ?? '');
    if (scroller.title !== title) scroller.title = title;
  });
  for (const type of ['focus', 'blur']) scroller.addEventListener(type, redraw);
  scroller.addEventListener('keydown', (event) => {
    if (event.altKey || event.metaKey || event.shiftKey || frame.length === 0 || frame.rows.length === 0) return;
    const chosen = frame.rows.findIndex(({ id }) => id === frame.chosen);
    const { row, tick } = frame.cursor ?? { row: rowFrom(Math.max(chosen, 0), 0), tick: Math.max(frame.present, 1) };
    const page = Math.max(1, Math.floor((frame.height - HEAD) / side) - 1);
    /** @type {Record<string, [number, number]>} */
    const moves = {
      ArrowLeft: [0, -1],
      ArrowRight: [0, 1],
      ArrowUp: [-1, 0],
      ArrowDown: [1, 0],
      Home: [event.ctrlKey ? -Infinity : 0, -Infinity],
      End: [event.ctrlKey ? Infinity : 0, Infinity],
      PageUp: [-page, 0],
      PageDown: [page, 0],
    };
    if (event.key === 'Enter') press(frame.rows[row], tick);
    else if (moves[event.key] && (!event.ctrlKey || /Home|End/.test(event.key))) {
      const [down, right] = frame.cursor || /Home|End/.test(event.key) ? moves[event.key] : [0, 0]; // the first key shows where one is
      point(rowFrom(row, down), Math.min(Math.max(tick + right, 1), frame.length));
    } else return;
    event.preventDefault();
    event.stopPropagation();
  });

  new ResizeObserver(() => {
    measure();
    if (following) bring(frame.present, null);
    draw();
  }).observe(scroller);
  new MutationObserver(recolour).observe(document.documentElement, { attributeFilter: ['data-theme'] });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', recolour);

  return {
    element,
    redraw,

    /** @param {GridRow[]} rows */
    rows(rows) {
      frame.rows = rows;
      if (frame.cursor && frame.cursor.row >= rows.length) frame.cursor = null;
      measure();
      redraw();
    },

    /** Follows the present tick unless the person scrolled away from it. @param {number} length @param {number} present */
    ticks(length, present) {
      const grown = length !== frame.length;
      frame.length = length;
      frame.present = present;
      if (frame.cursor && frame.cursor.tick > length) frame.cursor = null;
      if (grown) stretch();
      if (following) bring(present, null);
      redraw();
    },

    /** @param {Map<number, MarkKind[]>} marks */
    marks(marks) {
      frame.marks = marks;
      redraw();
    },

    /** @param {number | null} tick a tick to be pointed out */
    flag: (tick) => void (frame.flag = tick),

    /** @param {number | null} id */
    choose(id) {
      if (frame.chosen === id) return;
      frame.chosen = id;
      const row = frame.rows.findIndex((other) => other.id === id && !other.heading);
      if (row >= 0) bring(0, row);
      redraw();
    },

    /** What the grid holds, for those who do not see it. @param {string} summary */
    label: (summary) => scroller.setAttribute('aria-label', summary),

    /** Height that holds all rows. */
    wholeHeight: () => HEAD + frame.rows.length * side + 20,
  };
}

/** @typedef {ReturnType<typeof createTickGrid>} TickGrid */
