/** @import { Form, Path, Ray, Task } from '../sequence/types.js' */
/** @import { Theme } from './theme.js' */

const TAU = 2 * Math.PI;
const NEVER = 0xffffffff; // the step after which a cell that nobody visits counts as visited
const ROBOT = 0.9; // radius of a robot's mark, metres; within these bounds in pixels
const LEAST_MARK = 3.5;
const MOST_MARK = 9;
const EVERY = 5; // steps between two points of a drawn path
const MARGIN = 0.04; // of the side, for ticks and their marks
const ROW = 6;
/** What became of an integration, as in the rows of the frontier. */
export const FATE = { open: 0, collided: 1, dropped: 2, goal: 3 };

/** @typedef {Theme & { plan: string }} PlanTheme */

/**
 * @typedef {object} Scale from map metres to pixels
 * @property {number} unit pixels a metre
 * @property {(x: number) => number} x
 * @property {(y: number) => number} y
 */

/**
 * @typedef {object} Scene everything that is drawn
 * @property {number} size side of the square, CSS pixels
 * @property {Task} task
 * @property {Path | null} path
 * @property {number} step the moment
 * @property {boolean} stale whether the path belongs to an earlier placement
 * @property {number[][]} start where robots start; others than the path's first poses while they are dragged
 * @property {Record<'plan' | 'frontier' | 'robots' | 'fan', boolean>} layers
 */

/** Where the map stands in a square. @param {Pick<Task, 'map'>} task @param {number} size @returns {Scale} */
export function scaleOf({ map: [left, right, bottom, top] }, size) {
  const unit = (size * (1 - 2 * MARGIN)) / Math.max(right - left, top - bottom);
  const dx = size / 2 - ((left + right) / 2) * unit;
  const dy = size / 2 + ((bottom + top) / 2) * unit;
  return { unit, x: (x) => dx + x * unit, y: (y) => dy - y * unit };
}

/** Radius of a robot's mark in pixels. @param {number} unit */
export const markRadius = (unit) => Math.min(Math.max(LEAST_MARK, ROBOT * unit), MOST_MARK);

/** The moment that ends an interval, or the last one of a path cut short. @param {Path} path @param {Task} task @param {number} interval */
const endOf = (path, task, interval) => Math.min((interval + 1) * task.steps, path.frames - 1);

/** The swarm's middle at a step. @param {Path} path @param {number} robots @param {number} step @returns {[number, number]} */
export function middleAt(path, robots, step) {
  let x = 0;
  let y = 0;
  for (let robot = 0; robot < robots; robot += 1) {
    const at = (step * robots + robot) * 3;
    x += path.poses[at];
    y += path.poses[at + 1];
  }
  return [x / robots, y / robots];
}

/**
 * Ground, ticks, obstacles and target.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {Scene} scene
 * @param {PlanTheme} theme
 */
export function drawMap(context, { size, task }, theme) {
  const scale = scaleOf(task, size);
  const [left, right, bottom, top] = task.map;
  context.lineWidth = 1;
  context.strokeStyle = theme.secondary;
  const box = [Math.round(scale.x(left)) + 0.5, Math.round(scale.y(top)) + 0.5, Math.round((right - left) * scale.unit), Math.round((top - bottom) * scale.unit)];
  context.strokeRect(box[0], box[1], box[2], box[3]);
  context.beginPath();
  for (let mark = Math.ceil(left / 10) * 10; mark <= right; mark += 10) {
    const x = Math.round(scale.x(mark)) + 0.5;
    context.moveTo(x, box[1] + box[3]);
    context.lineTo(x, box[1] + box[3] + (mark % 50 === 0 ? 7 : 4));
  }
  for (let mark = Math.ceil(bottom / 10) * 10; mark <= top; mark += 10) {
    const y = Math.round(scale.y(mark)) + 0.5;
    context.moveTo(box[0], y);
    context.lineTo(box[0] - (mark % 50 === 0 ? 7 : 4), y);
  }
  context.stroke();
  for (const form of task.obstacles) {
    outline(context, form, scale);
    context.fillStyle = theme.hairline;
    context.fill();
    context.strokeStyle = theme.secondary;
    context.stroke();
  }
  if (!('target' in task.goal)) return;
  const [x, y, radius] = task.goal.target;
  context.beginPath();
  context.arc(scale.x(x), scale.y(y), radius * scale.unit, 0, TAU);
  context.globalAlpha = 0.12;
  context.fillStyle = theme.food;
  context.fill();
  context.globalAlpha = 1;
  context.strokeStyle = theme.food;
  context.lineWidth = 2;
  context.setLineDash([6, 4]);
  context.stroke();
  context.setLineDash([]);
}

