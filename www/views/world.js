import { button, h, s, write, zoomOf } from '../ui/dom.js';
import { text } from '../ui/strings.en.js';
import { locate } from '../draw/frame.js';
import { createTrail } from '../draw/trail.js';
import { NAMED, crownOf, drawWorld, markRadius, scaleOf, sinkOf } from '../draw/world.js';
import { bindPicking } from './picking.js';

/** @import { Seen } from '../lens.js' */
/** @import { State } from '../state.js' */
/** @import { Selection } from '../selection.js' */
/** @import { Theme } from '../draw/theme.js' */
/** @import { View } from '../draw/world.js' */

const TRAIL_LENGTH = 24;
const LARGEST_ZOOM = 8;
const FOLLOW_ZOOM = 3;

/**
 * @typedef {object} Beside what a second world takes from the first, so that one camera and one legend serve both
 * @property {View} view
 * @property {() => void} invalidate draws the first, and then the second
 * @property {(zoom: number) => void} zoomTo
 * @property {() => void} fit
 * @property {string} id
 * @property {string} describedBy
 */

/**
 * The world: canvas for what moves, SVG over it for selection and names.
 *
 * @param {{ pane: HTMLElement, run: Seen & { on: (name: 'loaded' | 'frame', listener: () => void) => void }, state: State, selection: Selection,
 *   theme: () => Theme, drawn: () => void, rings?: () => boolean, covered?: () => boolean, beside?: Beside | null }} parts
 *   `drawn` is called after each drawing, `covered` says whether the still is still to be seen, `rings` whether the chosen node is one of this world's trees
 */
