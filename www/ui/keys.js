import { h } from './dom.js';
import { text } from './strings.en.js';
import { remember, recall } from './storage.js';

/**
 * @typedef {object} KeyRow one row drives the handler, the list and `aria-keyshortcuts`
 * @property {string[]} keys values of `KeyboardEvent.key`; empty for keys that a part of the page handles itself
 * @property {string} shown
 * @property {string} action
 * @property {string} [tab] the only tabs that have it; for keys that a part of the page handles itself
 */

/** @type {KeyRow[]} a tab's list holds the rows whose action it has, or that name it */
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
  { keys: ['a', 'A'], shown: 'A', action: 'compare' },
  { keys: ['/'], shown: '/', action: 'search' },
  { keys: ['Escape'], shown: 'Escape', action: 'clear' },
  { keys: ['1'], shown: '1', action: 'tab-forage' },
  { keys: ['2'], shown: '2', action: 'tab-sequence' },
  { keys: ['3'], shown: '3', action: 'tab-soccer' },
  { keys: ['4'], shown: '4', action: 'tab-trees' },
  { keys: ['5'], shown: '5', action: 'tab-studies' },
  { keys: ['6'], shown: '6', action: 'tab-learn' },
  { keys: ['?'], shown: '?', action: 'keys' },
  { keys: [], shown: text.keys.arrows, action: 'world-arrows', tab: 'forage' },
  { keys: [], shown: 'Home, End', action: 'world-ends', tab: 'forage' },
  { keys: [], shown: text.keys.arrows, action: 'map-arrows', tab: 'sequence' },
  { keys: [], shown: 'Page Up, Page Down', action: 'map-pages', tab: 'sequence soccer' },
  { keys: [], shown: text.keys.arrows, action: 'pitch-arrows', tab: 'soccer' },
  { keys: [], shown: '[ ]', action: 'pitch-turn', tab: 'soccer' },
  { keys: [], shown: text.keys.arrows, action: 'tree-arrows', tab: 'forage trees' },
  { keys: [], shown: text.keys.arrows, action: 'codon-arrows', tab: 'forage' },
  { keys: [], shown: 'S, F, R, K', action: 'tree-answers', tab: 'trees' },
  { keys: [], shown: text.keys.undo, action: 'undo', tab: 'trees sequence' },
  { keys: [], shown: text.keys.redo, action: 'redo', tab: 'trees sequence' },
];

const FIELDS = 'input:not([type=range]):not([type=checkbox]), textarea, select, [role=spinbutton], [role=tab]';
const IN_A_TREE = /^[.,<>?\d]$/; // letters and the rest mean something else there

/**
 * Single keys act only while focus is in the drawing or the transport bar, or nowhere; never in fields, never with
 * Ctrl, Alt or Meta, never Space on something that Space presses (it would act twice).
 *
 * @param {Record<string, () => void>} everywhere actions of the page, by the names in `KEYS`
 */
export function createKeys(everywhere) {
  let on = recall('keys') !== 'off';
  /** @type {{ name: string, actions: Record<string, () => void>, regions: HTMLElement[] }} */
  let open = { name: '', actions: {}, regions: [] };
  const dialog = createKeysDialog(on, (now) => {
    on = now;
    remember('keys', now ? 'on' : 'off');
    mark();
  });
  document.body.append(dialog.element);

  /** @param {string} name @returns {(() => void) | undefined} */
  const actionOf = (name) => open.actions[name] ?? everywhere[name];

  /** Writes `aria-keyshortcuts` on every button that does what a key does. */
  function mark() {
    for (const element of document.querySelectorAll('[data-action]')) {
      const row = KEYS.find(({ action, keys }) => action === element.getAttribute('data-action') && keys.length > 0);
      if (row && on) element.setAttribute('aria-keyshortcuts', row.shown);
      else element.removeAttribute('aria-keyshortcuts');
    }
  }

  document.addEventListener('keydown', (event) => {
    if (!on || event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey || document.querySelector('dialog[open]')) return;
    const focus = document.activeElement;
    if (focus?.matches(FIELDS) || (focus?.matches('[role=treeitem]') && !IN_A_TREE.test(event.key))) return;
    const nowhere = !focus || focus === document.body;
    if (!nowhere && !open.regions.some((region) => region.contains(focus))) return;
    if (event.key === ' ' && focus?.matches('button, summary, input, a')) return;
    if (focus?.matches('input[type=range]') && /^[-+=]$/.test(event.key)) return;
    const row = KEYS.find(({ keys }) => keys.includes(event.key));
    const action = row && actionOf(row.action);
    if (!action) return;
    event.preventDefault();
    action();
  });

  return {
    open: dialog.open,

    /**
     * Keys act on another tab now, or on more of the same.
     *
     * @param {string} name
     * @param {{ actions: Record<string, () => void>, regions: HTMLElement[] } | null} tab null while it loads
     */
    use(name, tab) {
      open = { name, actions: tab?.actions ?? {}, regions: tab?.regions ?? [] };
      dialog.list(KEYS.filter(({ keys, action, tab: only }) => (keys.length > 0 ? actionOf(action) : !only || only.split(' ').includes(name))));
      mark();
    },
  };
}

/**
 * @param {boolean} on
 * @param {(on: boolean) => void} change
 */
function createKeysDialog(on, change) {
  const box = h('input', { type: 'checkbox', checked: on });
  box.addEventListener('change', () => change(box.checked));
  const rows = h('tbody', {});
  const close = h('button', { type: 'button', onclick: () => element.close() }, text.close);
  const element = h(
    'dialog',
    { class: 'keys-dialog', 'aria-labelledby': 'keys-title' },
    h('h2', { id: 'keys-title' }, text.keys.title),
    h('p', {}, text.keys.where),
    h('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': text.keys.title }, h('table', {}, rows)),
    h('div', { class: 'row' }, h('label', { class: 'check' }, box, text.keys.switch), close),
  );
  return {
    element,
    open: () => element.showModal(),
    /** @param {KeyRow[]} list */
    list: (list) => rows.replaceChildren(...list.map(({ shown, action }) => h('tr', {}, h('th', { scope: 'row' }, h('kbd', {}, shown)), h('td', {}, text.keys.does[action])))),
  };
}

/** @typedef {ReturnType<typeof createKeys>} Keys */
