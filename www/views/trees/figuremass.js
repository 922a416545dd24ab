import { ARROWS, GLYPHS, enlarged, outline, signOf } from '../../draw/benchshapes.js';
import { s } from '../../ui/dom.js';

/** @import { BenchNode } from '../../trees/types.js' */
/** @import { NodeState } from '../../draw/benchstate.js' */
/** @import { Spot } from '../../draw/benchlayout.js' */

const LARGE = 2.2;
const LARGE_GLYPHS = Object.fromEntries(Object.entries(GLYPHS).map(([letter, path]) => [letter, enlarged(path, LARGE)]));
const LARGE_ARROWS = Object.fromEntries(Object.entries(ARROWS).map(([kind, path]) => [kind, enlarged(path, 1.6)]));
const QUESTION = enlarged('m-3 -3.5c0 -4 6.5 -4 6.5 0c0 2.5 -3 2.5 -3 5.5m0 3v.6', 1.6);

/**
 * All nodes seen from afar, where no text can be read: a few paths for all that stand alike.
 *
 * @param {BenchNode[]} nodes
 * @param {Spot[]} spots
 * @param {(id: number) => NodeState} stateOf
 * @param {Map<number, string>} letters breakpoints
 * @returns {SVGGElement[]}
 */
export function massOf(nodes, spots, stateOf, letters) {
  /** @type {Map<string, { state: NodeState, shapes: string, glyphs: string }>} */
  const groups = new Map();
  let signs = '';
  let marks = '';
  for (const { id, x, y, w, h } of spots) {
    const state = stateOf(id);
    const key = state.when + state.letter;
    let group = groups.get(key);
    if (!group) groups.set(key, (group = { state, shapes: '', glyphs: '' }));
    group.shapes += outline(nodes[id].category, x, y, w, h);
    const sign = signOf(nodes[id]);
    if (sign && sign.kind !== 'word') signs += `M${x + (state.letter ? 0.3 : 0.5) * w} ${y + h / 2}${sign.kind === 'fallback' ? QUESTION : LARGE_ARROWS[sign.kind]}`;
    if (letters.get(id)) marks += `M${x} ${y + h / 2}m-9 0a9 9 0 0 1 18 0a9 9 0 0 1 -18 0z`;
    if (state.halted) marks += `M${x + w} ${y}${LARGE_GLYPHS.H}`;
    if (state.letter) group.glyphs += `M${x + (sign ? 0.7 : 0.5) * w} ${y + h / 2}${LARGE_GLYPHS[state.letter]}`;
  }
  const mass = [...groups.values()].map(({ state, shapes, glyphs }) =>
    s(
      'g',
      { 'data-letter': state.letter, 'data-when': state.when },
      s('path', { class: 'bench-under', d: shapes }),
      s('path', { class: 'bench-shape', d: shapes, 'fill-opacity': state.when === 'now' ? 0.4 : 1 }),
      s('path', { class: 'bench-glyph', d: glyphs, 'stroke-linecap': 'round', 'stroke-linejoin': 'round' }),
    ),
  );
  mass.push(s('g', {}, s('path', { class: 'bench-plate', d: marks }), s('path', { class: 'bench-arrow', d: signs, 'stroke-linecap': 'round' })));
  return mass;
}
