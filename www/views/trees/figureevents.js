import { s } from '../../ui/dom.js';
import { meaningOf } from './figurekeys.js';

/** @import { BenchNode, Status } from '../../trees/types.js' */
/** @import { Layout, Way } from '../../draw/benchlayout.js' */

/**
 * @typedef {object} Deeds what can be done with the nodes of a drawing
 * @property {() => { nodes: BenchNode[], layout: Layout, folded: Set<number>, way: Way, focused: number, selected: number | null }} now
 * @property {(id: number) => void} press selects a node, or what is selected no more
 * @property {(id: number, close: boolean) => void} fold
 * @property {(id: number, answer: Status | 'next') => void} answer
 * @property {(id: number) => void} go focuses a node
 * @property {(id: number | null) => void} reached the focus came to a node, or left them all
 */

/**
 * Clicks, keys and the focus on the nodes of a drawing.
 *
 * @param {HTMLElement} element
 * @param {SVGSVGElement} stage
 * @param {Deeds} deeds
 */
export function bindNodes(element, stage, { now, press, fold, answer, go, reached }) {
  stage.addEventListener('click', (event) => {
    const target = /** @type {Element} */ (event.target);
    const { folded, selected } = now();
    const id = nodeOf(target);
    if (id === null) return selected === null ? undefined : press(selected);
    if (target.closest('.bench-fold')) fold(id, !folded.has(id));
    else if (target.closest('.bench-answer')) answer(id, 'next');
    else press(id);
  });
  stage.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || nodeOf(document.activeElement) === null) return;
    const at = now();
    const meaning = meaningOf(event.key, at);
    if (!meaning || (meaning.clear && at.selected === null)) return;
    event.preventDefault();
    event.stopPropagation();
    if (meaning.go !== undefined) go(meaning.go);
    if (meaning.fold !== undefined) fold(at.focused, meaning.fold);
    if (meaning.answer) answer(at.focused, meaning.answer);
    if (meaning.press) press(at.focused);
    if (meaning.clear) press(Number(at.selected));
  });
  stage.addEventListener('pointerover', ({ target }) => {
    if (!(target instanceof SVGRectElement) || !target.dataset.id) return; // a node seen from afar has no title yet
    target.replaceChildren(s('title', {}, target.getAttribute('aria-label') ?? ''));
  });
  // Chromium lets Tab stop at an svg that listens for these, so its frame does
  element.addEventListener('focusin', (event) => reached(nodeOf(/** @type {Element} */ (event.target))));
  element.addEventListener('focusout', () => queueMicrotask(() => reached(null)));
}

/** @param {Element | null} element */
function nodeOf(element) {
  const id = /** @type {SVGElement | null | undefined} */ (element?.closest('.bench-node'))?.dataset.id;
  return id === undefined ? null : Number(id);
}
