import { button, h, write } from '../ui/dom.js';
import { text } from '../ui/strings.en.js';
import { gist } from '../draw/tree.js';

/** @import { SeenRun } from '../lens.js' */
/** @import { Selection } from '../selection.js' */
/** @import { AgentDetail, Detail } from '../types.js' */

/**
 * One robot: what it knows, carries and did; what its program is worth; which genomes it has met.
 *
 * @param {SeenRun} run
 * @param {Selection} selection
 */
export function createAgentTab(run, selection) {
  const title = h('h2', {});
  const follow = h('button', { type: 'button', 'data-action': 'follow' }, text.agent.follow);
  follow.addEventListener('click', selection.toggleFollow);
  const count = () => run.layout?.agents.count ?? 1;
  const move = (/** @type {number} */ by) => selection.selectAgent(((selection.agent ?? -by) + by + count()) % count());
  const under = h('p', { class: 'under' });
  const facts = h('dl', { class: 'facts-list' });
  const fitness = h('dl', { class: 'facts-list fitness-list' });
  const stored = h('tbody', {});
  const storedCaption = h('caption', {});
  const storedHead = h('thead', {}, h('tr', {}, ...text.agent.storedColumns.map((column) => h('th', { scope: 'col' }, column))));
  const storedTable = h(
    'table',
    { class: 'stored' },
    storedCaption,
    storedHead,
    stored,
  );
  const formula = h('p', { class: 'said small' });
  const body = h('div', {}, facts, h('h2', {}, text.agent.fitness), formula, fitness, storedTable);
  const empty = h('p', { class: 'empty' }, text.agent.none);
  const element = h(
    'div',
    { class: 'tab-body' },
    h('div', { class: 'agent-head' }, button(text.agent.previous, () => move(-1), { glyph: '‹' }), title, button(text.agent.next, () => move(1), { glyph: '›' }), follow),
    under,
    empty,
    body,
  );
  const rows = new Map([...text.agent.facts, ...text.agent.parts].map(([key, name]) => [key, { name, value: h('dd', {}) }]));
  for (const [list, keys] of /** @type {[HTMLElement, readonly (readonly [string, string])[]][]} */ ([[facts, text.agent.facts], [fitness, text.agent.parts]])) {
    for (const [key, name] of keys) list.append(h('dt', {}, name), /** @type {Node} */ (rows.get(key)?.value));
  }

  /** @param {string} key @param {string | number} value */
  const put = (key, value) => {
    const row = rows.get(key);
    if (row) write(row.value, value);
  };

  /** @param {Detail} detail */
  function show({ agent }) {
    empty.hidden = agent !== null;
    body.hidden = agent === null;
    write(title, agent ? text.world.robot(agent.id) : text.agent.title);
    follow.disabled = agent === null;
    follow.setAttribute('aria-pressed', String(selection.follow));
    showUnder();
    if (agent) showAgent(agent);
  }

  function showUnder() {
    under.hidden = selection.under.length < 2;
    if (under.hidden || under.dataset.ids === selection.under.join()) {
      for (const chip of under.querySelectorAll('button')) chip.setAttribute('aria-pressed', String(chip.textContent === String(selection.agent)));
      return;
    }
    under.dataset.ids = selection.under.join();
    const { under: ids } = selection;
    const chips = ids.map((/** @type {number} */ id) => h('button', { type: 'button', class: 'chip', 'aria-pressed': String(id === selection.agent), onclick: () => selection.selectAgent(id, ids) }, id));
    under.replaceChildren(h('span', {}, text.agent.under), ...chips);
  }

  /** @param {AgentDetail} agent */
  function showAgent(agent) {
    put('state', agent.alive ? text.agent.alive : text.agent.dead);
    put('action', agent.last_action ?? '–');
    put('load', agent.carrying ? text.agent.loaded : text.agent.unloaded);
    put('knows', agent.knows.join(', ') || '–');
    put('inside', agent.inside.join(', ') || '–');
    put('place', `${agent.x.toFixed(1)}, ${agent.y.toFixed(1)}`);
    put('since', text.agent.ticks(agent.since_swap));
    put('swaps', agent.swaps);
    put('next', agent.replaced_by ? gist(agent.replaced_by) : '–');
    showFitness(agent);
    storedHead.hidden = agent.stored.length === 0;
    write(storedCaption, text.agent.stored(agent.stored.length));
    while (stored.rows.length < agent.stored.length) stored.append(h('tr', {}, h('td', {}), h('td', {}), h('td', {})));
    while (stored.rows.length > agent.stored.length) stored.deleteRow(-1);
    agent.stored.forEach((genome, index) => {
      const { cells } = stored.rows[index];
      write(cells[0], text.world.robot(genome.donor));
      write(cells[1], genome.fitness.toFixed(2));
      write(cells[2], genome.diversity.toFixed(3));
    });
  }

  /**
   * The sum that the last tick made. A tree that was taken up in it starts at 0, and what it replaced is not summed up.
   *
   * @param {AgentDetail} agent
   */
  function showFitness(agent) {
    const { diversity, exploration, prospective, task, feedback, counts, memory, fitness: sum } = agent;
    const types = { diversity, exploration, prospective, task, feedback };
    const fresh = agent.since_swap === 0;
    let before = sum;
    for (const [type, value] of Object.entries(types)) {
      const shown = type === 'diversity' ? value.toFixed(3) : value;
      put(type, counts.includes(type) ? shown : text.agent.uncounted(shown));
      rows.get(type)?.value.classList.toggle('uncounted', !counts.includes(type));
      if (counts.includes(type)) before -= value;
    }
    write(formula, fresh ? text.agent.fresh : text.agent.formula);
    put('before', fresh || memory === 0 ? text.agent.forgotten : text.agent.before(memory, Math.abs(before) < 1e-9 ? 0 : before / memory));
    put('fitness', sum.toFixed(2));
  }

  return { element, show };
}
