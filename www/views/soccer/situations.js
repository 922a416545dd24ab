import { BALL, thingName } from '../../soccer/hold.js';
import { button, h, write } from '../../ui/dom.js';
import { soccerText } from '../../ui/strings.soccer.en.js';

/** @import { SoccerHold } from '../../soccer/hold.js' */
/** @import { SoccerSession } from '../../soccer/session.js' */

const words = soccerText.situation;

/**
 * What can be done to the match at the moment on screen: a situation is staged, or a robot or the ball put elsewhere.
 *
 * @param {{ hold: SoccerHold, session: SoccerSession, drive: HTMLElement, takeBack: () => void, stage: (value: object, label: string) => Promise<string>,
 *   say: (message: string, kind?: 'note' | 'problem') => void }} parts
 */
export function createSituations({ hold, session, drive, takeBack, stage, say }) {
  const select = h('select', { id: 'soccer-situation', 'aria-label': words.choose }, ...words.options.map(([value, label]) => h('option', { value }, label)));
  const go = button(words.go, () => void act());
  const thing = h('select', { id: 'soccer-thing' }, h('option', { value: '' }, words.none), ...Array.from({ length: BALL + 1 }, (_, index) => h('option', { value: index }, thingName(index))));
  const fields = /** @type {const} */ (['x', 'y', 'heading']).map((name) => {
    const [label, unit] = name === 'heading' ? [words.turn, words.degrees] : [words[name], words.metres];
    const field = h('input', { type: 'text', inputmode: 'decimal', id: `soccer-${name}`, size: 6, autocomplete: 'off' });
    field.addEventListener('change', () => {
      const value = Number(field.value.replace('−', '-'));
      if (field.value.trim() !== '' && Number.isFinite(value)) void hold.put({ [name]: value });
      else show();
    });
    return { name, field, element: h('label', { class: 'place-field' }, label, field, unit) };
  });
  const place = h('span', { class: 'place' }, ...fields.map(({ element }) => element));
  const refusal = h('p', { class: 'refusal', id: 'soccer-refusal', role: 'alert' });
  const back = button(words.undo, takeBack, { title: words.undoLong });
  const tools = h(
    'div',
    { class: 'soccer-tools', role: 'group', 'aria-label': words.label },
    h('span', { class: 'joined stage-one' }, select, go),
    drive,
    h('span', { class: 'move' }, h('label', { for: thing.id }, words.thing), thing, place, back),
  );
  const narrow = matchMedia('(max-width: 899px)');
  const element = h('details', { class: 'tools-fold', open: !narrow.matches }, h('summary', {}, words.fold), tools);
  narrow.addEventListener('change', () => (element.open = !narrow.matches));

  thing.addEventListener('change', () => hold.choose(thing.value === '' ? null : Number(thing.value)));

  async function act() {
    const [kind, who] = select.value.split(' ');
    const label = words.options.find(([value]) => value === select.value)?.[1] ?? '';
    const refused = await stage(kind === 'free-ball' ? { kind, quadrant: Number(who) } : { kind, team: who }, label);
    if (refused) say(words.refused(refused), 'problem');
  }

  function show() {
    const at = hold.place();
    thing.value = hold.chosen === null ? '' : String(hold.chosen);
    place.classList.toggle('blank', at === null); // it keeps its room: the pitch must not move under the hand
    if (at) {
      for (const { name, field, element: whole } of fields) {
        whole.classList.toggle('blank', name === 'heading' && hold.chosen === BALL);
        if (document.activeElement !== field) field.value = name === 'heading' ? at.heading.toFixed(0) : at[name].toFixed(3);
      }
    }
    write(refusal, hold.refusal === '' ? '' : words.refused(hold.refusal));
    back.classList.toggle('blank', (session.scenario().events ?? []).length === 0);
  }

  return {
    element,
    /** Why something cannot stand where it was put; over the pitch. */
    refusal,
    show,
    /** @param {boolean} on whether anything may be done now */
    enable(on) {
      for (const control of element.querySelectorAll('button, select, input')) if (control !== drive && !drive.contains(control)) /** @type {HTMLButtonElement} */ (control).disabled = !on;

    },
  };
}

