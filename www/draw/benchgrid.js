import { drawSign } from './benchcells.js';

/** @import { Colours } from './benchcells.js' */
/** @import { Sign } from './benchshapes.js' */

/**
 * @typedef {object} GridRow a row of a tick grid
 * @property {number} id node
 * @property {string} name
 * @property {number} depth
 * @property {Sign | null} sign
 * @property {boolean} heading a row of its own for a name, without cells
 */

/** @typedef {'answer' | 'write' | 'halt'} MarkKind */

/**
 * @typedef {object} GridFrame what is to be drawn
 * @property {GridRow[]} rows
 * @property {number} length ticks there are
 * @property {number} present tick shown elsewhere; 0 before the first
 * @property {number | null} chosen node
 * @property {{ row: number, tick: number } | null} cursor
 * @property {Map<number, MarkKind[]>} marks of the script, by the number of ticks after which they act
 * @property {number | null} flag tick that is pointed out
 * @property {number} left scrolled
 * @property {number} top
 * @property {number} width
 * @property {number} height
 * @property {number} labels width of the column with names
 * @property {number} side of a cell
 * @property {string} word what the numbers count
 */

export const HEAD = 36;
const INDENT = 8;
const DEEPEST = 7; // deeper rows are not indented further
const FONT = 12;

/** The ticks of which something is seen, from 1; empty when `from` is after `to`. @param {GridFrame} frame */
export function ticksSeen({ left, width, labels, side, length }) {
  return { from: Math.max(1, Math.floor(left / side) + 1), to: Math.min(length, Math.ceil((left + width - labels) / side)) };
}

/** Room a row's name wants, without the indentation of depth. @param {GridRow} row */
export const indentOf = (row) => 8 + Math.min(row.depth, DEEPEST) * INDENT + (row.sign && row.sign.kind !== 'word' ? 15 : 0);

/**
 * Draws a grid of ticks: names at the left and numbers on top stay, cells move under them.
 *
 * @param {CanvasRenderingContext2D} pen
 * @param {GridFrame} frame
 * @param {Colours} colours
 * @param {{ letter: (row: GridRow, tick: number) => string | null, differs: (row: GridRow, tick: number) => boolean,
 *   cell: (pen: CanvasRenderingContext2D, letter: string, x: number, y: number) => void,
 *   fit: (pen: CanvasRenderingContext2D, words: string, room: number) => string }} how `letter` is null while not known
 */
export function drawGrid(pen, frame, colours, how) {
  const { rows, left, top, width, height, labels, side, present, cursor, length } = frame;
  const { from, to } = ticksSeen(frame);
  const first = Math.max(0, Math.floor(top / side));
  const last = Math.min(rows.length, Math.ceil((top + height - HEAD) / side));
  const xOf = (/** @type {number} */ tick) => labels + (tick - 1) * side - left;
  const yOf = (/** @type {number} */ row) => HEAD + row * side - top;
  const end = Math.min(width, xOf(length + 1));
  pen.clearRect(0, 0, width, height);
  for (let at = first; at < last; at += 1) {
    const row = rows[at];
    if (row.id === frame.chosen && !row.heading) fill(pen, colours.wash, 0, yOf(at), width, side);
    for (let tick = from; tick <= to && !row.heading; tick += 1) {
      const letter = how.letter(row, tick);
      if (letter === null) fill(pen, colours.wash, xOf(tick), yOf(at), side, side);
      else if (letter !== '.') how.cell(pen, letter, xOf(tick), yOf(at));
      if (how.differs(row, tick)) fill(pen, colours.ink, xOf(tick) + 4, yOf(at) + side - 2, side - 8, 2);
    }
    fill(pen, colours.hairline, 0, yOf(at + 1) - 1, row.heading ? width : end, 1);
  }
  const foot = Math.min(height, yOf(rows.length));
  for (const tick of frame.marks.keys()) {
    if (tick >= from - 1 && tick <= to && foot > HEAD) dashed(pen, colours.secondary, xOf(tick + 1) + 0.5, HEAD, foot);
  }
  if (present >= from && present <= to) {
    pen.strokeStyle = colours.ink;
    pen.lineWidth = 1.5;
    pen.strokeRect(xOf(present) + 0.25, HEAD - 15, side - 0.5, foot - HEAD + 15);
  }
  if (cursor && cursor.row >= first && cursor.row < last) {
    pen.strokeStyle = colours.accent;
    pen.lineWidth = 2;
    pen.strokeRect(xOf(cursor.tick) + 1, yOf(cursor.row) + 1, side - 2, side - 2);
  }
  drawHead(pen, frame, colours, xOf, from, to);
  drawNames(pen, frame, colours, yOf, first, last, how.fit);
}

/**
 * @param {CanvasRenderingContext2D} pen @param {GridFrame} frame @param {Colours} colours
 * @param {(tick: number) => number} xOf @param {number} from @param {number} to
 */
