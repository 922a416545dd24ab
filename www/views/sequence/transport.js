import { readValue } from '../../link.js';
import { button, h, write } from '../../ui/dom.js';
import { sequenceText } from '../../ui/strings.sequence.en.js';
import { text } from '../../ui/strings.en.js';

/** @import { Planner } from '../../sequence/planner.js' */
/** @import { Playback } from '../../sequence/playback.js' */
/** @import { SequenceSession } from '../../sequence/session.js' */

const STEPS_PER_SECOND = 10;
const [SLOWEST, FASTEST] = [1, 60]; // simulated seconds per second
const SPEED_STEPS = 100;

/**
 * The transport bar: from the start, interval back and forward, play, time slider, speed, seed of the layout.
 *
 * @param {{ pane: HTMLElement, planner: Planner, playback: Playback, session: SequenceSession, say: (message: string) => void }} parts
 */
export function createSequenceTransport({ pane, planner, playback, session, say }) {
  const { pace } = playback;
  const play = button(sequenceText.transport.play, playback.toggle, { action: 'toggle', class: 'primary play' });
  const interval = () => planner.task?.steps ?? 100;
  const far = (/** @type {number} */ by) => playback.seek((by > 0 ? Math.floor(playback.step / interval()) + 1 : Math.ceil(playback.step / interval()) - 1) * interval());
  const step = (/** @type {number} */ by) => (playback.pause(), playback.seek(playback.step + by));
  const buttons = h(
    'div',
    { class: 'buttons', role: 'group', 'aria-label': sequenceText.transport.label },
    button(sequenceText.transport.start, () => playback.seek(0), { glyph: '↺', action: 'restart' }),
    button(sequenceText.transport.intervalBack, () => far(-1), { glyph: '⇤', action: 'far-back', class: 'far' }),
    button(sequenceText.transport.back, () => step(-1), { glyph: '−0.1', action: 'back' }),
    play,
    button(sequenceText.transport.forward, () => step(1), { glyph: '+0.1', action: 'forward' }),
    button(sequenceText.transport.intervalForward, () => far(1), { glyph: '⇥', action: 'far-forward', class: 'far' }),
  );

  const scrub = h('input', { type: 'range', id: 'sequence-scrub', min: 0, max: 0, step: 1, value: 0, 'aria-label': sequenceText.transport.scrub });
  const time = h('output', { id: 'sequence-time', for: scrub.id });
  const last = h('span', { class: 'of' });
  const timeGroup = h('div', { class: 'time' }, scrub, h('span', { class: 'tick' }, time, last));
  scrub.addEventListener('input', () => (playback.pause(), playback.seek(Number(scrub.value))));

  const speed = h('input', { type: 'range', id: 'sequence-speed', min: 0, max: SPEED_STEPS, step: 1 });
  const speedShown = h('output', { for: speed.id });
  const speedGroup = h('div', { class: 'speed' }, h('label', { for: speed.id }, text.transport.speed), speed, speedShown);
  speed.addEventListener('input', () => setSpeed(SLOWEST * (FASTEST / SLOWEST) ** (Number(speed.value) / SPEED_STEPS)));

  const seed = h('input', { type: 'text', inputmode: 'numeric', id: 'sequence-seed', autocomplete: 'off', spellcheck: 'false', size: 8, 'aria-describedby': 'sequence-seed-error' });
  const seedError = h('span', { class: 'field-error', id: 'sequence-seed-error' });
  const seedForm = h('form', { class: 'seed' }, h('label', { for: seed.id }, sequenceText.transport.seed), seed, button(sequenceText.transport.newLayout, newLayout, { action: 'new-seed' }), seedError);
  const parameter = session.schema.find(({ type }) => type === 'seed');
  seed.addEventListener('change', takeSeed);
  seedForm.addEventListener('submit', (event) => (event.preventDefault(), takeSeed()));

  pane.append(buttons, timeGroup, speedGroup, seedForm);

  function takeSeed() {
    if (!parameter) return;
    try {
      const value = Number(readValue(parameter, seed.value));
      write(seedError, '');
      if (value !== session.scenario.seed) void session.newLayout(value);
    } catch (error) {
      write(seedError, error instanceof Error ? error.message : String(error));
      say(seedError.textContent ?? '');
    }
    seed.toggleAttribute('aria-invalid', seedError.textContent !== '');
  }

  function newLayout() {
    write(seedError, '');
    void session.newLayout(100_000 + (crypto.getRandomValues(new Uint32Array(1))[0] % 900_000)); // short enough to be read out
  }

  /** @param {number} seconds simulated per second */
  function setSpeed(seconds) {
    const kept = Math.min(Math.max(seconds, SLOWEST), FASTEST);
    pace.ticksPerSecond = kept * STEPS_PER_SECOND;
    speed.value = String(Math.round((SPEED_STEPS * Math.log(kept / SLOWEST)) / Math.log(FASTEST / SLOWEST)));
    write(speedShown, sequenceText.transport.speed(kept));
    speed.setAttribute('aria-valuetext', sequenceText.transport.speed(kept));
  }

  function show() {
    const end = playback.end();
    scrub.max = String(end);
    scrub.value = String(playback.step);
    scrub.disabled = end === 0;
    play.disabled = end === 0;
    write(play, playback.playing ? sequenceText.transport.pause : sequenceText.transport.play);
    write(time, sequenceText.transport.seconds(playback.step / STEPS_PER_SECOND));
    write(last, sequenceText.transport.of(end / STEPS_PER_SECOND));
    scrub.setAttribute('aria-valuetext', sequenceText.transport.seconds(playback.step / STEPS_PER_SECOND));
    if (document.activeElement !== seed) seed.value = String(session.scenario.seed);
  }

  playback.on(show);
  session.on('change', show);
  setSpeed(pace.ticksPerSecond / STEPS_PER_SECOND);
  show();

  return {
    newLayout,
    step,
    far,
    faster: () => setSpeed((pace.ticksPerSecond / STEPS_PER_SECOND) * 1.5),
    slower: () => setSpeed(pace.ticksPerSecond / STEPS_PER_SECOND / 1.5),
  };
}
