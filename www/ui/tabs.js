import { h } from './dom.js';

/**
 * Tabs with panels: arrows move, the panel follows.
 *
 * @param {{ label: string, tabs: { name: string, label: string, panel: HTMLElement }[], changed: (name: string) => void }} options
 */
export function createTabs({ label, tabs, changed }) {
  const buttons = tabs.map(({ name, label: written }) =>
    h('button', { type: 'button', role: 'tab', id: `tab-${name}`, 'aria-controls': `panel-${name}`, onclick: () => open(name) }, written),
  );
  const list = h('div', { class: 'tabs', role: 'tablist', 'aria-label': label }, ...buttons);
  const panels = tabs.map(({ name, panel }) => h('div', { role: 'tabpanel', id: `panel-${name}`, 'aria-labelledby': `tab-${name}`, class: 'panel', tabindex: 0 }, panel));
  let current = tabs[0].name;

  /** @param {string} name */
  function open(name) {
    current = name;
    tabs.forEach((tab, index) => {
      buttons[index].setAttribute('aria-selected', String(tab.name === name));
      buttons[index].tabIndex = tab.name === name ? 0 : -1;
      panels[index].hidden = tab.name !== name;
    });
    changed(name);
  }

  list.addEventListener('keydown', (event) => {
    const at = tabs.findIndex(({ name }) => name === current);
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: tabs.length - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    const next = (to + tabs.length) % tabs.length;
    open(tabs[next].name);
    buttons[next].focus();
  });

  return { list, panels, open, current: () => current };
}
