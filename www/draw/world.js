/** @import { Places } from './frame.js' */
/** @import { Layout, Place } from '../types.js' */
/** @import { Theme } from './theme.js' */
/** @import { Trail } from './trail.js' */

const TAU = 2 * Math.PI;
const ROBOT = 1.25; // radius of a robot's mark, arena units; within these bounds in pixels
const MIN_MARK = 3.5;
const MAX_MARK = 13; // when zoomed in, marks stay marks
const LABEL_ZOOM = 2.5;

/**
 * @typedef {object} View
 * @property {Float32Array} frame
 * @property {Places} at
 * @property {Layout} layout
 * @property {{ x: number, y: number, zoom: number }} camera centre in arena units
 * @property {number} size side of the square, CSS pixels
 * @property {Record<'robots' | 'food' | 'carried' | 'delivered' | 'trails', boolean>} layers
 * @property {Uint8Array} ringed 1 for each robot to be ringed
 * @property {Trail} trail
 */

/** Pixels per arena unit. @param {{ size: number, layout: Layout, camera: { zoom: number } }} view */
export const scaleOf = ({ size, layout, camera }) => (size * camera.zoom) / (layout.arena.half * 2 * 1.08);

/** Radius of a robot's mark in pixels. @param {number} scale */
export const markRadius = (scale) => Math.min(Math.max(MIN_MARK, ROBOT * scale), MAX_MARK);

/**
 * Draws one moment. `context` is scaled to CSS pixels.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {View} view
 * @param {Theme} theme
 */
export function drawWorld(context, view, theme) {
  const { size, camera } = view;
  const scale = scaleOf(view);
  const left = size / 2 - camera.x * scale;
  const top = size / 2 + camera.y * scale;
  context.clearRect(0, 0, size, size);
  drawArena(context, view, theme, scale, left, top);
  if (view.layers.trails) drawTrails(context, view, theme, scale, left, top);
  if (view.layers.food) drawItems(context, view, theme, scale, left, top);
  if (view.layers.robots) drawRobots(context, view, theme, scale, left, top);
}

/** @typedef {(context: CanvasRenderingContext2D, view: View, theme: Theme, scale: number, left: number, top: number) => void} Layer */

/** The edge with a mark every ten units, and the places. @type {Layer} */
function drawArena(context, { layout, layers, frame, at }, theme, scale, left, top) {
  const half = layout.arena.half;
  const reach = half * scale;
  context.lineWidth = 1;
  context.strokeStyle = theme.secondary;
  context.strokeRect(Math.round(left - reach) + 0.5, Math.round(top - reach) + 0.5, Math.round(2 * reach), Math.round(2 * reach));
  context.beginPath();
  for (let mark = -half; mark <= half; mark += 10) {
    const length = mark % 50 === 0 ? 7 : 4;
    const x = Math.round(left + mark * scale) + 0.5;
    const y = Math.round(top - mark * scale) + 0.5;
    context.moveTo(x, top + reach);
    context.lineTo(x, top + reach + length);
    context.moveTo(left - reach, y);
    context.lineTo(left - reach - length, y);
  }
  context.stroke();
  for (const place of layout.places) {
    const x = left + place.x * scale;
    const y = top - place.y * scale;
    const radius = place.radius * scale;
    context.beginPath();
    if (place.square) {
      const [[west, south], [east, north]] = place.square;
      context.rect(left + west * scale, top - north * scale, (east - west) * scale, (north - south) * scale);
    } else {
      context.arc(x, y, radius, 0, TAU);
    }
    drawPlace(context, theme, place.kind, x, y, radius);
    // Around a cell there is no ring to fill; the numbers under the picture say how much was delivered.
    if (place.kind !== sinkOf(layout) || place.square || !layers.delivered) continue;
    const share = frame[at.total] > 0 ? frame[at.delivered] / frame[at.total] : 0;
    if (share === 0) continue;
    context.beginPath();
    context.arc(x, y, radius + 4, -TAU / 4, -TAU / 4 + TAU * share);
    context.strokeStyle = itemColour(layout, theme);
    context.lineWidth = 4;
    context.stroke();
  }
}

/**
 * The middle of a place's upper edge, where its name stands, in arena units.
 *
 * @param {Place} place
 * @returns {[number, number]}
 */
export const crownOf = ({ x, y, radius, square }) => (square ? [(square[0][0] + square[1][0]) / 2, square[1][1]] : [x, y + radius]);

/** The kind of place where items belong. @param {Layout} layout */
export const sinkOf = (layout) => (layout.item === 'debris' ? 'boundary' : 'hub');

/** @param {Layout} layout @param {Theme} theme */
const itemColour = (layout, theme) => (layout.item === 'debris' ? theme.debris : theme.food);

/**
 * A place by its outline, which is the path begun: sites and the boundary dashed, obstacles filled, traps crossed out.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {Theme} theme
 * @param {string} kind
 * @param {number} x
 * @param {number} y
 * @param {number} radius pixels
 */
function drawPlace(context, theme, kind, x, y, radius) {
  if (kind === 'obstacle') {
    context.fillStyle = theme.hairline;
    context.fill();
  }
  if (kind === 'trap') {
    const reach = radius * Math.SQRT1_2;
    context.moveTo(x - reach, y - reach);
    context.lineTo(x + reach, y + reach);
    context.moveTo(x - reach, y + reach);
    context.lineTo(x + reach, y - reach);
  }
  context.setLineDash(kind === 'site' || kind === 'boundary' ? DASHED : SOLID);
  context.strokeStyle = theme.secondary;
  context.lineWidth = kind === 'hub' || kind === 'trap' ? 1.5 : 1;
  context.stroke();
  context.setLineDash(SOLID);
}

