/** @import { Film } from '../soccer/film.js' */
/** @import { Theme } from './theme.js' */

const TAU = 2 * Math.PI;
const ROBOT = 0.075; // side, metres
const BALL = 0.0215;
const [HALF_LENGTH, HALF_WIDTH, GOAL_BACK, GOAL_HALF] = [0.75, 0.65, 0.85, 0.2];
const [AREA_X, AREA_HALF, CIRCLE] = [0.6, 0.35, 0.2];
const ARC = { x: 0.675, radius: 0.125, half: 0.9272 };
const PENALTY_X = 0.375;
const CROSS = { x: 0.375, y: 0.4, dot: 0.2 };
const ROOM = { x: 0.9, y: 0.7 }; // what is shown, from the middle
const LEAST_BALL = 4; // pixels
const NUMBERED = 24; // pixels of a robot's side from which its number is written
const NAME = { x: 0.11, y: 0.13 }; // metres around a robot that its name needs
const TRAIL = 90; // ticks
const TRAIL_STEP = 2;

/** Width of the pitch over its height, margins included. */
export const ASPECT = ROOM.x / ROOM.y;

/** @typedef {Theme & { yellow: string, line: string }} PitchTheme `yellow` fills, `line` draws the lines of the pitch */

/**
 * @typedef {object} Scale from metres to pixels
 * @property {number} unit pixels a metre
 * @property {(x: number) => number} x
 * @property {(y: number) => number} y
 */

/**
 * @typedef {object} PitchScene everything that is drawn
 * @property {number} width CSS pixels
 * @property {number} height
 * @property {[number, number][][]} walls
 * @property {Float32Array} frame
 * @property {Film} film
 * @property {number} tick
 * @property {string[]} names of the six robots, beside them
 * @property {boolean} exchanged whether blue defends the right goal
 * @property {{ names: boolean, trail: boolean }} layers
 */

/** Where the pitch stands. @param {number} width @param {number} height @returns {Scale} */
export function pitchScale(width, height) {
  const unit = Math.min(width / (2 * ROOM.x), height / (2 * ROOM.y));
  return { unit, x: (x) => width / 2 + x * unit, y: (y) => height / 2 - y * unit };
}

/** Half of a robot's side in pixels. @param {number} unit */
export const halfSide = (unit) => (ROBOT * unit) / 2;

/** Radius of the ball in pixels: never too small to be seen. @param {number} unit */
export const ballRadius = (unit) => Math.max(LEAST_BALL, BALL * unit);

/**
 * Walls as they collide, lines, areas, marks, and whose goal it is.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {PitchScene} scene
 * @param {PitchTheme} theme
 */
export function drawPitch(context, { width, height, walls, exchanged }, theme) {
  const { unit, x, y } = pitchScale(width, height);
  for (const side of [-1, 1]) {
    context.fillStyle = (side < 0) === exchanged ? theme.yellow : theme.robot;
    context.globalAlpha = 0.28;
    context.fillRect(side < 0 ? x(-GOAL_BACK) : x(HALF_LENGTH), y(GOAL_HALF), (GOAL_BACK - HALF_LENGTH) * unit, 2 * GOAL_HALF * unit);
    context.globalAlpha = 1;
  }
  context.strokeStyle = theme.line;
  context.lineWidth = Math.max(1, 0.006 * unit);
  line(context, [[x(0), y(HALF_WIDTH)], [x(0), y(-HALF_WIDTH)]]);
  circle(context, x(0), y(0), CIRCLE * unit, 0, TAU);
  for (const side of [-1, 1]) {
    line(context, [[x(side * HALF_LENGTH), y(AREA_HALF)], [x(side * AREA_X), y(AREA_HALF)], [x(side * AREA_X), y(-AREA_HALF)], [x(side * HALF_LENGTH), y(-AREA_HALF)]]);
    line(context, [[x(side * HALF_LENGTH), y(GOAL_HALF)], [x(side * HALF_LENGTH), y(-GOAL_HALF)]]);
    const facing = side < 0 ? 0 : Math.PI;
    circle(context, x(side * ARC.x), y(0), ARC.radius * unit, facing - ARC.half, facing + ARC.half);
    cross(context, x(side * PENALTY_X), y(0), 0.012 * unit);
    for (const up of [-1, 1]) {
      const [cx, cy] = [side * CROSS.x, up * CROSS.y];
      cross(context, x(cx), y(cy), 0.02 * unit);
      context.fillStyle = theme.line;
      for (const aside of [-CROSS.dot, CROSS.dot]) disc(context, x(cx + aside), y(cy), Math.max(1.25, 0.006 * unit));
    }
  }
  context.strokeStyle = theme.ink;
  context.lineWidth = Math.max(1.5, 0.008 * unit);
  for (const wall of walls) line(context, wall.map(([wx, wy]) => [x(wx), y(wy)]));
}

/**
 * The ball's last one and a half seconds.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {PitchScene} scene
 * @param {PitchTheme} theme
 */
export function drawTrail(context, { width, height, film, tick }, theme) {
  const { unit, x, y } = pitchScale(width, height);
  context.strokeStyle = theme.running;
  context.lineWidth = Math.max(1.5, ballRadius(unit) * 0.7);
  let [fx, fy] = film.ball(tick - TRAIL);
  for (let at = tick - TRAIL + TRAIL_STEP; at <= tick; at += TRAIL_STEP) {
    const [tx, ty] = film.ball(at);
    const jumped = Math.hypot(tx - fx, ty - fy) > 0.12; // a placement: it did not roll there
    if (!jumped && at > TRAIL_STEP) {
      context.globalAlpha = 0.65 * (1 - (tick - at) / TRAIL);
      line(context, [[x(fx), y(fy)], [x(tx), y(ty)]]);
    }
    [fx, fy] = [tx, ty];
  }
  context.globalAlpha = 1;
}

