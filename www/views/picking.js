import { agentTowards, agentsNear } from '../draw/frame.js';
import { markRadius, scaleOf } from '../draw/world.js';
import { zoomOf } from '../ui/dom.js';

/** @import { Seen } from '../lens.js' */
/** @import { Selection } from '../selection.js' */
/** @import { View } from '../draw/world.js' */

const DRAG_PIXELS = 5;
const ARROWS = new Map([
  ['ArrowLeft', [-1, 0]],
  ['ArrowRight', [1, 0]],
  ['ArrowUp', [0, 1]],
  ['ArrowDown', [0, -1]],
]);

/**
 * Choosing robots by click and by keyboard, and moving the part of the world that is shown.
 *
 * @param {{ view: View, canvas: HTMLCanvasElement, ready: () => boolean, invalidate: () => void, zoomTo: (zoom: number) => void, aim: () => void }} world
 *   `aim` brings the camera to the robot that is followed
 * @param {Seen} run
 * @param {Selection} selection
 */
export function bindPicking({ view, canvas, ready, invalidate, zoomTo, aim }, run, selection) {
  /** @type {{ x: number, y: number, moved: boolean } | null} */
  let press = null;

  canvas.addEventListener('pointerdown', (event) => {
    press = { x: event.clientX, y: event.clientY, moved: false };
  });
  canvas.addEventListener('pointermove', (event) => {
    if (!press || event.buttons === 0) return;
    const dx = event.clientX - press.x;
    const dy = event.clientY - press.y;
    if (!press.moved && Math.hypot(dx, dy) < DRAG_PIXELS) return;
    press = { x: event.clientX, y: event.clientY, moved: true };
    if (view.camera.zoom === 1 || selection.follow) return;
    const scale = scaleOf(view) * zoomOf(canvas);
    view.camera.x -= dx / scale;
    view.camera.y += dy / scale;
    invalidate();
  });
  canvas.addEventListener('pointerup', (event) => {
    if (press && !press.moved) pick(event);
    press = null;
  });
  canvas.addEventListener('pointercancel', () => {
    press = null;
  });
  canvas.addEventListener(
    'wheel',
    (event) => {
      if (!matchMedia('(min-width: 900px)').matches) return; // there the page scrolls
      event.preventDefault();
      zoomTo(view.camera.zoom * Math.exp(-event.deltaY / 400));
    },
    { passive: false },
  );
  canvas.addEventListener('keydown', (event) => {
    if (!ready() || event.ctrlKey || event.altKey || event.metaKey) return;
    const next = keyTarget(event.key);
    if (next === undefined) return;
    event.preventDefault();
    if (next !== null) selection.selectAgent(next, sharing(next));
  });

  /** The robot a key leads to; undefined for a key that is none of ours. @param {string} key */
  function keyTarget(key) {
    if (key === 'Home') return 0;
    if (key === 'End') return view.at.agents - 1;
    const direction = ARROWS.get(key);
    if (!direction) return undefined;
    if (selection.agent === null || selection.agent >= view.at.agents) return 0;
    return agentTowards(run.frame, view.at, selection.agent, direction[0], direction[1]);
  }

  /** @param {number} agent robots at the same spot */
  function sharing(agent) {
    const base = view.at.agentStart + agent * view.at.agentStride;
    const others = agentsNear(run.frame, view.at, run.frame[base + view.at.x], run.frame[base + view.at.y], 0.01);
    return others;
  }

  /** Another click on the same spot takes the next robot there. @param {PointerEvent} event */
  function pick(event) {
    if (!ready()) return;
    aim();
    const box = canvas.getBoundingClientRect();
    const scale = scaleOf(view);
    const x = view.camera.x + ((event.clientX - box.left) / zoomOf(canvas) - view.size / 2) / scale;
    const y = view.camera.y - ((event.clientY - box.top) / zoomOf(canvas) - view.size / 2) / scale;
    const reach = Math.max(markRadius(scale) + 2, event.pointerType === 'touch' ? 22 : 8) / scale;
    const under = agentsNear(run.frame, view.at, x, y, reach);
    if (under.length === 0) {
      selection.selectAgent(null);
      return;
    }
    const present = selection.agent === null ? -1 : under.indexOf(selection.agent);
    selection.selectAgent(under[(present + 1) % under.length], under);
  }
}