export function createWorldView({ pane, run, state, selection, theme, drawn, rings = () => true, covered = () => false, beside = null }) {
  const canvas = h('canvas', { tabindex: 0, role: 'application', 'aria-label': text.world.label, 'aria-describedby': beside?.describedBy ?? 'summary', id: beside?.id ?? 'canvas' });
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  const places = s('g', { class: 'place-names' });
  const ring = s('circle', { class: 'selected-ring', hidden: true });
  const name = s('text', { class: 'selected-name' });
  const overlay = s('svg', { class: 'overlay', 'aria-hidden': 'true' }, places, ring, name);
  const tag = h('p', { class: 'tag', id: beside ? null : 'tag' });
  const zoomBar = h(
    'div',
    { class: 'zoom', role: 'group', 'aria-label': text.world.zoom },
    button(text.world.zoomIn, () => zoomTo(view.camera.zoom * 1.5), { glyph: '+' }),
    button(text.world.zoomOut, () => zoomTo(view.camera.zoom / 1.5), { glyph: '−' }),
    button(text.world.zoomFit, () => fit(), { glyph: '⤢' }),
  );
  // The page has head and stage before any script has run, with a still in it.
  const still = beside ? null : pane.querySelector('#still');
  const stage = beside ? h('div', { class: 'stage' }) : /** @type {HTMLElement} */ (pane.querySelector('.stage'));
  const head = /** @type {HTMLElement} */ (pane.querySelector('.world-head'));
  const lede = beside ? null : pane.querySelector('.lede');
  stage.append(canvas, overlay);
  if (beside) pane.append(stage);
  else head.append(tag, zoomBar);
  if (lede) run.on('loaded', () => (lede.textContent = sentence(run.scenario)));

  /** @type {View | null} */
  let ready = null;
  /** What is drawn; `ready` is null until the first world stands. */
  const view = /** @type {View} */ ({
    camera: beside?.view.camera ?? { x: 0, y: 0, zoom: 1 },
    size: 0,
    layers: beside?.view.layers ?? { robots: true, food: true, carried: true, delivered: true, trails: false },
  });
  let pixelRatio = 0;
  let asked = false;
  let deliveredShown = -1;

  const world = {
    view,
    canvas,
    overlay,
    stage,
    head,
    draw,
    invalidate: beside?.invalidate ?? invalidate,
    zoomTo: beside?.zoomTo ?? zoomTo,
    fit: beside?.fit ?? fit,
    aim,
    /** Whether a world stands. */
    ready: () => ready !== null,
  };

  function invalidate() {
    if (beside) {
      beside.invalidate();
      return;
    }
    if (asked) return;
    asked = true;
    requestAnimationFrame(draw);
  }

  function draw() {
    asked = false;
    if (!ready || view.size === 0) return;
    if (pixelRatio !== devicePixelRatio * zoomOf(canvas)) resize();
    view.frame = run.frame;
    aim();
    canvas.classList.toggle('zoomed', view.camera.zoom > 1);
    context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
    drawWorld(context, view, theme());
    placeOverlay();
    if (still && !covered()) still.remove();
    drawn();
  }

  /** The chosen robot, where this world has one of that number. */
  const chosen = () => (selection.agent !== null && selection.agent < view.at.agents ? selection.agent : null);

  /** Brings the camera to the robot that is followed. */
  function aim() {
    const agent = ready && selection.follow ? chosen() : null;
    if (agent === null) return;
    const base = view.at.agentStart + agent * view.at.agentStride;
    view.camera.x = view.frame[base + view.at.x];
    view.camera.y = view.frame[base + view.at.y];
  }

  function placeOverlay() {
    const scale = scaleOf(view);
    const { camera, size, layout, frame, at } = view;
    const delivered = frame[at.delivered];
    const sink = layout.places.find((place) => place.kind === sinkOf(layout)); // one number is enough where there are several
    layout.places.forEach((place, index) => {
      const label = places.children[index];
      if (place === sink && delivered !== deliveredShown) write(label, text.world.sink(place.kind, delivered, frame[at.total]));
      const [x, y] = crownOf(place);
      label.setAttribute('x', String(size / 2 + (x - camera.x) * scale));
      label.setAttribute('y', String(size / 2 - (y - camera.y) * scale - 10));
    });
    deliveredShown = delivered;
    const agent = chosen();
    ring.toggleAttribute('hidden', agent === null);
    if (agent === null) {
      write(name, '');
      return;
    }
    const base = at.agentStart + agent * at.agentStride;
    const x = size / 2 + (frame[base + at.x] - camera.x) * scale;
    const y = size / 2 - (frame[base + at.y] - camera.y) * scale;
    const radius = markRadius(scale) + 4.5;
    const toTheLeft = x > size - 90;
    ring.setAttribute('cx', String(x));
    ring.setAttribute('cy', String(y));
    ring.setAttribute('r', String(radius));
    name.setAttribute('x', String(toTheLeft ? x - radius - 5 : x + radius + 5));
    name.setAttribute('y', String(Math.max(y - radius, 14)));
    name.setAttribute('text-anchor', toTheLeft ? 'end' : 'start');
    write(name, text.world.robot(agent));
  }

  function resize() {
    const side = Math.floor(Math.min(stage.clientWidth, stage.clientHeight));
    pixelRatio = devicePixelRatio * zoomOf(canvas);
    view.size = side;
    canvas.width = Math.round(side * pixelRatio);
    canvas.height = canvas.width;
    overlay.setAttribute('viewBox', `0 0 ${side} ${side}`);
    invalidate();
  }

  /** @param {number} zoom */
  function zoomTo(zoom) {
    view.camera.zoom = Math.min(Math.max(zoom, 1), LARGEST_ZOOM);
    if (view.camera.zoom === 1) fit();
    invalidate();
  }

  function fit() {
    Object.assign(view.camera, { x: 0, y: 0, zoom: 1 });
    if (selection.follow) selection.toggleFollow();
    invalidate();
  }

  run.on('loaded', () => {
    if (!run.layout) return;
    view.layout = run.layout;
    view.at = locate(run.layout);
    view.trail = createTrail(view.at.agents, TRAIL_LENGTH);
    view.trail.push(run.frame, view.at, run.tick);
    view.ringed = new Uint8Array(view.at.agents);
    ready = view;
    deliveredShown = -1;
    places.replaceChildren(...run.layout.places.map((place) => s('text', { 'text-anchor': 'middle' }, NAMED.has(place.kind) ? text.world.place(place.kind) : '')));
    if (!beside && selection.agent !== null && selection.agent >= view.at.agents) selection.selectAgent(null);
    invalidate();
  });
  run.on('frame', () => {
    if (ready && run.frame.length === view.layout.length) view.trail.push(run.frame, view.at, run.tick);
    invalidate();
  });
  selection.on(() => {
    if (!beside && selection.follow && view.camera.zoom === 1) zoomTo(FOLLOW_ZOOM);
    showRinged();
  });
  state.on((now, reason) => {
    if (now !== 'running') write(tag, text.tag(now, reason));
    tag.classList.toggle('blank', now === 'running');
  });

  /** Rings the robots whose last tick reached the chosen node. */
  function showRinged() {
    if (!ready) return;
    view.ringed.fill(0);
    for (const id of rings() ? selection.reached : []) view.ringed[id] = 1;
    invalidate();
  }

  new ResizeObserver(resize).observe(stage);
  bindPicking(world, run, selection);
  return { ...world, showRinged };
}

/** @typedef {ReturnType<typeof createWorldView>} WorldView */

/** What is to be said first, and is true of this scenario. @param {Record<string, unknown>} scenario */
function sentence({ evolution, grammar }) {
  if (evolution !== false) return text.world.evolving;
  return String(grammar).startsWith('hand-') ? text.world.byHand : text.world.fixed;
}
