import { createEngine } from '../engine.js';
import { h, write } from '../ui/dom.js';
import { soccerText } from '../ui/strings.soccer.en.js';
import { createPitch } from '../views/soccer/pitch.js';
import { createMatch } from './match.js';

/** @import { PitchTheme } from '../draw/soccer.js' */
/** @import { SoccerFrame } from '../views/soccer/frame.js' */
/** @import { SoccerMatch } from './match.js' */
/** @import { SoccerPlayback } from './playback.js' */
/** @import { SoccerSession } from './session.js' */

const words = soccerText.compare;

/**
 * A | B: one seed and one opponent, two coaches of blue, a worker and a pitch each, one clock.
 *
 * @param {{ frame: SoccerFrame, session: SoccerSession, playback: SoccerPlayback, match: SoccerMatch, layers: { names: boolean, trail: boolean },
 *   spawn: () => Worker, theme: () => PitchTheme, onTheme: (listener: () => void) => void, broke: (message: string) => void, announce: (message: string) => void }} parts
 *   `match` is that of the tab, whose clock both follow
 */
export function createSoccerCompare({ frame, session, playback, match: own, layers, spawn, theme, onTheme, broke, announce }) {
  const { setting } = session;
  let on = false;
  let parted = -1; // the first tick at which the two differ; -1 while none is known
  let compared = 0; // ticks that were compared
  let told = '';
  const sides = /** @type {const} */ (['a', 'b']).map((letter, index) => {
    const engine = createEngine(broke, spawn);
    const match = createMatch(engine);
    const pitch = createPitch({
      label: words.pitch(letter.toUpperCase()),
      scene() {
        if (match.film.count === 0) return null;
        const tick = match.film.within(playback.tick);
        const names = Array.from({ length: 6 }, (_, robot) => soccerText.short[setting.roles[match.film.role(tick, robot)]] ?? '');
        return { walls: setting.walls, frame: match.film.frame(tick), film: match.film, tick, names, exchanged: match.exchanged, layers };
      },
      theme,
    });
    const name = h('span', { class: 'side-name' });
    const said = h('p', { class: 'side-said' });
    const element = h('section', { class: 'soccer-side', 'data-side': letter, 'aria-label': letter.toUpperCase() }, h('h3', {}, h('b', {}, letter.toUpperCase()), ' ', name), pitch.stage, said);
    match.on('opened', pitch.invalidate);
    match.on('grown', progress);
    match.on('over', progress);
    onTheme(pitch.invalidate);
    return { letter, index, engine, match, pitch, name, said, element };
  });

  const pair = h('select', { id: 'soccer-pair' }, ...words.pairs.map(([value, label]) => h('option', { value }, label)));
  const kinds = Object.entries(soccerText.kinds);
  const against = h('select', { id: 'soccer-against' }, ...kinds.map(([value, label]) => h('option', { value }, label)));
  const status = h('p', { class: 'compare-said', id: 'soccer-compare' });
  const bar = h('div', { class: 'soccer-compare-bar' }, h('label', { for: pair.id }, words.pair), pair, h('label', { for: against.id }, words.against), against, status);
  const element = h('div', { class: 'soccer-sides' }, ...sides.map((side) => side.element));
  const note = h('p', { class: 'status-key' }, words.note);
  for (const select of [pair, against]) select.addEventListener('change', () => void run());

  /** Both play from the first kick-off. */
  async function run() {
    if (!on) return;
    parted = -1;
    compared = 0;
    told = '';
    write(status, words.computing);
    const blues = pair.value.split(' ');
    const common = { ...session.scenario(), 'blue-coach': '', 'yellow-coach': '', yellow: against.value, events: [] };
    await Promise.all(
      sides.map(({ match, name, index }) => {
        write(name, words.side(soccerText.kinds[blues[index]], soccerText.kinds[against.value]));
        return match.open({ ...common, blue: blues[index] });
      }),
    );
    show();
  }

  /** Compares what both have computed. */
  function progress() {
    const [a, b] = sides.map(({ match }) => match);
    const known = Math.min(a.film.count, b.film.count);
    while (parted < 0 && compared < known) {
      if (!a.film.same(b.film, compared)) parted = compared;
      compared += 1;
    }
    show();
    if (!a.over || !b.over || !a.outcome || !b.outcome) return;
    const parting = parted < 0 ? words.same : words.until(soccerText.exact(parted / 60));
    const said = `${parting} ${words.final(a.outcome.goals, b.outcome.goals)}`;
    write(status, said);
    if (said !== told) announce(said);
    told = said;
  }

  function show() {
    if (!on) return;
    for (const { letter, match, pitch, said } of sides) {
      if (match.film.count === 0) continue;
      pitch.invalidate();
      const { swaps, possession } = match.film.counts(playback.tick);
      const all = possession[0] + possession[1];
      write(said, words.now(letter.toUpperCase(), match.film.goals(playback.tick), swaps[0], all > 0 ? possession[0] / all : 0.5));
    }
  }

  session.on(() => void run());
  playback.on(show);

  return {
    on: () => on,

    open() {
      on = true;
      against.value = String(session.scenario().yellow);
      frame.stages.prepend(element);
      frame.stages.after(note);
      frame.head.prepend(bar);
      for (const { engine } of sides) engine.start();
      own.hold(); // two matches are enough
      void run();
    },

    close() {
      on = false;
      for (const { match, engine } of sides) {
        match.abandon();
        engine.end();
      }
      element.remove();
      note.remove();
      bar.remove();
      own.resume();
    },

    redraw: show,
    hold: () => sides.forEach(({ match }) => match.hold()),
    resume: () => on && sides.forEach(({ match }) => match.resume()),
  };
}

/** @typedef {ReturnType<typeof createSoccerCompare>} SoccerCompare */
