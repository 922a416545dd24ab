import { benchLink } from '../ui/benchlink.js';
import { button, h, write } from '../ui/dom.js';
import { text } from '../ui/strings.en.js';
import { copy, save } from '../ui/share.js';
import { LONGEST_LINK } from '../pack.js';
import { createSvgContext } from '../draw/svgcontext.js';
import { drawNames, drawWorld } from '../draw/world.js';

/** @import { Lens } from '../lens.js' */
/** @import { Run } from '../run.js' */
/** @import { State } from '../state.js' */
/** @import { Session } from '../session.js' */
/** @import { Theme } from '../draw/theme.js' */
/** @import { History } from '../types.js' */

const EVERY_MS = 500;
const PICTURE_SCALE = 2;

/**
 * The footer: what runs and how fast, and everything that can be taken away.
 *
 * @param {{ pane: HTMLElement, run: Run, lens: Lens, state: State, session: Session, theme: () => Theme, open: () => void,
 *   treeSvg: () => string | null, say: (message: string, kind?: 'note' | 'problem', offers?: { label: string, press: () => void }[]) => void }} parts
 *   pictures and files show what `lens` looks at; `open` asks for a file and opens it
 */
export function createFoot({ pane, run, lens, state, session, theme, open, treeSvg, say }) {
  const { world } = lens;
  const fingerprint = h('output', { id: 'fingerprint', title: text.foot.fingerprint, 'aria-label': text.foot.fingerprint });
  const fps = h('output', { id: 'fps', 'aria-label': text.foot.fps });
  const pace = h('output', { id: 'ms', 'aria-label': text.foot.ms });
  pane.append(
    h('p', { class: 'facts' }, h('span', { id: 'version' }, session.version), fingerprint, fps, pace, benchLink()),
    h(
      'div',
      { class: 'take', role: 'group', 'aria-label': text.foot.take },
      button(text.foot.copyLink, () => void copyLink(), { action: 'copy-link' }),
      button('PNG', png, { title: text.foot.png }),
      button(text.foot.worldSvg, worldSvg, { title: text.foot.worldSvgLong }),
      button(text.foot.video, () => void video(), { title: text.foot.videoLong }),
      button(text.foot.treeSvg, tree, { title: text.foot.treeSvgLong }),
      button('CSV', () => void csv().catch(() => {}), { title: text.foot.csv }),
      button('JSON', json, { title: text.foot.json }),
      button(text.foot.open, open, { title: text.foot.openLong }),
      button(text.foot.cite, () => void cite(), { title: text.foot.citeLong }),
    ),
  );

  const stem = () => `swarm-${session.preset}${lens.side() && `-${lens.side()}`}-seed${run.scenario.seed}-tick${run.tick}`;
  const caption = () => text.foot.caption(session.preset, lens.side(), run.scenario.seed, run.tick);
  const address = session.href;

  /** A link names one moment: while the world runs, the moment of the click. */
  async function copyLink() {
    if (state.name === 'running') await run.mark();
    const link = await address();
    if (link.length > LONGEST_LINK) say(text.foot.tooLong(link.length), 'problem', [{ label: text.foot.saveJson, press: json }]);
    else await give(link, text.foot.copied);
  }

  async function cite() {
    if (state.name === 'running') await run.mark();
    await give(text.foot.citation(session.version, await address(), run.scenario.seed, run.fingerprintTick, run.fingerprint), text.foot.cited);
  }

  /** @param {string} string @param {string} done */
  async function give(string, done) {
    if (await copy(string)) say(done);
    else say(text.foot.notCopied(string), 'problem');
  }

  function worldSvg() {
    if (!world().ready()) return;
    const { view } = world();
    const context = createSvgContext(view.size, view.size);
    const canvas = /** @type {CanvasRenderingContext2D} */ (/** @type {unknown} */ (context));
    drawWorld(canvas, view, theme());
    drawNames(canvas, view, theme(), caption());
    save(`${stem()}.svg`, new Blob([context.toString(caption(), theme().ground)], { type: 'image/svg+xml' }));
  }

  function png() {
    if (!world().ready()) return;
    const { view } = world();
    const canvas = h('canvas', { width: view.size * PICTURE_SCALE, height: view.size * PICTURE_SCALE });
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
    context.scale(PICTURE_SCALE, PICTURE_SCALE);
    drawWorld(context, view, theme());
    drawNames(context, view, theme(), caption());
    context.globalCompositeOperation = 'destination-over';
    context.fillStyle = theme().ground;
    context.fillRect(0, 0, view.size, view.size);
    canvas.toBlob((blob) => blob && save(`${stem()}.png`, blob));
  }

  async function video() {
    if (!world().ready()) return;
    const { layers } = world().view;
    const { scenario, tick } = lens.run;
    const parts = { scenario, tick, layers: { ...layers }, theme: theme(), steps: run.steps, stem: `swarm-${session.preset}-seed${scenario.seed}` };
    const at = (/** @type {number} */ now) => text.foot.caption(session.preset, lens.side(), scenario.seed, now);
    try {
      (await import('./filming.js')).filmRun({ ...parts, caption: at, say });
    } catch {
      say(text.foot.videoMissing, 'problem');
    }
  }

  function tree() {
    const drawing = treeSvg();
    if (drawing) save(`${stem()}-tree.svg`, new Blob([drawing], { type: 'image/svg+xml' }));
    else say(text.foot.noTree);
  }

  async function csv() {
    /** @type {History} */
    const history = (await lens.engine.request('history', { from: 0 })).history;
    const rows = history.delivered.map((delivered, index) =>
      [(history.from + index) * history.every, delivered, history.carrying[index], history.programs[index], history.swaps[index]].join(','),
    );
    save(`${stem()}.csv`, new Blob([['tick,delivered,carrying,programs,swaps', ...rows, ''].join('\n')], { type: 'text/csv' }));
  }

  function json() {
    save(`${stem()}.json`, new Blob([JSON.stringify(lens.run.scenario, null, 2)], { type: 'application/json' }));
  }

  function showFingerprint() {
    write(fingerprint, run.fingerprint);
    fingerprint.dataset.tick = String(run.fingerprintTick);
    fingerprint.classList.toggle('past', run.fingerprintTick !== run.tick);
  }

  let beats = 0;
  let since = performance.now();

  /** Called after each drawing; writes twice a second how fast the page keeps up. */
  function drew() {
    const now = performance.now();
    if (now - since < EVERY_MS) return;
    write(fps, state.name === 'running' ? text.foot.framesPerSecond(Math.round(((run.beats - beats) * 1000) / (now - since))) : '');
    write(pace, run.msPerTick > 0 ? text.foot.msPerTick(run.msPerTick) : '');
    beats = run.beats;
    since = now;
    showFingerprint();
  }

  run.on('settled', showFingerprint);
  run.on('scenario', showFingerprint);
  return { drew };
}
