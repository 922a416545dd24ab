import { autocompletion, closeCompletion, completionKeymap, completionStatus } from '@codemirror/autocomplete';
import { defaultKeymap, historyKeymap, indentWithTab, redo } from '@codemirror/commands';
import { bracketMatching, codeFolding, foldGutter, foldKeymap, indentOnInput, indentUnit } from '@codemirror/language';
import { autoCloseTags, xmlLanguage } from '@codemirror/lang-xml';
import { lintGutter, lintKeymap, setDiagnostics } from '@codemirror/lint';
import { closeSearchPanel, highlightSelectionMatches, openSearchPanel, search, searchKeymap } from '@codemirror/search';
import { EditorState, StateEffect, StateField } from '@codemirror/state';
import { Decoration, EditorView, highlightActiveLineGutter, keymap, lineNumbers } from '@codemirror/view';
import { h } from '../../ui/dom.js';
import { benchText } from '../../ui/strings.trees.en.js';
import { createCompletion } from './completion.js';
import { editorLook } from './editorlook.js';
import { fixesOf } from './fixes.js';
import { elementAt, offsetOf, placeOf, rangeAt } from './places.js';

/** @import { Extension } from '@codemirror/state' */
/** @import { ViewUpdate } from '@codemirror/view' */
/** @import { NodeModel, Problem } from '../../trees/types.js' */

const MARGIN = 40; // pixels around a line that is brought into sight

/** @type {import('@codemirror/state').StateEffectType<number | null>} */
const setMark = StateEffect.define();
const markLine = Decoration.line({ class: 'cm-node' });

/**
 * Puts typed text in place of a selection before the browser does: it would keep the look of what was there in a style
 * attribute, which the page's policy refuses.
 *
 * @param {InputEvent} event
 * @param {EditorView} view
 */
function replaceSelection(event, view) {
  if (event.inputType !== 'insertText' || event.data === null || event.isComposing || view.composing || view.state.selection.main.empty) return false;
  view.dispatch(view.state.replaceSelection(event.data), { userEvent: 'input.type', scrollIntoView: true });
  event.preventDefault();
  return true;
}

/** The line of the node that is selected in the drawing. */
const markField = StateField.define({
  create: () => Decoration.none,
  update(marks, transaction) {
    let next = marks.map(transaction.changes);
    for (const effect of transaction.effects) {
      if (!effect.is(setMark)) continue;
      next = effect.value === null ? Decoration.none : Decoration.set(markLine.range(transaction.state.doc.lineAt(effect.value).from));
    }
    return next;
  },
  provide: (field) => EditorView.decorations.from(field),
});

/**
 * The text of the tree. It stands in a shadow root, so that its styles are adopted sheets, which the page's policy allows.
 *
 * @param {{ state: Extension, edited: (update: ViewUpdate) => void, pointed: (place: { line: number, column: number } | null) => void, leave: () => void }} parts
 *   `state` are further parts of the editor's state, `pointed` is told the element the cursor is in, `leave` puts the focus behind the text
 */
