import { BADGE, CORNER, SLOT, portsOf } from '../../draw/benchlayout.js';
import { ARROWS, GLYPHS, endsOf, outline, signOf } from '../../draw/benchshapes.js';
import { s, write } from '../../ui/dom.js';
import { figureText as text } from '../../ui/strings.figures.en.js';

/** @import { BenchNode, Status } from '../../trees/types.js' */
/** @import { NodeState } from '../../draw/benchstate.js' */
/** @import { Label, Spot, Way } from '../../draw/benchlayout.js' */

/**
 * @typedef {object} Look how a node is drawn, apart from its status
 * @property {Way} way
 * @property {boolean} folded
 * @property {number} hidden nodes inside it that a fold hides
 * @property {number} target least side of what can be pressed, pixels
 * @property {(words: string) => number} tagWidth
 * @property {boolean} picture nothing to press
 */

const AFTER = ['_onSuccess', '_onFailure', '_post', '_onHalted'];
/** @type {Record<Status, string>} */
const LETTER = { SUCCESS: 'S', FAILURE: 'F', RUNNING: 'R', SKIPPED: 'K' };
const TAG = 14; // height of a tag
const ROUND = { 'stroke-linecap': 'round', 'stroke-linejoin': 'round', 'aria-hidden': 'true' };

/**
 * A node as SVG; `paint` changes what a moment changes and lays nothing out.
 *
 * @param {BenchNode} node
 * @param {Label} label
 * @param {Spot} spot
 * @param {Look} look
 */
export function createNode(node, label, spot, look) {
  const { w, h } = spot;
  const inner = spot.children.length > 0;
  const title = s('title', {}); // the accessible name
  const element = s('g', { ...attributes(node, spot, look), transform: `translate(${spot.x} ${spot.y})` }, title, ...body(node, label, w, h));
  const fill = element.querySelector('.bench-shape');
  const slot = w - endsOf(node.category) - SLOT / 2 - 1;
  const glyph = s('path', { class: 'bench-glyph', ...ROUND });
  const count = s('text', { class: 'bench-count', x: slot, y: h / 2 + 10.5, 'text-anchor': 'middle', 'aria-hidden': 'true' });
  element.append(glyph, count);
  const extras = createExtras(element, w, h, look.tagWidth);
  if (inner && (!look.picture || look.folded)) element.append(foldHandle(node, spot, look));
  const badge = node.scripted && !look.picture ? createBadge(node, spot, look) : null;
  if (badge) element.append(badge.element);
  let painted = '';

  /** @param {NodeState} state @param {string | undefined} letters of its breakpoint @param {boolean} hit of the search */
  function paint(state, letters, hit) {
    const key = keyOf(state, letters, hit);
    if (key === painted) return;
    painted = key;
    element.dataset.letter = state.letter;
    element.dataset.when = state.when;
    write(title, text.figure.said(node, state, label.sign?.corner ?? '', letters, look.folded ? look.hidden : 0));
    fill?.setAttribute('fill-opacity', state.when === 'now' ? '.13' : '1');
    const several = state.count > 1;
    glyph.setAttribute('d', state.error ? '' : (GLYPHS[state.letter] ?? '')); // a fault has a tag
    glyph.setAttribute('transform', `translate(${slot} ${h / 2 - (several ? 5 : 0)})`);
    write(count, several ? text.figure.times(state.count) : '');
    extras.paint(node, state, letters !== undefined && letters !== '', hit);
    badge?.paint(state.answer);
  }

  return { element, paint };
}

/**
 * A node seen from afar: a place to press and to focus; its shape is part of the mass.
 *
 * @param {BenchNode} node
 * @param {Spot} spot
 * @param {Look} look
 */
export function createFarNode(node, spot, look) {
  const { x, y, w, h } = spot;
  const element = s('rect', { ...attributes(node, spot, look), x, y, width: w, height: h });
  element.classList.add('bench-hit');
  const corner = signOf(node)?.corner ?? '';
  let painted = '';

  /** @param {NodeState} state @param {string | undefined} letters @param {boolean} hit */
  function paint(state, letters, hit) {
    const key = keyOf(state, letters, hit);
    if (key === painted) return;
    painted = key;
    element.classList.toggle('bench-found', hit);
    element.setAttribute('aria-label', text.figure.said(node, state, corner, letters, look.folded ? look.hidden : 0));
  }
  return { element, paint };
}

