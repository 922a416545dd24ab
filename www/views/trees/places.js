import { ensureSyntaxTree, syntaxTree } from '@codemirror/language';

/** @import { EditorState, Text } from '@codemirror/state' */
/** @import { SyntaxNode } from '@lezer/common' */

const PARSING_MS = 50;

/**
 * Where a line and column stand in a text. Columns count characters, the editor counts UTF-16 units.
 *
 * @param {Text} doc
 * @param {number} line from 1
 * @param {number} column from 1
 */
export function offsetOf(doc, line, column) {
  const { from, text } = doc.line(Math.min(Math.max(line, 1), doc.lines));
  let units = 0;
  for (let left = column - 1; left > 0 && units < text.length; left -= 1) units += /** @type {number} */ (text.codePointAt(units)) > 0xffff ? 2 : 1;
  return from + units;
}

/**
 * Line and column of an offset, in characters.
 *
 * @param {Text} doc
 * @param {number} offset
 */
export function placeOf(doc, offset) {
  const { number, from, text } = doc.lineAt(offset);
  return { line: number, column: [...text.slice(0, offset - from)].length + 1 };
}

/** The tree of the text as far as it is needed. @param {EditorState} state @param {number} [upto] */
export const parsed = (state, upto = state.doc.length) => ensureSyntaxTree(state, upto, PARSING_MS) ?? syntaxTree(state);

/** @typedef {{ element: SyntaxNode, tag: SyntaxNode, name: SyntaxNode }} ElementAt an element, its opening tag and the name in it */

/**
 * The innermost element that holds an offset.
 *
 * @param {EditorState} state
 * @param {number} offset
 * @returns {ElementAt | null}
 */
export function elementAt(state, offset) {
  const tree = parsed(state, Math.min(offset + 1, state.doc.length));
  const inside = tree.resolveInner(offset, 1);
  /** @type {SyntaxNode | null} */
  let node = inside.name === 'Element' || inside.parent?.name !== 'Document' ? inside : tree.resolveInner(offset, -1);
  for (; node; node = node.parent) {
    const tag = node.name === 'Element' ? node.firstChild : null;
    const name = tag?.getChild('TagName');
    if (tag && name) return { element: node, tag, name };
  }
  return null;
}

/**
 * What to underline for a problem at an offset: the tag's name, the attribute's name, or the one character.
 *
 * @param {EditorState} state
 * @param {number} offset
 */
export function rangeAt(state, offset) {
  const { length } = state.doc;
  const node = parsed(state, Math.min(offset + 1, length)).resolveInner(offset, 1);
  const name = node.name === 'StartTag' ? node.nextSibling : null;
  if (name?.name === 'TagName') return { from: offset, to: name.to };
  if (['TagName', 'AttributeName'].includes(node.name) && node.from === offset) return { from: offset, to: node.to };
  const { to } = state.doc.lineAt(offset);
  if (offset < to) return { from: offset, to: offset + (/** @type {number} */ (state.sliceDoc(offset, offset + 2).codePointAt(0)) > 0xffff ? 2 : 1) };
  return { from: Math.max(offset - 1, 0), to: offset }; // at the end of a line: the character before it
}

/**
 * The value of an attribute in a tag, without its quotes.
 *
 * @param {EditorState} state
 * @param {SyntaxNode} tag
 * @param {string} wanted
 * @returns {{ from: number, to: number, value: string } | null}
 */
export function attributeOf(state, tag, wanted) {
  for (const attribute of tag.getChildren('Attribute')) {
    const name = attribute.getChild('AttributeName');
    const value = attribute.getChild('AttributeValue');
    if (!name || !value || state.sliceDoc(name.from, name.to) !== wanted) continue;
    return { from: value.from + 1, to: value.to - 1, value: state.sliceDoc(value.from + 1, value.to - 1) };
  }
  return null;
}
