import { h } from './dom.js';
import { keysText } from './strings.keys.en.js';

/** @import { KeyRow } from './keys.js' */

/** Keys that a part of a tab handles itself, and the tabs that have it. */
const OF_PARTS = [
  { shown: keysText.arrows, action: 'world-arrows', tabs: 'forage' },
  { shown: 'Home, End', action: 'world-ends', tabs: 'forage' },
  { shown: keysText.arrows, action: 'map-arrows', tabs: 'sequence' },
  { shown: 'Page Up, Page Down', action: 'map-pages', tabs: 'sequence soccer' },
  { shown: keysText.arrows, action: 'pitch-arrows', tabs: 'soccer' },
  { shown: '[ ]', action: 'pitch-turn', tabs: 'soccer' },
  { shown: keysText.arrows, action: 'tree-arrows', tabs: 'forage trees' },
  { shown: keysText.arrows, action: 'codon-arrows', tabs: 'forage' },
  { shown: 'S, F, R, K', action: 'tree-answers', tabs: 'trees' },
  { shown: keysText.undo, action: 'undo', tabs: 'trees sequence' },
  { shown: keysText.redo, action: 'redo', tabs: 'trees sequence' },
];

/**
 * The list of keys, with a switch for them.
 *
 * @param {boolean} on
 * @param {(on: boolean) => void} change
 */
export function createKeysDialog(on, change) {
  const box = h('input', { type: 'checkbox', checked: on });
  box.addEventListener('change', () => change(box.checked));
  const rows = h('tbody', {});
  const close = h('button', { type: 'button', onclick: () => element.close() }, keysText.close);
  const element = h(
    'dialog',
    { class: 'keys-dialog', 'aria-labelledby': 'keys-title' },
    h('h2', { id: 'keys-title' }, keysText.title),
    h('p', {}, keysText.where),
    h('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': keysText.title }, h('table', {}, rows)),
    h('div', { class: 'row' }, h('label', { class: 'check' }, box, keysText.switch), close),
  );
  document.body.append(element);
  return {
    open: () => element.showModal(),

    /** @param {KeyRow[]} keys that act now @param {string} tab that is open */
    list(keys, tab) {
      const all = [...keys, ...OF_PARTS.filter(({ tabs }) => tabs.split(' ').includes(tab))];
      rows.replaceChildren(...all.map(({ shown, action }) => h('tr', {}, h('th', { scope: 'row' }, h('kbd', {}, shown)), h('td', {}, keysText.does[action]))));
    },
  };
}

/** @typedef {ReturnType<typeof createKeysDialog>} KeysDialog */
