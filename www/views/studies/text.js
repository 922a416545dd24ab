import { button, h, write } from '../../ui/dom.js';
import { save } from '../../ui/share.js';
import { studiesText as text } from '../../ui/strings.studies.en.js';
import { placeOf } from '../../studies/draft.js';

/** @import { StudySession } from '../../studies/session.js' */

/**
 * The study as JSON, beside the form; its fault with the way to its place.
 *
 * @param {{ pane: HTMLElement, session: StudySession, original: () => string | null, unfold: () => void }} parts `original` is
 *   the text of the study file that this one began as
 */
export function createStudyText({ pane, session, original, unfold }) {
  const plain = { wrap: 'off', spellcheck: 'false', autocapitalize: 'off', autocomplete: 'off' };
  const area = h('textarea', { id: 'studies-json', ...plain, 'aria-describedby': 'studies-fault' });
  const fault = h('p', { class: 'field-error', id: 'studies-fault', role: 'alert' });
  const place = button(text.fault.show, show);
  const back = button(text.text.original, () => session.edit(original() ?? session.text));
  area.addEventListener('input', () => session.edit(area.value));
  pane.append(
    h('label', { for: area.id, class: 'secondary' }, text.text.label),
    area,
    fault,
    h('div', { class: 'row' }, place, button(text.text.save, keep, { title: text.text.saveLong }), back),
  );

  function keep() {
    save(`${session.draft?.study ?? 'study'}.json`, new Blob([session.text], { type: 'application/json' }));
  }

  /** Selects the field that the fault names. */
  function show() {
    const range = session.fault && (placeOf(session.text, session.fault.path) ?? lineOf(session.fault.message));
    if (!range) return;
    unfold();
    area.focus();
    area.setSelectionRange(range[0], range[1]);
    const line = area.value.slice(0, range[0]).split('\n').length;
    area.scrollTop = Math.max(0, (line - 4) * Number.parseFloat(getComputedStyle(area).lineHeight));
  }

  /** The line that a message of the JSON reader names. @param {string} message @returns {[number, number] | null} */
  function lineOf(message) {
    const found = /line (\d+) column (\d+)/.exec(message);
    if (!found) return null;
    const lines = area.value.split('\n');
    const start = lines.slice(0, Number(found[1]) - 1).reduce((sum, line) => sum + line.length + 1, 0);
    return [Math.max(start, start + Number(found[2]) - 1), start + (lines[Number(found[1]) - 1]?.length ?? 0)];
  }

  session.on(() => {
    if (area.value !== session.text) area.value = session.text;
    area.toggleAttribute('aria-invalid', session.fault !== null);
    if (session.fault) area.setAttribute('aria-invalid', 'true');
    write(fault, session.fault ? text.fault.at(session.fault.path, session.fault.message) : '');
    place.hidden = session.fault === null || (placeOf(session.text, session.fault.path) ?? lineOf(session.fault.message)) === null;
    back.hidden = session.name === null || session.pristine();
  });
}
