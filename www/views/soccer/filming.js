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
const ALONE = 1; // which of them is proposed for a pitch
const BESIDE = 2; // and for two
const WAIT_MS = 40;

/**
 * Films a stretch of a match, or of two beside each other. What is not computed yet is waited for; one that ends before the other stands still.
 *
 * @param {{ matches: SoccerMatch[], tick: number, ground: string, width: number, height: number, paint: (context: CanvasRenderingContext2D, tick: number) => void,
 *   stem: string, say: (message: string, kind?: 'note' | 'problem') => void }} parts `tick` is the moment on screen; `paint` draws a moment `width` wide
 */
export function filmMatches({ matches, tick, ground, width, height, paint, stem, say }) {
  const scenarios = matches.map(({ scenario }) => scenario);
  const changed = () => matches.some(({ scenario }, index) => scenario !== scenarios[index]);
  const last = Math.max(...matches.map((match) => match.end()));
  const within = (/** @type {number} */ at) => Math.min(Math.max(Math.round(at), 0), last);
  const from = tick < last ? tick : 0; // at full time there is nothing after the moment
  const next = { from, to: within(from + NEXT_SECONDS * TICKS_PER_SECOND) };
  const goals = matches.flatMap(({ calls }) => calls.filter(isGoal)).sort((a, b) => a.frame - b.frame);
  const goal = goals.findLast(({ frame }) => frame <= tick) ?? goals[0];
  const stretches = [{ label: videoText.next(NEXT_SECONDS), ...next }];
  if (goal) {
    const label = videoText.goal(soccerText.exact(goal.frame / TICKS_PER_SECOND));
    stretches.push({ label, from: within(goal.frame - GOAL.before * TICKS_PER_SECOND), to: within(goal.frame + GOAL.after * TICKS_PER_SECOND) });
  }
  stretches.push({ label: videoText.whole, from: 0, to: last });
  openVideo(
    {
      about: matches.length > 1 ? videoText.about.beside : videoText.about.soccer,
      unit: 'seconds',
      perUnit: TICKS_PER_SECOND,
      last,
      proposed: next,
      stretches,
      speeds: SPEEDS,
      speed: USUAL,
      sizes: WIDTHS.map((pixels) => ({ width: pixels, height: 2 * Math.round((pixels * height) / width / 2) })),
      size: matches.length > 1 ? BESIDE : ALONE,
      stem,
      pictures,
    },
    say,
  );

  /** @param {Extent} extent @param {Size} size @param {AbortSignal} signal @returns {AsyncGenerator<Picture>} */
  async function* pictures(extent, size, signal) {
    for (const moment of momentsOf(extent)) {
      while (matches.some((match) => moment > match.front() && !match.over) && !changed() && !signal.aborted) await new Promise((resume) => setTimeout(resume, WAIT_MS));
      if (signal.aborted) return;
      if (changed()) throw new Error(videoText.changed);
      if (matches.every((match) => moment > match.front())) return; // over earlier than it could have been
      yield (context) => {
        context.setTransform(size.width / width, 0, 0, size.width / width, 0, 0);
        context.fillStyle = ground;
        context.fillRect(0, 0, width, height + 1);
        paint(context, moment);
      };
    }
  }
}
