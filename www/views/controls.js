import { button, h, write } from '../ui/dom.js';
import { text } from '../ui/strings.en.js';
import { createControl } from '../ui/control.js';
import { messageOf } from '../session.js';
import { fieldOf } from '../link.js';

/** @import { Engine } from '../engine.js' */
/** @import { Files } from '../files/files.js' */
/** @import { Run } from '../run.js' */
/** @import { Session } from '../session.js' */
/** @import { Parameter, Value } from '../types.js' */

/**
 * The left pane: preset, then every parameter of the schema by group, then the one button for changes that wait.
 *
 * @param {{ pane: HTMLElement, engine: Engine, run: Run, session: Session, files: Files }} parts
 */
export function createControls({ pane, engine, run, session, files }) {
  const kinds = text.presets.map(({ label, holds }) => ({ label, presets: session.presets.filter(({ name }) => text.presets.find((kind) => kind.holds.test(name))?.holds === holds) }));
  const preset = h(
    'select',
    { id: 'preset' },
    ...kinds.filter(({ presets }) => presets.length > 0).map(({ label, presets }) => h('optgroup', { label }, ...presets.map(({ name, title }) => h('option', { value: name }, title)))),
  );
  const about = h('p', { class: 'preset-about' });
  preset.addEventListener('change', () => void session.choosePreset(preset.value));

  const wiring = { change: (/** @type {Parameter} */ parameter, /** @type {Value} */ value) => void session.change(parameter, value), check, inFull, files };
  const parameters = session.schema.filter((parameter) => parameter.type !== 'seed');
  const controls = parameters.map((parameter) => ({ parameter, control: createControl(parameter, wiring) }));
  const groups = [...new Set(parameters.map((parameter) => parameter.group))].map((group, index) => {
    const inside = controls.filter(({ parameter }) => parameter.group === group);
    const count = h('span', { class: 'count' });
    const details = h('details', { class: 'group', open: index === 0 }, h('summary', {}, group, count), ...inside.map(({ control }) => control.element));
    return { inside, count, details };
  });

  const waiting = h('p', {});
  const apply = button(text.controls.restartToApply, () => void session.restart(), { class: 'primary' });
  apply.id = 'apply';
  const strip = h('div', { class: 'apply-strip', hidden: true }, waiting, apply);

  const narrow = matchMedia('(max-width: 899px)');
  const whole = h(
    'details',
    { class: 'all-controls', open: !narrow.matches },
    h('summary', {}, text.controls.title),
    h('div', { class: 'preset' }, h('label', { for: 'preset' }, text.controls.preset), preset, about),
    ...groups.map(({ details }) => details),
  );
  narrow.addEventListener('change', () => (whole.open = !narrow.matches));
  pane.setAttribute('aria-label', text.controls.title);
  pane.append(whole, strip);

  /** The engine's own message about a text; empty when it is fine. @param {Parameter} parameter @param {Value} value */
  async function check(parameter, value) {
    try {
      await engine.request('complete', { scenario: JSON.stringify({ ...run.scenario, [fieldOf(parameter.key)]: value }) });
      return '';
    } catch (error) {
      return messageOf(error);
    }
  }

  /** The built-in rules of a grammar's name; they depend on the task. @param {Parameter} parameter @param {Value} value */
  async function inFull(parameter, value) {
    if (parameter.key !== 'geese.grammar') return String(value);
    const answer = await engine.request('rules', { grammar: value, task: session.value('geese.task') });
    return answer.rules;
  }

  function show() {
    preset.value = session.preset;
    write(about, session.presets.find(({ name }) => name === session.preset)?.about ?? '');
    for (const { inside, count } of groups) {
      let changed = 0;
      for (const { parameter, control } of inside) {
        const value = session.value(parameter.key);
        const original = session.original(parameter.key);
        if (value !== original) changed += 1;
        control.show(value, original, session.pending.has(parameter.key));
      }
      write(count, changed > 0 ? text.controls.changedCount(changed) : '');
    }
    strip.hidden = session.pending.size === 0;
    write(waiting, text.controls.waiting(session.pending.size));
  }

  session.on(show);
  run.on('scenario', show);
  run.on('settled', () => {
    if (run.scenario.events?.length) show(); // values in force change with the tick
  });
  return { show };
}
