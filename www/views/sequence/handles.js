import { markRadius, scaleOf } from '../../draw/sequence.js';
import { formPlace, hull, middleOf, placeOf, placed, rounded, same, things } from '../../sequence/edit.js';
import { s } from '../../ui/dom.js';
import { sequenceText } from '../../ui/strings.sequence.en.js';

/** @import { Scale } from '../../draw/sequence.js' */
/** @import { Place, Thing } from '../../sequence/edit.js' */
/** @import { Form, Scenario, Task } from '../../sequence/types.js' */
/** @import { Hold } from '../../sequence/hold.js' */
/** @import { PlanMap } from './map.js' */

const SLACK = 3; // pixels around a robot that take hold of it
const ROOM = 2.5; // metres around the start that belong to the swarm
const LEAST = 0.5; // metres: the smallest radius or side that can be drawn
const TAP = 4; // pixels that a press may move and still be one

/** @typedef {'disc' | 'box' | 'polygon'} Tool */

/**
 * What can be taken hold of on the map: shapes over the canvas, so that a finger on anything else scrolls the page.
 *
 * @param {{ map: PlanMap, hold: Hold, task: () => Task | null, tool: () => Tool | null, drawn: (form: Form) => void }} parts
 *   `drawn` gets a new obstacle
 */
