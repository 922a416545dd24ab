import { h } from './dom.js';
import { text } from './strings.en.js';
import { remember, recall } from './storage.js';

/**
 * @typedef {object} KeyRow one row drives the handler, the list and `aria-keyshortcuts`
 * @property {string[]} keys values of `KeyboardEvent.key`; empty for keys that a part of the page handles itself
 * @property {string} shown
 * @property {string} action
 */

/** @type {KeyRow[]} */
export const KEYS = [
  { keys: [' '], shown: 'Space', action: 'toggle' },
  { keys: ['.'], shown: '.', action: 'forward' },
  { keys: [','], shown: ',', action: 'back' },
  { keys: ['>'], shown: '>', action: 'far-forward' },
  { keys: ['<'], shown: '<', action: 'far-back' },
  { keys: ['r', 'R'], shown: 'R', action: 'restart' },
  { keys: ['n', 'N'], shown: 'N', action: 'new-seed' },
  { keys: ['+', '='], shown: '+', action: 'faster' },
  { keys: ['-'], shown: '-', action: 'slower' },
  { keys: ['f', 'F'], shown: 'F', action: 'follow' },
  { keys: ['Escape'], shown: 'Escape', action: 'clear' },
  { keys: ['?'], shown: '?', action: 'keys' },
  { keys: [], shown: text.keys.arrows, action: 'world-arrows' },
  { keys: [], shown: 'Home, End', action: 'world-ends' },
  { keys: [], shown: text.keys.arrows, action: 'tree-arrows' },
  { keys: [], shown: text.keys.arrows, action: 'codon-arrows' },
];

const FIELDS = 'input:not([type=range]):not([type=checkbox]), textarea, select, [role=treeitem], [role=spinbutton], [role=tab]';

/**
 * Single keys act only while focus is in the world or the transport bar, or nowhere; never in fields, never with
 * Ctrl, Alt or Meta, never Space on something that Space presses (it would act twice).
 *
 * @param {Record<string, () => void>} actions by the names in `KEYS`
 * @param {HTMLElement[]} regions where keys act
 */
export function bindKeys(actions, regions) {
  let on = recall('keys') !== 'off';
  const dialog = createKeysDialog(on, (now) => {
    on = now;
    remember('keys', now ? 'on' : 'off');
    mark(on);
  });
  document.body.append(dialog);
  mark(on);

  document.addEventListener('keydown', (event) => {
    if (!on || event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey || dialog.open) return;
    const focus = document.activeElement;
    if (focus?.matches(FIELDS)) return;
    const nowhere = !focus || focus === document.body;
    if (!nowhere && !regions.some((region) => region.contains(focus))) return;
    if (event.key === ' ' && focus?.matches('button, summary, input, a')) return;
    if (focus?.matches('input[type=range]') && /^[-+=]$/.test(event.key)) return;
    const row = KEYS.find(({ keys }) => keys.includes(event.key));
    const action = row && (row.action === 'keys' ? () => dialog.showModal() : actions[row.action]);
    if (!action) return;
    event.preventDefault();
    action();
  });
  return { open: () => dialog.showModal() };
}

/** Writes `aria-keyshortcuts` on every button that does what a key does. @param {boolean} on */
function mark(on) {
  for (const element of document.querySelectorAll('[data-action]')) {
    const row = KEYS.find(({ action, keys }) => action === element.getAttribute('data-action') && keys.length > 0);
    if (row && on) element.setAttribute('aria-keyshortcuts', row.shown);
    else element.removeAttribute('aria-keyshortcuts');
  }
}

/**
 * @param {boolean} on
 * @param {(on: boolean) => void} change
 */
function createKeysDialog(on, change) {
  const box = h('input', { type: 'checkbox', checked: on });
  box.addEventListener('change', () => change(box.checked));
  const rows = KEYS.map(({ shown, action }) => h('tr', {}, h('th', { scope: 'row' }, h('kbd', {}, shown)), h('td', {}, text.keys.does[action])));
  const close = h('button', { type: 'button', onclick: () => dialog.close() }, text.close);
  const dialog = h(
    'dialog',
    { class: 'keys-dialog', 'aria-labelledby': 'keys-title' },
    h('h2', { id: 'keys-title' }, text.keys.title),
    h('p', {}, text.keys.where),
    h('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': text.keys.title }, h('table', {}, h('tbody', {}, ...rows))),
    h('div', { class: 'row' }, h('label', { class: 'check' }, box, text.keys.switch), close),
  );
  return dialog;
}