/** @type {number[]} */
const SOLID = [];
const DASHED = [4, 4];

/** @type {Layer} */
function drawItems(context, { frame, at, layout }, theme, scale, left, top) {
  const side = Math.max(3.5, 0.8 * scale);
  const outlined = layout.item === 'debris'; // purple alone is too pale on a light ground
  context.fillStyle = itemColour(layout, theme);
  context.strokeStyle = theme.ink;
  context.lineWidth = 0.75;
  for (let item = 0; item < at.items; item += 1) {
    const base = at.itemStart + item * at.itemStride;
    if (frame[base + at.itemState] !== 0) continue;
    const x = left + frame[base + at.itemX] * scale;
    const y = top - frame[base + at.itemY] * scale;
    context.fillRect(x - side / 2, y - side / 2, side, side);
    if (outlined) context.strokeRect(x - side / 2, y - side / 2, side, side);
  }
}

/** @type {Layer} */
function drawTrails(context, { trail, at }, theme, scale, left, top) {
  context.fillStyle = theme.robot;
  const size = Math.max(1.2, 0.22 * scale);
  for (let age = 1; age < trail.filled; age += 1) {
    const row = ((trail.head - 1 - age + 2 * trail.length) % trail.length) * at.agents * 2;
    context.globalAlpha = 0.5 * (1 - age / trail.length);
    for (let id = 0; id < at.agents; id += 1) {
      const x = left + trail.points[row + id * 2] * scale;
      const y = top - trail.points[row + id * 2 + 1] * scale;
      context.fillRect(x - size / 2, y - size / 2, size, size);
    }
  }
  context.globalAlpha = 1;
}

/** Discs with a notch for the heading, a dot for the load, a ring for robots that reached the chosen node. @type {Layer} */
function drawRobots(context, { frame, at, camera, ringed, layers, layout }, theme, scale, left, top) {
  const radius = markRadius(scale);
  const labelled = camera.zoom >= LABEL_ZOOM;
  context.font = `11px ${theme.font}`;
  for (let id = 0; id < at.agents; id += 1) {
    const base = at.agentStart + id * at.agentStride;
    const x = left + frame[base + at.x] * scale;
    const y = top - frame[base + at.y] * scale;
    const alive = at.alive < 0 || frame[base + at.alive] !== 0;
    context.beginPath();
    context.arc(x, y, radius, 0, TAU);
    context.fillStyle = alive ? theme.robot : theme.ground;
    context.fill();
    context.strokeStyle = alive ? theme.ground : theme.secondary;
    context.lineWidth = 1;
    context.stroke();
    drawNotch(context, theme, x, y, radius, frame[base + at.heading]);
    if (layers.carried && frame[base + at.carrying] !== 0) drawLoad(context, theme, x, y, radius);
    if (ringed[id]) {
      context.beginPath();
      context.arc(x, y, radius + 2.5, 0, TAU);
      context.strokeStyle = theme.ink;
      context.lineWidth = 1.5;
      context.stroke();
    }
    if (!labelled) continue;
    context.fillStyle = theme.ink;
    context.fillText(String(id), x + radius + 4, y - 1);
    context.fillStyle = theme.secondary;
    context.fillText(frame[base + at.action] > 0 ? layout.actions[frame[base + at.action]] : '', x + radius + 4, y + 11);
  }
}

/** @param {CanvasRenderingContext2D} context @param {Theme} theme @param {number} x @param {number} y @param {number} radius @param {number} heading */
function drawNotch(context, theme, x, y, radius, heading) {
  const along = Math.cos(heading);
  const up = Math.sin(heading);
  context.beginPath();
  context.moveTo(x + along * radius * 0.35, y - up * radius * 0.35);
  context.lineTo(x + along * radius, y - up * radius);
  context.strokeStyle = theme.ground;
  context.lineWidth = Math.max(1.25, radius * 0.24);
  context.stroke();
}

/** @param {CanvasRenderingContext2D} context @param {Theme} theme @param {number} x @param {number} y @param {number} radius */
function drawLoad(context, theme, x, y, radius) {
  context.beginPath();
  context.arc(x, y, radius * 0.56, 0, TAU);
  context.fillStyle = theme.load;
  context.fill();
  context.strokeStyle = theme.ground;
  context.lineWidth = Math.max(1, radius * 0.16);
  context.stroke();
}

/** Places with a name beside them; obstacles and traps show what they are. */
export const NAMED = new Set(['hub', 'site', 'boundary']);

/**
 * Names of the places, for pictures that leave the page; on the page they are SVG over the canvas.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {View} view
 * @param {Theme} theme
 * @param {string} caption
 */
export function drawNames(context, view, theme, caption) {
  const { size, camera, layout } = view;
  const scale = scaleOf(view);
  context.font = `13px ${theme.font}`;
  context.fillStyle = theme.ink;
  context.textAlign = 'center';
  for (const place of layout.places.filter((place) => NAMED.has(place.kind))) {
    const [x, y] = crownOf(place);
    const name = place.kind.charAt(0).toUpperCase() + place.kind.slice(1);
    context.fillText(name, size / 2 + (x - camera.x) * scale, size / 2 - (y - camera.y) * scale - 10);
  }
  context.textAlign = 'start';
  context.fillText(caption, 12, size - 8);
}
