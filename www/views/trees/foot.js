import { benchLink } from '../../ui/benchlink.js';
import { button, h, write } from '../../ui/dom.js';
import { copy, save } from '../../ui/share.js';
import { text } from '../../ui/strings.en.js';
import { benchText } from '../../ui/strings.trees.en.js';
import { readTheme } from '../../draw/theme.js';
import { LONGEST_LINK } from '../../pack.js';
import { imageOf } from './figurepicture.js';

/** @import { TreeRun } from '../../trees/run.js' */
/** @import { TreeSession } from '../../trees/session.js' */
/** @import { TreePicture } from './figurepicture.js' */

const PICTURE_SCALE = 2;

/**
 * The footer of the workbench: version, fingerprint, and everything that can be taken away.
 *
 * @param {{ pane: HTMLElement, run: TreeRun, session: TreeSession, format: (xml: string) => Promise<string>,
 *   picture: () => TreePicture | null, title: () => string,
 *   playCoach: (xml: string) => Promise<void>, say: (message: string, kind?: 'note' | 'problem', offers?: { label: string, press: () => void }[]) => void }} parts
 *   `format` gives canonical XML or rejects with the first fault, `picture` is null while there is none
 */
export function createBenchFoot({ pane, run, session, format, picture, title, playCoach, say }) {
  const fingerprint = h('output', { class: 'fingerprint', id: 'trees-fingerprint', title: text.foot.fingerprint, 'aria-label': text.foot.fingerprint });
  const coach = button(benchText.foot.coach, () => void playCoach(session.running().xml), { title: benchText.foot.coachLong });
  pane.append(
    h('p', { class: 'facts' }, h('span', {}, session.version), fingerprint, benchLink()),
    h(
      'div',
      { class: 'take', role: 'group', 'aria-label': benchText.foot.take },
      coach,
      button(text.foot.copyLink, () => void copyLink()),
      button('XML', () => void xml(), { title: benchText.foot.xml }),
      button('SVG', svg, { title: benchText.foot.svg }),
      button('PNG', () => void png(), { title: benchText.foot.png }),
      button(text.foot.video, () => void video(), { title: benchText.foot.videoLong }),
      button('JSON', json, { title: benchText.foot.json }),
      button(text.foot.cite, () => void cite(), { title: benchText.foot.citeLong }),
    ),
  );

  const name = () => session.entry()?.name ?? 'tree';
  const stem = () => `${name()}-tick${run.tick}`;
  const address = session.href;

  async function copyLink() {
    run.pause();
    const link = await address();
    if (link.length > LONGEST_LINK) say(benchText.foot.tooLong(link.length), 'problem', [{ label: text.foot.saveJson, press: json }]);
    else await give(link, benchText.foot.copied);
  }

  async function cite() {
    run.pause();
    await give(benchText.foot.citation(session.version, await address(), title(), run.tick, run.moment?.fingerprint ?? ''), text.foot.cited);
  }

  /** @param {string} string @param {string} done */
  async function give(string, done) {
    if (await copy(string)) say(done);
    else say(text.foot.notCopied(string), 'problem');
  }

  async function xml() {
    try {
      save(`${name()}.xml`, new Blob([await format(session.setup().xml)], { type: 'application/xml' }));
    } catch (error) {
      say(benchText.foot.notFormatted(error instanceof Error ? error.message : String(error)), 'problem');
    }
  }

  function svg() {
    const drawing = picture();
    if (drawing) save(`${stem()}.svg`, new Blob([drawing.svg(run.moment)], { type: 'image/svg+xml' }));
  }

  async function png() {
    const drawing = picture();
    if (!drawing) return;
    const canvas = h('canvas', { width: drawing.width * PICTURE_SCALE, height: drawing.height * PICTURE_SCALE });
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
    context.drawImage(await imageOf(drawing.svg(run.moment), drawing), 0, 0, canvas.width, canvas.height);
    canvas.toBlob((blob) => (blob ? save(`${stem()}.png`, blob) : say(benchText.foot.tooWide, 'problem')));
  }

  async function video() {
    const drawing = picture();
    if (!drawing) return;
    if (!run.moment) return say(benchText.foot.noRun);
    run.pause();
    const { xml: tree, script, mode, ms } = session.running();
    const names = run.tree?.nodes.map((node) => node.name) ?? [];
    try {
      const { filmTree } = await import('./filming.js');
      filmTree({ setup: { xml: tree, script, mode, ms }, title: title(), length: run.length, picture: drawing, names, theme: readTheme(pane), stem: name(), say });
    } catch {
      say(text.foot.videoMissing, 'problem');
    }
  }

  function json() {
    const { xml: written, script, mode, ms } = session.setup();
    const setup = { version: session.version, xml: written, script, mode, ms, length: run.length, at: run.tick };
    save(`${stem()}.json`, new Blob([JSON.stringify(setup, null, 2)], { type: 'application/json' }));
  }

  return {
    /** @param {boolean} coaches whether the tree can coach a soccer team */
    show(coaches) {
      coach.hidden = !coaches;
      write(fingerprint, run.moment?.fingerprint ?? '');
      fingerprint.dataset.tick = String(run.tick);
    },
  };
}
