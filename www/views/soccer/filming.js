import { FRAMES_PER_SECOND as TICKS_PER_SECOND } from '../../soccer/film.js';
import { soccerText } from '../../ui/strings.soccer.en.js';
import { videoText } from '../../ui/strings.video.en.js';
import { FRAMES_PER_SECOND, momentsOf } from '../../video/record.js';
import { openVideo } from '../videodialog.js';
import { isGoal } from './marks.js';

/** @import { SoccerMatch } from '../../soccer/match.js' */
/** @import { Extent, Picture } from '../../video/record.js' */
/** @import { Size } from '../videodialog.js' */

const REAL = TICKS_PER_SECOND / FRAMES_PER_SECOND; // ticks per picture at real time
const SPEEDS = [0.5, 1, 2, 4, 8, 16].map((factor) => ({ every: factor * REAL, label: videoText.speed(factor) }));
const USUAL = 1; // real time
const NEXT_SECONDS = 30;
const GOAL = { before: 6, after: 2 }; // seconds around a goal
const WIDTHS = [480, 720, 1080, 1440];
const WAIT_MS = 40;

/**
 * Films a stretch of a match. What is not computed yet is waited for.
 *
 * @param {{ match: SoccerMatch, tick: number, ground: string, width: number, height: number, paint: (context: CanvasRenderingContext2D, tick: number) => void,
 *   stem: string, say: (message: string, kind?: 'note' | 'problem') => void }} parts `tick` is the moment on screen; `paint` draws a moment `width` wide
 */
export function filmMatch({ match, tick, ground, width, height, paint, stem, say }) {
  const { scenario } = match;
  const last = match.end();
  const within = (/** @type {number} */ at) => Math.min(Math.max(Math.round(at), 0), last);
  const from = tick < last ? tick : 0; // at full time there is nothing after the moment
  const next = { from, to: within(from + NEXT_SECONDS * TICKS_PER_SECOND) };
  const goals = match.calls.filter(isGoal);
  const goal = goals.findLast(({ frame }) => frame <= tick) ?? goals[0];
  const stretches = [{ label: videoText.next(NEXT_SECONDS), ...next }];
  if (goal) {
    const label = videoText.goal(soccerText.exact(goal.frame / TICKS_PER_SECOND));
    stretches.push({ label, from: within(goal.frame - GOAL.before * TICKS_PER_SECOND), to: within(goal.frame + GOAL.after * TICKS_PER_SECOND) });
  }
  stretches.push({ label: videoText.whole, from: 0, to: last });
  openVideo(
    {
      about: videoText.about.soccer,
      unit: 'seconds',
      perUnit: TICKS_PER_SECOND,
      last,
      proposed: next,
      stretches,
      speeds: SPEEDS,
      speed: USUAL,
      sizes: WIDTHS.map((pixels) => ({ width: pixels, height: 2 * Math.round((pixels * height) / width / 2) })),
      size: 1,
      stem,
      pictures,
    },
    say,
  );

  /** @param {Extent} extent @param {Size} size @param {AbortSignal} signal @returns {AsyncGenerator<Picture>} */
  async function* pictures(extent, size, signal) {
    for (const moment of momentsOf(extent)) {
      while (moment > match.front() && !match.over && match.scenario === scenario && !signal.aborted) await new Promise((resume) => setTimeout(resume, WAIT_MS));
      if (signal.aborted) return;
      if (match.scenario !== scenario) throw new Error(videoText.changed);
      if (moment > match.front()) return; // it was over earlier than it could have been
      yield (context) => {
        context.setTransform(size.width / width, 0, 0, size.width / width, 0, 0);
        context.fillStyle = ground;
        context.fillRect(0, 0, width, height + 1);
        paint(context, moment);
      };
    }
  }
}
