import { shorten } from '../../draw/benchlayout.js';
import { createEngine } from '../../engine.js';
import { benchText } from '../../ui/strings.trees.en.js';
import { videoText } from '../../ui/strings.video.en.js';
import { momentsOf } from '../../video/record.js';
import { openVideo } from '../videodialog.js';
import { imageOf } from './figurepicture.js';

/** @import { Theme } from '../../draw/theme.js' */
/** @import { Moment, Setup } from '../../trees/types.js' */
/** @import { Extent, Picture } from '../../video/record.js' */
/** @import { Size } from '../videodialog.js' */
/** @import { TreePicture } from './figurepicture.js' */

const BENCH = 0;
const MOST_TICKS = 100_000; // that a bench computes, see `Setup`
const DEFAULT_TICKS = 20; // where nothing has run
const RATES = [1, 2, 4, 8, 15, 30]; // ticks a second, each a picture
const USUAL = 1; // as fast as the tab plays
const SIDES = [480, 720, 1080, 1440, 1920];
const FLATTEST = 3; // a drawing wider than so many heights stands in a picture of this form; so does a tall one
const TALLEST = 1 / 2;
const LETTER = 1 / 48; // height of the caption's letters, of the longer side
const SMALLEST = 12;
const BAND = 2.5; // height of the caption, in letters

/**
 * Films a run of a tree, with an engine of its own.
 *
 * @param {{ setup: Omit<Setup, 'length' | 'at'>, title: string, length: number, picture: TreePicture, names: string[], theme: Theme, stem: string,
 *   say: (message: string, kind?: 'note' | 'problem') => void }} parts `length` is how many ticks are known, `names` are those of the nodes
 */
export function filmTree({ setup, title, length, picture, names, theme, stem, say }) {
  openVideo(
    {
      about: videoText.about.trees,
      unit: 'ticks',
      perUnit: 1,
      last: MOST_TICKS,
      proposed: { from: 0, to: length > 0 ? length : DEFAULT_TICKS },
      stretches: [],
      speeds: RATES.map((rate) => ({ every: 1, rate, label: videoText.rate(rate) })),
      speed: USUAL,
      sizes: SIDES.map((side) => sizeOf(picture, side)),
      size: 2,
      stem,
      pictures,
    },
    say,
  );

  /** @param {Extent} extent @param {Size} size @param {AbortSignal} signal @returns {AsyncGenerator<Picture>} */
  async function* pictures(extent, size, signal) {
    let broken = '';
    const engine = createEngine((message) => (broken = message), () => new Worker(new URL('../../trees/worker.js', import.meta.url), { type: 'module' }));
    engine.start();
    try {
      const { opened } = await engine.request('open', { bench: BENCH, setup: { ...setup, length: extent.from, at: extent.from } });
      /** @type {Moment | null} */
      let moment = opened.moment;
      for (const tick of momentsOf(extent)) {
        if (signal.aborted || !moment) return;
        if (tick !== moment.tick) moment = (await engine.request('seek', { bench: BENCH, tick })).moment;
        if (moment?.tick !== tick) return; // no further tick can be recorded
        const image = await imageOf(picture.svg(moment), picture);
        const caption = videoText.tree(said(moment), title);
        yield (context) => paint(context, size, image, caption);
      }
    } catch (error) {
      throw broken ? new Error(broken) : error;
    } finally {
      engine.end();
    }
  }

  /** @param {Moment} moment */
  function said({ tick, root, error }) {
    if (error) return benchText.said.error(names[error.node] ?? '', error.message, tick);
    return root ? benchText.said.root(tick, root) : videoText.tick(tick);
  }

  /** @param {CanvasRenderingContext2D} context @param {Size} size @param {HTMLImageElement} image @param {string} caption */
  function paint(context, size, image, caption) {
    const letter = letterOf(size);
    const room = size.height - BAND * letter;
    const scale = Math.min(size.width / picture.width, room / picture.height);
    const [width, height] = [picture.width * scale, picture.height * scale];
    context.fillStyle = theme.ground;
    context.fillRect(0, 0, size.width, size.height);
    context.drawImage(image, (size.width - width) / 2, (room - height) / 2, width, height);
    context.font = `${letter}px ${theme.font}`;
    context.fillStyle = theme.ink;
    const words = shorten(caption, size.width - 2 * letter, (part) => context.measureText(part).width);
    context.fillText(words, letter, room + letter * 1.25);
  }
}

/** @param {Size} size */
const letterOf = ({ width, height }) => Math.max(SMALLEST, Math.round(Math.max(width, height) * LETTER));

/** A picture as large as the drawing with its caption, so that the longer side has so many pixels. @param {Size} drawing @param {number} side @returns {Size} */
function sizeOf({ width, height }, side) {
  const band = BAND * letterOf({ width: side, height: side });
  const even = (/** @type {number} */ pixels) => 2 * Math.round(pixels / 2);
  const form = Math.min(Math.max(width / height, TALLEST), FLATTEST);
  const across = Math.min(side, form * (side - band));
  return { width: even(across), height: even(across / form + band) };
}
