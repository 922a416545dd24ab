import { zoomOf } from '../../ui/dom.js';

/** @import { Spot } from '../../draw/benchlayout.js' */

const CLOSEST = 2.5;
const FARTHEST = 0.25; // unless the whole drawing needs more
const AIR = 32; // ground that stays around the drawing
const EDGE = 28; // between a node that was brought into view and the edge
const BELOW = 30; // room for what hangs under a node
const STEADY = 4; // pixels a pointer may move before a click becomes a drag
const WHEEL_LINE = 16;
const NOTCH = 40; // a wheel turns in larger steps than a pinch

/**
 * Pans and zooms: drag, wheel, pinch; a click is not a drag.
 *
 * @param {SVGSVGElement} stage
 * @param {() => { width: number, height: number }} drawing size at scale 1
 * @param {() => void} moved called at most once a frame
 */
export function createCamera(stage, drawing, moved) {
  const view = { x: 0, y: 0, k: 1, width: 0, height: 0 };
  /** @type {Map<number, { x: number, y: number }>} */
  const pointers = new Map();
  let start = { x: 0, y: 0 };
  let dragging = false;
  let frame = 0;

  function changed() {
    frame ||= requestAnimationFrame(() => ((frame = 0), moved()));
  }

  /** A place that keeps the drawing within reach. @param {number} at @param {number} size @param {number} room */
  const hold = (at, size, room) => Math.min(Math.max(at, Math.min(AIR, room - size - AIR)), Math.max(AIR, room - size - AIR));

  /** Whether something moved. @param {number} x @param {number} y */
  function moveTo(x, y) {
    const { width, height } = drawing();
    const held = { x: hold(x, width * view.k, view.width), y: hold(y, height * view.k, view.height) };
    const moves = Math.abs(held.x - view.x) > 0.01 || Math.abs(held.y - view.y) > 0.01;
    Object.assign(view, held);
    if (moves) changed();
    return moves;
  }

  /** @param {Spot} spot */
  const middleOf = ({ x, y, w }) => ({ x: view.x + (x + w / 2) * view.k, y: view.y + y * view.k });

  /** Scale at which everything is seen, at most 1. */
  function whole() {
    const { width, height } = drawing();
    return Math.min(1, view.width / Math.max(width, 1), view.height / Math.max(height, 1));
  }

  /** @param {number} k @param {number} x @param {number} y the point of the stage that stays where it is */
  function zoomTo(k, x = view.width / 2, y = view.height / 2) {
    const next = Math.min(Math.max(k, Math.min(FARTHEST, whole())), CLOSEST);
    const ratio = next / view.k;
    view.k = next;
    moveTo(x - (x - view.x) * ratio, y - (y - view.y) * ratio);
    changed();
  }

  /** @param {{ clientX: number, clientY: number }} event */
  function local({ clientX, clientY }) {
    const { left, top } = stage.getBoundingClientRect();
    const zoom = zoomOf(stage);
    return { x: (clientX - left) / zoom, y: (clientY - top) / zoom };
  }

  stage.addEventListener(
    'wheel',
    (event) => {
      const unit = event.deltaMode === 0 ? 1 : event.deltaMode === 1 ? WHEEL_LINE : view.height;
      const { x, y } = local(event);
      if (event.ctrlKey || event.metaKey) zoomTo(view.k * Math.exp(-event.deltaY * unit * (Math.abs(event.deltaY * unit) > NOTCH ? 0.002 : 0.01)), x, y);
      else {
        const [dx, dy] = event.shiftKey && event.deltaX === 0 ? [event.deltaY, 0] : [event.deltaX, event.deltaY];
        if (!moveTo(view.x - dx * unit, view.y - dy * unit)) return; // the page scrolls on where the drawing ends
      }
      event.preventDefault();
    },
    { passive: false },
  );

  stage.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    pointers.set(event.pointerId, local(event));
    if (pointers.size === 1) {
      start = local(event);
      dragging = false;
    }
  });
  stage.addEventListener('pointermove', (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    if (event.buttons === 0) return release(event); // let go outside
    const now = local(event);
    if (!dragging && pointers.size === 1 && Math.hypot(now.x - start.x, now.y - start.y) < STEADY) return;
    if (!dragging) {
      dragging = true;
      for (const id of pointers.keys()) stage.setPointerCapture(id);
      stage.classList.add('bench-dragging');
    }
    const other = [...pointers].find(([id]) => id !== event.pointerId)?.[1];
    pointers.set(event.pointerId, now);
    if (!other) moveTo(view.x + now.x - before.x, view.y + now.y - before.y);
    else pinch(before, now, other);
  });

  /** @param {{ x: number, y: number }} before @param {{ x: number, y: number }} now @param {{ x: number, y: number }} other */
  function pinch(before, now, other) {
    const ratio = Math.hypot(now.x - other.x, now.y - other.y) / Math.max(Math.hypot(before.x - other.x, before.y - other.y), 1);
    zoomTo(view.k * ratio, (now.x + other.x) / 2, (now.y + other.y) / 2);
    moveTo(view.x + (now.x - before.x) / 2, view.y + (now.y - before.y) / 2);
  }

  /** @param {PointerEvent} event */
  function release(event) {
    pointers.delete(event.pointerId);
    if (pointers.size === 0) stage.classList.remove('bench-dragging');
  }
  stage.addEventListener('pointerup', release);
  stage.addEventListener('pointercancel', release);
  stage.addEventListener(
    'click',
    (event) => {
      if (!dragging) return;
      dragging = false;
      event.stopImmediatePropagation();
    },
    { capture: true },
  );

  return {
    view,
    moveTo,
    whole,
    zoomBy: (/** @type {number} */ ratio) => zoomTo(view.k * ratio),
    zoomTo,

    /** Where the middle of a node's upper edge is on the stage. @param {Spot} spot */
    middleOf,

    /** Moves the view as little as shows a node. @param {Spot} spot */
    bring({ x, y, w, h }) {
      const shift = (/** @type {number} */ at, /** @type {number} */ size, /** @type {number} */ room) =>
        Math.max(0, EDGE - at) + Math.min(0, room - EDGE - size - Math.max(at, EDGE));
      const [left, top] = [view.x + x * view.k, view.y + y * view.k];
      moveTo(view.x + shift(left, w * view.k, view.width), view.y + shift(top, (h + BELOW) * view.k, view.height));
    },

    /** The node nearest to the middle of the stage. @param {Spot[]} spots */
    nearest(spots) {
      const away = (/** @type {Spot} */ spot) => Math.hypot(middleOf(spot).x - view.width / 2, middleOf(spot).y - view.height / 2);
      /** @type {Spot | null} */
      let best = null;
      for (const spot of spots) if (!best || away(spot) < away(best)) best = spot;
      return best && best.id;
    },

    /** The whole drawing in the middle. */
    fit() {
      const { width, height } = drawing();
      view.k = whole();
      moveTo((view.width - width * view.k) / 2, (view.height - height * view.k) / 2);
      changed();
    },
  };
}

/** @typedef {ReturnType<typeof createCamera>} Camera */