/** @param {NodeState} state @param {string | undefined} letters @param {boolean} hit */
const keyOf = ({ letter, when, tick, count, halted, error, answer }, letters, hit) =>
  `${letter}${when}${tick}|${count}${halted}${error}|${answer?.running}${answer?.then}${answer?.done}|${letters}${hit}`;

/** What makes a node one of the tree's items. @param {BenchNode} node @param {Spot} spot @param {Look} look */
const attributes = (node, spot, look) => ({
  class: 'bench-node',
  role: 'treeitem',
  'data-id': node.id,
  tabindex: -1,
  'aria-level': spot.level,
  'aria-posinset': spot.position,
  'aria-setsize': spot.siblings,
  'aria-expanded': spot.children.length > 0 ? String(!look.folded) : undefined,
});

/** @param {BenchNode} node @param {Label} label @param {number} w @param {number} h @returns {SVGElement[]} */
function body(node, label, w, h) {
  const shape = outline(node.category, 0, 0, w, h);
  const parts = [];
  if (node.category === 'subtree') parts.push(s('path', { class: 'bench-frame', d: outline('subtree', -5, -5, w + 10, h + 10) }));
  parts.push(s('path', { class: 'bench-under', d: shape }), s('path', { class: 'bench-shape', d: shape }));
  if (label.sign) parts.push(...sign(label, h));
  for (const { text: words, size, x, y } of label.lines) parts.push(s('text', { class: `bench-${size}`, x, y, 'aria-hidden': 'true' }, words));
  return parts;
}

/** The sign of a control node with its raised letter. @param {Label} label @param {number} h @returns {SVGElement[]} */
function sign({ sign, signWidth }, h) {
  const { kind, word, corner } = /** @type {NonNullable<Label['sign']>} */ (sign);
  const [x, y] = [(signWidth - CORNER[corner]) / 2, h / 2];
  const hidden = { 'text-anchor': 'middle', 'aria-hidden': 'true' };
  /** @type {SVGElement[]} */
  const parts = [s('path', { class: 'bench-rule', d: `M${signWidth} 5V${h - 5}` })];
  if (kind === 'word') parts.push(s('text', { class: 'bench-word', x, y: y + 4, ...hidden }, word));
  else if (kind === 'fallback') parts.push(s('text', { class: 'bench-question', x: x - 1, y: y + 6, ...hidden }, '?'));
  else parts.push(s('path', { class: 'bench-arrow', d: ARROWS[kind], transform: `translate(${x} ${y + 1})`, ...ROUND }));
  if (corner === 'R') parts.push(s('path', { class: 'bench-plate', d: `M${signWidth - 15} ${y - 11}h11v11h-11z` }));
  const [right, low] = corner === 'R' ? [9.5, -2] : [3 + 3.5 * corner.length + (kind === 'fallback' ? 4 : 0), 2];
  if (corner) parts.push(s('text', { class: corner === 'R' ? 'bench-corner bench-on-plate' : 'bench-corner', x: signWidth - right, y: y + low, ...hidden }, corner));
  return parts;
}

/**
 * What only some nodes carry, made when it is first needed: signs of conditions, a breakpoint, a halt, a hit.
 *
 * @param {SVGGElement} element
 * @param {number} w
 * @param {number} h
 * @param {Look['tagWidth']} tagWidth
 */
function createExtras(element, w, h, tagWidth) {
  /** @type {Map<string, SVGElement>} */
  const made = new Map();

  /** @param {string} name @param {boolean} there @param {() => SVGElement} make */
  function show(name, there, make) {
    const part = made.get(name);
    if (there && !part) {
      const fresh = make();
      made.set(name, fresh);
      if (name === 'hit') element.prepend(fresh);
      else element.append(fresh);
    } else if (!there && part) {
      part.remove();
      made.delete(name);
    }
  }

  /** @param {string} words @param {string} glyph */
  function tag(words, glyph) {
    const width = tagWidth(words) + 20;
    return s(
      'g',
      { class: 'bench-tag', transform: `translate(${Math.max(w - width - SLOT, 8)} -8)`, 'aria-hidden': 'true' },
      s('rect', { width, height: TAG, rx: 1 }),
      s('path', { d: glyph, transform: 'translate(8.5 7) scale(.85)', ...ROUND }),
      s('text', { x: 15.5, y: 10.5 }, words),
    );
  }

  return {
    /** @param {BenchNode} node @param {NodeState} state @param {boolean} stops @param {boolean} hit */
    paint(node, state, stops, hit) {
      const before = node.conditions.some(([name]) => !AFTER.includes(name));
      const after = node.conditions.some(([name]) => AFTER.includes(name));
      show('before', before, () => s('path', { class: 'bench-before', d: 'M14 -5l5 5l-5 5l-5 -5z' }));
      show('after', after, () => s('path', { class: 'bench-after', d: `M14 ${h - 5}l5 5l-5 5l-5 -5z` }));
      show('stops', stops, () => s('circle', { class: 'bench-stop', cx: 0, cy: h / 2, r: 6 }));
      show('hit', hit, () => s('path', { class: 'bench-found', d: outline(node.category, -6, -6, w + 12, h + 12) }));
      show('error', state.error !== '', () => tag(text.figure.error, GLYPHS.E));
      show('halted', state.halted, () => tag(text.figure.halted, GLYPHS.H));
    },
  };
}

