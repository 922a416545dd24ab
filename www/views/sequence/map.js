import { drawCells, drawFan, drawFrontier, drawLetters, drawMap, drawPlan, drawSwarm, strengthOf } from '../../draw/sequence.js';
import { h, s, zoomOf } from '../../ui/dom.js';

/** @import { PlanTheme, Scene } from '../../draw/sequence.js' */
/** @import { Path, Ray, Task } from '../../sequence/types.js' */

/** @typedef {{ canvas: HTMLCanvasElement, context: CanvasRenderingContext2D }} Sheet */

/**
 * The map on a square canvas. What stays the same from moment to moment is drawn once on sheets of its own: the plan, and
 * the frontier, to which only new rows are added.
 *
 * @param {{ label: string, scene: () => Omit<Scene, 'size'> | null, frontier: () => { rows: Float32Array, rowCount: number },
 *   fan: () => { rays: Ray[], middles: Float32Array } | null, theme: () => PlanTheme, drawn?: () => void }} parts `drawn` is told after every drawing
 */
export function createMap({ label, scene, frontier, fan, theme, drawn = () => {} }) {
  const canvas = h('canvas', { role: 'img', 'aria-label': label });
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  const overlay = s('svg', { class: 'overlay' });
  const stage = h('div', { class: 'stage' }, canvas, overlay);
  const still = sheet();
  const ghosts = sheet();
  let asked = false;
  let pixelRatio = 0;
  let size = 0;
  let stillOf = ''; // what the sheet of the plan shows
  /** @type {Path | null} */
  let stillPath = null;
  /** @type {Task | null} */
  let stillTask = null;
  /** @type {Task | null} */
  let ghostsTask = null;
  let ghostRows = 0;
  let look = ''; // size and colours the sheets were drawn with

  const map = {
    stage,
    canvas,
    overlay,
    size: () => size,
    invalidate,
    scene,

    /** The picture as a drawing on another context. @param {CanvasRenderingContext2D} target @param {number} side */
    paint(target, side) {
      const now = scene();
      if (now) paintScene(target, { ...now, size: side }, theme(), { frontier: frontier(), fan: fan() });
    },
  };

  function invalidate() {
    if (asked) return;
    asked = true;
    requestAnimationFrame(draw);
  }

  function draw() {
    asked = false;
    const now = scene();
    if (pixelRatio !== devicePixelRatio * zoomOf(canvas)) resize();
    if (!now || size === 0) return;
    const whole = { ...now, size };
    const colours = theme();
    const looks = `${size} ${pixelRatio} ${colours.ground} ${colours.ink}`;
    if (looks !== look) {
      look = looks;
      stillOf = '';
      ghostsTask = null;
    }
    context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
    context.clearRect(0, 0, size, size);
    drawCells(context, whole, colours);
    if (now.layers.frontier) {
      drawGhosts(whole, colours);
      lay(ghosts, strengthOf(ghostRows));
    }
    drawStill(whole, colours);
    lay(still);
    const rays = now.layers.fan ? fan() : null;
    if (rays) drawFan(context, whole, colours, rays);
    drawSwarm(context, whole, colours);
    if (now.layers.plan) drawLetters(context, whole, colours);
    drawn();
  }

  /** @param {Scene} now @param {PlanTheme} colours */
  function drawStill(now, colours) {
    const key = `${now.stale} ${now.layers.plan}`;
    if (key === stillOf && now.path === stillPath && now.task === stillTask) return;
    [stillOf, stillPath, stillTask] = [key, now.path, now.task];
    clear(still);
    drawMap(still.context, now, colours);
    if (now.layers.plan) drawPlan(still.context, now, colours);
  }

  /** @param {Scene} now @param {PlanTheme} colours */
  function drawGhosts(now, colours) {
    const { rows, rowCount } = frontier();
    if (now.task !== ghostsTask || rowCount < ghostRows) {
      ghostsTask = now.task;
      ghostRows = 0;
      clear(ghosts);
    }
    drawFrontier(ghosts.context, now, colours, rows, ghostRows, rowCount);
    ghostRows = rowCount;
  }

  /** @param {Sheet} from @param {number} [strength] */
  function lay(from, strength = 1) {
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.globalAlpha = strength;
    context.drawImage(from.canvas, 0, 0);
    context.globalAlpha = 1;
    context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
  }

  /** @param {Sheet} which */
  function clear(which) {
    which.context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
    which.context.clearRect(0, 0, size, size);
  }

  function resize() {
    size = Math.floor(Math.min(stage.clientWidth, stage.clientHeight));
    pixelRatio = devicePixelRatio * zoomOf(canvas);
    for (const each of [canvas, still.canvas, ghosts.canvas]) {
      each.width = Math.round(size * pixelRatio);
      each.height = each.width;
    }
    look = '';
    overlay.setAttribute('viewBox', `0 0 ${size} ${size}`);
    invalidate();
  }

  new ResizeObserver(resize).observe(stage);
  return map;
}

/**
 * A whole scene, for pictures.
 *
 * @param {CanvasRenderingContext2D} target
 * @param {Scene} scene
 * @param {PlanTheme} theme
 * @param {{ frontier: { rows: Float32Array, rowCount: number }, fan: { rays: Ray[], middles: Float32Array } | null } | null} search
 *   what is drawn of the search where the layers are on; null for nothing
 */
export function paintScene(target, scene, theme, search) {
  const { layers } = scene;
  drawCells(target, scene, theme);
  if (search && layers.frontier) {
    const { rows, rowCount } = search.frontier;
    drawFrontier(target, scene, theme, rows, 0, rowCount, strengthOf(rowCount));
  }
  drawMap(target, scene, theme);
  if (layers.plan) drawPlan(target, scene, theme);
  if (search?.fan && layers.fan) drawFan(target, scene, theme, search.fan);
  drawSwarm(target, scene, theme);
  if (layers.plan) drawLetters(target, scene, theme);
}

/** @returns {Sheet} */
function sheet() {
  const canvas = h('canvas');
  return { canvas, context: /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d')) };
}

/** @typedef {ReturnType<typeof createMap>} PlanMap */
