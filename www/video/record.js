import { locate } from '../draw/frame.js';
import { createTrail } from '../draw/trail.js';
import { drawNames, drawWorld } from '../draw/world.js';

/** @import { Engine } from '../engine.js' */
/** @import { Theme } from '../draw/theme.js' */
/** @import { View } from '../draw/world.js' */
/** @import { FrameAnswer, Layout, Scenario } from '../types.js' */

export const FRAMES_PER_SECOND = 30;
const TRAIL_LENGTH = 24;
const SECONDS_BETWEEN_KEYFRAMES = 2; // so that players can jump into the middle

/**
 * @typedef {object} Shot
 * @property {Scenario} scenario
 * @property {number} from tick of the first picture
 * @property {number} to tick that no picture is behind
 * @property {number} every ticks from one picture to the next
 * @property {number} size side of the picture, pixels, even
 * @property {View['layers']} layers
 * @property {Theme} theme
 * @property {(tick: number) => string} caption
 *
 * @typedef {{ blob: Blob, ending: string, frames: number, codec: string }} Film
 */

/** How many pictures a shot has, unless its run ends before. @param {Pick<Shot, 'from' | 'to' | 'every'>} shot */
export const framesOf = ({ from, to, every }) => Math.floor((to - from) / every) + 1;

/**
 * Films a run: each picture is a tick of its own, drawn when the engine has computed it, so that the timing is even however
 * slow the computer is.
 *
 * @param {Engine} engine one of its own, started
 * @param {Shot} shot
 * @param {(done: number) => boolean} goOn told after each picture; false ends the work
 * @returns {Promise<Film | 'stopped' | 'no encoder'>} `no encoder` where the browser cannot encode video of this size
 */
export async function record(engine, shot, goOn) {
  const { BufferTarget, CanvasSource, Mp4OutputFormat, Output, QUALITY_HIGH, WebMOutputFormat, getFirstEncodableVideoCodec } = await import('mediabunny');
  const { size } = shot;
  const codec = 'VideoEncoder' in globalThis ? await getFirstEncodableVideoCodec(['avc', 'vp9', 'vp8', 'av1'], { width: size, height: size, bitrate: QUALITY_HIGH }) : null;
  if (!codec) return 'no encoder';
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = size;
  const target = new BufferTarget();
  const format = codec === 'avc' ? new Mp4OutputFormat({ fastStart: 'in-memory' }) : new WebMOutputFormat();
  const output = new Output({ format, target });
  const source = new CanvasSource(canvas, { codec, bitrate: QUALITY_HIGH, keyFrameInterval: SECONDS_BETWEEN_KEYFRAMES });
  output.addVideoTrack(source, { frameRate: FRAMES_PER_SECOND });
  await output.start();
  let frames = 0;
  for await (const draw of pictures(engine, shot)) {
    draw(/** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d')));
    await source.add(frames / FRAMES_PER_SECOND, 1 / FRAMES_PER_SECOND); // waits while the encoder is behind
    frames += 1;
    if (goOn(frames)) continue;
    await output.cancel();
    return 'stopped';
  }
  await output.finalize();
  return { blob: new Blob([/** @type {ArrayBuffer} */ (target.buffer)], { type: format.mimeType }), ending: format.fileExtension, frames, codec };
}

/** The pictures of a shot, each as what draws it. @param {Engine} engine @param {Shot} shot */
async function* pictures(engine, { scenario, from, to, every, size, layers, theme, caption }) {
  /** @type {{ layout: Layout }} */
  const { layout } = await engine.request('load', { scenario: JSON.stringify(scenario), keyframes: 0 });
  const at = locate(layout);
  /** @type {View} */
  const view = { frame: new Float32Array(layout.length), at, layout, camera: { x: 0, y: 0, zoom: 1 }, size, layers, ringed: new Uint8Array(at.agents), trail: createTrail(at.agents, TRAIL_LENGTH) };
  /** @type {FrameAnswer} */
  let answer = await engine.request('seek', { tick: from });
  for (;;) {
    view.frame = new Float32Array(answer.buffer);
    view.trail.push(view.frame, at, answer.tick);
    const { tick } = answer;
    yield (/** @type {CanvasRenderingContext2D} */ context) => {
      drawWorld(context, view, theme);
      drawNames(context, view, theme, caption(tick));
      context.globalCompositeOperation = 'destination-over';
      context.fillStyle = theme.ground;
      context.fillRect(0, 0, size, size);
      context.globalCompositeOperation = 'source-over';
    };
    if (answer.finished || tick + every > to) return;
    answer = await engine.request('advance', { ticks: every, budgetMs: Infinity });
  }
}
