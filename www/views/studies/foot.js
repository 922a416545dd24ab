import { benchLink } from '../../ui/benchlink.js';
import { button, h } from '../../ui/dom.js';
import { copy, save } from '../../ui/share.js';
import { text as page } from '../../ui/strings.en.js';
import { studiesText as text } from '../../ui/strings.studies.en.js';
import { LONGEST_LINK } from '../../pack.js';

/** @import { StudyRun } from '../../studies/run.js' */
/** @import { StudySession } from '../../studies/session.js' */
/** @import { Reported } from '../../studies/types.js' */

const PICTURE_SCALE = 2;

/**
 * The footer of a study: version and hash, and everything that can be taken away.
 *
 * @param {{ pane: HTMLElement, run: StudyRun, session: StudySession, shown: () => Promise<Reported | null>, origin: () => { spec: string, hash: string },
 *   say: (message: string, kind?: 'note' | 'problem') => void }} parts `shown` gives the results on screen, `origin` the study they were made from
 */
export function createStudyFoot({ pane, run, session, shown, origin, say }) {
  const facts = h('p', { class: 'facts' });
  const clear = button(text.clear.do, () => void run.clear(), { title: text.clear.long });
  pane.append(
    facts,
    h(
      'div',
      { class: 'take', role: 'group', 'aria-label': text.foot.take },
      clear,
      button(page.foot.copyLink, () => void copyLink()),
      button('CSV', () => void take(({ results }) => file('csv', results, 'text/csv')), { title: text.foot.csv }),
      button(text.foot.spec, () => file('study.json', run.complete(), 'application/json'), { title: text.foot.specLong }),
      button(text.foot.report, () => void take(({ markdown }) => file('md', markdown, 'text/markdown')), { title: text.foot.reportLong }),
      button('SVG', () => void picture(svg), { title: text.foot.svg }),
      button('PNG', () => void picture(png), { title: text.foot.png }),
      button('ZIP', () => void take((reported) => void zip(reported)), { title: text.foot.zip }),
    ),
  );

  const stem = () => `${session.outline?.name ?? 'study'}${session.size === 'paper' ? '' : `-${session.size}`}`;

  /** @param {string} ending @param {string} content @param {string} type */
  function file(ending, content, type) {
    save(`${stem()}.${ending}`, new Blob([content], { type }));
  }

  /** @param {(reported: Reported) => void} give */
  async function take(give) {
    const reported = await shown();
    if (reported) give(reported);
    else say(text.foot.nothing);
  }

  /** @param {(figure: string) => void} give */
  async function picture(give) {
    const figure = (await shown())?.figure;
    if (figure) give(figure);
    else say(text.foot.noFigure);
  }

  /** @param {string} figure */
  const svg = (figure) => file('svg', figure, 'image/svg+xml');

  /** @param {string} figure */
  async function png(figure) {
    const address = URL.createObjectURL(new Blob([figure], { type: 'image/svg+xml' }));
    try {
      const image = h('img', { src: address });
      image.style.colorScheme = 'light';
      await image.decode();
      const canvas = h('canvas', { width: image.naturalWidth * PICTURE_SCALE, height: image.naturalHeight * PICTURE_SCALE });
      /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d')).drawImage(image, 0, 0, canvas.width, canvas.height);
      canvas.toBlob((blob) => blob && save(`${session.outline?.name ?? 'study'}.png`, blob));
    } finally {
      URL.revokeObjectURL(address);
    }
  }

  /** The whole study: what was asked, every row, report, figure, and how to cite it. @param {Reported} reported */
  async function zip({ results, markdown, figure }) {
    try {
      const { strToU8, zipSync } = await import('fflate');
      const { name = 'study', title = '' } = session.outline ?? {};
      const { spec, hash } = origin();
      const citation = text.foot.citation(name, title || name, session.version, hash, await address());
      const files = { [`${name}.study.json`]: spec, [`${name}.csv`]: results, [`${name}.md`]: markdown, ...(figure && { [`${name}.svg`]: figure }), 'CITATION.txt': citation };
      // The same study gives the same bytes: no file carries the time of the click.
      const packed = zipSync(Object.fromEntries(Object.entries(files).map(([path, content]) => [path, strToU8(content)])), { mtime: new Date(1980, 0, 1) });
      save(`${stem()}.zip`, new Blob([new Uint8Array(packed)], { type: 'application/zip' }));
    } catch {
      say(text.foot.zipMissing, 'problem');
    }
  }

  const address = session.href;

  async function copyLink() {
    const link = await address();
    if (link.length > LONGEST_LINK) say(text.foot.tooLong(link.length), 'problem');
    else say((await copy(link)) ? text.foot.copied : page.foot.notCopied(link));
  }

  function show() {
    const { plan } = run;
    facts.replaceChildren(...(plan ? [h('span', {}, session.version), h('span', { class: 'hash' }, plan.hash)] : []), benchLink());
    clear.disabled = run.done() === 0;
  }

  run.on('plan', show);
  run.on('progress', show);
}
