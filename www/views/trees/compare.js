import '../../style/trees/compare.css';
import { compareForms, leavesOf } from '../../draw/benchcompare.js';
import { GLYPHS } from '../../draw/benchshapes.js';
import { h, s, write } from '../../ui/dom.js';
import { figureText as text } from '../../ui/strings.figures.en.js';
import { createBenchFigure } from './figure.js';
import { createTickGrid } from './timelinegrid.js';

/** @import { Moment, Timeline } from '../../trees/types.js' */
/** @import { Form } from '../../draw/benchcompare.js' */
/** @import { GridRow } from '../../draw/benchgrid.js' */

/** @type {Record<string, string>} */
const LETTER = { SUCCESS: 'S', FAILURE: 'F', RUNNING: 'R', SKIPPED: 'K', ERROR: 'E' };

/**
 * Forms of one tree side by side, and the sentence that says where they part.
 *
 * @param {{ label: string }} options
 */
export function createCompare({ label }) {
  const note = h('p', { class: 'compare-note' });
  const sentence = h('p', { class: 'compare-sentence', role: 'status' });
  const panels = h('div', { class: 'compare-panels' });
  const hint = h('p', { class: 'compare-hint' }, text.compare.tableHint);
  /** @type {ReturnType<typeof createPanel>[]} */
  let made = [];
  /** @type {Form[]} */
  let forms = [];
  /** @type {Timeline[]} */
  let histories = [];
  let present = 0;
  let compared = compareForms([], []);
  /** @type {Map<GridRow, { form: number, leaf: number }>} */
  let places = new Map();
  const grid = createTickGrid({
    letter(row, tick) {
      const place = places.get(row);
      return place ? compared.letter(place.form, place.leaf, tick) : null;
    },
    differs: (row, tick) => compared.differs(places.get(row)?.leaf ?? 0, tick),
    describe,
    press: (row) => row && choose(row.id),
  });
  const frame = h('section', { class: 'compare-ticks', 'aria-label': text.compare.table }, grid.element, hint);
  const element = h('div', { class: 'compare', role: 'group', 'aria-label': label }, note, sentence, panels, frame);

  /** @param {GridRow | null} row @param {number} tick */
  function describe(row, tick) {
    const place = row && places.get(row);
    if (!row || !place) return text.timeline.column(tick, []);
    const said = text.timeline.cell(`${forms[place.form].type}, ${row.name}`, tick, compared.letter(place.form, place.leaf, tick) ?? '', []);
    return compared.differs(place.leaf, tick) ? text.compare.differing(said) : said;
  }

  /** @param {number | null} id */
  function choose(id) {
    for (const { figure } of made) figure.select(id);
    grid.choose(id);
  }

  function showRows() {
    places = new Map();
    /** @type {GridRow[]} */
    const rows = [];
    forms.forEach(({ type, nodes }, form) => {
      rows.push({ id: -1 - form, name: type, depth: 0, sign: null, heading: true });
      leavesOf(nodes).forEach(({ id, name }, leaf) => {
        const row = { id, name, depth: 1, sign: null, heading: false };
        places.set(row, { form, leaf });
        rows.push(row);
      });
    });
    grid.rows(rows);
    grid.element.style.height = `${grid.wholeHeight()}px`;
  }

  function showTicks() {
    compared = compareForms(forms, histories);
    const { from, to, first } = compared;
    const several = forms.length > 1;
    write(sentence, !several ? '' : to < from ? text.compare.before : first ? text.compare.differ(first, from) : text.compare.equal(from, to));
    frame.hidden = forms.length === 0 || to < from;
    hint.hidden = !first;
    grid.label(`${text.compare.table}. ${sentence.textContent} ${text.timeline.keys}`);
    grid.flag(first?.tick ?? null);
    grid.ticks(Math.max(to, 0), Math.min(present, Math.max(to, 0)));
  }

  showTicks();

  return {
    element,

    /** @param {Form[]} list up to three @param {string} words what they are forms of, or why there are none */
    show(list, words) {
      write(note, words);
      note.hidden = words === '';
      forms = list;
      histories = [];
      present = 0;
      made = list.map((form) => createPanel(form, choose));
      panels.replaceChildren(...made.map((panel) => panel.element));
      for (const panel of made) panel.open();
      showRows();
      showTicks();
    },

    /** @param {Moment[]} moments one for each form */
    paint(moments) {
      moments.forEach((moment, index) => made[index]?.paint(moment));
      present = moments[0]?.tick ?? 0;
      showTicks();
    },

    /** @param {Timeline[]} list one for each form */
    history(list) {
      histories = list;
      showTicks();
    },
  };
}

/**
 * @param {Form} form
 * @param {(id: number | null) => void} choose
 */
function createPanel({ type, nodes }, choose) {
  const figure = createBenchFigure({ label: text.compare.figure(type), select: choose, answer: () => {} });
  const root = h('p', { class: 'compare-root' });
  const title = h('h4', {});
  const leaves = h('ol', { class: 'compare-leaves' });
  const drawn = h('div', { class: 'compare-figure' }, figure.element);
  const element = h('section', { class: 'compare-panel', 'aria-label': type }, h('h3', {}, type), drawn, root, title, leaves);

  return {
    element,
    figure,

    /** Answers are changed elsewhere, for all forms at once. */
    open() {
      figure.show(nodes.map((node) => ({ ...node, scripted: false })));
      figure.zoom.fit();
    },

    /** @param {Moment} moment */
    paint(moment) {
      figure.paint(moment);
      const letter = moment.root === null ? '' : LETTER[moment.root];
      root.replaceChildren(mark(letter), h('span', {}, moment.root === null ? text.compare.noRoot : text.compare.rootIs(moment.root)));
      write(title, text.compare.leaves(moment.tick));
      const returns = moment.trace.filter(([id]) => nodes[id]?.end === id + 1);
      leaves.classList.toggle('compare-none', returns.length === 0);
      const told = returns.map(([id, status]) => h('li', {}, mark(LETTER[status]), h('span', {}, nodes[id].name), h('span', { class: 'compare-status' }, status)));
      leaves.replaceChildren(...(told.length > 0 ? told : [h('li', {}, text.compare.noLeaf)]));
    },
  };
}

/** The sign of a status beside its word. @param {string} letter */
function mark(letter) {
  const path = s('path', { class: 'bench-glyph', 'data-letter': letter, d: GLYPHS[letter] ?? '', 'stroke-linecap': 'round', 'stroke-linejoin': 'round' });
  return s('svg', { class: 'compare-mark', viewBox: '-8 -8 16 16', 'aria-hidden': 'true' }, path);
}

/** @typedef {ReturnType<typeof createCompare>} Compare */
