import './style/hiding.css';
import { listed } from './pagekeys.js';
import { button, h } from './ui/dom.js';
import { hidingText } from './ui/strings.hiding.en.js';

/** @import { Room } from './router.js' */

/**
 * @typedef {object} Part something of a tab that a link can hide
 * @property {string} name as in links
 * @property {string} within the part that holds it, empty when none does
 * @property {string} selector
 */

/** @type {Part[]} in reading order; what a tab does not have is passed over */
const PARTS = [
  { name: 'controls', within: '', selector: '.controls-pane' },
  { name: 'preset', within: 'controls', selector: '.preset' },
  { name: 'inspector', within: '', selector: '.inspector-pane, .studies-text' },
  { name: 'words', within: '', selector: '.lede' },
  { name: 'zoom', within: '', selector: '.zoom' },
  { name: 'compare', within: '', selector: '[data-action=compare]' },
  { name: 'tools', within: '', selector: '.sequence-tools, .trees-bar' },
  { name: 'ribbon', within: '', selector: '.ribbon-pane' },
  { name: 'timeline', within: '', selector: '.trees-timeline' },
  { name: 'legend', within: '', selector: '.legend' },
  { name: 'transport', within: '', selector: '.transport' },
  { name: 'play', within: 'transport', selector: '.transport .buttons' },
  { name: 'scrub', within: 'transport', selector: '.transport .time' },
  { name: 'speed', within: 'transport', selector: '.transport .speed' },
  { name: 'ticks', within: 'transport', selector: '.tick-kind' },
  { name: 'seed', within: 'transport', selector: '.transport .seed' },
  { name: 'foot', within: '', selector: '.foot' },
];
const LONGEST = 60; // of what is repeated of a link
const NONE = 'none'; // in `ui`: the world alone
const NAME = /^[a-z][a-z0-9.-]{0,60}$/;

/**
 * Hides parts of tabs as addresses say. A sheet of rules does it, so that what is built later is never seen either.
 *
 * @param {{ tools: HTMLElement, active: () => Room | null }} parts `tools` is where the way back to all controls stands
 */
export function createHiding({ tools, active }) {
  const sheet = new CSSStyleSheet();
  document.adoptedStyleSheets.push(sheet);
  /** @type {Map<string, string>} rules by room */
  const rules = new Map();
  /** @type {Map<string, () => void>} ways back by room */
  const ways = new Map();
  const note = h('span', { class: 'hiding-note' });
  const all = button(hidingText.showAll, () => ways.get(active()?.name ?? '')?.(), { action: 'show-all' });
  const strip = h('span', { class: 'hiding', hidden: true }, note, all);
  tools.prepend(strip);

  function show() {
    const room = active();
    strip.hidden = !room || !listed(room.page, 'hide').length;
  }

  return {
    /**
     * Takes the page's part of a room's address.
     *
     * @param {Room} room
     * @param {() => void} showAll forgets it
     */
    apply(room, showAll) {
      const { name, element, page } = room;
      const hidden = hiddenBy(name, page);
      rules.set(name, hidden.selectors.length > 0 ? `:is(${hidden.selectors.join(', ')}):is(#${element.id} *) { display: none !important }` : '');
      element.dataset.without = hidden.names.join(' ');
      sheet.replaceSync([...rules.values()].join('\n'));
      ways.set(name, showAll);
      this.settle(room);
    },

    /** Opens what an address asks for: the groups of its controls, and where the open tab of an inspector is hidden, the first visible one. @param {Room} room */
    settle(room) {
      const { element, page } = room;
      show();
      const known = hidable(room).map(({ name }) => name);
      const built = known.some((name) => name.includes('.') || name === 'play');
      const unknown = listed(page, 'hide').filter((name) => !NAME.test(name) || (built && !known.includes(name)));
      note.textContent = unknown.length > 0 ? hidingText.unknown(unknown.join(', ').slice(0, LONGEST)) : '';
      for (const key of listed(page, 'ui')) {
        const control = NAME.test(key) ? element.querySelector(`[data-key="${key}"]`) : null;
        control?.closest('details')?.setAttribute('open', '');
      }
      for (const list of element.querySelectorAll('[role=tablist]')) {
        const tabs = [...list.querySelectorAll('[role=tab]')].filter((tab) => tab instanceof HTMLElement);
        const seen = tabs.filter((tab) => getComputedStyle(tab).display !== 'none');
        if (!seen.some((tab) => tab.getAttribute('aria-selected') === 'true')) seen[0]?.click();
      }
    },
  };
}