export function createEditor({ state, edited, pointed, leave }) {
  const element = h('div', { class: 'trees-code' });
  const root = element.attachShadow({ mode: 'open' });
  /** @type {NodeModel[]} */
  let models = [];

  /** @param {ViewUpdate} update */
  function updated(update) {
    edited(update);
    if (update.selectionSet && view.hasFocus) pointed(pointedAt());
  }

  /** Closes what is open over the text, and then leaves it. @param {EditorView} inside */
  function escape(inside) {
    const listed = completionStatus(inside.state) === 'active';
    closeCompletion(inside); // also one that is about to open
    if (!listed && !closeSearchPanel(inside)) leave();
    return true;
  }

  /** Line and column of the element the cursor is in. */
  function pointedAt() {
    const { head } = view.state.selection.main;
    const behind = view.state.sliceDoc(Math.max(head - 1, 0), head) === '>' && view.state.sliceDoc(head, head + 1) !== '<';
    const at = elementAt(view.state, behind ? head - 1 : head);
    return at && placeOf(view.state.doc, at.element.from);
  }

  const view = new EditorView({
    root,
    parent: root,
    extensions: [
      state,
      xmlLanguage,
      autoCloseTags,
      xmlLanguage.data.of({ autocomplete: createCompletion(() => models) }),
      autocompletion({ icons: false, defaultKeymap: false }),
      lineNumbers(),
      highlightActiveLineGutter(),
      lintGutter(),
      codeFolding(),
      foldGutter({ openText: '▾', closedText: '▸' }),
      bracketMatching(),
      indentOnInput(),
      indentUnit.of('  '),
      EditorState.tabSize.of(2),
      search({ top: true }),
      highlightSelectionMatches(),
      markField,
      editorLook,
      keymap.of([
        { key: 'Escape', run: escape },
        ...completionKeymap,
        ...searchKeymap,
        ...lintKeymap,
        ...historyKeymap,
        { key: 'Mod-Shift-z', run: redo, preventDefault: true }, // on every system
        ...foldKeymap,
        ...defaultKeymap,
        indentWithTab,
      ]),
      EditorView.contentAttributes.of({ 'aria-label': benchText.editor.label, spellcheck: 'false', tabindex: '0' }),
      EditorView.updateListener.of(updated),
      EditorView.domEventHandlers({ beforeinput: replaceSelection }),
    ],
  });

  /** Does what can be done about a problem, if the text is still as it was. @param {Problem} problem @param {string} label */
  function fix(problem, label) {
    const found = fixesOf(view.state, problem).find((candidate) => candidate.label === label);
    if (found) view.dispatch({ changes: found.changes(), userEvent: 'input.fix', scrollIntoView: true });
  }

  /** Scrolls the text, and nothing but the text, so that a place is in sight. @param {number} offset */
  function bring(offset) {
    const { top, bottom } = view.lineBlockAt(offset);
    const { scrollTop, clientHeight } = view.scrollDOM;
    if (top - MARGIN < scrollTop) view.scrollDOM.scrollTop = top - MARGIN;
    else if (bottom + MARGIN > scrollTop + clientHeight) view.scrollDOM.scrollTop = bottom + MARGIN - clientHeight;
  }

  return {
    element,
    view,
    fix,
    find: () => void openSearchPanel(view),
    focused: () => view.hasFocus,
    pointedAt,

    /** Underlines problems where they are. @param {Problem[]} problems */
    problems(problems) {
      const diagnostics = problems.map((problem) => {
        const actions = fixesOf(view.state, problem).map(({ label }) => ({ name: label, apply: () => fix(problem, label) }));
        const severity = /** @type {'warning' | 'error'} */ (problem.warning ? 'warning' : 'error');
        return { ...rangeAt(view.state, offsetOf(view.state.doc, problem.line, problem.column)), severity, message: problem.message, source: problem.code, actions };
      });
      view.dispatch(setDiagnostics(view.state, diagnostics));
    },

    /** What can be done about a problem of the text as it is now. @param {Problem} problem */
    fixes: (problem) => fixesOf(view.state, problem),

    /** Puts the cursor at a place. @param {number} line @param {number} column */
    goTo(line, column) {
      view.dispatch({ selection: { anchor: offsetOf(view.state.doc, line, column) }, effects: EditorView.scrollIntoView(offsetOf(view.state.doc, line, column), { y: 'center' }) });
      view.focus();
    },

    /** Marks the line of a node and brings it into sight; the cursor stays. @param {{ line: number, column: number } | null} place */
    mark(place) {
      const offset = place && offsetOf(view.state.doc, place.line, place.column);
      view.dispatch({ effects: setMark.of(offset) });
      if (offset !== null && !view.hasFocus) bring(offset);
    },

    /** @param {NodeModel[]} list the built-in nodes, for completion */
    know: (list) => void (models = list),
  };
}

/** @typedef {ReturnType<typeof createEditor>} Editor */
