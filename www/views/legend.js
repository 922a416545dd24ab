import { h, write } from '../ui/dom.js';
import { text } from '../ui/strings.en.js';

/** @import { Lens } from '../lens.js' */
/** @import { Run } from '../run.js' */
/** @import { State } from '../state.js' */
/** @import { Selection } from '../selection.js' */
/** @import { WorldView } from './world.js' */

const SUMMARY_EVERY_MS = 5000;

/**
 * Under the world: the layers with their counts as switches, the summary for screen readers, the table.
 *
 * @param {{ pane: HTMLElement, run: Run, lens: Lens, state: State, selection: Selection, world: WorldView }} parts
 */
export function createLegend({ pane, run, lens, state, selection, world }) {
  const { view } = world;
  const layers = /** @type {(keyof typeof view.layers)[]} */ (['robots', 'food', 'carried', 'delivered', 'trails']);
  const counts = new Map(layers.map((layer) => [layer, h('output', {})]));
  const names = new Map(layers.map((layer) => [layer, h('span', {}, text.layers[layer])]));
  const rows = layers.map((layer) => {
    const box = h('input', { type: 'checkbox', checked: view.layers[layer] });
    box.addEventListener('change', () => {
      view.layers[layer] = box.checked;
      world.invalidate();
    });
    return h('label', { class: 'layer', 'data-layer': layer }, box, h('i', { class: 'swatch', 'aria-hidden': 'true' }), names.get(layer) ?? '', ' ', counts.get(layer) ?? '');
  });
  /** @type {import('./agenttable.js').AgentTable | null} */
  let table = null;
  const slot = h('span', { hidden: true });
  const tableSwitch = h('button', { type: 'button', class: 'quiet', 'aria-pressed': 'false' }, text.world.table);
  tableSwitch.addEventListener('click', () => {
    const shown = tableSwitch.getAttribute('aria-pressed') !== 'true';
    tableSwitch.setAttribute('aria-pressed', String(shown));
    pane.classList.toggle('as-table', shown);
    void tabulate();
  });
  const summary = h('p', { class: 'unseen', id: 'summary' });
  pane.append(slot, h('div', { class: 'legend' }, h('div', { class: 'layers', role: 'group', 'aria-label': text.world.layers }, ...rows), tableSwitch), summary);

  let summarised = -Infinity;

  /** Shows or hides the table, which is loaded when it is first wished. */
  async function tabulate() {
    const { createAgentTable } = await import('./agenttable.js');
    if (!table) {
      table = createAgentTable(lens, selection);
      slot.replaceWith(table.element);
    }
    table.show(tableSwitch.getAttribute('aria-pressed') === 'true');
  }

  function count() {
    if (!world.ready()) return;
    const { at } = view;
    const { frame } = run;
    write(/** @type {Element} */ (counts.get('robots')), frame[at.aliveCount]);
    write(/** @type {Element} */ (counts.get('food')), frame[at.free]);
    write(/** @type {Element} */ (counts.get('carried')), frame[at.carried]);
    write(/** @type {Element} */ (counts.get('delivered')), frame[at.delivered]);
    const now = performance.now();
    if (state.name === 'running' && now - summarised < SUMMARY_EVERY_MS) return;
    summarised = now;
    write(summary, text.world.summary(run.tick, view.layout.item, frame[at.carried], at.agents, frame[at.delivered], frame[at.total]));
  }

  run.on('loaded', () => {
    const item = run.layout?.item ?? 'food';
    pane.dataset.item = item;
    write(/** @type {Element} */ (names.get('food')), text.items[item]);
    count();
  });
  run.on('settled', count);
  run.on('frame', count);
}