function drawHead(pen, { width, labels, side, marks, present, flag }, colours, xOf, from, to) {
  fill(pen, colours.ground, 0, 0, width, HEAD - 16);
  for (let tick = from; tick <= to; tick += 1) if (tick !== present) fill(pen, colours.ground, xOf(tick), HEAD - 16, side, 16);
  fill(pen, colours.ground, xOf(to + 1), HEAD - 16, width, 16);
  fill(pen, colours.hairline, 0, HEAD - 1, width, 1);
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  for (let tick = from; tick <= to; tick += 1) {
    const here = tick === present;
    if (!here && (tick % 5 !== 0 || (Math.abs(tick - present) * side < 30 && present > 0))) continue;
    pen.font = `${here ? '600 ' : ''}${FONT - 1}px ${colours.font}`;
    pen.fillStyle = here ? colours.ink : colours.secondary;
    pen.fillText(String(tick), xOf(tick) + side / 2, HEAD - 9);
  }
  pen.fillStyle = colours.ink;
  pen.font = `600 ${FONT + 1}px ${colours.font}`;
  if (flag !== null && flag >= from && flag <= to) pen.fillText('≠', xOf(flag) + side / 2, 10);
  for (const [tick, kinds] of marks) {
    if (tick < from - 1 || tick > to) continue;
    kinds.slice(0, 3).forEach((kind, at) => mark(pen, kind, Math.max(xOf(tick + 1), labels + 5) + at * 9, 9));
  }
}

/** @param {CanvasRenderingContext2D} pen @param {MarkKind} kind @param {number} x @param {number} y */
function mark(pen, kind, x, y) {
  pen.beginPath();
  if (kind === 'halt') pen.rect(x - 3.5, y - 3.5, 7, 7);
  else {
    pen.moveTo(x - 4, kind === 'answer' ? y - 3.5 : y);
    pen.lineTo(kind === 'answer' ? x + 4 : x, y - (kind === 'answer' ? 3.5 : 4));
    if (kind === 'write') pen.lineTo(x + 4, y);
    pen.lineTo(x, y + 4);
  }
  pen.fill();
}

/**
 * @param {CanvasRenderingContext2D} pen @param {GridFrame} frame @param {Colours} colours
 * @param {(row: number) => number} yOf @param {number} first @param {number} last
 * @param {(pen: CanvasRenderingContext2D, words: string, room: number) => string} fit
 */
function drawNames(pen, { rows, labels, width, side, chosen, word }, colours, yOf, first, last, fit) {
  pen.textAlign = 'start';
  pen.textBaseline = 'middle';
  for (let at = first; at < last; at += 1) {
    const row = rows[at];
    const middle = yOf(at) + side / 2 + 0.5;
    const here = row.id === chosen && !row.heading;
    fill(pen, colours.ground, 0, yOf(at), labels, side - 1);
    if (here) fill(pen, colours.wash, 0, yOf(at), labels, side - 1);
    if (here) fill(pen, colours.accent, 0, yOf(at), 3, side - 1);
    fill(pen, colours.hairline, 0, yOf(at + 1) - 1, labels, 1);
    pen.font = `${row.heading || here ? '600 ' : ''}${FONT}px ${colours.font}`;
    pen.fillStyle = pen.strokeStyle = colours.ink;
    const x = 8 + Math.min(row.depth, DEEPEST) * INDENT;
    const used = drawSign(pen, row.sign, x, middle);
    const words = fit(pen, row.name, (row.heading ? width : labels) - x - used - 6);
    if (row.heading) fill(pen, colours.ground, x, yOf(at) + 1, pen.measureText(words).width + 4, side - 2); // over what crosses it
    pen.fillStyle = colours.ink;
    pen.fillText(words, x + used, middle);
    if (!row.heading) fill(pen, colours.hairline, labels - 1, yOf(at), 1, side);
  }
  fill(pen, colours.ground, 0, 0, labels, HEAD - 1);
  pen.font = `${FONT - 1}px ${colours.font}`;
  pen.fillStyle = colours.secondary;
  pen.textAlign = 'end';
  pen.fillText(word, labels - 6, HEAD - 9);
  fill(pen, colours.hairline, labels - 1, 0, 1, HEAD);
  fill(pen, colours.hairline, 0, HEAD - 1, labels, 1);
}

/** @param {CanvasRenderingContext2D} pen @param {string} colour @param {number} x @param {number} y @param {number} w @param {number} h */
function fill(pen, colour, x, y, w, h) {
  pen.fillStyle = colour;
  pen.fillRect(x, y, w, h);
}

/** @param {CanvasRenderingContext2D} pen @param {string} colour @param {number} x @param {number} from @param {number} to */
function dashed(pen, colour, x, from, to) {
  pen.strokeStyle = colour;
  pen.lineWidth = 1;
  pen.setLineDash([2, 3]);
  pen.beginPath();
  pen.moveTo(x, from);
  pen.lineTo(x, to);
  pen.stroke();
  pen.setLineDash([]);
}
