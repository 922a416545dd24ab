import { readValue } from '../../link.js';
import { FRAMES_PER_SECOND } from '../../soccer/film.js';
import { button, h, write } from '../../ui/dom.js';
import { soccerText } from '../../ui/strings.soccer.en.js';
import { text } from '../../ui/strings.en.js';
import { createMarks } from './marks.js';

/** @import { SoccerMatch } from '../../soccer/match.js' */
/** @import { SoccerPlayback } from '../../soccer/playback.js' */
/** @import { SoccerSession } from '../../soccer/session.js' */

const [SLOWEST, FASTEST] = [0.1, 60]; // times real time
const SPEED_STEPS = 100;
const words = soccerText.transport;

/**
 * The transport bar: from the kick-off, from call to call, play, the scrubber with its marks, speed, seed.
 *
 * @param {{ pane: HTMLElement, match: SoccerMatch, playback: SoccerPlayback, session: SoccerSession, say: (message: string) => void }} parts
 */
export function createSoccerTransport({ pane, match, playback, session, say }) {
  const { pace } = playback;
  const play = button(words.play, playback.toggle, { action: 'toggle', class: 'primary play' });
  const step = (/** @type {number} */ by) => (playback.pause(), playback.seek(playback.tick + by));
  const buttons = h(
    'div',
    { class: 'buttons', role: 'group', 'aria-label': words.label },
    button(words.start, () => playback.seek(0), { glyph: '↺', action: 'restart' }),
    button(words.eventBack, () => far(-1), { glyph: '⇤', action: 'far-back', class: 'far' }),
    button(words.back, () => step(-1), { glyph: '−1', action: 'back' }),
    play,
    button(words.forward, () => step(1), { glyph: '+1', action: 'forward' }),
    button(words.eventForward, () => far(1), { glyph: '⇥', action: 'far-forward', class: 'far' }),
  );

  /** Goes to the next call, or the one before. @param {number} way */
  function far(way) {
    const frames = [0, ...match.calls.map(({ frame }) => frame), match.front()];
    const next = way > 0 ? frames.find((frame) => frame > playback.tick) : frames.findLast((frame) => frame < playback.tick);
    playback.pause();
    if (next !== undefined) playback.seek(next);
  }

  const marks = createMarks(match);
  const scrub = h('input', { type: 'range', id: 'soccer-scrub', min: 0, max: 0, step: 1, value: 0, 'aria-label': words.scrub });
  const time = h('output', { id: 'soccer-clock', for: scrub.id });
  const last = h('span', { class: 'of' });
  const timeGroup = h('div', { class: 'time' }, h('div', { class: 'scrubber' }, marks.svg, scrub), h('span', { class: 'tick' }, time, last));
  scrub.addEventListener('input', () => (playback.pause(), playback.seek(Number(scrub.value))));

  const speed = h('input', { type: 'range', id: 'soccer-speed', min: 0, max: SPEED_STEPS, step: 1 });
  const speedShown = h('output', { for: speed.id });
  const speedGroup = h('div', { class: 'speed' }, h('label', { for: speed.id }, text.transport.speed), speed, speedShown);
  speed.addEventListener('input', () => setSpeed(SLOWEST * (FASTEST / SLOWEST) ** (Number(speed.value) / SPEED_STEPS)));

  const seed = h('input', { type: 'text', inputmode: 'numeric', id: 'soccer-seed', autocomplete: 'off', spellcheck: 'false', size: 8, 'aria-describedby': 'soccer-seed-error' });
  const seedError = h('span', { class: 'field-error', id: 'soccer-seed-error' });
  const seedForm = h('form', { class: 'seed' }, h('label', { for: seed.id }, words.seed), seed, button(words.newSeed, newMatch, { action: 'new-seed' }), seedError);
  const parameter = session.schema.find(({ type }) => type === 'seed');
  seed.addEventListener('change', takeSeed);
  seedForm.addEventListener('submit', (event) => (event.preventDefault(), takeSeed()));

  pane.append(buttons, timeGroup, speedGroup, seedForm);

  function takeSeed() {
    if (!parameter) return;
    try {
      const value = readValue(parameter, seed.value);
      write(seedError, '');
      void session.change(parameter, value);
    } catch (error) {
      write(seedError, error instanceof Error ? error.message : String(error));
      say(seedError.textContent ?? '');
    }
    seed.toggleAttribute('aria-invalid', seedError.textContent !== '');
  }

  function newMatch() {
    write(seedError, '');
    const six = 100_000 + (crypto.getRandomValues(new Uint32Array(1))[0] % 900_000); // short enough to be read out
    void session.play({ seed: six });
  }

  /** @param {number} factor times real time */
  function setSpeed(factor) {
    const kept = Math.min(Math.max(factor, SLOWEST), FASTEST);
    pace.ticksPerSecond = kept * FRAMES_PER_SECOND;
    speed.value = String(Math.round((SPEED_STEPS * Math.log(kept / SLOWEST)) / Math.log(FASTEST / SLOWEST)));
    write(speedShown, words.speed(kept));
    speed.setAttribute('aria-valuetext', words.speed(kept));
  }

  function show() {
    const end = match.end();
    scrub.max = String(end);
    scrub.value = String(playback.tick);
    scrub.style.setProperty('--computed', `${(100 * match.front()) / Math.max(end, 1)}%`);
    write(play, playback.playing ? words.pause : words.play);
    const { phase, seconds } = match.film.clock(playback.tick);
    write(time, soccerText.exact(playback.tick / FRAMES_PER_SECOND));
    write(last, words.of(end / FRAMES_PER_SECOND, match.over));
    scrub.setAttribute('aria-valuetext', words.moment(soccerText.board.time(phase, seconds), match.film.goals(playback.tick)));
    if (document.activeElement !== seed) seed.value = String(session.scenario().seed);
  }

  playback.on(show);
  session.on(show);
  for (const name of /** @type {const} */ (['opened', 'grown', 'cut', 'over'])) {
    match.on(name, () => {
      show();
      marks.show();
    });
  }
  setSpeed(1);
  show();

  return {
    newMatch,
    step,
    far,
    faster: () => setSpeed((pace.ticksPerSecond / FRAMES_PER_SECOND) * 1.5),
    slower: () => setSpeed(pace.ticksPerSecond / FRAMES_PER_SECOND / 1.5),
    /** @param {boolean} on */
    enable(on) {
      for (const control of pane.querySelectorAll('button, input')) /** @type {HTMLButtonElement} */ (control).disabled = !on;
    },
  };
}