/** @param {CanvasRenderingContext2D} context @param {Form} form @param {Scale} scale */
function outline(context, form, scale) {
  context.beginPath();
  if ('disc' in form) {
    context.arc(scale.x(form.disc[0]), scale.y(form.disc[1]), form.disc[2] * scale.unit, 0, TAU);
    return;
  }
  const [l, b, r, t] = 'box' in form ? form.box : [0, 0, 0, 0];
  const corners = 'box' in form ? [[l, b], [r, b], [r, t], [l, t], [l, b]] : [...form.polygon, form.polygon[0]];
  corners.forEach(([x, y], index) => (index === 0 ? context.moveTo(scale.x(x), scale.y(y)) : context.lineTo(scale.x(x), scale.y(y))));
}

/**
 * Cells that were visited by the moment on screen.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {Scene} scene
 * @param {PlanTheme} theme
 */
export function drawCells(context, { size, task, path, step }, theme) {
  if (!('cells' in task.goal) || !path) return;
  const { origin, side, columns } = task.goal.cells;
  const scale = scaleOf(task, size);
  context.fillStyle = theme.food;
  context.globalAlpha = 0.3;
  const edge = side * scale.unit;
  for (let cell = 0; cell < path.visits.length; cell += 1) {
    if (path.visits[cell] === NEVER || path.visits[cell] > step) continue;
    context.fillRect(scale.x(origin[0] + (cell % columns) * side), scale.y(origin[1] + (Math.floor(cell / columns) + 1) * side), edge, edge);
  }
  context.globalAlpha = 1;
}

/**
 * The way of every robot along the plan, alternate intervals dashed, with the letter of each behaviour that moves.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {Scene} scene
 * @param {PlanTheme} theme
 */
export function drawPlan(context, { size, task, path, stale }, theme) {
  if (!path) return;
  const scale = scaleOf(task, size);
  const robots = task.start.length;
  context.strokeStyle = stale ? theme.secondary : theme.accent;
  context.lineWidth = 1;
  context.globalAlpha = stale ? 0.3 : 0.5;
  [...path.letters].forEach((_, interval) => {
    const from = interval * task.steps;
    if (from >= path.frames - 1) return;
    context.setLineDash(interval % 2 === 0 ? [] : [3, 3]);
    context.beginPath();
    for (let robot = 0; robot < robots; robot += 1) trace(context, path, robots, robot, from, endOf(path, task, interval), scale);
    context.stroke();
  });
  context.setLineDash([]);
  context.globalAlpha = 1;
}

/**
 * The letters of the plan where the swarm's middle is half way through each interval.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {Scene} scene
 * @param {PlanTheme} theme
 */
export function drawLetters(context, { size, task, path, stale }, theme) {
  if (!path || stale) return;
  const scale = scaleOf(task, size);
  const robots = task.start.length;
  context.font = `12px ${theme.font}`;
  context.textAlign = 'center';
  [...path.letters].forEach((letter, interval) => {
    const from = interval * task.steps;
    if (letter === '.' || from >= path.frames - 1) return;
    const [mx, my] = middleAt(path, robots, Math.floor((from + endOf(path, task, interval)) / 2));
    context.beginPath();
    context.arc(scale.x(mx), scale.y(my), 9, 0, TAU);
    context.fillStyle = theme.ground;
    context.globalAlpha = 0.85;
    context.fill();
    context.globalAlpha = 1;
    context.fillStyle = theme.ink;
    context.fillText(letter, scale.x(mx), scale.y(my) + 4);
  });
  context.textAlign = 'start';
}

/** @param {CanvasRenderingContext2D} context @param {Path} path @param {number} robots @param {number} robot @param {number} from @param {number} to @param {Scale} scale */
function trace(context, path, robots, robot, from, to, scale) {
  for (let step = from; ; step = Math.min(step + EVERY, to)) {
    const at = (step * robots + robot) * 3;
    const [x, y] = [scale.x(path.poses[at]), scale.y(path.poses[at + 1])];
    if (step === from) context.moveTo(x, y);
    else context.lineTo(x, y);
    if (step >= to) return;
  }
}

/** How strongly a frontier is drawn: a large one would hide what is under it. @param {number} rows */
export const strengthOf = (rows) => Math.max(0.2, Math.min(1, Math.sqrt(1000 / Math.max(rows, 1))));

/**
 * Integrations of the search as lines of the swarm's middle: open ones end in a dot, collided ones in a cross.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {{ size: number, task: Task }} scene
 * @param {PlanTheme} theme
 * @param {Float32Array} rows
 * @param {number} from first row
 * @param {number} to behind the last row
 * @param {number} [strength] of all marks, at most 1
 */
