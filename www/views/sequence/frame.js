import { h, write } from '../../ui/dom.js';
import { sequenceText } from '../../ui/strings.sequence.en.js';

/**
 * The panes of the tab, in reading order: map, controls, inspector, transport, footer.
 *
 * @param {HTMLElement} element
 */
export function createSequenceFrame(element) {
  const pane = h('section', { class: 'world-pane sequence-pane', 'aria-label': sequenceText.pane.map });
  const controls = h('section', { class: 'controls-pane', 'aria-label': sequenceText.pane.controls });
  const inspector = h('section', { class: 'inspector-pane', 'aria-label': sequenceText.pane.inspector });
  const main = h('main', { class: 'frame sequence-frame' }, pane, controls, inspector);
  const transport = h('section', { class: 'transport sequence-transport', 'aria-label': sequenceText.transport.region });
  const foot = h('footer', { class: 'foot' });
  element.append(main, transport, foot);

  const verdict = h('p', { class: 'lede verdict', id: 'sequence-verdict' });
  const tag = h('p', { class: 'tag', id: 'sequence-tag' });
  const head = h('div', { class: 'world-head' }, verdict, tag);
  const refusal = h('p', { class: 'refusal', id: 'sequence-refusal', role: 'alert' });
  const stages = h('div', { class: 'sequence-stages' }, refusal);
  pane.append(h('h2', { class: 'unseen' }, sequenceText.pane.map), head, stages);

  return {
    main,
    pane,
    head,
    stages,
    controls,
    inspector,
    transport,
    foot,

    /** @param {{ verdict: string, tag: string, refusal: string }} shown */
    show(shown) {
      write(verdict, shown.verdict);
      write(tag, shown.tag);
      tag.classList.toggle('blank', shown.tag === '');
      write(refusal, shown.refusal);
    },
  };
}

/** @typedef {ReturnType<typeof createSequenceFrame>} SequenceFrame */