export function createHandles({ map, hold, task, tool, drawn }) {
  const { overlay } = map;
  const back = s('rect', { class: 'drawing-ground', x: 0, y: 0, width: '100%', height: '100%' });
  const layer = s('g', {});
  const ring = s('g', { class: 'chosen-ring' });
  const names = s('g', { class: 'place-names' });
  const sketch = s('path', { class: 'sketch' });
  overlay.append(back, layer, ring, names, sketch);
  overlay.setAttribute('aria-hidden', 'true'); // the list beside the map holds the same things
  /** @type {[number, number][]} corners of a polygon that is being drawn */
  let corners = [];
  /** @type {[number, number] | null} where a disc or box was begun */
  let origin = null;
  /** @type {Task | null} */
  let shownTask = null;
  let shownLooks = '';

  /** @param {PointerEvent} event @param {Scale} scale @returns {[number, number]} metres */
  function pointOf(event, scale) {
    const box = map.canvas.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * map.size();
    const y = ((event.clientY - box.top) / box.height) * map.size();
    return [(x - scale.x(0)) / scale.unit, (scale.y(0) - y) / scale.unit];
  }

  /**
   * @param {SVGElement} shape
   * @param {Thing} thing
   * @param {(from: Place, dx: number, dy: number) => Partial<Place>} [change] what a drag makes of the place it began at
   */
  function bind(shape, thing, change = (from, dx, dy) => ({ x: from.x + dx, y: from.y + dy })) {
    /** @type {{ at: [number, number], scenario: Scenario, place: Place, x: number, y: number, moved: boolean } | null} */
    let drag = null;
    shape.addEventListener('pointerdown', (event) => {
      const now = task();
      if (event.button !== 0 || !now || tool() !== null) return;
      event.preventDefault();
      hold.choose(thing);
      const scenario = hold.frozen();
      const place = placeOf(scenario, thing);
      if (!place) return;
      overlay.setPointerCapture(event.pointerId); // the shape itself is made anew while it moves
      drag = { at: pointOf(event, scaleOf(now, map.size())), scenario, place, x: event.clientX, y: event.clientY, moved: false };
      const moves = (/** @type {PointerEvent} */ next) => {
        if (!drag || next.pointerId !== event.pointerId) return;
        drag.moved ||= Math.hypot(next.clientX - drag.x, next.clientY - drag.y) >= TAP;
        if (!drag.moved) return;
        const [x, y] = pointOf(next, scaleOf(now, map.size()));
        void hold.drag(placed(drag.scenario, thing, change(drag.place, x - drag.at[0], y - drag.at[1])));
      };
      const ends = (/** @type {PointerEvent} */ next) => {
        if (next.pointerId !== event.pointerId) return;
        overlay.removeEventListener('pointermove', moves);
        for (const type of ENDS) overlay.removeEventListener(type, ends);
        if (drag?.moved) void hold.drop();
        drag = null;
      };
      overlay.addEventListener('pointermove', moves);
      for (const type of ENDS) overlay.addEventListener(type, ends);
    });
  }

  // Drawing: disc and box from one press to its end, a polygon corner by corner.
  back.addEventListener('pointerdown', (event) => {
    const now = task();
    const kind = tool();
    if (event.button !== 0 || !now) return;
    if (kind === null) {
      hold.choose(null);
      return;
    }
    event.preventDefault();
    const scale = scaleOf(now, map.size());
    const [x, y] = pointOf(event, scale);
    if (kind === 'polygon') {
      const first = corners[0];
      const closes = corners.length > 2 && Math.hypot(first[0] - x, first[1] - y) * scale.unit < 12;
      if (closes) finish();
      else corners.push([rounded(x), rounded(y)]);
      showSketch(scale, null);
      return;
    }
    back.setPointerCapture(event.pointerId);
    origin = [x, y];
  });
  back.addEventListener('pointermove', (event) => {
    const now = task();
    if (!now || tool() === null) return;
    const scale = scaleOf(now, map.size());
    showSketch(scale, pointOf(event, scale));
  });
  back.addEventListener('dblclick', finish);
  for (const type of ['pointerup', 'pointercancel']) {
    back.addEventListener(type, (event) => {
      const now = task();
      const kind = tool();
      if (!origin || !now || (kind !== 'disc' && kind !== 'box')) return;
      const form = shapeOf(kind, origin, pointOf(/** @type {PointerEvent} */ (event), scaleOf(now, map.size())));
      origin = null;
      sketch.setAttribute('d', '');
      if (form && type === 'pointerup') drawn(form);
    });
  }

  /** Closes the polygon begun. */
  function finish() {
    const polygon = hull(corners);
    corners = [];
    sketch.setAttribute('d', '');
    if (polygon.length > 2) drawn({ polygon });
  }

  /** @param {Scale} scale @param {[number, number] | null} pointer */
  function showSketch(scale, pointer) {
    const kind = tool();
    const form = origin && pointer && (kind === 'disc' || kind === 'box') ? shapeOf(kind, origin, pointer) : null;
    const open = kind === 'polygon' ? [...corners, ...(pointer ? [pointer] : [])] : [];
    const path = form ? pathOf(form, scale) : open.map(([x, y], index) => `${index === 0 ? 'M' : 'L'}${scale.x(x)} ${scale.y(y)}`).join('');
    sketch.setAttribute('d', path);
  }

  return {
    finish,

    /** Forgets a drawing begun. */
    forget() {
      corners = [];
      origin = null;
      sketch.setAttribute('d', '');
    },

    /** Shapes where things stand now; those that are there stay while nothing has changed, or a press would lose them. */
    show() {
      const now = task();
      back.classList.toggle('on', tool() !== null);
      if (!now || map.size() === 0) return;
      const looks = `${map.size()} ${hold.chosen?.kind} ${hold.chosen?.index} ${hold.refusal()} ${tool()}`;
      if (now === shownTask && looks === shownLooks) return;
      [shownTask, shownLooks] = [now, looks];
      const scale = scaleOf(now, map.size());
      const start = middleOf(now.start);
      const reach = Math.max(...now.start.map(([x, y]) => Math.hypot(x - start.x, y - start.y)));
      const shapes = things(now).map((thing) => {
        const shape = shapeFor(thing, now, scale, start, reach);
        shape.classList.toggle('chosen', same(hold.chosen, thing));
        shape.classList.toggle('refused', same(hold.chosen, thing) && hold.refusal() !== '');
        bind(shape, thing);
        return shape;
      });
      layer.replaceChildren(...shapes);
      showRing(now, scale);
      const label = (/** @type {string} */ text, /** @type {number} */ x, /** @type {number} */ y) => s('text', { x: scale.x(x), y: scale.y(y) - 6, 'text-anchor': 'middle' }, text);
      names.replaceChildren(
        label(sequenceText.map.start, start.x, start.y + reach + ROOM),
        ...('target' in now.goal ? [label(sequenceText.map.target, now.goal.target[0], now.goal.target[1] + now.goal.target[2])] : []),
      );
    },
  };

  /** A grip that changes the size of what is chosen. @param {Task} now @param {Scale} scale */
  function showRing(now, scale) {
    const { chosen } = hold;
    ring.replaceChildren();
    if (!chosen || tool() !== null) return;
    /** @type {Place | null} */
    const place = chosen.kind === 'obstacle' && now.obstacles[chosen.index] ? formPlace(now.obstacles[chosen.index]) : chosen.kind === 'target' && 'target' in now.goal ? { x: now.goal.target[0], y: now.goal.target[1], radius: now.goal.target[2] } : null;
    if (!place) return;
    const { x, y, radius, width, height } = place;
    if (radius !== undefined) {
      const grip = gripAt(scale.x(x + radius), scale.y(y), 'ew');
      bind(grip, chosen, (from, dx) => ({ radius: Math.max(LEAST, rounded((from.radius ?? 0) + dx)) }));
      ring.append(grip);
    } else if (width !== undefined && height !== undefined) {
      const grip = gripAt(scale.x(x + width / 2), scale.y(y + height / 2), 'nesw');
      bind(grip, chosen, (from, dx, dy) => ({ width: Math.max(LEAST, rounded((from.width ?? 0) + 2 * dx)), height: Math.max(LEAST, rounded((from.height ?? 0) + 2 * dy)) }));
      ring.append(grip);
    }
  }
}

