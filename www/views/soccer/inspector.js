import { h, write } from '../../ui/dom.js';
import { soccerText } from '../../ui/strings.soccer.en.js';
import { text } from '../../ui/strings.en.js';
import { createTabs } from '../../ui/tabs.js';

/** @typedef {{ element: HTMLElement, show: () => void }} Panel */

/**
 * The right pane; writes only the tab that is open.
 *
 * @param {{ pane: HTMLElement, panels: { name: string, label: string, panel: Panel }[] }} parts
 */
export function createSoccerInspector({ pane, panels }) {
  const tabs = createTabs({
    label: soccerText.pane.inspector,
    tabs: panels.map(({ name, label, panel }) => ({ name: `soccer-${name}`, label, panel: panel.element })),
    changed: () => show(),
  });
  const sheet = h('button', { type: 'button', class: 'sheet-handle', 'aria-expanded': 'false', 'aria-controls': 'soccer-sheet' }, text.inspector.open);
  sheet.addEventListener('click', () => spread(!pane.classList.contains('open')));
  pane.append(sheet, h('div', { class: 'sheet-body', id: 'soccer-sheet' }, tabs.list, ...tabs.panels));

  /** @param {boolean} open on phones the pane is a sheet over the page's foot */
  function spread(open) {
    pane.classList.toggle('open', open);
    sheet.setAttribute('aria-expanded', String(open));
    write(sheet, open ? text.inspector.close : text.inspector.open);
    show();
  }

  function show() {
    panels.find(({ name }) => `soccer-${name}` === tabs.current())?.panel.show();
  }

  return {
    show,
    spread,
    current: () => tabs.current().replace(/^soccer-/, ''),
    /** @param {string} name */
    open: (name) => tabs.open(`soccer-${name}`),
  };
}
