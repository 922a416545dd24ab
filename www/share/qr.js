import encodeQR from 'qr';
import { s } from '../ui/dom.js';

const QUIET = 4; // modules of ground around the code, as the standard asks

/**
 * A text as a QR code; null when it is too long for one.
 *
 * @param {string} text
 * @param {string} label
 * @returns {SVGSVGElement | null}
 */
export function drawQr(text, label) {
  try {
    const rows = encodeQR(text, 'raw', { ecc: 'low', border: QUIET });
    const cells = rows.flatMap((row, y) => row.flatMap((dark, x) => (dark ? [`M${x} ${y}h1v1h-1z`] : [])));
    const side = rows.length;
    return s('svg', { class: 'qr', viewBox: `0 0 ${side} ${side}`, role: 'img', 'aria-label': label }, s('rect', { width: side, height: side, fill: '#fff' }), s('path', { d: cells.join(''), fill: '#000' }));
  } catch {
    return null;
  }
}
