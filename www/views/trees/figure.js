import '../../style/trees/figure.css';
import { labelsOf, place } from '../../draw/benchlayout.js';
import { outline } from '../../draw/benchshapes.js';
import { readMoment } from '../../draw/benchstate.js';
import { h, s } from '../../ui/dom.js';
import { figureText as text } from '../../ui/strings.figures.en.js';
import { createCamera } from './figurecamera.js';
import { bindNodes } from './figureevents.js';
import { followNodes } from './figurekeys.js';
import { massOf } from './figuremass.js';
import { measure } from './figuremeasure.js';
import { createFarNode, createNode, findNodes } from './figurenode.js';
import { createPicture, hasStarted, takenEdges } from './figurepicture.js';

/** @import { BenchNode, Moment, Status } from '../../trees/types.js' */
/** @import { Label, Layout, Way } from '../../draw/benchlayout.js' */
/** @import { BenchItem, Look } from './figurenode.js' */

const FAR = 0.42; // scale below which texts cannot be read and nodes are drawn as a mass
const FARTHER = 0.2; // scale below which signs are left out too
const LEGIBLE = 0.66; // scale from which a whole tree is shown when it opens
const READABLE = 0.75; // scale at which a larger one opens, at its beginning
const NEAR = 160; // pixels around the view within which nodes are drawn
const KEEP = 3; // times as far they are kept
const STEP = 1.25;
const ROW = { fine: 34, coarse: 44 };

/** @param {string} words */
const tagWidth = (words) => measure(words, 'word');

/**
 * A behaviour tree as a drawing that is panned, zoomed, folded and walked by keys. The layout is made by `show`, folds
 * and `direction`; a moment only changes how nodes look. Only what is in or near the view is drawn.
 *
 * @param {{ label: string, select: (id: number | null) => void, answer: (id: number, answer: Status | 'next') => void }} options
 */
