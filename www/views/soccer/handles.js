import { ballRadius, halfSide, pitchScale } from '../../draw/soccer.js';
import { BALL, thingName } from '../../soccer/hold.js';
import { s } from '../../ui/dom.js';

/** @import { SoccerHold } from '../../soccer/hold.js' */
/** @import { Pitch } from './pitch.js' */

const TAP = 4; // pixels a pointer may move before it drags
const LEAST = 13; // half of what a finger can take hold of
const STEP = 0.01; // metres
const TURN = 15; // degrees
const ENDS = /** @type {const} */ (['pointerup', 'pointercancel']);

/**
 * Shapes over robots and ball by which they are taken hold of, and the keys that do the same.
 *
 * @param {{ pitch: Pitch, hold: SoccerHold, frame: () => Float32Array | null, may: () => boolean, clear: () => void }} parts
 *   `frame` is what is on screen, `may` whether anything can be moved now
 */
export function createHandles({ pitch, hold, frame, may, clear }) {
  const shapes = Array.from({ length: BALL + 1 }, (_, thing) => {
    const shape = s('circle', { class: 'thing', 'data-thing': thing, r: 0 }, s('title', {}, thingName(thing)));
    bind(shape, thing);
    return shape;
  });
  pitch.overlay.append(...shapes);

  /** @param {SVGCircleElement} shape @param {number} thing */
  function bind(shape, thing) {
    shape.addEventListener('pointerdown', (event) => {
      if (event.button !== 0 || !may()) return;
      event.preventDefault();
      pitch.canvas.focus({ preventScroll: true });
      hold.choose(thing);
      const from = hold.place();
      if (!from) return;
      pitch.overlay.setPointerCapture(event.pointerId);
      const { unit } = pitchScale(pitch.size().width, pitch.size().height);
      let dragging = false;
      const moves = (/** @type {PointerEvent} */ next) => {
        if (next.pointerId !== event.pointerId) return;
        const [dx, dy] = [next.clientX - event.clientX, next.clientY - event.clientY];
        dragging ||= Math.hypot(dx, dy) >= TAP;
        if (dragging) hold.drag({ ...from, x: from.x + dx / unit, y: from.y - dy / unit });
      };
      const ends = (/** @type {PointerEvent} */ next) => {
        if (next.pointerId !== event.pointerId) return;
        pitch.overlay.removeEventListener('pointermove', moves);
        for (const type of ENDS) pitch.overlay.removeEventListener(type, ends);
        if (dragging) void hold.drop();
      };
      pitch.overlay.addEventListener('pointermove', moves);
      for (const type of ENDS) pitch.overlay.addEventListener(type, ends);
    });
  }

  pitch.canvas.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || !may()) return;
    const step = event.shiftKey ? STEP / 5 : STEP;
    /** @type {Record<string, () => void>} */
    const keys = {
      PageUp: () => hold.step(-1),
      PageDown: () => hold.step(1),
      Home: () => hold.step('first'),
      End: () => hold.step('last'),
      ArrowLeft: () => hold.nudge(-step, 0),
      ArrowRight: () => hold.nudge(step, 0),
      ArrowUp: () => hold.nudge(0, step),
      ArrowDown: () => hold.nudge(0, -step),
      '[': () => hold.nudge(0, 0, TURN),
      ']': () => hold.nudge(0, 0, -TURN),
      Escape: clear,
    };
    if (!keys[event.key]) return;
    event.preventDefault();
    event.stopPropagation();
    keys[event.key]();
  });

  return {
    /** Puts the shapes where things stand now. */
    show() {
      const now = frame();
      const { width, height } = pitch.size();
      pitch.overlay.classList.toggle('idle', !may());
      if (!now || width === 0) return;
      const scale = pitchScale(width, height);
      shapes.forEach((shape, thing) => {
        const at = thing === BALL ? 18 : 3 * thing;
        shape.setAttribute('cx', String(scale.x(now[at])));
        shape.setAttribute('cy', String(scale.y(now[at + 1])));
        shape.setAttribute('r', String(Math.max(LEAST, thing === BALL ? ballRadius(scale.unit) + 5 : 1.45 * halfSide(scale.unit))));
        shape.classList.toggle('chosen', hold.chosen === thing);
        shape.classList.toggle('refused', hold.chosen === thing && hold.refusal !== '');
      });
    },
  };
}
