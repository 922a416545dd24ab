import { button, h } from '../../ui/dom.js';
import { studiesText as text } from '../../ui/strings.studies.en.js';
import { pathName } from '../../studies/draft.js';

/** @import { Path } from '../../studies/draft.js' */
/** @import { Parameter } from '../../types.js' */

/** The id of the field for a value of the study, always the same. @param {Path} path */
export const idOf = (path) => `study-${pathName(path)}`;

/** What was typed as a number, or as it stands, for the engine to judge. @param {string} typed */
export function read(typed) {
  const trimmed = typed.trim();
  return trimmed !== '' && Number.isFinite(Number(trimmed)) ? Number(trimmed) : trimmed;
}

/**
 * A label and its field, under which the engine's fault is told when it is about this value.
 *
 * @param {Path} path of the value in the study
 * @param {string} label
 * @param {HTMLElement} field
 * @param {HTMLElement | null} [aside] beside the label
 */
export function labelled(path, label, field, aside = null) {
  field.id = idOf(path);
  field.setAttribute('aria-describedby', `${field.id}-fault`);
  return h(
    'div',
    { class: 'control', 'data-path': pathName(path) },
    h('div', { class: 'control-head' }, h('label', { for: field.id }, label), aside),
    field,
    h('p', { class: 'field-error', id: `${field.id}-fault` }),
  );
}

/** @param {any} value @param {(value: string) => void} change @param {{ long?: boolean, numeric?: boolean }} [options] */
export function textField(value, change, { long = false, numeric = false } = {}) {
  const shown = typeof value === 'string' || typeof value === 'number' ? String(value) : value === undefined ? '' : JSON.stringify(value);
  const field = long ? h('textarea', { rows: 3 }) : h('input', { type: 'text', inputmode: numeric ? 'decimal' : undefined, autocomplete: 'off' });
  field.value = shown;
  field.addEventListener('change', () => change(field.value));
  return field;
}

/** @param {{ value: string, label: string }[]} choices @param {any} value @param {(value: string) => void} change */
export function choiceField(choices, value, change) {
  const known = choices.some((choice) => choice.value === value);
  const options = known ? choices : [...choices, { value: String(value ?? ''), label: String(value ?? '') }];
  const field = h('select', {}, ...options.map(({ value: name, label }) => h('option', { value: name, selected: name === String(value ?? '') }, label)));
  field.addEventListener('change', () => change(field.value));
  return field;
}

/** Choices of a parameter that has some; both values of one that is on or off. @param {Parameter} parameter */
function choicesOf({ type, choices }) {
  if (type === 'bool') return [true, false].map((value) => ({ value, label: value ? text.form.on : text.form.off }));
  return choices ?? null;
}

/**
 * The field for one value of a parameter.
 *
 * @param {Parameter} parameter
 * @param {any} value
 * @param {(value: any) => void} change
 */
export function parameterField(parameter, value, change) {
  if (parameter.type === 'bool') {
    const named = (/** @type {any} */ found) => (typeof found === 'boolean' ? String(found) : found);
    const choices = [true, false].map((choice) => ({ value: String(choice), label: choice ? text.form.on : text.form.off }));
    return choiceField(choices, named(value), (chosen) => change(chosen === 'true'));
  }
  if (parameter.type === 'choice') return choiceField(parameter.choices ?? [], value, change);
  if (parameter.type === 'text') return textField(value, change, { long: true });
  return textField(value, (typed) => change(read(typed)), { numeric: true });
}

/**
 * The fields for the values that a parameter takes in a grid: numbers in one line, choices as check boxes, texts one by one.
 *
 * @param {{ path: Path, parameter: Parameter, values: any, change: (path: Path, value: any) => void, aside: HTMLElement }} what
 */
export function valuesField({ path, parameter, values, change, aside }) {
  const list = Array.isArray(values) ? values : [values];
  const choices = choicesOf(parameter);
  if (choices) {
    const boxes = choices.map(({ value, label }, index) => {
      const box = h('input', { type: 'checkbox', id: `${idOf(path)}-${index}`, checked: list.includes(value) });
      box.addEventListener('change', () => change(path, choices.map((choice) => choice.value).filter((choice) => (choice === value ? box.checked : list.includes(choice)))));
      return h('label', { class: 'check' }, box, label);
    });
    const id = idOf(path);
    return h(
      'fieldset',
      { class: 'control', 'data-path': pathName(path), id, tabindex: -1, 'aria-describedby': `${id}-fault` },
      h('legend', {}, parameter.label),
      h('div', { class: 'control-head' }, h('div', { class: 'choices' }, ...boxes), aside),
      h('p', { class: 'field-error', id: `${id}-fault` }),
    );
  }
  if (parameter.type === 'text') {
    const fields = list.map((value, index) => {
      const [label, inside] = [text.form.value(parameter.label, index + 1), [...path, index]];
      const remove = button(text.form.remove(label), () => change(inside, undefined), { glyph: '×', class: 'quiet remove' });
      return labelled(inside, label, textField(value, (typed) => change(inside, typed), { long: true }), list.length > 1 ? remove : null);
    });
    const head = h('div', { class: 'control-head' }, h('p', {}, parameter.label), aside);
    return h('div', { 'data-path': pathName(path) }, head, ...fields, h('p', { class: 'field-error' }), button(text.form.addValue, () => change([...path, list.length], String(parameter.default))));
  }
  const typed = textField(list.join(', '), (words) => change(path, words.split(',').filter((word) => word.trim() !== '').map(read)), { numeric: true });
  return labelled(path, text.form.values(parameter.label), typed, aside);
}
