import { h, write } from './dom.js';
import { text } from './strings.en.js';
import { readValue } from '../link.js';
import { createPopulationControl } from './populationcontrol.js';
import { createTextControl } from './textcontrol.js';

/** @import { Files } from '../files/files.js' */
/** @import { Parameter, Value } from '../types.js' */

/**
 * @typedef {object} Control
 * @property {HTMLElement} element
 * @property {(value: Value, original: Value, waits: boolean) => void} show what stands on screen, what the preset says, whether a restart is needed
 */

/**
 * @typedef {object} Wiring
 * @property {(parameter: Parameter, value: Value) => void} change
 * @property {(parameter: Parameter, value: Value) => Promise<string>} check what is wrong with a text; empty when nothing
 * @property {(parameter: Parameter, value: Value) => Promise<string>} inFull the text that a name such as `ppa` stands for
 * @property {Files} files
 */

/**
 * A control made from one entry of the schema: label, field, what it does, what changed.
 *
 * @param {Parameter} parameter
 * @param {Wiring} wiring
 * @returns {Control}
 */
export function createControl(parameter, wiring) {
  const id = `control-${parameter.key}`;
  const help = h('p', { class: 'help', id: `${id}-help`, hidden: true }, parameter.help, ' ', h('span', { class: 'source' }, text.controls.source(parameter)));
  const about = h('button', { type: 'button', class: 'about', 'aria-expanded': 'false', 'aria-controls': help.id, 'aria-label': text.controls.about(parameter.label) }, '?');
  about.addEventListener('click', () => {
    help.hidden = !help.hidden;
    about.setAttribute('aria-expanded', String(!help.hidden));
  });
  const error = h('p', { class: 'field-error', id: `${id}-error`, role: 'alert' });
  const reset = h('button', { type: 'button', class: 'reset' });
  const waits = h('span', { class: 'waits', title: text.controls.waitsLong }, text.controls.waits);
  const changed = h('p', { class: 'changed', hidden: true }, reset, waits);
  const say = (/** @type {string} */ message) => write(error, message);
  const field = createField(parameter, id, wiring, say);
  const head = h('div', { class: 'control-head' }, field.label, h('span', { class: 'control-side' }, field.aside, about));
  const element = h('div', { class: `control ${parameter.type}`, 'data-key': parameter.key, 'data-apply': parameter.apply }, head, field.body, error, changed, help);

  /** @type {Value} */
  let preset = parameter.default;
  reset.addEventListener('click', () => {
    say('');
    wiring.change(parameter, preset);
  });

  return {
    element,
    show(value, original, needsRestart) {
      preset = original;
      field.show(value);
      const differs = value !== original;
      element.classList.toggle('differs', differs);
      changed.hidden = !differs && !needsRestart;
      reset.hidden = !differs;
      waits.hidden = !needsRestart;
      write(reset, text.controls.reset(parameter.type === 'text' ? '' : valueName(parameter, original)));
      reset.setAttribute('aria-label', text.controls.resetLong(parameter.label, parameter.type === 'text' ? '' : valueName(parameter, original)));
    },
  };
}

/** How a value is written for people. @param {Parameter} parameter @param {Value} value */
export function valueName({ choices, unit }, value) {
  if (typeof value === 'boolean') return value ? text.controls.on : text.controls.off;
  return choices?.find((choice) => choice.value === value)?.label ?? `${value}${unit ? ` ${unit}` : ''}`;
}

/** @typedef {{ label: Node, aside: Node, body: Node, show: (value: Value) => void }} Field */

/**
 * @param {Parameter} parameter
 * @param {string} id
 * @param {Wiring} wiring
 * @param {(message: string) => void} say
 * @returns {Field}
 */
function createField(parameter, id, wiring, say) {
  switch (parameter.type) {
    case 'bool':
      return createCheck(parameter, id, wiring);
    case 'choice':
      return createChoice(parameter, id, wiring);
    case 'text':
      return parameter.key === 'geese.population' ? createPopulationControl(parameter.label, id, wiring.files) : createTextControl(parameter, id, wiring, say);
    default:
      return createNumber(parameter, id, wiring, say);
  }
}

