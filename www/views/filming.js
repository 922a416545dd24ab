import { locate } from '../draw/frame.js';
import { createTrail } from '../draw/trail.js';
import { drawNames, drawWorld } from '../draw/world.js';
import { createEngine } from '../engine.js';
import { videoText } from '../ui/strings.video.en.js';
import { momentsOf } from '../video/record.js';
import { openVideo } from './videodialog.js';

/** @import { Theme } from '../draw/theme.js' */
/** @import { View } from '../draw/world.js' */
/** @import { FrameAnswer, Layout, Scenario } from '../types.js' */
/** @import { Extent, Picture } from '../video/record.js' */
/** @import { Size } from './videodialog.js' */

const TRAIL_LENGTH = 24;
const SIZES = [480, 720, 1080].map((side) => ({ width: side, height: side }));
const DEFAULT_TICKS = 600; // where the run has not begun

/**
 * Films a run of the swarm, with an engine of its own.
 *
 * @param {{ scenario: Scenario, layers: View['layers'], theme: Theme, caption: (tick: number) => string, tick: number, steps: number, stem: string,
 *   say: (message: string, kind?: 'note' | 'problem') => void }} parts `tick` is where the run on screen stands
 */
export function filmRun({ scenario, layers, theme, caption, tick, steps, stem, say }) {
  openVideo(
    {
      about: videoText.about.forage,
      unit: 'ticks',
      perUnit: 1,
      last: steps,
      proposed: { from: 0, to: tick > 0 ? tick : Math.min(steps, DEFAULT_TICKS) },
      stretches: [],
      speeds: [],
      speed: 0,
      sizes: SIZES,
      size: 1,
      stem,
      pictures,
    },
    say,
  );

  /** @param {Extent} extent @param {Size} size @param {AbortSignal} signal @returns {AsyncGenerator<Picture>} */
  async function* pictures(extent, { width: size }, signal) {
    let broken = '';
    const engine = createEngine((message) => (broken = message), () => new Worker(new URL('../worker.js', import.meta.url), { type: 'module' }));
    engine.start();
    try {
      /** @type {{ layout: Layout }} */
      const { layout } = await engine.request('load', { scenario: JSON.stringify(scenario), keyframes: 0 });
      const at = locate(layout);
      /** @type {View} */
      const view = { frame: new Float32Array(layout.length), at, layout, camera: { x: 0, y: 0, zoom: 1 }, size, layers, ringed: new Uint8Array(at.agents), trail: createTrail(at.agents, TRAIL_LENGTH) };
      let stands = -1;
      for (const moment of momentsOf(extent)) {
        if (signal.aborted) return;
        /** @type {FrameAnswer} */
        const answer = stands < 0 ? await engine.request('seek', { tick: moment }) : await engine.request('advance', { ticks: moment - stands, budgetMs: Infinity });
        const { tick: now } = answer;
        view.frame = new Float32Array(answer.buffer);
        view.trail.push(view.frame, at, now);
        yield (context) => {
          drawWorld(context, view, theme);
          drawNames(context, view, theme, caption(now));
          context.globalCompositeOperation = 'destination-over';
          context.fillStyle = theme.ground;
          context.fillRect(0, 0, size, size);
          context.globalCompositeOperation = 'source-over';
        };
        if (answer.finished) return;
        stands = moment;
      }
    } catch (error) {
      throw broken ? new Error(broken) : error;
    } finally {
      engine.end();
    }
  }
}
