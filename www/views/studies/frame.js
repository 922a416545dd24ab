import { h } from '../../ui/dom.js';
import { studiesText as text } from '../../ui/strings.studies.en.js';

/**
 * The parts of the tab: notices, the list, and for one study results, form, text, bar and footer, in reading order.
 *
 * @param {HTMLElement} element
 */
export function createStudiesFrame(element) {
  const notes = h('div', { class: 'studies-notes' });
  const list = h('main', { class: 'studies-list', 'aria-label': text.list.title });
  const results = h('section', { class: 'world-pane studies-results', 'aria-label': text.pane.results });
  const form = h('div', { class: 'studies-fields' });
  const words = h('div', { class: 'studies-words' });
  const wholeForm = h('details', { class: 'all-controls', open: true }, h('summary', {}, text.pane.form), form);
  const wholeText = h('details', { class: 'all-controls', open: true }, h('summary', {}, text.pane.text), words);
  const formPane = h('section', { class: 'controls-pane studies-form', 'aria-label': text.pane.form }, wholeForm);
  const textPane = h('section', { class: 'studies-text', 'aria-label': text.pane.text }, wholeText);
  const study = h('main', { class: 'frame studies-frame' }, results, formPane, textPane);
  const bar = h('section', { class: 'transport studies-bar', 'aria-label': text.pane.bar });
  const foot = h('footer', { class: 'foot' });
  const narrow = matchMedia('(max-width: 899px)');
  const fold = () => void (wholeForm.open = wholeText.open = !narrow.matches);
  narrow.addEventListener('change', fold);
  fold();
  element.append(h('div', { class: 'studies-page' }, notes, list, study), bar, foot);

  return {
    notes,
    list,
    results,
    form,
    words,
    bar,
    foot,

    /** @param {boolean} listed whether the list is shown rather than a study */
    show(listed) {
      list.hidden = !listed;
      study.hidden = bar.hidden = foot.hidden = listed;
    },

    /** Unfolds the text where it is folded. */
    unfold: () => void (wholeText.open = true),
  };
}
