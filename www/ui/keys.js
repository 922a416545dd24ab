import { remember, recall } from './storage.js';

/**
 * @typedef {object} KeyRow one row drives the handler, the list and `aria-keyshortcuts`
 * @property {string[]} keys values of `KeyboardEvent.key`
 * @property {string} shown
 * @property {string} action
 */

/** @type {KeyRow[]} a tab's list holds the rows whose action it has */
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
  /** @type {import('./keysdialog.js').KeysDialog | null} */
  let dialog = null;

  /** @param {string} name @returns {(() => void) | undefined} */
  const actionOf = (name) => open.actions[name] ?? everywhere[name];

  /** Writes `aria-keyshortcuts` on every button that does what a key does. */
  function mark() {
    for (const element of document.querySelectorAll('[data-action]')) {
      const row = KEYS.find(({ action }) => action === element.getAttribute('data-action'));
      if (row && on) element.setAttribute('aria-keyshortcuts', row.shown);
      else element.removeAttribute('aria-keyshortcuts');
    }
  }

  const list = () => dialog?.list(KEYS.filter(({ action }) => actionOf(action)), open.name);

  /** @param {boolean} now whether single keys act */
  function switched(now) {
    on = now;
    remember('keys', now ? 'on' : 'off');
    mark();
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
    /** Shows the list, which is loaded when it is first wished. */
    async open() {
      const { createKeysDialog } = await import('./keysdialog.js');
      dialog ??= createKeysDialog(on, switched);
      list();
      dialog.open();
    },

    /**
     * Keys act on another tab now, or on more of the same.
     *
     * @param {string} name
     * @param {{ actions: Record<string, () => void>, regions: HTMLElement[] } | null} tab null while it loads
     */
    use(name, tab) {
      open = { name, actions: tab?.actions ?? {}, regions: tab?.regions ?? [] };
      list();
      mark();
    },
  };
}

/** @typedef {ReturnType<typeof createKeys>} Keys */
