import { benchText } from '../../ui/strings.trees.en.js';
import { attributeOf, elementAt, offsetOf, parsed } from './places.js';

/** @import { ChangeSpec, EditorState } from '@codemirror/state' */
/** @import { SyntaxNode } from '@lezer/common' */
/** @import { ElementAt } from './places.js' */
/** @import { Problem } from '../../trees/types.js' */

/** @typedef {{ label: string, changes: () => ChangeSpec[] }} Fix what would change is worked out when it is pressed */

const EXPLICIT = ['Action', 'Condition', 'Control', 'Decorator', 'SubTree'];

/**
 * What can be done about a problem at a press.
 *
 * @param {EditorState} state
 * @param {Problem} problem
 * @returns {Fix[]}
 */
export function fixesOf(state, problem) {
  const offset = offsetOf(state.doc, problem.line, problem.column);
  const near = /did you mean "([^"]+)"\?/.exec(problem.message)?.[1];
  const fixes = near ? [replacement(state, problem, offset, near)] : [];
  const at = problem.code === 'unknown-node' && !problem.warning ? elementAt(state, offset) : null;
  if (at && at.element.from === offset && !at.element.getChild('Element')) {
    for (const kind of /** @type {const} */ (['Action', 'Condition'])) fixes.push(declaration(state, at, kind));
  }
  return fixes.filter((fix) => fix !== null);
}

/** @param {EditorState} state @param {Problem} problem @param {number} offset @param {string} near @returns {Fix | null} */
function replacement(state, { code }, offset, near) {
  const label = benchText.problems.replace(near);
  const at = elementAt(state, offset);
  if (!at) return null;
  if (code === 'unknown-node' || code === 'unknown-subtree') {
    const id = EXPLICIT.includes(state.sliceDoc(at.name.from, at.name.to)) ? attributeOf(state, at.tag, 'ID') : null;
    if (id) return { label, changes: () => [{ from: id.from, to: id.to, insert: near }] };
    return { label, changes: () => namesOf(at).map(({ from, to }) => ({ from, to, insert: near })) };
  }
  const node = parsed(state, Math.min(offset + 1, state.doc.length)).resolveInner(offset, 1);
  if (node.name === 'AttributeName') return { label, changes: () => [{ from: node.from, to: node.to, insert: near }] };
  if (node.name === 'AttributeValue') return { label, changes: () => [{ from: node.from + 1, to: node.to - 1, insert: near }] };
  return null;
}

/** The name in the opening tag and, where there is one, in the closing tag. @param {ElementAt} at */
function namesOf({ element, name }) {
  const closing = element.getChild('CloseTag')?.getChild('TagName');
  return closing ? [name, closing] : [name];
}

/** Declares a node of the visitor's own in the TreeNodesModel, with the ports it is given here. @param {EditorState} state @param {ElementAt} at @param {'Action' | 'Condition'} kind @returns {Fix | null} */
function declaration(state, at, kind) {
  const tag = state.sliceDoc(at.name.from, at.name.to);
  const name = EXPLICIT.includes(tag) ? attributeOf(state, at.tag, 'ID')?.value : tag;
  const root = parsed(state).topNode.getChild('Element');
  if (!name || !root?.getChild('CloseTag')) return null;
  const changes = () => {
    const ports = portsOf(state, name).map(([port, direction]) => `\n      <${direction} name="${port}"/>`);
    return insertion(state, root, ports.length > 0 ? `<${kind} ID="${name}">${ports.join('')}\n    </${kind}>` : `<${kind} ID="${name}"/>`);
  };
  return { label: benchText.problems.declare(kind, name), changes };
}

/**
 * The attributes that elements of this name have and that are neither names nor conditions: its ports. What is bound
 * to an entry may be read and written.
 *
 * @param {EditorState} state
 * @param {string} name
 */
function portsOf(state, name) {
  /** @type {Map<string, string>} */
  const ports = new Map();
  parsed(state).iterate({
    enter(cursor) {
      if (cursor.name !== 'OpenTag' && cursor.name !== 'SelfClosingTag') return;
      const tag = cursor.node;
      const written = tag.getChild('TagName');
      const explicit = written && EXPLICIT.includes(state.sliceDoc(written.from, written.to));
      const own = explicit ? attributeOf(state, tag, 'ID')?.value : written && state.sliceDoc(written.from, written.to);
      if (own !== name) return;
      for (const attribute of tag.getChildren('Attribute')) {
        const key = attribute.getChild('AttributeName');
        const port = key ? state.sliceDoc(key.from, key.to) : '';
        if (!port || port === 'name' || port === 'ID' || port.startsWith('_')) continue;
        const bound = /^\{.*\}$/.test(attributeOf(state, tag, port)?.value ?? '');
        if (bound || !ports.has(port)) ports.set(port, bound ? 'inout_port' : 'input_port');
      }
    },
  });
  return [...ports];
}

/** Where a model goes: into the TreeNodesModel, which is made before the end of root when there is none. @param {EditorState} state @param {SyntaxNode} root @param {string} model @returns {ChangeSpec[]} */
function insertion(state, root, model) {
  for (const child of root.getChildren('Element')) {
    const tag = child.firstChild;
    const name = tag?.getChild('TagName');
    if (!tag || !name || state.sliceDoc(name.from, name.to) !== 'TreeNodesModel') continue;
    const close = child.getChild('CloseTag');
    if (!close) return [{ from: child.from, to: child.to, insert: `<TreeNodesModel>\n    ${model}\n  </TreeNodesModel>` }];
    return [{ ...lineStart(state, close.from), insert: `${onOwnLine(state, close.from) ? '' : '\n'}    ${model}\n  ` }];
  }
  const end = /** @type {SyntaxNode} */ (root.getChild('CloseTag'));
  const inner = `  <TreeNodesModel>\n    ${model}\n  </TreeNodesModel>\n`;
  return [{ ...lineStart(state, end.from), insert: `${onOwnLine(state, end.from) ? '' : '\n'}${inner}` }];
}

/** Whether only blanks stand before an offset in its line. @param {EditorState} state @param {number} offset */
const onOwnLine = (state, offset) => /^\s*$/.test(state.sliceDoc(state.doc.lineAt(offset).from, offset));

/** The blanks before an offset, to be replaced. @param {EditorState} state @param {number} offset */
const lineStart = (state, offset) => (onOwnLine(state, offset) ? { from: state.doc.lineAt(offset).from, to: offset } : { from: offset, to: offset });
