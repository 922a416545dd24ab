import { history } from '@codemirror/commands';
import { button, h, write } from '../../ui/dom.js';
import { soccerText } from '../../ui/strings.soccer.en.js';

/** @import { SoccerSession } from '../../soccer/session.js' */
/** @import { TreeShapes } from '../../soccer/shapes.js' */
/** @import { Problem, Team } from '../../soccer/types.js' */
/** @import { Editor } from '../trees/editor.js' */

const words = soccerText.coach;
const TYPING_MS = 400;

/**
 * The text of a team's coach or roles, in the editor of the workbench, which is loaded when it is first asked for. What is
 * valid plays at once; what is not is marked where it stands, and the last valid one plays on.
 *
 * @param {{ session: SoccerSession, shapes: TreeShapes, changed: () => void }} parts
 */
export function createCoachText({ session, shapes, changed }) {
  /** @type {Editor | null} */
  let editor = null;
  /** @type {{ team: Team, what: 'coach' | 'roles' } | null} */
  let shown = null;
  let written = ''; // what the editor was given or gave last
  let filling = false;
  let typing = 0;
  const said = h('p', { class: 'said small', id: 'soccer-text-said', role: 'status' });
  const list = h('ol', { class: 'text-problems' });
  const place = h('div', { class: 'soccer-code' });
  const what = h('select', { id: 'soccer-text-what' }, h('option', { value: 'coach' }, words.editor.coachOption), h('option', { value: 'roles' }, words.editor.rolesOption));
  what.addEventListener('change', () => shown && void open(shown.team, what.value === 'roles' ? 'roles' : 'coach'));
  const back = button(words.builtIn, () => {
    if (!shown) return;
    void session.give(shown.team, shown.what, '').then(() => shown && open(shown.team, shown.what));
  });
  const element = h('div', { class: 'coach-text', hidden: true }, h('div', { class: 'row' }, h('label', { for: what.id }, words.editor.what), what, back), place, said, list);

  /** @param {Team} team @param {'coach' | 'roles'} kind */
  const textOf = (team, kind) => (kind === 'coach' ? (session.coachText(team) ?? '') : session.rolesText(team));

  /** @param {Team} team @param {'coach' | 'roles'} kind */
  async function open(team, kind) {
    shown = { team, what: kind };
    what.value = kind;
    what.options[0].disabled = session.coachText(team) === null;
    if (!editor) {
      const { createEditor } = await import('../trees/editor.js');
      editor = createEditor({ state: history(), edited, pointed: () => {}, leave: () => what.focus() });
      place.append(editor.element);
    }
    fill(textOf(team, kind));
    changed();
  }

  /** @param {string} text */
  function fill(text) {
    if (!editor) return;
    written = text;
    filling = true;
    editor.view.dispatch({ changes: { from: 0, to: editor.view.state.doc.length, insert: text } });
    filling = false;
    tell([]);
  }

  /** @param {import('@codemirror/view').ViewUpdate} update */
  function edited(update) {
    if (!update.docChanged || filling) return;
    clearTimeout(typing);
    write(said, words.editor.waiting);
    typing = window.setTimeout(() => void apply(), TYPING_MS);
  }

  async function apply() {
    if (!editor || !shown) return;
    const { team, what: kind } = shown;
    const text = editor.view.state.doc.toString();
    if (text === written) return;
    const { problems } = await shapes.read(kind, text);
    if (editor.view.state.doc.toString() !== text || shown?.team !== team || shown.what !== kind) return;
    tell(problems);
    if (problems.some(({ warning }) => !warning)) return;
    written = text;
    await session.give(team, kind, text);
  }

  /** @param {Problem[]} problems */
  function tell(problems) {
    editor?.problems(problems);
    const faults = problems.filter(({ warning }) => !warning).length;
    write(said, faults > 0 ? words.editor.problems(faults) : words.editor.valid);
    list.replaceChildren(
      ...problems.map(({ line, column, message }) => h('li', {}, button(words.editor.place(line, column), () => editor?.goTo(line, column), { class: 'quiet' }), ' ', message)),
    );
  }

  return {
    element,
    what: () => what.value,
    /** Whether the text of this team is to be seen. @param {Team} team */
    open: (team) => shown?.team === team,

    /** Shows a text, or hides it again. @param {Team} team @param {'coach' | 'roles'} kind */
    toggle(team, kind) {
      if (shown?.team === team) {
        shown = null;
        changed();
      } else void open(team, kind);
    },

    /** @param {Team} team @param {'coach' | 'roles'} kind */
    show: (team, kind) => open(team, kind),

    /** The text in force is another one, unless it was typed here. */
    refresh() {
      if (!shown || !editor) return;
      const text = textOf(shown.team, shown.what);
      if (text !== written) fill(text);
    },
  };
}

/** @typedef {ReturnType<typeof createCoachText>} CoachText */
