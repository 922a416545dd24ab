export const FRAMES_PER_SECOND = 30; // unless a film says otherwise
const SECONDS_BETWEEN_KEYFRAMES = 2; // so that players can jump into the middle

/**
 * @typedef {{ from: number, to: number, every: number }} Extent the moments of a run that are filmed: the first, the last, and
 *   how many lie from one picture to the next
 * @typedef {(context: CanvasRenderingContext2D) => void} Picture draws all of one picture
 * @typedef {{ width: number, height: number, rate: number, pictures: AsyncIterable<Picture> }} Shot width and height in pixels, even;
 *   `rate` in pictures a second
 * @typedef {{ blob: Blob, ending: string, frames: number, codec: string }} Film
 */

/** How many pictures an extent has, unless its run ends before. @param {Extent} extent */
export const framesOf = ({ from, to, every }) => Math.ceil((to - from) / every) + 1;

/** The moments of an extent; the last one is there whatever the distance, so that the end is seen. @param {Extent} extent */
export function* momentsOf({ from, to, every }) {
  for (let moment = from; moment < to; moment += every) yield moment;
  yield to;
}

/**
 * Films a run: each picture is a moment of its own, drawn when it has been computed, so that the timing is even however slow
 * the computer is.
 *
 * @param {Shot} shot
 * @param {AbortSignal} signal ends the work; the pictures end by themselves when it is given
 * @param {(done: number) => void} made told after each picture
 * @returns {Promise<Film | 'stopped' | 'no encoder'>} `no encoder` where the browser cannot encode video of this size
 */
export async function record({ width, height, rate, pictures }, signal, made) {
  const { BufferTarget, CanvasSource, Mp4OutputFormat, Output, QUALITY_HIGH, WebMOutputFormat, getFirstEncodableVideoCodec } = await import('mediabunny');
  const codec = 'VideoEncoder' in globalThis ? await getFirstEncodableVideoCodec(['avc', 'vp9', 'vp8', 'av1'], { width, height, bitrate: QUALITY_HIGH }) : null;
  if (!codec) return 'no encoder';
  const canvas = document.createElement('canvas');
  Object.assign(canvas, { width, height });
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  const target = new BufferTarget();
  const format = codec === 'avc' ? new Mp4OutputFormat({ fastStart: 'in-memory' }) : new WebMOutputFormat();
  const output = new Output({ format, target });
  const source = new CanvasSource(canvas, { codec, bitrate: QUALITY_HIGH, keyFrameInterval: SECONDS_BETWEEN_KEYFRAMES });
  output.addVideoTrack(source, { frameRate: rate });
  await output.start();
  let frames = 0;
  try {
    for await (const draw of pictures) {
      if (signal.aborted) break;
      draw(context);
      await source.add(frames / rate, 1 / rate); // waits while the encoder is behind
      frames += 1;
      made(frames);
    }
  } catch (error) {
    await output.cancel();
    throw error;
  }
  if (signal.aborted) {
    await output.cancel();
    return 'stopped';
  }
  await output.finalize();
  return { blob: new Blob([/** @type {ArrayBuffer} */ (target.buffer)], { type: format.mimeType }), ending: format.fileExtension, frames, codec };
}
