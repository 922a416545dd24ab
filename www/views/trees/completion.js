import { completeFromSchema } from '@codemirror/lang-xml';
import { attributeOf, parsed } from './places.js';

/** @import { CompletionContext, CompletionResult } from '@codemirror/autocomplete' */
/** @import { AttrSpec, ElementSpec } from '@codemirror/lang-xml' */
/** @import { EditorState } from '@codemirror/state' */
/** @import { SyntaxNode } from '@lezer/common' */
/** @import { NodeModel } from '../../trees/types.js' */

const CONDITIONS = ['_failureIf', '_successIf', '_skipIf', '_while', '_onSuccess', '_onFailure', '_onHalted', '_post'];
const KINDS = ['Action', 'Condition', 'Control', 'Decorator'];
const PORT_ELEMENTS = ['input_port', 'output_port', 'inout_port'];
const TYPES = ['std::string', 'int', 'unsigned int', 'double', 'bool'];

/** @typedef {{ name: string, category: string, ports: string[] }} Declared a node of the document's own */

/**
 * Completes names of nodes, trees, ports and conditions: of the built-in nodes and of those the document declares.
 *
 * @param {() => NodeModel[]} models
 * @returns {(context: CompletionContext) => CompletionResult | Promise<CompletionResult | null> | null}
 */
export function createCompletion(models) {
  return (context) => {
    const { declared, trees } = declarations(context.state);
    return completeFromSchema(elements(models(), declared, trees), [{ name: 'name', global: true }])(context);
  };
}

/** @param {NodeModel[]} models @param {Declared[]} declared @param {string[]} trees @returns {ElementSpec[]} */
function elements(models, declared, trees) {
  const inTree = [...models.map(({ name }) => name).filter((name) => name !== 'SubTree'), ...declared.map(({ name }) => name), 'SubTree'];
  const conditions = CONDITIONS.map((name) => ({ name, completion: { boost: -2 } }));
  const own = new Set(declared.map(({ name }) => name));
  return [
    { name: 'root', top: true, children: ['BehaviorTree', 'TreeNodesModel'], attributes: ['BTCPP_format', { name: 'main_tree_to_execute', values: trees }] },
    { name: 'BehaviorTree', children: inTree, attributes: ['ID'] },
    { name: 'TreeNodesModel', children: [...KINDS, 'SubTree'] },
    { name: 'SubTree', children: [], attributes: [{ name: 'ID', values: trees }, { name: '_autoremap', values: ['true', 'false'] }, ...conditions] },
    ...KINDS.map((name) => ({ name, children: [...PORT_ELEMENTS, ...inTree], attributes: [{ name: 'ID', values: [...own] }, ...conditions] })),
    ...PORT_ELEMENTS.map((name) => ({ name, children: [], attributes: ['default', { name: 'type', values: TYPES }] })),
    ...models
      .filter(({ name }) => name !== 'SubTree' && !own.has(name))
      .map(({ name, category, ports }) => ({ name, ...childrenOf(category, inTree), attributes: [...ports.map(portOf), ...conditions], completion: { detail: category } })),
    ...declared.map(({ name, category, ports }) => ({ name, ...childrenOf(category, inTree), attributes: [...ports, ...conditions], completion: { detail: category.toLowerCase() } })),
  ];
}

/** @param {string} category @param {string[]} inTree */
const childrenOf = (category, inTree) => ({ children: /^(control|decorator)$/i.test(category) ? inTree : [] });

/** @param {NodeModel['ports'][number]} port @returns {AttrSpec} */
function portOf({ name, direction, type, default: preset, description }) {
  const info = [`${direction} ${type}`, preset === null ? '' : `= ${preset}`, description].filter((part) => part !== '').join(', ');
  return { name, values: type === 'bool' ? ['true', 'false'] : undefined, completion: { detail: type, info, boost: 1 } };
}

/** What the document declares: nodes in its TreeNodesModel, and trees. @param {EditorState} state */
function declarations(state) {
  /** @type {Declared[]} */
  const declared = [];
  /** @type {string[]} */
  const trees = [];
  const root = parsed(state).topNode.getChild('Element');
  for (const child of root?.getChildren('Element') ?? []) {
    const name = nameOf(state, child);
    if (name === 'BehaviorTree') trees.push(idOf(state, child));
    if (name !== 'TreeNodesModel') continue;
    for (const model of child.getChildren('Element')) {
      const category = nameOf(state, model);
      const ports = model.getChildren('Element').map((port) => (port.firstChild ? attributeOf(state, port.firstChild, 'name')?.value ?? '' : ''));
      if (KINDS.includes(category)) declared.push({ name: idOf(state, model), category, ports: ports.filter((port) => port !== '') });
    }
  }
  return { declared: declared.filter(({ name }) => name !== ''), trees: trees.filter((name) => name !== '') };
}

/** @param {EditorState} state @param {SyntaxNode} element */
function nameOf(state, element) {
  const name = element.firstChild?.getChild('TagName');
  return name ? state.sliceDoc(name.from, name.to) : '';
}

/** @param {EditorState} state @param {SyntaxNode} element */
const idOf = (state, element) => (element.firstChild ? (attributeOf(state, element.firstChild, 'ID')?.value ?? '') : '');