export function createBenchFigure({ label, select, answer }) {
  const paths = ['bench-edges', 'bench-edges bench-taken', 'bench-chosen', 'bench-focus'];
  const [edges, taken, chosen, pointed] = paths.map((name) => s('path', { class: name, 'aria-hidden': 'true' }));
  const mass = s('g', { class: 'bench-mass', 'aria-hidden': 'true' });
  const ground = s('g', {});
  const scene = s('g', {}, edges, taken, mass, ground, chosen, pointed);
  const stage = s('svg', { class: 'bench-stage', 'aria-label': label }, scene);
  const empty = h('p', { class: 'bench-empty' }, text.figure.empty);
  const element = h('div', { class: 'bench' }, stage, empty);
  const coarse = matchMedia('(pointer: coarse)');
  /** @type {Map<number, BenchItem>} */
  const items = new Map();
  /** @type {BenchNode[]} */
  let nodes = [];
  /** @type {Label[]} */
  let labels = [];
  /** @type {Layout} */
  let layout = { spots: [], shown: [], links: '', width: 0, height: 0 };
  /** @type {Set<number>} */
  let folded = new Set();
  /** @type {Way} */
  let way = 'down';
  let stateOf = readMoment([], null);
  /** @type {Map<number, string>} */
  let letters = new Map();
  /** @type {Set<number>} */
  let hits = new Set();
  /** @type {number | null} */
  let selected = null;
  let focused = 0;
  let far = false;
  let settled = false; // whether the view was placed since the tree was shown
  let whole = false; // whether the view stays on the whole drawing
  const camera = createCamera(stage, () => layout, draw);
  const { view } = camera;

  /** Places all nodes and forgets what was drawn; who calls sees to the view, then draws. */
  function layOut() {
    layout = place(nodes, labels, folded, way, coarse.matches ? ROW.coarse : ROW.fine);
    while (focused > 0 && !layout.spots[focused]?.shown) focused = nodes[focused]?.parent ?? 0;
    clear();
    edges.setAttribute('d', layout.links);
    paintEdges();
  }

  /** Lays out again; the anchor stays where it is on the screen. @param {number} anchor */
  function arrange(anchor) {
    const focus = ground.contains(document.activeElement);
    const before = corner(anchor);
    layOut();
    const after = corner(anchor);
    camera.moveTo(view.x + before.x - after.x, view.y + before.y - after.y);
    draw();
    if (focus) focusOn(focused);
  }

  /** Where a node is on the stage. @param {number} id */
  const corner = (id) => camera.middleOf(layout.spots[id]);

  function clear() {
    items.clear();
    ground.replaceChildren();
    mass.replaceChildren();
  }

  /** The view in which a tree opens: all of it, or its beginning when that could not be read. */
  function begin() {
    settled = view.width > 0 && nodes.length > 0;
    if (!settled) return;
    if (whole || camera.whole() >= LEGIBLE) return camera.fit();
    view.k = READABLE;
    const root = layout.spots[0];
    camera.moveTo(way === 'down' ? view.width / 2 - (root.x + root.w / 2) * view.k : 0, 0);
  }

  function draw() {
    const crisp = (/** @type {number} */ at) => Math.round(at) + 0.5; // hairlines fill whole pixels
    scene.setAttribute('transform', `translate(${crisp(view.x)} ${crisp(view.y)}) scale(${view.k.toFixed(4)})`);
    stage.classList.toggle('bench-farther', view.k < FARTHER);
    if (view.k < FAR !== far) {
      const focus = ground.contains(document.activeElement);
      far = view.k < FAR;
      stage.classList.toggle('bench-far', far);
      clear();
      if (focus) window.queueMicrotask(() => focusOn(focused));
    }
    if (far && mass.childElementCount === 0) mass.replaceChildren(...massOf(nodes, layout.shown, stateOf, letters));
    drawItems();
    ring();
  }

  /** Makes the nodes in or near the view and removes those that are far from it, in the order of the tree. */
  function drawItems() {
    let at = ground.firstChild;
    for (const { id, x, y, w, h: height } of layout.shown) {
      const [left, top] = [view.x + x * view.k, view.y + y * view.k];
      const away = Math.max(-left - w * view.k, left - view.width, -top - (height + 30) * view.k, top - view.height);
      const old = items.get(id);
      if (old) at = old.element.nextSibling;
      if (old && away > NEAR * KEEP && id !== focused) {
        old.element.remove();
        items.delete(id);
      } else if (!old && (away < NEAR || id === focused)) {
        const spot = layout.spots[id];
        const item = far ? createFarNode(nodes[id], spot, lookOf(id)) : createNode(nodes[id], labels[id], spot, lookOf(id));
        item.element.setAttribute('aria-selected', String(id === selected));
        if (id === focused) item.element.setAttribute('tabindex', '0');
        item.paint(stateOf(id), letters.get(id), hits.has(id));
        items.set(id, item);
        ground.insertBefore(item.element, at);
      }
    }
  }

  /** @param {number} id @returns {Look} */
  const lookOf = (id, picture = false) => ({ way, folded: folded.has(id), hidden: nodes[id].end - id - 1, target: coarse.matches ? 44 : 24, tagWidth, picture });

  function paintEdges() {
    taken.setAttribute('d', takenEdges(layout, stateOf));
  }

  function paintItems() {
    for (const [id, item] of items) item.paint(stateOf(id), letters.get(id), hits.has(id));
  }

  function ring() {
    const visible = focused in layout.spots && items.get(focused)?.element.matches(':focus-visible');
    chosen.setAttribute('d', selected === null ? '' : ringOf(selected, 4));
    pointed.setAttribute('d', visible ? ringOf(focused, 8) : '');
  }

  /** @param {number} id @param {number} out */
  function ringOf(id, out) {
    const { x, y, w, h: height, shown } = layout.spots[id];
    const by = out + (nodes[id].category === 'subtree' ? 4 : 0);
    return shown ? outline(nodes[id].category, x - by, y - by, w + 2 * by, height + 2 * by) : '';
  }

  /** @param {number | null} id */
  function choose(id) {
    if (selected !== null) items.get(selected)?.element.setAttribute('aria-selected', 'false');
    selected = id !== null && id < nodes.length ? id : null;
    if (selected !== null) items.get(selected)?.element.setAttribute('aria-selected', 'true');
    ring();
  }

  /** @param {number} id */
  function press(id) {
    choose(id === selected ? null : id);
    select(selected);
  }

  /** @param {number} id */
  function focusOn(id) {
    rove(id);
    camera.bring(layout.spots[id]);
    drawItems();
    items.get(id)?.element.focus({ preventScroll: true });
  }

  /** Makes a node the one that Tab reaches. @param {number} id */
  function rove(id) {
    items.get(focused)?.element.setAttribute('tabindex', '-1');
    focused = id;
    items.get(id)?.element.setAttribute('tabindex', '0');
  }

  /** @param {number} id @param {boolean} close */
  function fold(id, close) {
    if (close) folded.add(id);
    else folded.delete(id);
    rove(id);
    arrange(id);
  }

  bindNodes(element, stage, {
    now: () => ({ nodes, layout, folded, way, focused, selected }),
    press,
    fold,
    answer,
    go: focusOn,
    reached(id) {
      if (id !== null) rove(id);
      ring();
    },
  });
  for (const type of ['wheel', 'pointerdown']) stage.addEventListener(type, () => (whole = false), { passive: true });
  new ResizeObserver(() => {
    if (element.clientWidth === 0 || element.clientHeight === 0) return; // put away for now
    view.width = element.clientWidth;
    view.height = element.clientHeight;
    if (!settled || whole) begin();
    else camera.moveTo(view.x, view.y);
    draw();
  }).observe(element);

  return {
    element,

    /**
     * Draws a tree; gives the node that is now selected.
     *
     * @param {BenchNode[] | null} next
     * @param {{ keep?: boolean }} [options] keep: place, folds and selection stay as far as nodes are found again
     * @returns {number | null}
     */
    show(next, { keep = false } = {}) {
      const to = keep && next ? followNodes(nodes, next) : () => null;
      const focus = ground.contains(document.activeElement);
      const middle = keep ? (selected ?? camera.nearest(layout.shown)) : null;
      const [sight, anchor] = middle === null ? [null, null] : [corner(middle), to(middle)];
      folded = new Set([...folded].map(to).filter((id) => id !== null));
      selected = selected === null ? null : to(selected);
      focused = nodes.length > 0 ? (to(focused) ?? 0) : 0;
      nodes = next ?? [];
      labels = labelsOf(nodes, way, measure);
      stateOf = readMoment(nodes, null);
      hits = new Set();
      letters = new Map();
      for (const part of [stage, empty]) part.toggleAttribute('hidden', (part === stage) === (nodes.length === 0));
      if (nodes.length > 0) stage.setAttribute('role', 'tree');
      else stage.removeAttribute('role');
      layOut();
      if (!keep || !settled) {
        whole = false;
        begin();
      } else if (sight && anchor !== null && layout.spots[anchor].shown) camera.moveTo(view.x + sight.x - corner(anchor).x, view.y + sight.y - corner(anchor).y);
      else camera.moveTo(view.x, view.y);
      draw();
      if (focus && nodes.length > 0) focusOn(focused);
      return selected;
    },

    /** @param {Moment | null} moment */
    paint(moment) {
      stateOf = readMoment(nodes, moment);
      stage.classList.toggle('bench-started', hasStarted(moment));
      if (far) mass.replaceChildren(...massOf(nodes, layout.shown, stateOf, letters));
      paintEdges();
      paintItems();
    },

    /** @param {Map<number, string>} breakpoints letters by node */
    mark(breakpoints) {
      letters = new Map(breakpoints);
      if (far) mass.replaceChildren(...massOf(nodes, layout.shown, stateOf, letters));
      paintItems();
    },

    select: choose,

    /** Unfolds what hides a node and moves the view to it. @param {number} id */
    reveal(id) {
      let above = nodes[id]?.parent ?? null;
      let opened = false;
      for (; above !== null; above = nodes[above].parent) opened = folded.delete(above) || opened;
      if (opened) arrange(0);
      if (!nodes[id] || view.width === 0) return;
      whole = false;
      if (view.k < FAR) camera.zoomTo(READABLE);
      camera.bring(layout.spots[id]);
      draw();
    },

    /** Marks the nodes that hold all words; gives their ids. @param {string} words */
    search(words) {
      hits = new Set(findNodes(nodes, words));
      paintItems();
      return [...hits];
    },

    zoom: {
      in: () => ((whole = false), camera.zoomBy(STEP)),
      out: () => ((whole = false), camera.zoomBy(1 / STEP)),
      fit: () => ((whole = true), begin()),
    },

    fold: {
      all: () => {
        for (const { id, end } of nodes) if (id > 0 && end > id + 1) folded.add(id);
        if (nodes.length > 0) arrange(0);
      },
      none: () => {
        folded.clear();
        if (nodes.length > 0) arrange(0);
      },
    },

    /** @param {Way} next */
    direction(next) {
      if (next === way) return;
      way = next;
      labels = labelsOf(nodes, way, measure);
      layOut();
      begin();
      draw();
      if (settled && !whole && selected !== null && layout.spots[selected].shown) camera.bring(layout.spots[selected]);
    },

    /** The whole drawing as it is now, of any moment. */
    picture: () => createPicture({ host: element, title: label, nodes, labels, layout, lookOf: (id) => lookOf(id, true), letters }),
  };
}

/** @typedef {ReturnType<typeof createBenchFigure>} BenchFigure */
