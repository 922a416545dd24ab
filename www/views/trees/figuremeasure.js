/** @import { Measure } from '../../draw/benchlayout.js' */

const FONTS = { name: '13px', small: '11px', word: '600 11px' };
const pen = /** @type {CanvasRenderingContext2D} */ (document.createElement('canvas').getContext('2d'));
const widths = { name: new Map(), small: new Map(), word: new Map() };

/** Widths of texts as the style sheet sets them; each is measured once. @type {Measure} */
export function measure(words, size) {
  /** @type {number | undefined} */
  let width = widths[size].get(words);
  if (width === undefined) {
    pen.font = `${FONTS[size]} ${getComputedStyle(document.body).fontFamily}`;
    width = pen.measureText(words).width;
    widths[size].set(words, width);
  }
  return width;
}
