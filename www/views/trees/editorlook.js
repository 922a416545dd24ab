import { HighlightStyle, syntaxHighlighting } from '@codemirror/language';
import { EditorView } from '@codemirror/view';
import { tags } from '@lezer/highlight';

// Weight and shade tell the parts of the text apart; colour is kept for data.
const letters = HighlightStyle.define([
  { tag: tags.tagName, fontWeight: '600' },
  { tag: [tags.angleBracket, tags.definitionOperator, tags.attributeName, tags.processingInstruction, tags.documentMeta], color: 'var(--secondary)' },
  { tag: tags.comment, color: 'var(--secondary)', fontStyle: 'italic' },
  { tag: tags.character, fontWeight: '600' },
  { tag: tags.invalid, textDecoration: 'underline dotted' },
]);

const look = EditorView.theme({
  '&': { height: '100%', color: 'var(--ink)', backgroundColor: 'var(--ground)', fontSize: 'var(--code, 12px)' },
  '&.cm-focused': { outline: '2px solid var(--accent)', outlineOffset: '-2px' },
  '.cm-scroller': { fontFamily: 'ui-monospace, monospace', lineHeight: '1.5' },
  '.cm-content': { padding: '4px 0', caretColor: 'var(--ink)' },
  '.cm-line': { padding: '0 8px 0 4px' },
  '&.cm-focused > .cm-scroller .cm-selectionBackground, .cm-content ::selection': { backgroundColor: 'color-mix(in srgb, var(--accent) 30%, transparent)' },
  '.cm-gutters': { color: 'var(--secondary)', backgroundColor: 'var(--ground)', border: '0', borderRight: '1px solid var(--hairline)' },
  '.cm-lineNumbers .cm-gutterElement': { minWidth: '28px', padding: '0 4px 0 0' },
  '.cm-foldGutter .cm-gutterElement': { width: '16px', textAlign: 'center', cursor: 'pointer' },
  '.cm-gutter-lint': { width: '14px' },
  '.cm-gutter-lint .cm-gutterElement': { padding: '0' },
  '.cm-lint-marker': { width: '14px', height: '18px', textAlign: 'center', fontWeight: '700', color: 'var(--ink)' },
  '.cm-lint-marker-error, .cm-lint-marker-warning': { content: 'normal' },
  '.cm-lint-marker-error::before': { content: '"✗"' },
  '.cm-lint-marker-warning::before': { content: '"!"' },
  '.cm-activeLineGutter': { color: 'var(--ink)', backgroundColor: 'transparent' },
  '.cm-node': { backgroundColor: 'var(--wash)', boxShadow: 'inset 2px 0 var(--ink)' },
  '.cm-foldPlaceholder': { color: 'inherit', backgroundColor: 'transparent', border: '1px solid var(--field)', padding: '0 4px' },
  '.cm-selectionMatch': { backgroundColor: 'color-mix(in srgb, var(--accent) 14%, transparent)' },
  '.cm-searchMatch': { backgroundColor: 'transparent', outline: '1px solid var(--ink)' },
  '.cm-searchMatch-selected': { backgroundColor: 'color-mix(in srgb, var(--accent) 30%, transparent)' },
  '&.cm-focused .cm-matchingBracket, .cm-matchingBracket': { backgroundColor: 'transparent', outline: '1px solid var(--field)' },
  '&.cm-focused .cm-nonmatchingBracket, .cm-nonmatchingBracket': { backgroundColor: 'transparent', textDecoration: 'underline dotted' },

  '.cm-lintRange': { backgroundImage: 'none', paddingBottom: '0' },
  '.cm-lintRange-error': { textDecoration: 'underline wavy 1.5px var(--load)', textUnderlineOffset: '3px', textDecorationSkipInk: 'none' },
  '.cm-lintRange-warning': { textDecoration: 'underline dotted 2px var(--ink)', textUnderlineOffset: '3px', textDecorationSkipInk: 'none' },
  '.cm-lintRange-active': { backgroundColor: 'var(--wash)' },
  '.cm-tooltip': { color: 'var(--ink)', backgroundColor: 'var(--ground)', border: '1px solid var(--ink)', maxWidth: '420px' },
  '.cm-diagnostic': { padding: '4px 8px', borderLeft: '3px solid var(--ink)', font: '13px/20px system-ui, sans-serif', overflowWrap: 'anywhere' },
  '.cm-diagnostic-warning': { borderLeftStyle: 'dotted' },
  '.cm-diagnosticSource': { fontSize: '12px', opacity: '1', color: 'var(--secondary)' },
  '.cm-tooltip-autocomplete > ul': { fontFamily: 'ui-monospace, monospace', maxHeight: '240px' },
  '.cm-tooltip-autocomplete > ul > li': { padding: '2px 8px', minHeight: '24px' },
  '.cm-tooltip-autocomplete > ul > li[aria-selected]': { color: 'var(--on-accent)', backgroundColor: 'var(--accent)' },
  '.cm-completionDetail': { fontStyle: 'normal', marginLeft: '8px', opacity: '1', color: 'var(--secondary)' },
  'li[aria-selected] .cm-completionDetail': { color: 'inherit' },
  '.cm-completionMatchedText': { textDecoration: 'underline' },
  '.cm-completionInfo': { padding: '4px 8px', font: '13px/20px system-ui, sans-serif' },

  '.cm-panels': { color: 'var(--ink)', backgroundColor: 'var(--ground)', font: '13px/20px system-ui, sans-serif' },
  '.cm-panels.cm-panels-top': { borderBottom: '1px solid var(--hairline)' },
  '.cm-panel.cm-search': { padding: '6px 32px 6px 8px' },
  '.cm-panel label': { font: 'inherit !important' },
  '.cm-textfield': { font: 'inherit', color: 'inherit', backgroundColor: 'var(--ground)', border: '1px solid var(--field)', borderRadius: '2px', minHeight: '24px' },
  '.cm-button, .cm-diagnosticAction, .cm-panel [name=close]': {
    font: 'inherit',
    color: 'inherit',
    background: 'var(--ground)',
    border: '1px solid var(--field)',
    borderRadius: '2px',
    minHeight: '24px',
    minWidth: '24px',
    padding: '0 8px',
    cursor: 'pointer',
  },
  '.cm-button:hover, .cm-diagnosticAction:hover': { background: 'var(--wash)', borderColor: 'var(--ink)' },
  '.cm-diagnosticAction': { display: 'inline-block', margin: '4px 8px 4px 0' },
  '.cm-panel [name=close]': { top: '4px !important', right: '4px !important', padding: '0', borderColor: 'transparent' },
  ':focus-visible': { outline: '2px solid var(--accent)', outlineOffset: '1px' },
  '.cm-content:focus-visible': { outline: 'none' },
});

/** How the editor looks: the page's colours, in both themes. */
export const editorLook = [look, syntaxHighlighting(letters)];