const ENDS = /** @type {const} */ (['pointerup', 'pointercancel']);

/** @param {number} x @param {number} y @param {string} way */
const gripAt = (x, y, way) => s('rect', { class: `grip ${way}`, x: x - 6, y: y - 6, width: 12, height: 12 });

/** @param {Thing} thing @param {Task} task @param {Scale} scale @param {{ x: number, y: number }} start @param {number} reach */
function shapeFor({ kind, index }, task, scale, start, reach) {
  const circle = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ r) => s('circle', { class: `thing ${kind}`, 'data-thing': `${kind}-${index}`, cx: scale.x(x), cy: scale.y(y), r });
  if (kind === 'swarm') return circle(start.x, start.y, (reach + ROOM) * scale.unit);
  if (kind === 'robot') return circle(task.start[index][0], task.start[index][1], markRadius(scale.unit) + SLACK);
  if (kind === 'target') {
    const [x, y, radius] = 'target' in task.goal ? task.goal.target : [0, 0, 0];
    return circle(x, y, radius * scale.unit);
  }
  return s('path', { class: `thing ${kind}`, 'data-thing': `${kind}-${index}`, d: pathOf(task.obstacles[index], scale) });
}

/** @param {Form} form @param {Scale} scale */
function pathOf(form, scale) {
  if ('disc' in form) {
    const [x, y, radius] = [scale.x(form.disc[0]), scale.y(form.disc[1]), form.disc[2] * scale.unit];
    return `M${x - radius} ${y}a${radius} ${radius} 0 1 0 ${2 * radius} 0a${radius} ${radius} 0 1 0 ${-2 * radius} 0Z`;
  }
  const corners = 'polygon' in form ? form.polygon : [[form.box[0], form.box[1]], [form.box[2], form.box[1]], [form.box[2], form.box[3]], [form.box[0], form.box[3]]];
  return `${corners.map(([x, y], at) => `${at === 0 ? 'M' : 'L'}${scale.x(x)} ${scale.y(y)}`).join('')}Z`;
}

/**
 * What a drag draws: a disc around where it began, or a box between its ends.
 *
 * @param {'disc' | 'box'} kind
 * @param {[number, number]} from
 * @param {[number, number]} to
 * @returns {Form | null} null when it is too small to be meant
 */
function shapeOf(kind, from, to) {
  if (kind === 'disc') {
    const radius = rounded(Math.hypot(to[0] - from[0], to[1] - from[1]));
    return radius < LEAST ? null : { disc: [rounded(from[0]), rounded(from[1]), radius] };
  }
  const [left, right] = [from[0], to[0]].sort((a, b) => a - b).map(rounded);
  const [bottom, top] = [from[1], to[1]].sort((a, b) => a - b).map(rounded);
  return right - left < LEAST || top - bottom < LEAST ? null : { box: [left, bottom, right, top] };
}
