import '../style/video.css';
import { messageOf } from '../session.js';
import { button, h, write } from '../ui/dom.js';
import { save } from '../ui/share.js';
import { text } from '../ui/strings.en.js';
import { videoText } from '../ui/strings.video.en.js';
import { FRAMES_PER_SECOND, framesOf, record } from '../video/record.js';

/** @import { Extent, Picture } from '../video/record.js' */

const MOST_FRAMES = 18_000; // ten minutes
const DIGITS = 100; // a moment in seconds is shown to 0.01 s

/**
 * @typedef {{ width: number, height: number }} Size of a picture, even pixels
 *
 * @typedef {{ every: number, rate?: number, label: string }} Speed moments per picture, pictures a second where these are not the usual ones, and
 *   what that is called
 *
 * @typedef {object} Reel what can be filmed
 * @property {string} about one or two sentences
 * @property {'ticks' | 'seconds'} unit what the fields count
 * @property {number} perUnit moments in one of these
 * @property {number} last the last moment
 * @property {{ from: number, to: number }} proposed moments
 * @property {{ label: string, from: number, to: number }[]} stretches that a press proposes
 * @property {Speed[]} speeds where there are none, moments per picture are typed
 * @property {number} speed which of them is proposed
 * @property {Size[]} sizes
 * @property {number} size which of them is proposed
 * @property {string} stem of the file's name
 * @property {(extent: Extent, size: Size, signal: AbortSignal) => AsyncIterable<Picture>} pictures ends when the signal is given
 */

/**
 * Opens the dialog that films a run.
 *
 * @param {Reel} reel
 * @param {(message: string, kind?: 'note' | 'problem') => void} say
 */
export function openVideo({ about, unit, perUnit, last, proposed, stretches, speeds, speed: usualSpeed, sizes, size: usualSize, stem, pictures }, say) {
  const words = videoText.units[unit];
  const shown = (/** @type {number} */ moment) => String(Math.floor((moment / perUnit) * DIGITS) / DIGITS);
  const row = (/** @type {string} */ label, /** @type {HTMLInputElement | HTMLSelectElement} */ control) => {
    control.addEventListener('input', show);
    return h('label', { class: 'row' }, label, control);
  };
  const field = (/** @type {string} */ value, /** @type {number} */ min) => h('input', { type: 'number', min, max: shown(last), step: perUnit === 1 ? 1 : 'any', value });
  const from = field(shown(proposed.from), 0);
  const to = field(shown(proposed.to), 0);
  const every = field('1', 1);
  const speed = h('select', {}, ...speeds.map(({ every: stride, rate, label }, index) => h('option', { value: rate ?? stride, selected: index === usualSpeed }, label)));
  const typed = speeds.length === 0;
  const size = h('select', {}, ...sizes.map(({ width, height }, index) => h('option', { value: width, selected: index === usualSize }, `${width} × ${height}`)));
  const quick = stretches.map((stretch) =>
    button(stretch.label, () => {
      [from.value, to.value] = [shown(stretch.from), shown(stretch.to)];
      show();
    }),
  );
  const extent = h('p', { class: 'secondary', id: 'video-extent', role: 'status' });
  const progress = h('progress', { value: 0, max: 1, 'aria-label': videoText.progress, hidden: true });
  const main = button(videoText.start, () => void (work ? work.abort() : film()), { class: 'primary' });
  const rows = h('fieldset', { class: 'video-rows' }, row(words.from, from), row(words.to, to), typed ? row(videoText.every, every) : row(videoText.pace, speed), row(videoText.size, size));
  if (quick.length > 0) rows.prepend(h('div', { class: 'video-quick', role: 'group', 'aria-label': videoText.stretch }, ...quick));
  const dialog = h(
    'dialog',
    { class: 'video-dialog', 'aria-labelledby': 'video-title' },
    h('h2', { id: 'video-title' }, videoText.title),
    h('p', {}, about),
    rows,
    extent,
    progress,
    h('div', { class: 'row' }, main, button(text.close, () => dialog.close())),
  );
  /** @type {AbortController | null} while a film is made */
  let work = null;

  const rate = () => (typed ? undefined : speeds[speed.selectedIndex].rate) ?? FRAMES_PER_SECOND;

  /** What is asked for; null when it makes no film. @returns {Extent | null} */
  function range() {
    const [first, final, written] = [from, to, every].map(({ value }) => (value.trim() === '' ? NaN : Number(value)));
    const stride = typed ? written : speeds[speed.selectedIndex].every;
    const counted = [first, final].every(perUnit === 1 ? Number.isSafeInteger : Number.isFinite);
    if (!counted || !Number.isSafeInteger(stride) || stride < 1) return null;
    const asked = { from: Math.round(first * perUnit), to: Math.round(final * perUnit), every: stride };
    return asked.from >= 0 && asked.from <= asked.to && asked.to <= last ? asked : null;
  }

  function show() {
    const asked = range();
    const frames = asked ? framesOf(asked) : 0;
    if (!asked) write(extent, `${words.none(shown(last))}${typed ? videoText.oneEach : ''}.`);
    else if (frames > MOST_FRAMES) write(extent, videoText.tooLong(frames, MOST_FRAMES));
    else write(extent, videoText.extent(frames, (frames / rate()).toFixed(1), rate()));
    main.disabled = !asked || frames > MOST_FRAMES;
  }

  async function film() {
    const asked = range();
    if (!asked) return;
    const [frames, chosen] = [framesOf(asked), sizes[size.selectedIndex]];
    const mine = new AbortController();
    work = mine;
    write(main, videoText.stop);
    rows.disabled = true;
    progress.hidden = false;
    progress.max = frames;
    progress.value = 0;
    try {
      const film = await record({ ...chosen, rate: rate(), pictures: pictures(asked, chosen, mine.signal) }, mine.signal, (done) => {
        progress.value = done;
        write(extent, videoText.done(done, frames));
      });
      if (film === 'stopped') write(extent, videoText.stopped);
      else if (film === 'no encoder') write(extent, videoText.noEncoder);
      else {
        const name = `${stem}-${shown(asked.from)}-to-${shown(asked.to)}${words.ending}${film.ending}`;
        save(name, film.blob);
        say(videoText.saved(name, film.frames, film.codec));
        dialog.close();
      }
    } catch (error) {
      write(extent, mine.signal.aborted ? videoText.stopped : videoText.failed(messageOf(error)));
    } finally {
      work = null;
      write(main, videoText.start);
      rows.disabled = false;
      progress.hidden = true;
    }
  }

  dialog.addEventListener('close', () => {
    work?.abort();
    dialog.remove();
  });
  document.body.append(dialog);
  show();
  dialog.showModal();
}
