import '../style/video.css';
import { createEngine } from '../engine.js';
import { messageOf } from '../session.js';
import { button, h, write } from '../ui/dom.js';
import { save } from '../ui/share.js';
import { text } from '../ui/strings.en.js';
import { videoText } from '../ui/strings.video.en.js';
import { FRAMES_PER_SECOND, framesOf, record } from '../video/record.js';

/** @import { Shot } from '../video/record.js' */

const SIZES = [480, 720, 1080];
const DEFAULT_SIZE = 720;
const DEFAULT_TICKS = 600; // where the run has not begun
const MOST_FRAMES = 18_000; // ten minutes

/**
 * Opens the dialog that films a run, with an engine of its own.
 *
 * @param {Pick<Shot, 'scenario' | 'layers' | 'theme' | 'caption'> & { tick: number, steps: number, stem: string, say: (message: string, kind?: 'note' | 'problem') => void }} parts
 *   `tick` is where the run on screen stands
 */
export function openVideo({ scenario, layers, theme, caption, tick, steps, stem, say }) {
  const field = (/** @type {string} */ label, /** @type {number} */ value, /** @type {number} */ min) => {
    const input = h('input', { type: 'number', min, max: steps, step: 1, value });
    input.addEventListener('input', show);
    return { input, element: h('label', { class: 'row' }, label, input) };
  };
  const from = field(videoText.from, 0, 0);
  const to = field(videoText.to, tick > 0 ? tick : Math.min(steps, DEFAULT_TICKS), 0);
  const every = field(videoText.every, 1, 1);
  const size = h('select', {}, ...SIZES.map((side) => h('option', { value: side, selected: side === DEFAULT_SIZE }, `${side} × ${side}`)));
  const extent = h('p', { class: 'secondary', id: 'video-extent' });
  const progress = h('progress', { value: 0, max: 1, 'aria-label': videoText.progress, hidden: true });
  const main = button(videoText.start, () => void (working ? stop() : film()), { class: 'primary' });
  const dialog = h(
    'dialog',
    { class: 'video-dialog', 'aria-labelledby': 'video-title' },
    h('h2', { id: 'video-title' }, videoText.title),
    h('p', {}, videoText.about),
    from.element,
    to.element,
    every.element,
    h('label', { class: 'row' }, videoText.size, size),
    extent,
    progress,
    h('div', { class: 'row' }, main, button(text.close, () => dialog.close())),
  );
  let broken = '';
  const engine = createEngine((message) => (broken = message), () => new Worker(new URL('../worker.js', import.meta.url), { type: 'module' }));
  let working = false;
  let wanted = true;

  /** What is asked for; null when it makes no film. */
  function range() {
    const [first, last, stride] = [from, to, every].map(({ input }) => (input.value.trim() === '' ? NaN : Number(input.value)));
    const whole = [first, last, stride].every(Number.isSafeInteger);
    return whole && first >= 0 && first <= last && last <= steps && stride >= 1 ? { from: first, to: last, every: stride } : null;
  }

  function show() {
    const asked = range();
    const frames = asked ? framesOf(asked) : 0;
    if (!asked) write(extent, videoText.noExtent(steps));
    else if (frames > MOST_FRAMES) write(extent, videoText.tooLong(frames, MOST_FRAMES));
    else write(extent, videoText.extent(frames, (frames / FRAMES_PER_SECOND).toFixed(1), FRAMES_PER_SECOND));
    main.disabled = !asked || frames > MOST_FRAMES;
  }

  async function film() {
    const asked = range();
    if (!asked) return;
    const frames = framesOf(asked);
    const shot = { ...asked, scenario, layers, theme, caption, size: Number(size.value) };
    working = wanted = true;
    write(main, videoText.stop);
    progress.hidden = false;
    progress.max = frames;
    progress.value = 0;
    try {
      engine.start();
      const film = await record(engine, shot, (done) => {
        progress.value = done;
        write(extent, videoText.done(done, frames));
        return wanted;
      });
      if (film === 'stopped') write(extent, videoText.stopped);
      else if (film === 'no encoder') write(extent, videoText.noEncoder);
      else {
        const name = `${stem}-${asked.from}-to-${asked.to}${film.ending}`;
        save(name, film.blob);
        say(videoText.saved(name, film.frames, film.codec));
        dialog.close();
      }
    } catch (error) {
      write(extent, wanted ? videoText.failed(broken || messageOf(error)) : videoText.stopped);
    } finally {
      engine.end();
      working = false;
      write(main, videoText.start);
      progress.hidden = true;
    }
  }

  function stop() {
    wanted = false;
  }

  dialog.addEventListener('close', () => {
    stop();
    dialog.remove();
  });
  document.body.append(dialog);
  show();
  dialog.showModal();
}
