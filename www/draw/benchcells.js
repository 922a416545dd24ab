import { ARROWS, GLYPHS } from './benchshapes.js';
import { shorten } from './benchlayout.js';

/** @import { Sign } from './benchshapes.js' */

const NAMES = /** @type {const} */ (['ground', 'ink', 'secondary', 'hairline', 'field', 'wash', 'accent', 'food', 'load', 'running', 'outline']);

/** @typedef {Record<typeof NAMES[number], string> & { font: string }} Colours */

/** The colours of a tick grid in force. @param {Element} element @returns {Colours} */
export function readColours(element) {
  const style = getComputedStyle(element);
  return /** @type {Colours} */ ({ ...Object.fromEntries(NAMES.map((name) => [name, style.getPropertyValue(`--${name}`).trim()])), font: style.fontFamily });
}

const PATHS = Object.fromEntries(Object.entries({ ...GLYPHS, ...ARROWS }).map(([name, path]) => [name, new Path2D(path)]));
const AIR = 3; // between a cell's border and that of its neighbour, halved

/**
 * Draws one cell per status: the sign, the colour and the border that the drawing of the tree has. Every cell is drawn
 * once and then copied.
 *
 * @param {Colours} colours
 * @param {number} side
 * @param {number} ratio device pixels per pixel
 */
export function createCells(colours, side, ratio) {
  /** @type {Map<string, HTMLCanvasElement>} */
  const made = new Map();

  /** @param {string} letter */
  function make(letter) {
    const sheet = document.createElement('canvas');
    sheet.width = sheet.height = Math.ceil(side * ratio);
    const pen = /** @type {CanvasRenderingContext2D} */ (sheet.getContext('2d'));
    pen.scale(ratio, ratio);
    drawCell(pen, letter, side, colours);
    made.set(letter, sheet);
    return sheet;
  }

  return (/** @type {CanvasRenderingContext2D} */ pen, /** @type {string} */ letter, /** @type {number} */ x, /** @type {number} */ y) =>
    pen.drawImage(made.get(letter) ?? make(letter), x, y, side, side);
}

/** @param {CanvasRenderingContext2D} pen @param {string} letter @param {number} side @param {Colours} colours */
function drawCell(pen, letter, side, colours) {
  const { ink, ground, food, load, running, outline } = colours;
  /** @param {string} colour @param {number} width @param {number} inset */
  const frame = (colour, width, inset) => {
    const from = AIR + inset + width / 2;
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.strokeRect(from, from, side - 2 * from, side - 2 * from);
  };
  /** @param {string} colour */
  const tint = (colour) => {
    pen.globalAlpha = 0.16;
    pen.fillStyle = colour;
    pen.fillRect(AIR, AIR, side - 2 * AIR, side - 2 * AIR);
    pen.globalAlpha = 1;
  };
  if (letter === 'S') {
    tint(food);
    frame(food, 1.5, 0);
  } else if (letter === 'F') {
    tint(load);
    frame(load, 1, 0);
    frame(load, 1, 2);
  } else if (letter === 'R') {
    tint(running);
    frame(outline, 1, 0);
    frame(running, 2, 0.75);
  } else if (letter === 'K') {
    pen.setLineDash([1.5, 2.25]);
    frame(ink, 1.25, 0);
    pen.setLineDash([]);
  } else if (letter === 'H') {
    pen.fillStyle = ink;
    pen.fillRect(AIR, AIR, side - 2 * AIR, side - 2 * AIR);
  } else if (letter === 'E') frame(ink, 3, 0);
  glyph(pen, letter, side / 2, { S: food, F: load, K: ink, E: ink, H: ground, R: outline }[letter] ?? ink, letter === 'R' ? running : ground);
}

/** @param {CanvasRenderingContext2D} pen @param {string} letter @param {number} middle @param {string} line @param {string} fill */
function glyph(pen, letter, middle, line, fill) {
  const path = PATHS[letter];
  if (!path) return;
  pen.save();
  pen.translate(middle, middle);
  pen.scale(0.9, 0.9);
  pen.lineCap = 'round';
  pen.lineJoin = 'round';
  pen.strokeStyle = line;
  pen.fillStyle = fill;
  pen.lineWidth = letter === 'R' || letter === 'H' ? 1 : 2.1;
  if (letter === 'R' || letter === 'H') pen.fill(path);
  pen.stroke(path);
  pen.restore();
}

/**
 * The sign of a control node before its name; gives the room it took.
 *
 * @param {CanvasRenderingContext2D} pen
 * @param {Sign | null} sign
 * @param {number} x
 * @param {number} y
 */
export function drawSign(pen, sign, x, y) {
  if (!sign || sign.kind === 'word') return 0;
  if (sign.kind === 'fallback') pen.fillText('?', x + 2, y);
  else {
    pen.save();
    pen.translate(x + 6, y + 0.5);
    pen.scale(0.75, 0.75);
    pen.lineWidth = 1.75;
    pen.stroke(PATHS[sign.kind]);
    pen.restore();
  }
  return 15;
}

/** Cuts texts to the room there is; results are kept, since every frame asks again. */
export function createFitting() {
  /** @type {Map<string, string>} */
  const known = new Map();
  return (/** @type {CanvasRenderingContext2D} */ pen, /** @type {string} */ words, /** @type {number} */ room) => {
    const key = `${Math.round(room)} ${pen.font} ${words}`;
    let fitting = known.get(key);
    if (fitting === undefined) known.set(key, (fitting = shorten(words, room, (part) => pen.measureText(part).width)));
    return fitting;
  };
}
