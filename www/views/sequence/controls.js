import { readValue } from '../../link.js';
import { readList } from '../../sequence/link.js';
import { messageOf } from '../../session.js';
import { createControl } from '../../ui/control.js';
import { button, h, write } from '../../ui/dom.js';
import { sequenceText } from '../../ui/strings.sequence.en.js';
import { text } from '../../ui/strings.en.js';

/** @import { Files } from '../../files/files.js' */
/** @import { Parameter } from '../../types.js' */
/** @import { SequenceSession } from '../../sequence/session.js' */

/** Parameters that are not asked for here: the seed stands in the bar below. */
const ELSEWHERE = new Set(['seed']);
/** What only one of the tasks has a use for. @type {Record<string, RegExp>} */
const USELESS = { navigate: /\.(cell-size|coverage|coverage-margin)$/, cover: /\.(target-x|target-y|target-radius|clear-of-target|target-margin|geodesic)$/ };
const LONG = 40; // characters of a list that no longer fit a line

/**
 * The left pane: preset, then every parameter of the schema by group. A change is planned for at once.
 *
 * @param {{ pane: HTMLElement, session: SequenceSession, open: () => void }} parts `open` asks for a file
 */
export function createSequenceControls({ pane, session, open }) {
  const preset = h('select', { id: 'sequence-preset' }, ...session.presets.map(({ name, title }) => h('option', { value: name }, title)));
  const about = h('p', { class: 'preset-about' });
  preset.addEventListener('change', () => void session.choosePreset(preset.value));

  const wiring = {
    change: (/** @type {Parameter} */ parameter, /** @type {any} */ value) => void session.change(parameter, value).then(show),
    check: async () => '',
    inFull: async (/** @type {Parameter} */ _, /** @type {any} */ value) => String(value),
    files: /** @type {Files} */ ({}), // only populations of another tab are files
  };
  const parameters = session.schema.filter(({ key }) => !ELSEWHERE.has(key));
  const controls = parameters.map((parameter) => ({
    parameter,
    control: parameter.type === 'text' || parameter.type === 'list' ? createWritten(parameter, session) : createControl(parameter, wiring),
  }));
  const opened = new Set(['Task', 'Search']);
  const groups = [...new Set(parameters.map(({ group }) => group))].map((group) => {
    const inside = controls.filter(({ parameter }) => parameter.group === group);
    const count = h('span', { class: 'count' });
    const details = h('details', { class: 'group', open: opened.has(group) }, h('summary', {}, group, count), ...inside.map(({ control }) => control.element));
    return { inside, count, details };
  });
  const narrow = matchMedia('(max-width: 899px)');
  const whole = h(
    'details',
    { class: 'all-controls', open: !narrow.matches },
    h('summary', {}, sequenceText.pane.controls),
    h('div', { class: 'preset' }, h('label', { for: preset.id }, text.controls.preset), preset, about, h('div', { class: 'row' }, button(sequenceText.controls.open, open))),
    ...groups.map(({ details }) => details),
  );
  narrow.addEventListener('change', () => (whole.open = !narrow.matches));
  pane.append(whole);

  function show() {
    preset.value = session.preset;
    write(about, session.presets.find(({ name }) => name === session.preset)?.about ?? '');
    for (const { inside, count } of groups) {
      let changed = 0;
      for (const { parameter, control } of inside) {
        const [value, original] = [session.value(parameter.key), session.original(parameter.key)];
        if (JSON.stringify(value) !== JSON.stringify(original)) changed += 1;
        control.element.hidden = USELESS[session.scenario.task]?.test(parameter.key) ?? false;
        control.show(value, original, false);
      }
      write(count, changed > 0 ? text.controls.changedCount(changed) : '');
    }
  }

  session.on('change', show);
  return { show };
}

/**
 * A control for a list or a short text, which is written as it stands in files.
 *
 * @param {Parameter} parameter
 * @param {SequenceSession} session
 */
function createWritten(parameter, session) {
  const id = `control-${parameter.key}`;
  const isList = parameter.type !== 'text';
  const field = isList ? h('textarea', { id, rows: 1, spellcheck: 'false', 'aria-describedby': `${id}-error` }) : h('input', { type: 'text', id, spellcheck: 'false', autocapitalize: 'off', autocomplete: 'off', 'aria-describedby': `${id}-error` });
  const help = h('p', { class: 'help', id: `${id}-help`, hidden: true }, parameter.help, ' ', h('span', { class: 'source' }, text.controls.source(parameter)));
  const about = h('button', { type: 'button', class: 'about', 'aria-expanded': 'false', 'aria-controls': help.id, 'aria-label': text.controls.about(parameter.label) }, '?');
  about.addEventListener('click', () => {
    help.hidden = !help.hidden;
    about.setAttribute('aria-expanded', String(!help.hidden));
  });
  const error = h('p', { class: 'field-error', id: `${id}-error`, role: 'alert' });
  const reset = button(text.controls.reset(''), () => void session.change(parameter, session.original(parameter.key)), { class: 'reset' });
  reset.setAttribute('aria-label', text.controls.resetLong(parameter.label, ''));
  const changed = h('p', { class: 'changed', hidden: true }, reset);
  let shown = '';

  field.addEventListener('change', async () => {
    try {
      const value = isList ? readList(field.value) : readValue(parameter, field.value);
      write(error, '');
      field.removeAttribute('aria-invalid');
      if (!(await session.change(parameter, value))) put(shown);
    } catch (problem) {
      field.setAttribute('aria-invalid', 'true');
      write(error, messageOf(problem));
    }
  });

  /** @param {string} written */
  function put(written) {
    field.value = written;
    if (isList) field.setAttribute('rows', String(written.length > LONG ? 4 : 1));
  }

  return {
    element: h('div', { class: 'control written', 'data-key': parameter.key }, h('div', { class: 'control-head' }, h('label', { for: id }, parameter.label), about), field, error, changed, help),
    /** @param {unknown} value @param {unknown} original */
    show(value, original) {
      const written = isList ? JSON.stringify(value) : String(value);
      if (written !== shown || document.activeElement !== field) {
        put(written);
        write(error, '');
        field.removeAttribute('aria-invalid');
      }
      shown = written;
      changed.hidden = JSON.stringify(value) === JSON.stringify(original);
    },
  };
}