/** @param {Parameter} parameter @param {string} id @param {Wiring} wiring @returns {Field} */
function createCheck(parameter, id, { change }) {
  const box = h('input', { type: 'checkbox', id });
  box.addEventListener('change', () => change(parameter, box.checked));
  const label = h('label', { class: 'check', for: id }, box, parameter.label);
  return { label, aside: h('span'), body: h('span', { hidden: true }), show: (value) => void (box.checked = value === true) };
}

/** @param {Parameter} parameter @param {string} id @param {Wiring} wiring @returns {Field} */
function createChoice(parameter, id, { change }) {
  const options = (parameter.choices ?? []).map(({ value, label }) => h('option', { value }, label));
  const select = h('select', { id }, ...options);
  select.addEventListener('change', () => change(parameter, select.value));
  return { label: h('label', { for: id }, parameter.label), aside: h('span'), body: select, show: (value) => void (select.value = String(value)) };
}

/**
 * A slider over `min..max` and a box that takes values up to `hard_max`, with a warning.
 *
 * @param {Parameter} parameter
 * @param {string} id
 * @param {Wiring} wiring
 * @param {(message: string) => void} say
 * @returns {Field}
 */
function createNumber(parameter, id, { change }, say) {
  const { min = 0, max = 1, hard_max: hardMax = max, unit, scale } = parameter;
  const step = parameter.step ?? (parameter.type === 'int' ? 1 : (max - min) / 100);
  const logarithmic = scale === 'log' && min > 0;
  const box = h('input', { type: 'text', inputmode: 'decimal', id, size: 7, autocomplete: 'off', 'aria-describedby': `${id}-error` });
  const slider = h('input', { type: 'range', 'aria-label': parameter.label, min: logarithmic ? 0 : min, max: logarithmic ? 200 : max, step: logarithmic ? 1 : step });

  const toValue = () => {
    const exact = logarithmic ? min * (max / min) ** (Number(slider.value) / 200) : Number(slider.value);
    return Number((min + Math.round((exact - min) / step) * step).toPrecision(12));
  };
  const toSlider = (/** @type {number} */ value) => (logarithmic ? (200 * Math.log(value / min)) / Math.log(max / min) : value);
  const warn = (/** @type {number} */ value) => say(value > max ? text.controls.beyond(max, hardMax) : '');

  // What is being typed or dragged is not overwritten by what comes in meanwhile.
  let editing = false;
  let shown = 0;
  box.addEventListener('input', () => {
    editing = true;
  });
  for (const field of [box, slider]) {
    field.addEventListener('blur', () => {
      if (editing) show(shown);
    });
  }
  slider.addEventListener('input', () => {
    editing = true;
    box.value = String(toValue());
    slider.setAttribute('aria-valuetext', box.value);
  });
  slider.addEventListener('change', () => {
    editing = false;
    say('');
    change(parameter, toValue());
  });
  box.addEventListener('change', () => {
    editing = false;
    try {
      const value = Number(readValue(parameter, box.value));
      box.removeAttribute('aria-invalid');
      warn(value);
      change(parameter, value);
    } catch (problem) {
      box.setAttribute('aria-invalid', 'true');
      say(problem instanceof Error ? problem.message : String(problem));
    }
  });
  const show = (/** @type {number} */ value) => {
    editing = false;
    box.removeAttribute('aria-invalid');
    box.value = String(value);
    slider.value = String(toSlider(value));
    slider.setAttribute('aria-valuetext', unit ? `${value} ${unit}` : String(value));
  };
  return {
    label: h('label', { for: id }, parameter.label),
    aside: h('span', { class: 'number' }, box, unit ? h('span', { class: 'unit' }, unit) : ''),
    body: slider,
    show: (value) => {
      shown = Number(value);
      if (!editing && !(box.getAttribute('aria-invalid') && document.activeElement === box)) show(shown);
    },
  };
}
