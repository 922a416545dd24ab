import { handWords } from '../../sequence/words.js';
import { button, h, write } from '../../ui/dom.js';
import { sequenceText } from '../../ui/strings.sequence.en.js';

/** @import { Planner } from '../../sequence/planner.js' */
/** @import { Playback } from '../../sequence/playback.js' */
/** @import { SequenceSession } from '../../sequence/session.js' */
/** @import { Path } from '../../sequence/types.js' */

/**
 * The plan as a ribbon, a cell for each interval. A press goes to its start; another behaviour can be chosen for it, and
 * the beginning up to it kept while the rest is planned.
 *
 * @param {{ planner: Planner, playback: Playback, session: SequenceSession, announce: (message: string) => void }} parts
 */
export function createRibbon({ planner, playback, session, announce }) {
  const strip = h('div', { class: 'ribbon', role: 'toolbar', 'aria-label': sequenceText.ribbon.label });
  const where = h('span', { class: 'ribbon-where' });
  const choice = h('select', { id: 'sequence-behaviour' });
  const lock = button('', toggleLock, { title: sequenceText.ribbon.lockLong });
  lock.id = 'sequence-lock';
  const own = h('p', { class: 'ribbon-said', id: 'sequence-hand' });
  const back = button(sequenceText.ribbon.back, () => void session.byHand(null), { class: 'quiet' });
  back.id = 'sequence-back';
  const edit = h('div', { class: 'ribbon-edit' }, h('label', { for: choice.id }, where), choice, lock, own, back);
  const empty = h('p', { class: 'ribbon-empty' });
  const element = h('div', { class: 'ribbon-pane' }, strip, empty, edit);
  let chosen = 0;
  /** @type {Path | null} */
  let shown = null;
  let library = '';

  choice.addEventListener('change', () => change(choice.value));
  strip.addEventListener('keydown', (event) => {
    const last = strip.children.length - 1;
    const to = { ArrowRight: chosen + 1, ArrowLeft: chosen - 1, Home: 0, End: last }[event.key];
    const turn = { ArrowUp: -1, ArrowDown: 1 }[event.key];
    if (to !== undefined) go(Math.min(Math.max(to, 0), last), true);
    else if (turn !== undefined && shown) {
      const letters = (planner.task?.library ?? []).map(({ letter }) => letter);
      const at = letters.indexOf([...shown.letters][chosen]);
      change(letters[(at + turn + letters.length) % letters.length]);
    } else return;
    event.preventDefault();
    event.stopPropagation();
  });

  /** @param {number} interval @param {boolean} [focus] */
  function go(interval, focus = false) {
    chosen = interval;
    playback.pause();
    playback.seek(interval * (planner.task?.steps ?? 0));
    show();
    if (focus) /** @type {HTMLElement} */ (strip.children[interval])?.focus();
  }

  /** @param {string} letter */
  function change(letter) {
    const path = session.path();
    if (!path || !letter) return;
    const letters = [...path.letters];
    if (letters[chosen] === letter) return;
    letters[chosen] = letter;
    playback.pause();
    void session.byHand(letters.join(''));
  }

  /** Keeps the beginning up to the chosen interval, or nothing of it when it is kept. */
  function toggleLock() {
    const path = session.path();
    if (!path) return;
    const locked = session.scenario.prefix.length;
    const upTo = chosen + 1;
    void session.lock(upTo <= locked ? path.letters.slice(0, chosen) : path.letters.slice(0, upTo));
  }

  /** @param {Path} path */
  function build(path) {
    const { task } = planner;
    if (!task) return;
    const locked = session.scenario.prefix.length;
    const { collision, costs } = path.replay;
    const had = strip.contains(document.activeElement);
    strip.replaceChildren(
      ...[...path.letters].map((letter, interval) => {
        const name = task.library.find((behaviour) => behaviour.letter === letter)?.name ?? letter;
        const cut = collision !== null && interval >= collision.interval;
        const fails = collision?.interval === interval;
        const cost = costs[interval];
        const label = sequenceText.ribbon.cell(interval + 1, name, cost ?? null, interval < locked, fails);
        const kind = ['plan-cell', letter === '.' ? 'idle' : '', interval < locked ? 'locked' : '', fails ? 'fails' : '', cut && !fails ? 'unreached' : ''].filter(Boolean).join(' ');
        return h(
          'button',
          { type: 'button', class: kind, title: label, tabindex: interval === chosen ? 0 : -1, onclick: () => go(interval) },
          h('span', { class: 'cell-letter' }, fails ? `${letter}✗` : letter === '.' ? '·' : letter),
          h('span', { class: 'cell-cost' }, cost === undefined ? '–' : Math.round(cost)),
          h('span', { class: 'unseen' }, ` ${label}`),
        );
      }),
    );
    if (had) /** @type {HTMLElement} */ (strip.children[chosen])?.focus();
  }

  function show() {
    const path = session.path();
    const { task } = planner;
    edit.hidden = path === null || !task;
    strip.hidden = path === null;
    empty.hidden = path !== null;
    write(empty, planner.status === 'ended' ? sequenceText.ribbon.none : sequenceText.ribbon.waiting);
    element.classList.toggle('stale', planner.stale && session.hand === null);
    element.classList.toggle('by-hand', session.hand !== null);
    if (!path || !task) {
      shown = null;
      strip.replaceChildren();
      return;
    }
    chosen = Math.min(chosen, path.letters.length - 1);
    const letters = task.library.map(({ letter }) => letter).join('');
    if (letters !== library) {
      library = letters;
      choice.replaceChildren(...task.library.map(({ letter, name }) => h('option', { value: letter }, `${letter}  ${name}`)));
    }
    if (path !== shown) {
      build(path);
      shown = path;
    }
    const at = Math.min(Math.floor(playback.step / task.steps), path.letters.length - 1);
    [...strip.children].forEach((cell, interval) => {
      cell.setAttribute('aria-pressed', String(interval === chosen));
      cell.toggleAttribute('data-now', interval === at);
      /** @type {HTMLElement} */ (cell).tabIndex = interval === chosen ? 0 : -1;
    });
    write(where, sequenceText.ribbon.interval(chosen + 1, chosen * task.interval, (chosen + 1) * task.interval));
    choice.value = [...path.letters][chosen] ?? '';
    const locked = session.scenario.prefix.length;
    write(lock, chosen + 1 <= locked ? sequenceText.ribbon.unlock(chosen) : sequenceText.ribbon.lock(chosen + 1));
    back.hidden = session.hand === null;
    const best = planner.stale ? null : (planner.progress?.cost ?? null);
    const words = session.hand === null ? (locked > 0 ? sequenceText.ribbon.locked(locked) : '') : handWords(path, task, best);
    if (words !== own.textContent && session.hand !== null) announce(words);
    write(own, words);
  }

  session.on('path', show);
  session.on('change', () => {
    shown = null; // the locked beginning may be another
    show();
  });
  planner.on('slice', show);
  let interval = -1;
  playback.on(() => {
    const now = planner.task ? Math.floor(playback.step / planner.task.steps) : -1;
    if (playback.playing && now !== interval) chosen = Math.max(0, Math.min(now, (session.path()?.letters.length ?? 1) - 1));
    if (now !== interval) show();
    interval = now;
  });
  return { element, show };
}
