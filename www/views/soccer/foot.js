import { ASPECT, drawMatch } from '../../draw/soccer.js';
import { createSvgContext } from '../../draw/svgcontext.js';
import { LONGEST_LINK } from '../../pack.js';
import { logCsv, logJson, posesCsv } from '../../soccer/export.js';
import { button, h, write } from '../../ui/dom.js';
import { copy, save } from '../../ui/share.js';
import { soccerText } from '../../ui/strings.soccer.en.js';
import { text } from '../../ui/strings.en.js';

/** @import { PitchScene, PitchTheme } from '../../draw/soccer.js' */
/** @import { SoccerCompare } from '../../soccer/compare.js' */
/** @import { SoccerMatch } from '../../soccer/match.js' */
/** @import { SoccerPlayback } from '../../soccer/playback.js' */
/** @import { SoccerSession } from '../../soccer/session.js' */

const WIDTH = 900;
const CAPTION = 28;
const HEIGHT = Math.round(WIDTH / ASPECT) + CAPTION;
const PICTURE_SCALE = 2;
const words = soccerText.foot;

/**
 * The footer: version, fingerprint, and everything that can be taken away.
 *
 * @param {{ pane: HTMLElement, match: SoccerMatch, playback: SoccerPlayback, session: SoccerSession, theme: () => PitchTheme, names: () => string[],
 *   scene: (tick: number) => Omit<PitchScene, 'width' | 'height'> | null, beside: () => SoccerCompare | null, still: () => Promise<void>,
 *   say: (message: string, kind?: 'note' | 'problem', offers?: { label: string, press: () => void }[]) => void }} parts
 *   `scene` is what is drawn of a moment, `beside` is A | B while it is open, `still` ends what somebody does to the match by hand
 */
export function createSoccerFoot({ pane, match, playback, session, theme, names, scene, beside, still, say }) {
  const fingerprint = h('output', { class: 'fingerprint', id: 'soccer-fingerprint', title: words.fingerprint, 'aria-label': words.fingerprint });
  pane.append(
    h('p', { class: 'facts' }, h('span', {}, session.version), fingerprint),
    h(
      'div',
      { class: 'take', role: 'group', 'aria-label': text.foot.take },
      button(text.foot.copyLink, () => void copyLink()),
      button('PNG', png, { title: words.png }),
      button('SVG', svg, { title: words.svg }),
      button(text.foot.video, () => void video(), { title: words.videoLong }),
      button(words.log, log, { title: words.logLong }),
      button(words.logCsv, logAsCsv, { title: words.logCsvLong }),
      button(words.csv, poses, { title: words.csvLong }),
      button('JSON', json, { title: words.json }),
      button(text.foot.cite, () => void cite(), { title: words.citeLong }),
    ),
  );

  const stem = () => `${session.preset}-seed${session.scenario().seed}`;
  const address = session.href;
  const caption = (/** @type {number} */ tick) => {
    const { phase, seconds } = match.film.clock(tick);
    const [blue, yellow] = names();
    return words.caption(blue, yellow, Number(session.scenario().seed), soccerText.board.time(phase, seconds), match.film.goals(tick));
  };

  async function copyLink() {
    const link = await address();
    if (link.length > LONGEST_LINK) say(words.tooLong(link.length), 'problem', [{ label: text.foot.saveJson, press: json }]);
    else await give(link, words.copied);
  }

  async function cite() {
    await give(words.citation(session.version, await address(), Number(session.scenario().seed), match.fingerprint), text.foot.cited);
  }

  /** @param {string} string @param {string} done */
  async function give(string, done) {
    if (await copy(string)) say(done);
    else say(text.foot.notCopied(string), 'problem');
  }

  /** The picture of a moment with its caption. @param {CanvasRenderingContext2D} context @param {number} tick */
  function paint(context, tick) {
    const now = scene(tick);
    if (now) drawMatch(context, { ...now, width: WIDTH, height: WIDTH / ASPECT }, theme());
    context.font = `13px ${theme().font}`;
    context.fillStyle = theme().ink;
    context.textAlign = 'start';
    context.fillText(caption(tick), 24, WIDTH / ASPECT + CAPTION / 2);
  }

  function svg() {
    const context = createSvgContext(WIDTH, HEIGHT);
    paint(/** @type {CanvasRenderingContext2D} */ (/** @type {unknown} */ (context)), playback.tick);
    save(`${stem()}-tick${playback.tick}.svg`, new Blob([context.toString(caption(playback.tick), theme().ground)], { type: 'image/svg+xml' }));
  }

  function png() {
    const canvas = h('canvas', { width: WIDTH * PICTURE_SCALE, height: HEIGHT * PICTURE_SCALE });
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
    context.scale(PICTURE_SCALE, PICTURE_SCALE);
    context.fillStyle = theme().ground;
    context.fillRect(0, 0, WIDTH, HEIGHT);
    paint(context, playback.tick);
    canvas.toBlob((blob) => blob && save(`${stem()}-tick${playback.tick}.png`, blob));
  }

  async function video() {
    if (!scene(playback.tick)) return;
    playback.pause();
    await still();
    const both = beside();
    if (both?.matches.some(({ film }) => film.count === 0)) return say(soccerText.compare.soon);
    const parts = { tick: playback.tick, ground: theme().ground, say };
    try {
      const { filmMatches } = await import('./filming.js');
      if (!both) return filmMatches({ ...parts, matches: [match], width: WIDTH, height: HEIGHT, paint, stem: stem() });
      const picture = await import('./bothpicture.js');
      const colours = theme();
      filmMatches({
        ...parts,
        matches: both.matches,
        width: picture.WIDTH,
        height: picture.HEIGHT,
        paint: (context, tick) => picture.paintBoth(context, both.halves(tick), colours),
        stem: `${stem()}-a-b`,
      });
    } catch {
      say(text.foot.videoMissing, 'problem');
    }
  }

  /** Says so when the match is not whole yet. */
  function whole() {
    if (!match.over) say(words.partial);
  }

  function log() {
    whole();
    save(`${stem()}-log.json`, new Blob([logJson(session.version, session.scenario(), match)], { type: 'application/json' }));
  }

  function logAsCsv() {
    whole();
    save(`${stem()}-log.csv`, new Blob([logCsv(match)], { type: 'text/csv' }));
  }

  function poses() {
    whole();
    save(`${stem()}-poses.csv`, new Blob([posesCsv(match, session.setting.roles)], { type: 'text/csv' }));
  }

  function json() {
    save(`${stem()}.json`, new Blob([JSON.stringify(session.scenario(), null, 2)], { type: 'application/json' }));
  }

  return {
    show() {
      write(fingerprint, match.over ? match.fingerprint : soccerText.state.computing(match.front() / 60));
      fingerprint.dataset.whole = match.over ? 'true' : '';
    },
  };
}
