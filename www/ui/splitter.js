import { h } from './dom.js';
import { recall, remember } from './storage.js';

const STEP = 16;

/**
 * A handle between two panes, moved by dragging or by arrow keys; what was chosen is remembered.
 *
 * @param {{ label: string, controls: string, name: string, least: number, most: () => number, preset: () => number, set: (pixels: number) => void }} options
 *   `controls` is the id of the pane whose width it is, `name` where the width is kept
 */
export function createSplitter({ label, controls, name, least, most, preset, set }) {
  let chosen = Number(recall(name)) || 0; // 0: the preset, which follows the window
  let width = 0;
  const element = h('div', { class: 'splitter', role: 'separator', tabindex: 0, 'aria-orientation': 'vertical', 'aria-label': label, 'aria-controls': controls, 'aria-valuemin': least });
  /** @type {{ from: number, width: number } | null} */
  let drag = null;

  /** @param {number} wanted 0 for the preset */
  function choose(wanted) {
    chosen = wanted;
    show();
    remember(name, chosen === 0 ? null : String(width));
  }

  function show() {
    const largest = Math.max(most(), least);
    width = Math.round(Math.min(Math.max(chosen || preset(), least), largest));
    element.setAttribute('aria-valuenow', String(width));
    element.setAttribute('aria-valuemax', String(largest));
    set(width);
  }

  element.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const to = { ArrowLeft: width - STEP, ArrowRight: width + STEP, Home: least, End: most(), Enter: 0 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    choose(to);
  });
  element.addEventListener('dblclick', () => choose(0));
  element.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    element.setPointerCapture(event.pointerId);
    drag = { from: event.clientX, width };
  });
  element.addEventListener('pointermove', (event) => {
    if (drag) choose(drag.width + event.clientX - drag.from);
  });
  for (const type of ['pointerup', 'pointercancel']) element.addEventListener(type, () => (drag = null));
  window.addEventListener('resize', show);
  show();

  return element;
}
