import { signOf } from '../../draw/benchshapes.js';
import { button, h, write } from '../../ui/dom.js';
import { figureText as text } from '../../ui/strings.figures.en.js';
import { createColumns } from './timelinedata.js';
import { createTickGrid } from './timelinegrid.js';

/** @import { BenchNode, Moment, ScriptEvent, Timeline } from '../../trees/types.js' */
/** @import { GridRow, MarkKind } from '../../draw/benchgrid.js' */

const FILTERS = /** @type {const} */ (['all', 'leaves', 'ticked']);
const TOLD = 6; // events told of one tick

/**
 * What every node returned in every tick: nodes as rows, ticks as columns.
 *
 * @param {{ label: string, seek: (tick: number) => void, select: (id: number | null) => void, fetch: (from: number, to: number) => Promise<Timeline> }} options
 */
export function createTimeline({ label, seek, select, fetch }) {
  /** @type {BenchNode[]} */
  let nodes = [];
  /** @type {Moment | null} */
  let moment = null;
  /** @type {typeof FILTERS[number]} */
  let filter = 'all';
  /** @type {Set<number>} */
  let met = new Set(); // nodes ticked so far, also after going back
  /** @type {Map<number, ScriptEvent[]>} */
  let events = new Map();
  let shownMet = -1;
  const columns = createColumns(fetch, () => grid.redraw(), (failed) => tell(failed ? text.timeline.failed : ''));
  const grid = createTickGrid({
    letter: (row, tick) => columns.letter(row.id, tick),
    seen: (from, to) => columns.want(from, to, moment?.length ?? 0),
    describe,
    press(row, tick) {
      if (row) select(row.id);
      if (tick !== null) seek(tick);
    },
  });
  const choices = FILTERS.map((name) => button(text.timeline.filters[name], () => choose(name)));
  const note = h('p', { class: 'timeline-note', role: 'status' });
  const empty = h('p', { class: 'timeline-empty' });
  const head = h('div', { class: 'timeline-head' }, h('div', { class: 'timeline-filter', role: 'group', 'aria-label': text.timeline.rows }, ...choices), note);
  const element = h('div', { class: 'timeline' }, head, grid.element, empty);

  /** @param {GridRow | null} row @param {number} tick */
  function describe(row, tick) {
    const acting = (events.get(tick - 1) ?? []).map(text.timeline.event);
    const told = acting.length > TOLD ? [...acting.slice(0, TOLD), text.timeline.more(acting.length - TOLD)] : acting;
    if (!row) return text.timeline.column(tick, told);
    const letter = columns.letter(row.id, tick);
    return text.timeline.cell(row.name, tick, letter ?? '', told);
  }

  /** @param {string} words */
  function tell(words) {
    write(note, words);
  }

  /** @param {typeof FILTERS[number]} name */
  function choose(name) {
    filter = name;
    shownMet = -1;
    showRows();
  }

  function showRows() {
    FILTERS.forEach((name, index) => choices[index].setAttribute('aria-pressed', String(name === filter)));
    if (filter === 'ticked' && shownMet === met.size) return;
    shownMet = met.size;
    const chosen = nodes.filter(({ id, end }) => id === 0 || filter === 'all' || (filter === 'leaves' ? end === id + 1 : met.has(id)));
    /** @type {number[]} */
    const depths = [];
    for (const { id, parent } of nodes) depths[id] = parent === null ? 0 : depths[parent] + 1;
    grid.rows(chosen.map((node) => ({ id: node.id, name: node.name, depth: filter === 'leaves' ? 0 : depths[node.id], sign: signOf(node), heading: false })));
  }

  function showState() {
    const none = nodes.length === 0 || !moment || moment.length === 0;
    write(empty, nodes.length === 0 ? text.timeline.noTree : text.timeline.none);
    empty.hidden = !none;
    head.hidden = grid.element.hidden = none;
    grid.label(text.timeline.summary(label, nodes.length, moment?.length ?? 0, moment?.tick ?? 0, moment?.root ?? ''));
  }

  showState();
  showRows();

  return {
    element,

    /** @param {BenchNode[] | null} next @param {ScriptEvent[]} script */
    show(next, script) {
      const other = next !== nodes;
      nodes = next ?? [];
      events = new Map();
      for (const event of script) if (event.tick > 0 || !('leaf' in event)) events.set(event.tick, [...(events.get(event.tick) ?? []), event]);
      grid.marks(new Map([...events].map(([tick, list]) => [tick, list.map(kindOf).filter((kind, at, all) => all.indexOf(kind) === at)])));
      if (other) {
        moment = null;
        met = new Set();
        shownMet = -1;
        columns.forget();
        grid.choose(null);
        grid.ticks(0, 0);
        showRows();
      }
      showState();
    },

    /** @param {Moment | null} now */
    paint(now) {
      if (now && !columns.fits(now.length)) columns.forget();
      moment = now;
      now?.last.forEach((tick, id) => tick !== null && met.add(id));
      if (filter === 'ticked') showRows();
      showState();
      grid.ticks(now?.length ?? 0, now?.tick ?? 0);
    },

    /** @param {number | null} id */
    select: (id) => grid.choose(id),

    /** Forgets what was fetched: the run has become another. */
    refresh() {
      columns.forget();
      met = new Set();
      grid.redraw();
    },
  };
}

/** @param {ScriptEvent} event @returns {MarkKind} */
const kindOf = (event) => ('leaf' in event ? 'answer' : 'set' in event ? 'write' : 'halt');

/** @typedef {ReturnType<typeof createTimeline>} BenchTimeline */
