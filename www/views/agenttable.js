import { h, write } from '../ui/dom.js';
import { text } from '../ui/strings.en.js';

/** @import { Lens } from '../lens.js' */
/** @import { Selection } from '../selection.js' */

const EVERY_MS = 1000;

/**
 * All robots as a table: what the canvas shows, for screen readers and for reading numbers.
 *
 * @param {Lens} lens
 * @param {Selection} selection
 */
export function createAgentTable(lens, selection) {
  const { run } = lens;
  const body = h('tbody', {});
  const head = h('tr', {}, ...text.table.columns.map((column) => h('th', { scope: 'col' }, column)));
  const caption = h('caption', {});
  const element = h('div', { class: 'agent-table', hidden: true, tabindex: 0, role: 'region', 'aria-label': text.world.table }, h('table', {}, caption, h('thead', {}, head), body));
  let shown = false;
  let written = -Infinity;

  function fill() {
    if (!shown || !lens.world().ready()) return;
    written = performance.now();
    const { at, layout } = lens.world().view;
    const { frame } = run;
    write(caption, text.table.caption(run.tick, lens.side()));
    while (body.rows.length < at.agents) body.append(row(body.rows.length));
    while (body.rows.length > at.agents) body.deleteRow(-1);
    for (let id = 0; id < at.agents; id += 1) {
      const base = at.agentStart + id * at.agentStride;
      const { cells } = body.rows[id];
      write(cells[1], frame[base + at.x].toFixed(1));
      write(cells[2], frame[base + at.y].toFixed(1));
      write(cells[3], frame[base + at.carrying] !== 0 ? text.yes : text.no);
      write(cells[4], frame[base + at.action] > 0 ? layout.actions[frame[base + at.action]] : '–');
      body.rows[id].classList.toggle('chosen', selection.agent === id);
    }
  }

  /** @param {number} id */
  function row(id) {
    const choose = h('button', { type: 'button', class: 'quiet', onclick: () => selection.selectAgent(id) }, id);
    return h('tr', {}, h('th', { scope: 'row' }, choose), h('td', {}), h('td', {}), h('td', {}), h('td', {}));
  }

  run.on('frame', () => {
    if (performance.now() - written > EVERY_MS) fill();
  });
  run.on('loaded', fill);
  run.on('settled', fill);
  selection.on(fill);

  return {
    element,
    /** @param {boolean} now */
    show(now) {
      shown = now;
      element.hidden = !now;
      fill();
    },
  };
}

/** @typedef {ReturnType<typeof createAgentTable>} AgentTable */
