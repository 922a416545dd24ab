import { h, write } from '../../ui/dom.js';
import { text } from '../../ui/strings.en.js';
import { sequenceText } from '../../ui/strings.sequence.en.js';
import { createTabs } from '../../ui/tabs.js';

/** @typedef {{ element: HTMLElement, show: () => void, secret?: boolean }} Panel what is secret is not shown to somebody who plays */

/**
 * The right pane; writes only the tab that is open.
 *
 * @param {{ pane: HTMLElement, panels: { name: string, label: string, panel: Panel }[], playing: () => boolean }} parts `playing` is whether secrets are kept
 */
export function createSequenceInspector({ pane, panels, playing }) {
  const bodies = panels.map(({ panel }) => {
    const note = h('p', { class: 'tab-body secondary', hidden: true }, sequenceText.game.notNow);
    return { note, body: h('div', {}, panel.element, note) };
  });
  const tabs = createTabs({
    label: sequenceText.pane.inspector,
    tabs: panels.map(({ name, label }, index) => ({ name: `sequence-${name}`, label, panel: bodies[index].body })),
    changed: () => show(),
  });
  const sheet = h('button', { type: 'button', class: 'sheet-handle', 'aria-expanded': 'false', 'aria-controls': 'sequence-sheet' }, text.inspector.open);
  sheet.addEventListener('click', () => spread(!pane.classList.contains('open')));
  pane.append(sheet, h('div', { class: 'sheet-body', id: 'sequence-sheet' }, tabs.list, ...tabs.panels));

  /** @param {boolean} open on phones the pane is a sheet over the page's foot */
  function spread(open) {
    pane.classList.toggle('open', open);
    sheet.setAttribute('aria-expanded', String(open));
    write(sheet, open ? text.inspector.close : text.inspector.open);
    show();
  }

  function show() {
    const at = panels.findIndex(({ name }) => `sequence-${name}` === tabs.current());
    const { panel } = panels[at];
    const kept = panel.secret === true && playing();
    panel.element.hidden = kept;
    bodies[at].note.hidden = !kept;
    if (!kept) panel.show();
  }

  return {
    show,
    spread,
    current: () => tabs.current().replace(/^sequence-/, ''),
    /** Opens the first tab; not before everything it shows is there. */
    begin: () => tabs.open(`sequence-${panels[0].name}`),
    /** @param {string} name */
    open(name) {
      tabs.open(`sequence-${name}`);
    },
  };
}
