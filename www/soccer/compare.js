import { createEngine } from '../engine.js';
import { h, write } from '../ui/dom.js';
import { soccerText } from '../ui/strings.soccer.en.js';
import { createPitch } from '../views/soccer/pitch.js';
import { createMatch } from './match.js';

/** @import { PitchScene, PitchTheme } from '../draw/soccer.js' */
/** @import { SoccerFrame } from '../views/soccer/frame.js' */
/** @import { SoccerMatch } from './match.js' */
/** @import { SoccerPlayback } from './playback.js' */
/** @import { SoccerSession } from './session.js' */
/** @import { Scenario } from './types.js' */

const words = soccerText.compare;

/**
 * A | B: A is the match of the page, B the same with another coach of blue, in a worker of its own. One seed, one clock.
 *
 * @param {{ frame: SoccerFrame, session: SoccerSession, playback: SoccerPlayback, match: SoccerMatch, layers: { names: boolean, trail: boolean },
 *   spawn: () => Worker, theme: () => PitchTheme, onTheme: (listener: () => void) => void, broke: (message: string) => void, announce: (message: string) => void }} parts
 */
export function createSoccerCompare({ frame, session, playback, match: own, layers, spawn, theme, onTheme, broke, announce }) {
  const { setting } = session;
  let on = false;
  let parted = -1; // the first tick at which the two differ; -1 while none is known
  let compared = 0; // ticks that were compared
  let told = '';
  let opened = ''; // the scenario that B plays
  /** @type {string[][]} coaches of blue and yellow on both sides */
  let teams = [];
  const engine = createEngine(broke, spawn);
  const other = createMatch(engine);
  const sides = /** @type {const} */ (['a', 'b']).map((letter, index) => {
    const match = index === 0 ? own : other;
    const pitch = createPitch({
      label: words.pitch(letter.toUpperCase()),
      scene: () => sceneOf(match, playback.tick),
      theme,
    });
    const name = h('span', { class: 'side-name' });
    const said = h('p', { class: 'side-said' });
    const element = h('section', { class: 'soccer-side', 'data-side': letter, 'aria-label': letter.toUpperCase() }, h('h3', {}, h('b', {}, letter.toUpperCase()), ' ', name), pitch.stage, said);
    match.on('grown', progress);
    match.on('over', progress);
    onTheme(pitch.invalidate);
    return { letter, match, pitch, name, said, element };
  });

  /** What is drawn of a match; past its end it stands still. @param {SoccerMatch} match @param {number} moment @returns {Omit<PitchScene, 'width' | 'height'> | null} */
  function sceneOf(match, moment) {
    if (match.film.count === 0) return null;
    const tick = match.film.within(moment);
    const names = Array.from({ length: 6 }, (_, robot) => soccerText.short[setting.roles[match.film.role(tick, robot)]] ?? '');
    return { walls: setting.walls, frame: match.film.frame(tick), film: match.film, tick, names, exchanged: match.exchanged, layers };
  }

  const blue = h('select', { id: 'soccer-other' }, ...Object.entries(soccerText.kinds).map(([value, label]) => h('option', { value }, label)));
  const status = h('p', { class: 'compare-said', id: 'soccer-compare' });
  const bar = h('div', { class: 'soccer-compare-bar' }, h('label', { for: blue.id }, words.other), blue, status);
  const element = h('div', { class: 'soccer-sides' }, ...sides.map((side) => side.element));
  const note = h('p', { class: 'status-key' }, words.note);
  blue.addEventListener('change', () => {
    session.compare(blue.value);
    void run();
  });

  /** B plays from the first kick-off, with whatever was done to A. */
  async function run() {
    if (!on) return;
    /** @type {Scenario} */
    const scenario = { ...session.scenario(), blue: blue.value, 'blue-coach': '' };
    const written = JSON.stringify(scenario);
    if (written !== opened) {
      opened = written;
      write(status, words.computing);
      other.film.clear();
      await other.open(scenario);
    }
    [parted, compared, told] = [-1, 0, ''];
    teams = [session.scenario(), scenario].map((each) => [soccerText.kinds[each.blue] + (each['blue-coach'] ? words.edited : ''), soccerText.kinds[each.yellow]]);
    sides.forEach(({ name }, index) => write(name, words.side(teams[index][0], teams[index][1])));
    progress();
  }

  /** Compares what both have computed. */
  function progress() {
    if (!on) return;
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
  own.on('cut', () => void run());
  playback.on(show);

  return {
    on: () => on,

    /** @param {string | null} kind who coaches blue in B; null for the other kind of coach than in A */
    open(kind) {
      if (kind !== null || !on) blue.value = kind ?? (session.scenario().blue === 'machine' ? 'tree' : 'machine');
      session.compare(blue.value);
      if (on) return void run();
      on = true;
      frame.stages.prepend(element);
      frame.stages.after(note);
      frame.head.prepend(bar);
      engine.start();
      void run();
    },

    /** Ends B; whether the session still asks for it is not decided here. */
    close() {
      on = false;
      opened = '';
      other.abandon();
      engine.end();
      element.remove();
      note.remove();
      bar.remove();
    },

    matches: sides.map(({ match }) => match),

    /** Both sides at a moment, for a picture. @param {number} moment */
    halves: (moment) =>
      sides.map(({ letter, match }, index) => {
        const { phase, seconds } = match.film.clock(moment);
        return {
          scene: sceneOf(match, moment),
          score: words.score(letter.toUpperCase(), teams[index], match.film.goals(moment)),
          time: words.time(Number(match.scenario?.seed), soccerText.board.time(phase, seconds)),
        };
      }),

    redraw: show,
    hold: other.hold,
    resume: () => void (on && other.resume()),
  };
}

/** @typedef {ReturnType<typeof createSoccerCompare>} SoccerCompare */