/**
 * What an address hides: everything in `hide`, and where it says `ui`, everything that `ui` does not list.
 *
 * @param {string} room
 * @param {string} page
 * @returns {{ selectors: string[], names: string[] }} `names` of the parts that are hidden as a whole
 */
function hiddenBy(room, page) {
  const [hide, ui] = [listed(page, 'hide'), listed(page, 'ui')];
  const names = new Set(hide.filter((name) => NAME.test(name)));
  /** @type {string[]} */
  const selectors = [];
  if (ui.length > 0) {
    const wanted = ui.filter((name) => NAME.test(name) && name !== NONE);
    const keys = wanted.filter((name) => name.includes('.'));
    const tabs = wanted.filter((name) => !name.includes('.') && !PARTS.some((part) => part.name === name));
    const holds = (/** @type {string} */ part) => PARTS.some(({ name, within }) => within === part && wanted.includes(name));
    for (const { name, within } of PARTS) {
      const filled = holds(name) || (name === 'controls' && keys.length > 0) || (name === 'inspector' && tabs.length > 0);
      if (!wanted.includes(name) && !wanted.includes(within) && !filled) names.add(name);
    }
    if (!wanted.includes('controls')) selectors.push(...otherControls(keys));
    if (!wanted.includes('inspector')) selectors.push(...otherTabs(room, tabs));
  }
  for (const name of names) selectors.push(PARTS.find((part) => part.name === name)?.selector ?? selectorOf(room, name));
  return { selectors, names: [...names].filter((name) => PARTS.some((part) => part.name === name)) };
}

/** Every control but these, and the groups that hold none of them. @param {string[]} keys */
function otherControls(keys) {
  const kept = keys.map((key) => `[data-key="${key}"]`);
  const holds = kept.length > 0 ? kept.join(', ') : ':not(*)';
  return [`[data-key]:not(${holds})`, `.group:not(:has(${holds}))`];
}

/** Every tab of the inspector but these, and its panel. @param {string} room @param {string[]} tabs */
function otherTabs(room, tabs) {
  const rest = (/** @type {string} */ kind) => tabs.map((tab) => `:not(#${kind}-${esc(tab)}, #${kind}-${room}-${esc(tab)})`).join('');
  return [`.inspector-pane [role=tab]${rest('tab')}`, `.inspector-pane [role=tabpanel]${rest('panel')}`];
}

/** A control by its key, or a tab of the inspector by its name. @param {string} room @param {string} name */
function selectorOf(room, name) {
  if (name.includes('.')) return `[data-key="${name}"]`;
  return ['tab', 'panel'].flatMap((kind) => [`#${kind}-${esc(name)}`, `#${kind}-${room}-${esc(name)}`]).join(', ');
}

/** @param {string} name */
const esc = (name) => CSS.escape(name);

/**
 * Everything of a tab that a link can hide, as it stands on the page.
 *
 * @param {Room} room
 * @returns {{ name: string, within: string, label: string }[]}
 */
export function hidable({ name: room, element }) {
  const parts = PARTS.filter(({ selector }) => element.querySelector(selector)).map(({ name, within }) => ({ name, within, label: hidingText.parts[name] }));
  const tabs = [...element.querySelectorAll('.inspector-pane [role=tab]')].map((tab) => ({
    name: tab.id.replace(/^tab-/, '').replace(`${room}-`, ''),
    within: 'inspector',
    label: hidingText.tab(tab.textContent ?? ''),
  }));
  const controls = [...element.querySelectorAll('.controls-pane [data-key]')].map((control) => ({
    name: control.getAttribute('data-key') ?? '',
    within: 'controls',
    label: control.querySelector('label, .control-name')?.textContent ?? '',
  }));
  return [...parts, ...tabs, ...controls].filter(({ name }) => NAME.test(name));
}

/** @typedef {ReturnType<typeof createHiding>} Hiding */
