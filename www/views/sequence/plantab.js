import { metres } from '../../sequence/words.js';
import { button, h, write } from '../../ui/dom.js';
import { sequenceText } from '../../ui/strings.sequence.en.js';

/** @import { Fan } from '../../sequence/fan.js' */
/** @import { Planner } from '../../sequence/planner.js' */
/** @import { SequenceSession } from '../../sequence/session.js' */

const MORE = /** @type {Record<string, string>} */ ({ searching: 'stop', held: 'go', 'gave-up': 'more', cancelled: 'more' });

/**
 * The plan on screen: its behaviours with what each costs, and how it fares when robots start a little elsewhere.
 *
 * @param {{ planner: Planner, session: SequenceSession, fan: Fan, kind: () => string }} parts `kind` is that of the result
 */
export function createPlanTab({ planner, session, fan, kind }) {
  const search = button('', () => void (planner.status === 'searching' ? planner.cancel() : planner.resume()), {});
  search.id = 'sequence-more';
  const total = h('p', {});
  const rows = h('tbody', {});
  const table = h('table', { class: 'plan-table' }, h('thead', {}, h('tr', {}, ...sequenceText.plan.columns.map((column) => h('th', { scope: 'col' }, column)))), rows);
  const jitter = h('select', { id: 'sequence-jitter' }, ...sequenceText.robust.jitters.map(([value, label]) => h('option', { value }, label)));
  const check = button(sequenceText.robust.check, () => void fan.run(Number(jitter.value)));
  check.id = 'sequence-robust';
  const said = h('p', { class: 'robust-said', id: 'sequence-robust-said' });
  const robust = h('section', { class: 'robust' }, h('h2', {}, sequenceText.robust.title), h('p', { class: 'secondary small' }, sequenceText.robust.about), h('div', { class: 'row' }, h('label', { for: jitter.id }, sequenceText.robust.jitter), jitter, check), said);
  const element = h('div', { class: 'tab-body' }, h('div', { class: 'row' }, search), total, table, robust);
  let shown = '';

  return {
    element,
    show() {
      const now = planner.status === 'held' ? 'held' : kind();
      const more = MORE[now];
      search.hidden = more === undefined || !planner.task;
      if (more) write(search, more === 'stop' ? sequenceText.search.stop : more === 'go' ? sequenceText.search.go : sequenceText.search.more(session.scenario.budget));
      const path = session.path();
      const { task } = planner;
      check.disabled = path === null || fan.running();
      write(said, fan.words());
      table.hidden = path === null;
      if (!path || !task) {
        write(total, planner.blocked.length > 0 ? sequenceText.plan.blocked : sequenceText.plan.none);
        rows.replaceChildren(...planner.blocked.map((line) => h('tr', {}, h('td', { colspan: 4 }, line))));
        table.hidden = planner.blocked.length === 0;
        shown = '';
        return;
      }
      const { replay, letters } = path;
      write(total, sequenceText.plan.total(metres(replay.total), metres(replay.charges), replay.charges > 0));
      const key = `${letters} ${replay.total}`;
      if (key === shown) return;
      shown = key;
      const covers = 'cells' in task.goal;
      rows.replaceChildren(
        ...[...letters].map((letter, interval) => {
          const name = task.library.find((behaviour) => behaviour.letter === letter)?.name ?? letter;
          const cost = replay.costs[interval];
          const cells = covers ? (replay.visited[interval + 1] ?? null) : null;
          return h('tr', {}, h('th', { scope: 'row' }, interval + 1), h('td', {}, `${letter}  ${name}`), h('td', {}, cost === undefined ? '–' : cost.toFixed(1)), h('td', {}, cells === null ? '' : cells));
        }),
      );
      table.classList.toggle('covers', covers);
    },
  };
}
