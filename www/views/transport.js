import { button, h, write } from '../ui/dom.js';
import { text } from '../ui/strings.en.js';
import { readValue } from '../link.js';

/** @import { Run } from '../run.js' */
/** @import { State } from '../state.js' */
/** @import { Session } from '../session.js' */

const SLOWEST = 1;
const FASTEST = 2000;
const SPEED_STEPS = 100;

/**
 * The one transport bar: restart, steps, play, speed, scrubber, seed.
 *
 * @param {{ pane: HTMLElement, run: Run, state: State, session: Session, say: (message: string, kind?: 'note' | 'problem') => void }} parts
 */
export function createTransport({ pane, run, state, session, say }) {
  const { pace } = run;
  const play = button(text.transport.play, run.toggle, { action: 'toggle', class: 'primary' });
  play.id = 'play';
  const buttons = h(
    'div',
    { class: 'buttons', role: 'group', 'aria-label': text.transport.label },
    button(text.transport.restart, () => void session.restart(), { glyph: '↺', action: 'restart' }),
    button(text.transport.farBack, () => void run.step(-100), { glyph: '−100', action: 'far-back', class: 'far' }),
    button(text.transport.back, () => void run.step(-1), { glyph: '−1', action: 'back' }),
    play,
    button(text.transport.forward, () => void run.step(1), { glyph: '+1', action: 'forward' }),
    button(text.transport.farForward, () => void run.step(100), { glyph: '+100', action: 'far-forward', class: 'far' }),
  );

  const speed = h('input', { type: 'range', id: 'speed', min: 0, max: SPEED_STEPS, step: 1, value: toStep(pace.ticksPerSecond) });
  const speedShown = h('output', { for: 'speed', id: 'speed-shown' });
  const max = h('input', { type: 'checkbox', id: 'max' });
  const speedGroup = h('div', { class: 'speed' }, h('label', { for: 'speed' }, text.transport.speed), speed, speedShown, h('label', { class: 'check' }, max, text.transport.max));

  const scrub = h('input', { type: 'range', id: 'scrub', min: 0, max: 0, value: 0, 'aria-label': text.transport.scrub });
  const tick = h('output', { id: 'tick', for: 'scrub' }, 0);
  const last = h('span', { class: 'of' });
  const progress = h('span', { class: 'progress', id: 'progress' });
  const cancel = button(text.transport.cancel, run.cancel, { class: 'quiet' });
  const busy = h('span', { class: 'busy', hidden: true }, progress, cancel);
  const time = h('div', { class: 'time' }, scrub, busy, h('span', { class: 'tick' }, text.transport.tick, ' ', tick, last));

  const seed = h('input', { type: 'text', inputmode: 'numeric', id: 'seed', autocomplete: 'off', spellcheck: 'false', size: 8, 'aria-describedby': 'seed-error' });
  const seedError = h('span', { class: 'field-error', id: 'seed-error' });
  const seedForm = h('form', { class: 'seed' }, h('label', { for: 'seed' }, text.transport.seed), seed, button(text.transport.newSeed, newSeed, { action: 'new-seed' }), seedError);

  pane.setAttribute('aria-label', text.transport.region);
  pane.append(buttons, time, speedGroup, seedForm);

  const seedParameter = session.schema.find((parameter) => parameter.type === 'seed');

  speed.addEventListener('input', () => setSpeed(fromStep(Number(speed.value))));
  max.addEventListener('change', () => setMax(max.checked));
  scrub.addEventListener('input', () => void run.seek(Number(scrub.value)).catch(() => {}));
  seed.addEventListener('change', () => void takeSeed());
  seedForm.addEventListener('submit', (event) => {
    event.preventDefault();
    if (takeSeed()) void session.restart();
  });

  /** Reads the box; a seed that is none is named and nothing changes. */
  function takeSeed() {
    if (!seedParameter) return false;
    try {
      const value = readValue(seedParameter, seed.value);
      showSeedError('');
      void session.change(seedParameter, value);
      return true;
    } catch (error) {
      showSeedError(error instanceof Error ? error.message : String(error));
      say(seedError.textContent ?? '');
      return false;
    }
  }

  /** @param {string} message */
  function showSeedError(message) {
    write(seedError, message);
    seed.toggleAttribute('aria-invalid', message !== '');
    if (message) seed.setAttribute('aria-invalid', 'true');
  }

  function newSeed() {
    const six = 100_000 + (crypto.getRandomValues(new Uint32Array(1))[0] % 900_000); // short enough to be read out
    showSeedError('');
    void session.restart({ seed: six });
  }

  /** @param {number} ticksPerSecond */
  function setSpeed(ticksPerSecond) {
    pace.ticksPerSecond = Math.min(Math.max(ticksPerSecond, SLOWEST), FASTEST);
    pace.max = false;
    max.checked = false;
    speed.value = String(toStep(pace.ticksPerSecond));
    showSpeed();
  }

  /** @param {boolean} on as fast as it can */
  function setMax(on) {
    pace.max = on;
    max.checked = on;
    showSpeed();
  }

  function showSpeed() {
    const shown = pace.max ? text.transport.maxSpeed : text.transport.ticksPerSecond(Math.round(pace.ticksPerSecond));
    write(speedShown, shown);
    speed.setAttribute('aria-valuetext', shown);
  }

  function showTick() {
    if (scrub.max !== String(run.steps)) {
      scrub.max = String(run.steps);
      write(last, text.transport.of(run.steps));
    }
    write(tick, run.tick);
    scrub.value = String(run.tick);
  }

  run.on('loaded', showTick);
  run.on('frame', showTick);
  run.on('progress', (now, target) => {
    write(progress, text.transport.progress(now, target));
    busy.hidden = state.name !== 'busy';
  });
  state.on((name) => {
    const running = name === 'running';
    write(play, running ? text.transport.pause : text.transport.play);
    play.disabled = name !== 'running' && name !== 'paused';
    busy.hidden = name !== 'busy';
    for (const control of buttons.querySelectorAll('button')) if (control !== play) control.disabled = name === 'loading' || name === 'error';
  });
  session.on(() => {
    if (seedParameter && document.activeElement !== seed) seed.value = String(session.value(seedParameter.key));
  });
  showSpeed();

  return { newSeed, faster: () => setSpeed(pace.ticksPerSecond * 1.5), slower: () => setSpeed(pace.ticksPerSecond / 1.5), fastest: () => setMax(true) };
}

/** @param {number} ticksPerSecond */
function toStep(ticksPerSecond) {
  return Math.round((SPEED_STEPS * Math.log(ticksPerSecond / SLOWEST)) / Math.log(FASTEST / SLOWEST));
}

/** @param {number} step */
function fromStep(step) {
  const exact = SLOWEST * (FASTEST / SLOWEST) ** (step / SPEED_STEPS);
  return exact < 10 ? Math.round(exact) : Number(exact.toPrecision(2));
}
