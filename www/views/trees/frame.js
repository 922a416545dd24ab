import { h, write } from '../../ui/dom.js';
import { createSplitter } from '../../ui/splitter.js';
import { benchText } from '../../ui/strings.trees.en.js';

const NARROWEST = 240;
const PRESET = { wide: 340, middle: 264, from: 1280 };
const LEFT_FOR_OTHERS = 640; // pixels that drawing and inspector keep

/**
 * The panes of the workbench, in reading order: drawing, text, inspector, transport, footer.
 *
 * @param {HTMLElement} element
 */
export function createBenchFrame(element) {
  const drawing = h('section', { class: 'world-pane trees-pane', 'aria-label': benchText.pane.tree });
  const text = h('div', { class: 'trees-text', id: 'trees-text' });
  const narrow = matchMedia('(max-width: 899px)');
  const whole = h('details', { class: 'all-controls', open: true }, h('summary', {}, benchText.pane.editor), text);
  const editor = h('section', { class: 'controls-pane trees-editor', 'aria-label': benchText.pane.editor }, whole);
  const inspector = h('section', { class: 'inspector-pane', 'aria-label': benchText.pane.inspector });
  const main = h('main', { class: 'frame trees-frame' }, drawing, editor, inspector);
  const transport = h('section', { class: 'transport trees-transport', 'aria-label': benchText.transport.region });
  const foot = h('footer', { class: 'foot' });
  editor.append(
    createSplitter({
      label: benchText.pane.width,
      controls: text.id,
      name: 'trees-width',
      least: NARROWEST,
      most: () => innerWidth - LEFT_FOR_OTHERS,
      preset: () => (innerWidth < PRESET.from ? PRESET.middle : PRESET.wide),
      set: (pixels) => main.style.setProperty('--text', `${pixels}px`),
    }),
  );
  narrow.addEventListener('change', () => (whole.open = true));
  element.append(main, transport, foot);

  const watch = h('p', { class: 'lede watch' });
  const tag = h('p', { class: 'tag' });
  const stage = h('div', { class: 'trees-stage' });
  const stale = h('p', { class: 'stale', hidden: true }, benchText.drawing.stale);
  const fault = h('p', { class: 'tick-fault', hidden: true });
  const notes = h('div', { class: 'stage-notes' }, stale, fault);
  const timeline = h('div', { class: 'trees-timeline' });
  drawing.append(h('h2', { class: 'unseen' }, benchText.pane.tree), h('div', { class: 'world-head' }, watch, tag), stage, timeline);
  stage.append(notes);

  return {
    drawing,
    text,
    inspector,
    transport,
    foot,
    stage,
    timeline,
    narrow,

    /** @param {{ watch: string, tag: string, stale: boolean, fault: string }} shown `fault` is the error that ended the tick */
    show(shown) {
      write(watch, shown.watch);
      write(tag, shown.tag);
      stale.hidden = !shown.stale;
      fault.hidden = shown.fault === '';
      write(fault, shown.fault);
    },
  };
}

/** @typedef {ReturnType<typeof createBenchFrame>} BenchFrame */