export function drawFrontier(context, { size, task }, theme, rows, from, to, strength = 1) {
  const scale = scaleOf(task, size);
  const colours = [theme.secondary, theme.secondary, theme.secondary, theme.food];
  const dark = theme.accent === theme.plan; // there the sky blue needs no outline, and lines are brighter than the ground
  const alphas = dark ? [0.2, 0.14, 0.08, 0.7] : [0.3, 0.2, 0.12, 0.8];
  context.lineWidth = 1;
  for (let row = from; row < to; row += 1) {
    const at = row * ROW;
    const fate = rows[at + 5];
    const [x, y] = [scale.x(rows[at + 2]), scale.y(rows[at + 3])];
    context.globalAlpha = alphas[fate] * strength;
    context.strokeStyle = colours[fate];
    context.beginPath();
    context.moveTo(scale.x(rows[at]), scale.y(rows[at + 1]));
    context.lineTo(x, y);
    if (fate === FATE.collided) {
      context.moveTo(x - 2.5, y - 2.5);
      context.lineTo(x + 2.5, y + 2.5);
      context.moveTo(x - 2.5, y + 2.5);
      context.lineTo(x + 2.5, y - 2.5);
    }
    context.stroke();
    if (fate !== FATE.open && fate !== FATE.goal) continue;
    context.globalAlpha = strength;
    context.beginPath();
    context.arc(x, y, 1.75, 0, TAU);
    context.fillStyle = fate === FATE.goal ? theme.food : theme.plan;
    context.fill();
    context.strokeStyle = dark ? theme.ground : theme.ink;
    context.lineWidth = 0.5;
    context.stroke();
    context.lineWidth = 1;
  }
  context.globalAlpha = 1;
}

/**
 * Replays from moved starts: the ways of the swarm's middle, and crosses where one collided.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {{ size: number, task: Task }} scene
 * @param {PlanTheme} theme
 * @param {{ rays: Ray[], middles: Float32Array }} fan
 */
export function drawFan(context, { size, task }, theme, { rays, middles }) {
  const scale = scaleOf(task, size);
  let at = 0;
  for (const { feasible, frames, hit } of rays) {
    context.beginPath();
    for (let frame = 0; frame < frames; frame += 1, at += 2) {
      if (frame === 0) context.moveTo(scale.x(middles[at]), scale.y(middles[at + 1]));
      else context.lineTo(scale.x(middles[at]), scale.y(middles[at + 1]));
    }
    context.strokeStyle = feasible ? theme.food : theme.load;
    context.setLineDash(feasible ? [] : [5, 3]);
    context.lineWidth = 1.25;
    context.globalAlpha = 0.7;
    context.stroke();
    context.setLineDash([]);
    context.globalAlpha = 1;
    if (hit) drawCross(context, theme.load, scale.x(hit[0]), scale.y(hit[1]), 4);
  }
}

/** @param {CanvasRenderingContext2D} context @param {string} colour @param {number} x @param {number} y @param {number} reach */
function drawCross(context, colour, x, y, reach) {
  context.beginPath();
  context.moveTo(x - reach, y - reach);
  context.lineTo(x + reach, y + reach);
  context.moveTo(x - reach, y + reach);
  context.lineTo(x + reach, y - reach);
  context.strokeStyle = colour;
  context.lineWidth = 2;
  context.stroke();
}

/**
 * Start poses, trails up to the moment, robots with a notch for the heading, and the cross of a collision.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {Scene} scene
 * @param {PlanTheme} theme
 */
export function drawSwarm(context, { size, task, path, step, stale, start, layers }, theme) {
  const scale = scaleOf(task, size);
  const robots = task.start.length;
  const radius = markRadius(scale.unit);
  const moving = path !== null && !stale && path.poses.length >= (step + 1) * robots * 3;
  if (!moving || step > 0) {
    context.globalAlpha = moving ? 0.55 : 1;
    for (const [x, y, heading] of start) drawRobot(context, theme, scale.x(x), scale.y(y), radius, heading, !moving);
    context.globalAlpha = 1;
  }
  if (!moving || !layers.robots) return;
  if (layers.plan && step > 0) {
    context.strokeStyle = theme.robot;
    context.lineWidth = 1.5;
    context.beginPath();
    for (let robot = 0; robot < robots; robot += 1) trace(context, path, robots, robot, 0, step, scale);
    context.stroke();
  }
  for (let robot = 0; robot < robots; robot += 1) {
    const at = (step * robots + robot) * 3;
    drawRobot(context, theme, scale.x(path.poses[at]), scale.y(path.poses[at + 1]), radius, path.poses[at + 2], true);
  }
  const { collision } = path.replay;
  if (collision && step === path.frames - 1) {
    const at = (step * robots + collision.robot) * 3;
    drawCross(context, theme.load, scale.x(path.poses[at]), scale.y(path.poses[at + 1]), radius + 5);
  }
}

/** @param {CanvasRenderingContext2D} context @param {PlanTheme} theme @param {number} x @param {number} y @param {number} radius @param {number} heading @param {boolean} filled */
function drawRobot(context, theme, x, y, radius, heading, filled) {
  context.beginPath();
  context.arc(x, y, radius, 0, TAU);
  context.fillStyle = filled ? theme.robot : theme.ground;
  context.fill();
  context.strokeStyle = filled ? theme.ground : theme.robot;
  context.lineWidth = 1;
  context.stroke();
  const [along, up] = [Math.cos(heading), Math.sin(heading)];
  context.beginPath();
  context.moveTo(x + along * radius * 0.3, y - up * radius * 0.3);
  context.lineTo(x + along * radius, y - up * radius);
  context.strokeStyle = filled ? theme.ground : theme.robot;
  context.lineWidth = Math.max(1.25, radius * 0.26);
  context.stroke();
}
