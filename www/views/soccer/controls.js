import { createControl } from '../../ui/control.js';
import { button, h, write } from '../../ui/dom.js';
import { soccerText } from '../../ui/strings.soccer.en.js';
import { text } from '../../ui/strings.en.js';

/** @import { Files } from '../../files/files.js' */
/** @import { Parameter, Value } from '../../types.js' */
/** @import { SoccerSession } from '../../soccer/session.js' */
/** @import { Team } from '../../soccer/types.js' */

const OPENED = new Set(['Teams', 'Match']);

/**
 * The left pane: preset, then every parameter of the schema by group. A change plays the match anew.
 *
 * @param {{ pane: HTMLElement, session: SoccerSession, open: () => void, edit: (team: Team, what: 'coach' | 'roles') => void }} parts
 *   `open` asks for a file, `edit` shows the text of a coach or of roles
 */
export function createSoccerControls({ pane, session, open, edit }) {
  const preset = h('select', { id: 'soccer-preset' }, ...session.presets.map(({ name, title }) => h('option', { value: name }, title)));
  const about = h('p', { class: 'preset-about' });
  preset.addEventListener('change', () => void session.choosePreset(preset.value));

  const wiring = {
    change: (/** @type {Parameter} */ parameter, /** @type {Value} */ value) => void session.change(parameter, value).then((taken) => taken || show()),
    check: async () => '',
    inFull: async (/** @type {Parameter} */ _, /** @type {Value} */ value) => String(value),
    files: /** @type {Files} */ (/** @type {unknown} */ (null)), // no parameter of soccer is a file
  };
  const parameters = session.schema.filter(({ type }) => type !== 'seed');
  const controls = parameters.map((parameter) => ({ parameter, control: parameter.type === 'text' ? createTreeControl(parameter, session, edit) : createControl(parameter, wiring) }));
  const groups = [...new Set(parameters.map(({ group }) => group))].map((group) => {
    const inside = controls.filter(({ parameter }) => parameter.group === group);
    const count = h('span', { class: 'count' });
    const details = h('details', { class: 'group', open: OPENED.has(group) }, h('summary', {}, group, count), ...inside.map(({ control }) => control.element));
    return { inside, count, details };
  });
  const narrow = matchMedia('(max-width: 899px)');
  const whole = h(
    'details',
    { class: 'all-controls', open: !narrow.matches },
    h('summary', {}, soccerText.pane.controls),
    h(
      'div',
      { class: 'preset' },
      h('label', { for: preset.id }, text.controls.preset),
      preset,
      about,
      h('p', { class: 'preset-about small' }, soccerText.controls.about),
      h('div', { class: 'row' }, button(soccerText.controls.open, open)),
    ),
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
        if (value !== original) changed += 1;
        control.show(value, original, false);
      }
      write(count, changed > 0 ? text.controls.changedCount(changed) : '');
    }
  }

  session.on(show);
  return { show };
}

/**
 * A text that is edited elsewhere: whether it is the built-in one, and the ways to it and back.
 *
 * @param {Parameter} parameter
 * @param {SoccerSession} session
 * @param {(team: Team, what: 'coach' | 'roles') => void} edit
 */
function createTreeControl(parameter, session, edit) {
  const [team, what] = /** @type {[Team, 'coach' | 'roles']} */ (parameter.key.replace('soccer.', '').split('-'));
  const said = h('p', { class: 'control-name' });
  const open = button(soccerText.controls.edit, () => edit(team, what));
  open.setAttribute('aria-label', `${soccerText.controls.edit}: ${parameter.label}`);
  const back = button(soccerText.controls.builtIn, () => void session.give(team, what, ''), { class: 'reset' });
  back.setAttribute('aria-label', `${soccerText.controls.builtIn}: ${parameter.label}`);
  return {
    element: h('div', { class: 'control written', 'data-key': parameter.key }, h('div', { class: 'control-head' }, said, open), back),
    /** @param {Value} value */
    show(value) {
      const own = String(value);
      write(said, soccerText.controls.text(parameter.label, own === '' ? 0 : own.split('\n').length));
      back.hidden = own === '';
      open.disabled = what === 'coach' && session.coachText(team) === null;
    },
  };
}