/** @param {BenchNode} node @param {Spot} spot @param {Look} look */
function foldHandle(node, { w, h }, { way, folded, hidden, target }) {
  const words = text.figure.folded(hidden);
  const width = folded ? 10 + 6.5 * words.length : 13;
  const [x, y] = way === 'down' ? [w / 2, folded ? h + 9 : h] : [w + (folded ? width / 2 : 0), h / 2];
  const reach = Math.max(24, Math.min(target, way === 'down' ? target : 32));
  return s(
    'g',
    { class: 'bench-fold', role: 'button', tabindex: -1, transform: `translate(${x} ${y})` },
    s('title', {}, folded ? text.figure.unfold(node.name, hidden) : text.figure.fold(node.name)),
    s('rect', { class: 'bench-hit', x: -Math.max(width, reach) / 2, y: way === 'down' ? -10 : -reach / 2, width: Math.max(width, reach), height: reach }),
    s('rect', { class: 'bench-knob', x: -width / 2, y: folded ? -9 : -6.5, width, height: folded ? 18 : 13, rx: folded ? 9 : 6.5 }),
    folded ? s('text', { class: 'bench-small', y: 4, 'text-anchor': 'middle' }, words) : s('path', { class: 'bench-minus', d: 'M-3 0H3' }),
  );
}

/** What a scripted leaf answers next, as a button. @param {BenchNode} node @param {Spot} spot @param {Look} look */
function createBadge(node, { w, h }, { way, target }) {
  const [x, y] = way === 'down' ? [(w - BADGE.width) / 2, h + BADGE.gap] : [w + BADGE.gap, (h - BADGE.height) / 2];
  const reach = Math.max(BADGE.height, Math.min(target, way === 'down' ? target : 40));
  const title = s('title', {});
  const words = s('text', { class: 'bench-small', x: 28, y: 16, 'text-anchor': 'end' });
  const running = s('path', { class: 'bench-glyph', 'data-letter': 'R', transform: `translate(37 ${BADGE.height / 2}) scale(.85)`, ...ROUND });
  const then = s('path', { class: 'bench-glyph', ...ROUND });
  const element = s(
    'g',
    { class: 'bench-answer', role: 'button', tabindex: -1, transform: `translate(${x} ${y})` },
    title,
    s('rect', { class: 'bench-hit', y: (BADGE.height - reach) / 2, width: BADGE.width, height: reach }),
    s('rect', { class: 'bench-badge', width: BADGE.width, height: BADGE.height, rx: 2 }),
    words,
    running,
    then,
  );
  return {
    element,

    /** @param {NodeState['answer']} answer */
    paint(answer) {
      element.classList.toggle('bench-unknown', !answer);
      if (!answer) return;
      const waits = answer.running > 0 && answer.then !== 'RUNNING';
      const letter = LETTER[answer.then];
      write(words, waits ? text.figure.running(answer.running, answer.done) : '');
      running.setAttribute('d', waits ? GLYPHS.R : '');
      then.setAttribute('d', GLYPHS[letter]);
      then.dataset.letter = letter;
      then.setAttribute('transform', `translate(${waits ? 54 : BADGE.width / 2} ${BADGE.height / 2})`);
      write(title, text.figure.answer(node.name, answer));
    },
  };
}

/** The nodes whose name, type and ports hold all words; none without words. @param {BenchNode[]} nodes @param {string} words */
export function findNodes(nodes, words) {
  const parts = words.toLowerCase().split(/\s+/).filter((part) => part !== '');
  const holds = (/** @type {string} */ where) => parts.every((part) => where.includes(part));
  return nodes.filter((node) => parts.length > 0 && holds(`${node.name} ${node.type} ${portsOf(node)}`.toLowerCase())).map(({ id }) => id);
}

/** @typedef {{ element: SVGGraphicsElement, paint: ReturnType<typeof createNode>['paint'] }} BenchItem */
