import { videoText } from '../../ui/strings.video.en.js';
import { FRAMES_PER_SECOND, momentsOf } from '../../video/record.js';
import { openVideo } from '../videodialog.js';

/** @import { Extent, Picture } from '../../video/record.js' */
/** @import { Size } from '../videodialog.js' */

const STEPS_PER_SECOND = 10;
const SLOWEST = FRAMES_PER_SECOND / STEPS_PER_SECOND; // times real time, with a picture for each step
const SPEEDS = [1, 2, 3, 5, 10, 20].map((every) => ({ every, label: videoText.speed(every * SLOWEST) }));
const USUAL = 2; // as fast as the tab plays, nearly
const SIZES = [480, 720, 1080].map((side) => ({ width: side, height: side }));

/**
 * Films a plan as it is carried out.
 *
 * @param {{ last: number, side: number, ground: string, paint: (context: CanvasRenderingContext2D, step: number) => void, stem: string,
 *   say: (message: string, kind?: 'note' | 'problem') => void }} parts `last` is the plan's last step; `paint` draws a step `side` wide and high
 */
export function filmPlan({ last, side, ground, paint, stem, say }) {
  openVideo(
    {
      about: videoText.about.sequence,
      unit: 'seconds',
      perUnit: STEPS_PER_SECOND,
      last,
      proposed: { from: 0, to: last },
      stretches: [],
      speeds: SPEEDS,
      speed: USUAL,
      sizes: SIZES,
      size: 1,
      stem,
      pictures,
    },
    say,
  );

  /** @param {Extent} extent @param {Size} size @param {AbortSignal} signal @returns {AsyncGenerator<Picture>} */
  async function* pictures(extent, size, signal) {
    for (const step of momentsOf(extent)) {
      if (signal.aborted) return;
      yield (context) => {
        context.setTransform(size.width / side, 0, 0, size.width / side, 0, 0);
        context.fillStyle = ground;
        context.fillRect(0, 0, side, side);
        paint(context, step);
      };
    }
  }
}