/**
 * All of it, for pictures.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {PitchScene} scene
 * @param {PitchTheme} theme
 */
export function drawMatch(context, scene, theme) {
  drawPitch(context, scene, theme);
  if (scene.layers.trail) drawTrail(context, scene, theme);
  drawPlayers(context, scene, theme);
}

/**
 * Robots and ball. Blue carries a disc, yellow a diamond; the notch is the front.
 *
 * @param {CanvasRenderingContext2D} context
 * @param {PitchScene} scene
 * @param {PitchTheme} theme
 */
export function drawPlayers(context, { width, height, frame, names, layers }, theme) {
  const scale = pitchScale(width, height);
  const half = halfSide(scale.unit);
  for (let robot = 0; robot < 6; robot += 1) {
    drawRobot(context, theme, scale.x(frame[3 * robot]), scale.y(frame[3 * robot + 1]), half, frame[3 * robot + 2], robot);
  }
  context.fillStyle = theme.running;
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.25;
  context.beginPath();
  context.arc(scale.x(frame[18]), scale.y(frame[19]), ballRadius(scale.unit), 0, TAU);
  context.fill();
  context.stroke();
  if (!layers.names) return;
  names.forEach((name, robot) => {
    const [x, y] = [scale.x(frame[3 * robot]), scale.y(frame[3 * robot + 1])];
    const below = isCrowded(frame, robot, 1) && !isCrowded(frame, robot, -1);
    drawName(context, theme, x, below ? y + 1.55 * half + 9 : y - 1.55 * half, name, scale.unit);
  });
}

/** Whether something stands where a robot's name would be written. @param {Float32Array} frame @param {number} robot @param {1 | -1} side above or below it */
function isCrowded(frame, robot, side) {
  const [x, y] = [frame[3 * robot], frame[3 * robot + 1]];
  for (let other = 0; other <= 6; other += 1) {
    const up = side * (frame[3 * other + 1] - y); // the ball follows the six robots
    if (other !== robot && Math.abs(frame[3 * other] - x) < NAME.x && up > 0.02 && up < NAME.y) return true;
  }
  return false;
}

/** @param {CanvasRenderingContext2D} context @param {PitchTheme} theme @param {number} cx @param {number} cy @param {number} half @param {number} heading @param {number} robot */
function drawRobot(context, theme, cx, cy, half, heading, robot) {
  const blue = robot < 3;
  const [cos, sin] = [Math.cos(heading), Math.sin(heading)];
  // along the heading and to the left of it; y grows downwards on the screen
  const at = (/** @type {number} */ ahead, /** @type {number} */ left) => /** @type {[number, number]} */ ([cx + (ahead * cos - left * sin) * half, cy - (ahead * sin + left * cos) * half]);
  const body = [at(1, 1), at(1, 0.42), at(0.55, 0), at(1, -0.42), at(1, -1), at(-1, -1), at(-1, 1), at(1, 1)];
  context.fillStyle = blue ? theme.robot : theme.yellow;
  context.strokeStyle = theme.ink;
  context.lineWidth = Math.max(1, half * 0.09);
  path(context, body);
  context.fill();
  context.stroke();
  context.fillStyle = blue ? '#fff' : '#1c2127';
  if (blue) disc(context, ...at(-0.22, 0), half * 0.5);
  else {
    const [mx, my] = at(-0.22, 0);
    const reach = half * 0.62;
    path(context, [[mx, my - reach], [mx + reach, my], [mx, my + reach], [mx - reach, my], [mx, my - reach]]);
    context.fill();
  }
  if (2 * half < NUMBERED) return;
  const [mx, my] = at(-0.22, 0);
  context.fillStyle = blue ? '#1c2127' : '#fff';
  context.font = `600 ${Math.round(half * 0.62)}px ${theme.font}`;
  context.textAlign = 'center';
  context.fillText(String((robot % 3) + 1), mx, my + half * 0.22);
}

/** @param {CanvasRenderingContext2D} context @param {PitchTheme} theme @param {number} x @param {number} y @param {string} name @param {number} unit */
function drawName(context, theme, x, y, name, unit) {
  context.font = `600 ${unit < 320 ? 11 : 12}px ${theme.font}`;
  context.textAlign = 'center';
  context.lineWidth = 3;
  context.strokeStyle = theme.ground;
  context.strokeText?.(name, x, y); // drawings for files go without
  context.fillStyle = theme.ink;
  context.fillText(name, x, y);
}

/** @param {CanvasRenderingContext2D} context @param {number[][]} points */
function path(context, points) {
  context.beginPath();
  points.forEach(([x, y], index) => (index === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
}

/** @param {CanvasRenderingContext2D} context @param {number[][]} points */
function line(context, points) {
  path(context, points);
  context.stroke();
}

/** @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {number} radius @param {number} from @param {number} to */
function circle(context, x, y, radius, from, to) {
  context.beginPath();
  context.arc(x, y, radius, from, to);
  context.stroke();
}

/** @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {number} radius */
function disc(context, x, y, radius) {
  context.beginPath();
  context.arc(x, y, radius, 0, TAU);
  context.fill();
}

/** @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {number} reach */
function cross(context, x, y, reach) {
  line(context, [[x - reach, y], [x + reach, y]]);
  line(context, [[x, y - reach], [x, y + reach]]);
}
