import { ASPECT, drawPitch, drawPlayers, drawTrail } from '../../draw/soccer.js';
import { h, s } from '../../ui/dom.js';

/** @import { PitchScene, PitchTheme } from '../../draw/soccer.js' */

/**
 * The pitch on a canvas, with a layer of shapes over it. Lines and walls are drawn once, on a sheet of their own.
 *
 * @param {{ label: string, scene: () => Omit<PitchScene, 'width' | 'height'> | null, theme: () => PitchTheme, drawn?: () => void }} parts
 *   `drawn` is told after every drawing
 */
export function createPitch({ label, scene, theme, drawn = () => {} }) {
  const canvas = h('canvas', { role: 'img', 'aria-label': label });
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  const still = h('canvas');
  const stillContext = /** @type {CanvasRenderingContext2D} */ (still.getContext('2d'));
  const overlay = s('svg', { class: 'overlay' });
  const stage = h('div', { class: 'pitch-stage' }, canvas, overlay);
  let asked = false;
  let pixelRatio = 0;
  const size = { width: 0, height: 0 };
  let look = ''; // what the sheet was drawn with

  function invalidate() {
    if (asked) return;
    asked = true;
    requestAnimationFrame(draw);
  }

  function draw() {
    asked = false;
    if (pixelRatio !== devicePixelRatio) resize();
    const now = scene();
    if (!now || size.width === 0) return;
    const whole = { ...now, ...size };
    const colours = theme();
    const looks = `${size.width} ${pixelRatio} ${colours.ground} ${colours.ink} ${now.exchanged}`;
    if (looks !== look) {
      look = looks;
      stillContext.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
      stillContext.clearRect(0, 0, size.width, size.height);
      drawPitch(stillContext, whole, colours);
    }
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.drawImage(still, 0, 0);
    context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
    if (now.layers.trail) drawTrail(context, whole, colours);
    drawPlayers(context, whole, colours);
    drawn();
  }

  function resize() {
    const { clientWidth, clientHeight } = stage;
    const width = Math.floor(Math.min(clientWidth, clientHeight * ASPECT));
    const height = Math.floor(width / ASPECT);
    pixelRatio = devicePixelRatio;
    Object.assign(size, { width, height });
    for (const each of [canvas, still]) {
      each.width = Math.round(width * pixelRatio);
      each.height = Math.round(height * pixelRatio);
    }
    for (const each of [canvas, overlay]) {
      each.style.width = `${width}px`;
      each.style.height = `${height}px`;
    }
    overlay.setAttribute('viewBox', `0 0 ${width} ${height}`);
    look = '';
    invalidate();
  }

  new ResizeObserver(resize).observe(stage);

  return {
    stage,
    canvas,
    overlay,
    size: () => size,
    invalidate,
  };
}

/** @typedef {ReturnType<typeof createPitch>} Pitch */
