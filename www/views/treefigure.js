import { s, write } from '../ui/dom.js';
import { text } from '../ui/strings.en.js';
import { ROW, indented, symbolOf, tidy } from '../draw/tree.js';

/** @import { TreeNode } from '../types.js' */
/** @import { Drawing } from '../draw/tree.js' */

const WIDE = 520; // pixels from which the tidy drawing is used
const SHARE = 32; // room for the share at the end of a row
const MARK = 9; // half the side of a node's mark

/** @type {Record<string, string>} glyph of a status; colour and border come from the style sheet */
const GLYPH = { SUCCESS: '✓', FAILURE: '✗', RUNNING: '▸', SKIPPED: '–', IDLE: '' };

/**
 * A behaviour tree as SVG, with `role="tree"` and the keys that go with it. The shape is drawn once; after that only
 * statuses and shares change.
 *
 * @param {{ label: string, select: (id: number | null) => void, empty?: string }} options
 */
export function createTreeFigure({ label, select }) {
  const svg = s('svg', { class: 'tree', role: 'tree', 'aria-label': label });
  /** @type {Map<number, { item: SVGGElement, title: SVGTitleElement, symbol: SVGTSpanElement, glyph: SVGTextElement, share: SVGTextElement, bar: SVGRectElement, tint: SVGRectElement }>} */
  const parts = new Map();
  /** @type {TreeNode[]} */
  let nodes = [];
  /** @type {Drawing} */
  let drawing = { boxes: [], links: [], width: 0, height: 0 };
  let shape = '';
  /** @type {Set<number>} */
  let collapsed = new Set();
  /** @type {number | null} */
  let selected = null;
  let focused = 0;
  let width = 0;
  let query = '';
  let group = false;

  const pen = /** @type {CanvasRenderingContext2D} */ (document.createElement('canvas').getContext('2d'));

  /** Room a node needs: mark, name, tag, share. @param {TreeNode} node */
  function widthOf(node) {
    return 2 * MARK + 10 + pen.measureText(`${symbolOf(node.kind)} ${named(node)} ${node.tag ?? ''}`).width + (group ? SHARE : 6);
  }

  /** What stands beside a mark; in the wide form control nodes have their symbol only. @param {TreeNode} node */
  const named = (node) => (width >= WIDE && symbolOf(node.kind) ? '' : caption(node));

  function build() {
    parts.clear();
    if (nodes.length === 0) {
      drawing = { boxes: [], links: [], width: 0, height: 0 };
      svg.replaceChildren();
      svg.setAttribute('height', '0');
      return;
    }
    const { fontSize, fontFamily } = getComputedStyle(svg);
    pen.font = `${fontSize} ${fontFamily}`;
    drawing = width >= WIDE ? tidy(nodes, collapsed, widthOf) : indented(nodes, collapsed, widthOf, width);
    const full = Math.max(drawing.width, width);
    svg.setAttribute('width', String(full));
    svg.setAttribute('height', String(drawing.height));
    svg.setAttribute('viewBox', `0 0 ${full} ${drawing.height}`);
    const links = s('path', { class: 'links', d: drawing.links.join(''), 'aria-hidden': 'true' });
    svg.replaceChildren(links, ...drawing.boxes.filter((box) => !box.hidden).map((box) => item(box, full)));
    paint();
  }

  /** @param {Drawing['boxes'][number]} box @param {number} full */
  function item(box, full) {
    const node = nodes[box.id];
    const wide = width >= WIDE;
    const right = wide ? box.x + widthOf(node) : full - 4;
    const left = box.x - MARK - 3;
    const tint = s('rect', { class: 'tint', x: left, y: box.y - ROW / 2 + 1, width: right - left, height: ROW - 2, rx: 2 });
    const bar = s('rect', { class: 'bar', x: box.x + MARK + 6, y: box.y + ROW / 2 - 4, width: 0, height: 2 });
    bar.dataset.full = String(right - box.x - MARK - 10);
    const glyph = s('text', { class: 'glyph', x: box.x, y: box.y, 'text-anchor': 'middle', dy: '0.35em', 'aria-hidden': 'true' });
    const title = s('title', {}); // the accessible name
    const symbol = s('tspan', { 'aria-hidden': 'true' });
    const name = s('text', { class: 'node-name', x: box.x + MARK + 7, y: box.y, dy: '0.35em' }, symbol, named(node));
    if (node.tag) name.append(s('tspan', { class: 'node-tag', dx: 7 }, node.tag.toLowerCase()));
    const share = s('text', { class: 'share', x: right - 3, y: box.y, dy: '0.35em', 'text-anchor': 'end', 'aria-hidden': 'true' });
    const marks = [
      s('rect', { class: 'mark', x: box.x - MARK, y: box.y - MARK, width: 2 * MARK, height: 2 * MARK, rx: box.children > 0 ? 2 : MARK }),
      s('rect', { class: 'mark-inner', x: box.x - MARK + 3, y: box.y - MARK + 3, width: 2 * MARK - 6, height: 2 * MARK - 6, rx: box.children > 0 ? 1 : MARK }),
    ];
    const element = s(
      'g',
      {
        role: 'treeitem',
        class: 'node',
        'data-id': box.id,
        tabindex: box.id === focused ? 0 : -1,
        'aria-level': box.level,
        'aria-posinset': box.position,
        'aria-setsize': box.siblings,
        'aria-expanded': box.children > 0 ? String(!collapsed.has(box.id)) : undefined,
        onclick: () => press(box.id),
      },
      title,
      tint,
      bar,
      ...marks,
      glyph,
      name,
      share,
    );
    parts.set(box.id, { item: element, title, symbol, glyph, share, bar, tint });
    return element;
  }

  function paint() {
    for (const [id, { item: element, title, symbol, glyph, share, bar, tint }] of parts) {
      const node = nodes[id];
      const now = node.reached_now ?? 0;
      const status = group ? '' : (node.status ?? 'IDLE');
      const ringed = group ? (now > 0 ? 'now' : (node.reached_recently ?? 0) > 0 ? 'recent' : 'never') : '';
      element.dataset.status = status;
      element.dataset.reached = ringed;
      write(glyph, collapsed.has(id) ? '+' : (group ? symbolOf(node.kind) : GLYPH[status]) || '');
      write(symbol, !group && symbolOf(node.kind) ? `${symbolOf(node.kind)} ` : '');
      write(share, group && node.reached_now !== undefined && named(node) ? text.tree.share(now) : '');
      bar.setAttribute('width', group ? String(Number(bar.dataset.full) * now) : '0');
      tint.setAttribute('opacity', group ? String(now * 0.14) : '0');
      element.setAttribute('aria-selected', String(id === selected));
      element.classList.toggle('found', query !== '' && caption(node).toLowerCase().includes(query));
      write(title, text.tree.node(`${caption(node)}${node.tag ? ` ${node.tag.toLowerCase()}` : ''}`, status, group ? now : null));
    }
    svg.classList.toggle('searching', query !== '');
  }

  /** @param {number} id */
  function press(id) {
    focus(id);
    select(id === selected ? null : id);
  }

  /** @param {number} id */
  function focus(id) {
    parts.get(focused)?.item.setAttribute('tabindex', '-1');
    focused = id;
    const element = parts.get(id)?.item;
    element?.setAttribute('tabindex', '0');
    element?.focus({ preventScroll: false });
  }

  /** @param {number} id @param {boolean} close */
  function fold(id, close) {
    if (close) collapsed.add(id);
    else collapsed.delete(id);
    build();
    focus(id);
  }

  svg.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || nodes.length === 0) return;
    const visible = [...parts.keys()];
    const at = visible.indexOf(focused);
    const open = nodes[focused].end > focused + 1 && !collapsed.has(focused);
    const parent = nodes[focused].parent;
    /** @type {Record<string, () => void>} */
    const moves = {
      ArrowDown: () => focus(visible[Math.min(at + 1, visible.length - 1)]),
      ArrowUp: () => focus(visible[Math.max(at - 1, 0)]),
      ArrowRight: () => (collapsed.has(focused) ? fold(focused, false) : open && focus(focused + 1)),
      ArrowLeft: () => (open ? fold(focused, true) : parent !== null && focus(parent)),
      Home: () => focus(visible[0]),
      End: () => focus(visible[visible.length - 1]),
      Enter: () => press(focused),
      ' ': () => press(focused),
    };
    if (!moves[event.key]) return;
    event.preventDefault();
    event.stopPropagation();
    moves[event.key]();
  });

  return {
    svg,
    size: () => ({ width: Number(svg.getAttribute('width') ?? 0), height: drawing.height }),

    /**
     * @param {TreeNode[] | null} next
     * @param {{ shape: string, group?: boolean, selected?: number | null }} how `shape` names the tree: while it stays, nothing is laid out
     */
    show(next, how) {
      nodes = next ?? [];
      group = how.group ?? false;
      selected = how.selected ?? null;
      if (how.shape === shape) {
        paint();
        return;
      }
      const focusInside = svg.contains(document.activeElement);
      shape = how.shape;
      collapsed = new Set();
      focused = Math.min(focused, Math.max(nodes.length - 1, 0));
      build();
      if (focusInside) focus(focused);
    },

    /** @param {number} pixels room there is */
    fit(pixels) {
      if (pixels === width || pixels === 0) return;
      width = pixels;
      build();
    },

    /** Marks nodes whose name holds `words`; says how many. @param {string} words */
    search(words) {
      query = words.trim().toLowerCase();
      paint();
      return query === '' ? null : nodes.filter((node) => caption(node).toLowerCase().includes(query)).length;
    },

    /** @param {number | null} id node to point at from outside */
    point(id) {
      for (const [other, { item: element }] of parts) element.classList.toggle('pointed', other === id);
    },
  };
}

/** Name of a node; control nodes carry their symbol beside it. @param {TreeNode} node */
function caption(node) {
  return node.negated && !node.label.startsWith('not ') ? `not ${node.label}` : node.label;
}

/** @typedef {ReturnType<typeof createTreeFigure>} TreeFigure */
