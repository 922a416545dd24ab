import { benchLink } from '../../ui/benchlink.js';
import { createSvgContext } from '../../draw/svgcontext.js';
import { LONGEST_LINK } from '../../pack.js';
import { planJson, trajectoriesCsv } from '../../sequence/export.js';
import { button, h } from '../../ui/dom.js';
import { copy, save } from '../../ui/share.js';
import { sequenceText } from '../../ui/strings.sequence.en.js';
import { text } from '../../ui/strings.en.js';
import { paintScene } from './map.js';

/** @import { PlanTheme } from '../../draw/sequence.js' */
/** @import { Planner } from '../../sequence/planner.js' */
/** @import { Playback } from '../../sequence/playback.js' */
/** @import { SequenceSession } from '../../sequence/session.js' */
/** @import { PlanMap } from './map.js' */

const SIDE = 800;
const PICTURE_SCALE = 2;

/**
 * The footer: version, and everything that can be taken away.
 *
 * @param {{ pane: HTMLElement, planner: Planner, playback: Playback, session: SequenceSession, map: PlanMap, theme: () => PlanTheme,
 *   say: (message: string, kind?: 'note' | 'problem', offers?: { label: string, press: () => void }[]) => void }} parts
 */
export function createSequenceFoot({ pane, planner, playback, session, map, theme, say }) {
  pane.append(
    h('p', { class: 'facts' }, h('span', {}, session.version), h('span', {}, sequenceText.foot.honest), benchLink()),
    h(
      'div',
      { class: 'take', role: 'group', 'aria-label': text.foot.take },
      button(text.foot.copyLink, () => void copyLink()),
      button('PNG', png, { title: sequenceText.foot.png }),
      button('SVG', svg, { title: sequenceText.foot.svg }),
      button(text.foot.video, () => void video(), { title: sequenceText.foot.videoLong }),
      button(sequenceText.foot.plan, plan, { title: sequenceText.foot.planLong }),
      button('CSV', csv, { title: sequenceText.foot.csv }),
      button('JSON', json, { title: sequenceText.foot.json }),
      button(text.foot.cite, () => void cite(), { title: sequenceText.foot.citeLong }),
    ),
  );

  const stem = () => `sequence-${session.preset}-seed${session.scenario.seed}`;
  const address = session.href;
  const caption = (/** @type {number} */ step) => sequenceText.foot.caption(session.preset, Number(session.scenario.seed), session.path()?.letters ?? '', step / 10);

  async function copyLink() {
    const link = await address();
    if (link.length > LONGEST_LINK) say(text.foot.tooLong(link.length), 'problem', [{ label: text.foot.saveJson, press: json }]);
    else await give(link, sequenceText.foot.copied);
  }

  async function cite() {
    const { cost = null, proven_ratio: ratio = null } = planner.progress ?? {};
    await give(sequenceText.foot.citation(session.version, await address(), session.path()?.letters ?? '', cost, ratio), text.foot.cited);
  }

  /** @param {string} string @param {string} done */
  async function give(string, done) {
    if (await copy(string)) say(done);
    else say(text.foot.notCopied(string), 'problem');
  }

  /** The picture with its caption. @param {CanvasRenderingContext2D} context */
  function paint(context) {
    map.paint(context, SIDE);
    write(context, caption(playback.step));
  }

  /** @param {CanvasRenderingContext2D} context @param {string} words */
  function write(context, words) {
    context.font = `13px ${theme().font}`;
    context.fillStyle = theme().ink;
    context.textAlign = 'start';
    context.fillText(words, 32, SIDE - 6);
  }

  function svg() {
    const context = createSvgContext(SIDE, SIDE);
    paint(/** @type {CanvasRenderingContext2D} */ (/** @type {unknown} */ (context)));
    save(`${stem()}.svg`, new Blob([context.toString(caption(playback.step), theme().ground)], { type: 'image/svg+xml' }));
  }

  function png() {
    const canvas = h('canvas', { width: SIDE * PICTURE_SCALE, height: SIDE * PICTURE_SCALE });
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
    context.scale(PICTURE_SCALE, PICTURE_SCALE);
    context.fillStyle = theme().ground;
    context.fillRect(0, 0, SIDE, SIDE);
    paint(context);
    canvas.toBlob((blob) => blob && save(`${stem()}.png`, blob));
  }

  /** Films the plan on screen; what the search still finds changes nothing of it. */
  async function video() {
    const scene = map.scene();
    if (!scene?.path || scene.stale) {
      say(sequenceText.foot.noPlan);
      return;
    }
    playback.pause();
    const letters = scene.path.letters;
    const colours = theme();
    try {
      const { filmPlan } = await import('./filming.js');
      filmPlan({
        last: scene.path.frames - 1,
        side: SIDE,
        ground: colours.ground,
        paint(context, step) {
          paintScene(context, { ...scene, size: SIDE, step }, colours, null);
          write(context, sequenceText.foot.caption(session.preset, Number(session.scenario.seed), scene.layers.plan ? letters : '', step / 10));
        },
        stem: stem(),
        say,
      });
    } catch {
      say(text.foot.videoMissing, 'problem');
    }
  }

  /** The path on screen; says so when there is none. */
  function path() {
    const now = planner.stale && session.hand === null ? null : session.path();
    if (!now || !planner.task) say(sequenceText.foot.noPlan);
    return now && planner.task ? { path: now, task: planner.task } : null;
  }

  function csv() {
    const now = path();
    if (now) save(`${stem()}.csv`, new Blob([trajectoriesCsv(now.task, now.path, 1)], { type: 'text/csv' }));
  }

  function plan() {
    const now = path();
    if (!now) return;
    const { cost = null, lower_bound = null, proven_ratio = null } = planner.progress ?? {};
    const written = planJson({ version: session.version, scenario: session.scenario, ...now, byHand: session.hand !== null, proof: { cost, lower_bound, proven_ratio } });
    save(`${stem()}-plan.json`, new Blob([written], { type: 'application/json' }));
  }

  function json() {
    save(`${stem()}.json`, new Blob([JSON.stringify(session.scenario, null, 2)], { type: 'application/json' }));
  }
}
