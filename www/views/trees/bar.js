import { button, h, write } from '../../ui/dom.js';
import { benchText } from '../../ui/strings.trees.en.js';

/** @import { BenchFigure } from './figure.js' */

/**
 * The bar over the drawing: what is done to the tree, how it is seen, finding nodes, comparing.
 *
 * @param {{ figure: BenchFigure, undo: () => void, redo: () => void, hit: (id: number) => void, compare: () => void }} parts
 *   `hit` shows a node that was found
 */
export function createBar({ figure, undo, redo, hit, compare }) {
  const back = button(benchText.bar.undo, undo, { glyph: '↶', action: 'undo' });
  const again = button(benchText.bar.redo, redo, { glyph: '↷', action: 'redo' });
  const way = button(benchText.bar.down, turn, { glyph: '↓' });
  const search = h('input', { type: 'search', placeholder: benchText.bar.search, 'aria-label': benchText.bar.search, 'data-action': 'search' });
  const count = h('output', { class: 'found-count', 'aria-live': 'off' });
  const next = button(benchText.bar.next, () => go(1), { glyph: '›' });
  const side = button(benchText.bar.compare, compare, { title: benchText.bar.compareLong, class: 'compare-switch' });
  const seen = [
    h(
      'div',
      { class: 'joined' },
      button(benchText.bar.zoomIn, figure.zoom.in, { glyph: '+' }),
      button(benchText.bar.zoomOut, figure.zoom.out, { glyph: '−' }),
      button(benchText.bar.fit, figure.zoom.fit, { glyph: '⤢' }),
      way,
    ),
    h('div', { class: 'joined' }, button(benchText.bar.fold, figure.fold.all), button(benchText.bar.unfold, figure.fold.none)),
    h('div', { class: 'search' }, search, count, next),
  ];
  const element = h('div', { class: 'trees-bar', role: 'group', 'aria-label': benchText.bar.label }, h('div', { class: 'joined' }, back, again), ...seen, side);
  /** @type {number[]} */
  let hits = [];
  let at = -1;
  let down = true;

  search.addEventListener('input', find);
  search.addEventListener('keydown', (event) => {
    if (event.key === 'Enter') go(event.shiftKey ? -1 : 1);
    if (event.key === 'Escape' && search.value !== '') {
      search.value = '';
      find();
      event.stopPropagation();
    }
  });

  function find() {
    hits = figure.search(search.value);
    at = -1;
    say();
  }

  /** @param {number} by */
  function go(by) {
    if (hits.length === 0) return;
    at = (at + by + hits.length + (at < 0 && by < 0 ? 1 : 0)) % hits.length;
    hit(hits[at]);
    say();
  }

  function say() {
    next.disabled = hits.length === 0;
    write(count, search.value.trim() === '' ? '' : at < 0 ? benchText.bar.found(hits.length) : benchText.bar.at(at + 1, hits.length));
  }

  function turn() {
    down = !down;
    figure.direction(down ? 'down' : 'right');
    write(way, down ? '↓' : '→');
    const label = down ? benchText.bar.down : benchText.bar.right;
    way.setAttribute('aria-label', label);
    way.title = label;
  }

  say();
  return {
    element,
    focusSearch: () => search.focus(),

    /** Another tree is drawn: its hits are other nodes. */
    again: find,

    /** @param {{ undo: boolean, redo: boolean, compare: boolean }} can @param {boolean} comparing */
    show(can, comparing) {
      back.disabled = !can.undo;
      again.disabled = !can.redo;
      side.disabled = !can.compare;
      side.setAttribute('aria-pressed', String(comparing));
      for (const part of seen) part.hidden = comparing;
    },
  };
}
