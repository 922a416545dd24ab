import { h, write } from '../../ui/dom.js';
import { benchText } from '../../ui/strings.trees.en.js';

/** @type {Record<string, string>} */
const GLYPH = { S: '✓', F: '✗', R: '▸', K: '–', H: '■', I: '', E: '!' };
/** @type {Record<string, string>} letters by name */
const LETTER = { SUCCESS: 'S', FAILURE: 'F', RUNNING: 'R', SKIPPED: 'K', HALTED: 'H', ERROR: 'E' };

/** The letter of a status. @param {string | null | undefined} status */
export const letterOf = (status) => LETTER[status ?? ''] ?? '.';

/**
 * A status as glyph, border and word.
 *
 * @param {string} letter S F R K, H halted, E error; anything else is no status
 * @param {string} [words] instead of the status's name
 */
export function statusMark(letter, words) {
  const element = h('span', { class: 'status' }, h('i', { class: 'status-glyph', 'aria-hidden': 'true' }), h('span', {}));
  showStatus(element, letter, words);
  return element;
}

/** Changes a mark. @param {HTMLElement} mark @param {string} letter @param {string} [words] */
export function showStatus(mark, letter, words = letter === 'E' ? 'ERROR' : (benchText.status[letter] ?? '')) {
  mark.dataset.status = letter;
  const [glyph, word] = mark.children;
  write(glyph, GLYPH[letter] ?? '');
  write(word, words);
}
