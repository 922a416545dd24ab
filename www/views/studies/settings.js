import { button, h } from '../../ui/dom.js';
import { studiesText as text } from '../../ui/strings.studies.en.js';
import { pathName } from '../../studies/draft.js';
import { idOf, labelled, parameterField, textField, valuesField } from './fields.js';

/** @import { Path } from '../../studies/draft.js' */
/** @import { Parameter } from '../../types.js' */

/**
 * Parameters by their keys, each with its value or with the values it takes; any other of the schema can be added.
 *
 * @param {{ path: Path, values: Record<string, any> | undefined, schema: Parameter[], legend: string, grid?: boolean, prefix?: string,
 *   change: (path: Path, value: any) => void }} what `prefix` is that of keys which the fields leave out
 */
export function createSettings({ path, values = {}, schema, legend, grid = false, prefix = '', change }) {
  const parameters = schema.filter(({ key, type }) => type !== 'seed' && key.startsWith(prefix));
  const fieldOf = (/** @type {Parameter} */ { key }) => key.slice(prefix.length);
  const entries = Object.entries(values !== null && typeof values === 'object' ? values : {});
  const rows = entries.map(([field, value]) => {
    const parameter = parameters.find((entry) => fieldOf(entry) === field);
    const inside = [...path, field];
    if (!parameter) return prefix === '' ? labelled(inside, field, textField(value, (typed) => change(inside, typed)), removal(inside, field)) : null;
    const aside = removal(inside, parameter.label);
    if (grid) return valuesField({ path: inside, parameter, values: value, change, aside });
    return labelled(inside, parameter.label, parameterField(parameter, value, (next) => change(inside, next)), aside);
  });

  /** @param {Path} inside @param {string} label */
  function removal(inside, label) {
    return button(text.form.remove(label), () => change(inside, undefined), { glyph: '×', class: 'quiet remove' });
  }

  const id = `${idOf(path)}-add`;
  const free = parameters.filter((parameter) => !(fieldOf(parameter) in values));
  const groups = [...new Set(free.map(({ group }) => group))];
  const select = h('select', { id }, ...groups.map((group) => h('optgroup', { label: group }, ...free.filter((entry) => entry.group === group).map((entry) => h('option', { value: fieldOf(entry) }, entry.label)))));
  const add = button(text.form.add, () => {
    const parameter = parameters.find((entry) => fieldOf(entry) === select.value);
    if (parameter) change([...path, select.value], grid ? [parameter.default] : parameter.default);
  });
  return h(
    'div',
    { class: 'settings', 'data-path': pathName(path), role: 'group', 'aria-label': legend },
    h('p', { class: 'settings-legend' }, legend),
    ...rows,
    h('p', { class: 'field-error' }),
    h('div', { class: 'row add' }, h('label', { for: id, class: 'unseen' }, `${legend}: ${text.form.parameter}`), select, add),
  );
}
