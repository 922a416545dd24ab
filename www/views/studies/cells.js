import { button, h } from '../../ui/dom.js';
import { studiesText as text } from '../../ui/strings.studies.en.js';
import { pathName } from '../../studies/draft.js';
import { choiceField, idOf, labelled, textField } from './fields.js';
import { createSettings } from './settings.js';

/** @import { Path } from '../../studies/draft.js' */
/** @import { StudySession } from '../../studies/session.js' */

/**
 * The cells that a study names, each folded, with its preset, labels and parameters.
 *
 * @param {{ session: StudySession, presets: { value: string, label: string }[], change: (path: Path, value: any) => void,
 *   rename: (path: Path, from: string, to: string, value: any) => void }} parts
 * @returns {HTMLElement[]}
 */
export function createCells({ session, presets, change, rename }) {
  /** @type {any[]} */
  const cells = Array.isArray(session.draft.cells) ? session.draft.cells : [];
  const add = () => change(['cells', cells.length], { name: text.form.newCell(cells.length + 1) });
  return [...cells.map(cell), button(text.form.addCell, () => (cells.length > 0 ? add() : change(['cells'], [{ name: text.form.newCell(1) }])))];

  /** @param {any} value @param {number} index */
  function cell(value, index) {
    const path = ['cells', index];
    const name = typeof value?.name === 'string' && value.name !== '' ? value.name : text.form.cell(index + 1);
    const own = [...presets];
    if (session.draft.scenario !== undefined || value?.preset === undefined) own.unshift({ value: '', label: text.form.ownPreset });
    return h(
      'details',
      { class: 'cell', id: idOf(path), 'data-path': pathName(path) },
      h('summary', {}, name),
      labelled([...path, 'name'], text.form.name, textField(value?.name, (typed) => change([...path, 'name'], typed))),
      value?.scenario === undefined
        ? labelled([...path, 'preset'], text.form.preset, choiceField(own, value?.preset ?? '', (chosen) => change([...path, 'preset'], chosen === '' ? undefined : chosen)))
        : h('p', { class: 'secondary' }, text.form.whole),
      createSettings({ path: [...path, 'set'], values: value?.set, schema: session.parameters(), legend: text.form.settings, change }),
      labels([...path, 'labels'], value?.labels ?? {}),
      button(text.form.removeCell, () => change(path, undefined)),
      h('p', { class: 'field-error' }),
    );
  }

  /** @param {Path} path @param {Record<string, any>} values */
  function labels(path, values) {
    const rows = Object.entries(values).map(([label, value], index) => {
      const key = h('input', { type: 'text', id: `${idOf(path)}-${index}`, value: label, 'aria-label': text.form.label(index + 1), autocomplete: 'off' });
      key.addEventListener('change', () => rename(path, label, key.value, value));
      const says = textField(value, (typed) => change([...path, label], typed));
      says.id = idOf([...path, label]);
      says.setAttribute('aria-label', text.form.labelValue(label));
      const remove = button(text.form.remove(label), () => change([...path, label], undefined), { glyph: '×', class: 'quiet remove' });
      return h('div', { class: 'row label-row', 'data-path': pathName([...path, label]) }, key, says, remove, h('p', { class: 'field-error' }));
    });
    const add = button(text.form.add, () => change([...path, text.form.newLabel], text.form.newLabel));
    return h('div', { class: 'settings', role: 'group', 'aria-label': text.form.labels }, h('p', { class: 'settings-legend' }, text.form.labels), ...rows, add);
  }
}
