import { history, invertedEffects, isolateHistory } from '@codemirror/commands';
import { StateEffect, StateField, Transaction } from '@codemirror/state';

/** @import { EditorState, Extension } from '@codemirror/state' */
/** @import { EditorView } from '@codemirror/view' */
/** @import { ScriptEvent } from './types.js' */

/**
 * @typedef {object} Rest what decides a run beside the text
 * @property {string | null} entry name of the library entry it began as; null for a tree of the visitor's own
 * @property {string} title what a tree of the visitor's own is called
 * @property {ScriptEvent[]} script
 * @property {'once' | 'exactly_once'} mode
 * @property {number} ms
 */

/** @type {Rest} */
export const PLAIN = { entry: null, title: '', script: [], mode: 'once', ms: 100 };

/** @type {import('@codemirror/state').StateEffectType<Partial<Rest>>} */
const setRest = StateEffect.define();

/** @type {StateField<Rest>} */
const restField = StateField.define({
  create: () => PLAIN,
  update(rest, transaction) {
    for (const effect of transaction.effects) if (effect.is(setRest)) rest = { ...rest, ...effect.value };
    return rest;
  },
});

/**
 * Script, mode and time belong to the state of the editor, so that one history covers them and the text.
 *
 * @type {Extension}
 */
export const setupState = [
  restField,
  history(),
  invertedEffects.of((transaction) => (transaction.effects.some((effect) => effect.is(setRest)) ? [setRest.of(transaction.startState.field(restField))] : [])),
];

/** @param {EditorState} state */
export const restOf = (state) => state.field(restField);

/** Whether a change of state changed more than the text. @param {EditorState} before @param {EditorState} now */
export const restChanged = (before, now) => before.field(restField) !== now.field(restField);

/** Changes script, mode or time: one step of the history. @param {EditorView} view @param {Partial<Rest>} changes */
export function changeRest(view, changes) {
  view.dispatch({ effects: setRest.of(changes), annotations: [isolateHistory.of('full'), Transaction.userEvent.of('script')] });
}

/**
 * Puts another tree in place of the present one: one step of the history, unless there is nothing to go back to.
 *
 * @param {EditorView} view
 * @param {string} xml
 * @param {Rest} rest
 * @param {boolean} remembered
 */
export function replaceSetup(view, xml, rest, remembered) {
  view.dispatch({
    changes: { from: 0, to: view.state.doc.length, insert: xml },
    selection: { anchor: 0 },
    effects: setRest.of(rest),
    annotations: [isolateHistory.of('full'), Transaction.userEvent.of('input.open'), Transaction.addToHistory.of(remembered)],
  });
  view.scrollDOM.scrollTo(0, 0);
}
