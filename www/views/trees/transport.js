import { button, h, write } from '../../ui/dom.js';
import { text } from '../../ui/strings.en.js';
import { benchText } from '../../ui/strings.trees.en.js';
import { letterOf, showStatus, statusMark } from './status.js';

/** @import { State } from '../../state.js' */
/** @import { TreeRun } from '../../trees/run.js' */

const SLOWEST = 0.5;
const FASTEST = 60;
const SPEED_STEPS = 100;
const LONGEST_MS = 3_600_000;

/** @typedef {'once' | 'exactly_once'} Mode */

/**
 * The transport bar of the workbench: restart, steps, play, scrubber, speed, what a tick is and how long it takes.
 *
 * @param {{ pane: HTMLElement, run: TreeRun, state: State, restart: () => void, change: (changes: { mode?: Mode, ms?: number }) => void,
 *   complete: (pause: boolean) => void }} parts `complete` is told whether to pause when the root completes
 */
export function createBenchTransport({ pane, run, state, restart, change, complete }) {
  const { pace } = run;
  const play = button(benchText.transport.play, run.toggle, { action: 'toggle', class: 'primary play' });
  const back = button(benchText.transport.back, () => void run.step(-1), { glyph: '−1', action: 'back' });
  const forward = button(benchText.transport.forward, () => void run.step(1), { glyph: '+1', action: 'forward' });
  const start = button(benchText.transport.restart, restart, { glyph: '↺', action: 'restart' });
  const buttons = h('div', { class: 'buttons', role: 'group', 'aria-label': benchText.transport.label }, start, back, play, forward);

  const scrub = h('input', { type: 'range', id: 'trees-scrub', min: 0, max: 0, value: 0, 'aria-label': benchText.transport.scrub });
  const tick = h('output', { id: 'trees-tick', for: scrub.id }, 0);
  const last = h('span', { class: 'of' });
  const root = statusMark('.');
  root.id = 'trees-root';
  const time = h('div', { class: 'time' }, scrub, h('span', { class: 'tick' }, benchText.transport.tick, ' ', tick, last), h('span', { class: 'root' }, benchText.transport.root, ' ', root));

  const speed = h('input', { type: 'range', id: 'trees-speed', min: 0, max: SPEED_STEPS, step: 1 });
  const speedShown = h('output', { for: speed.id });
  const speedGroup = h('div', { class: 'speed' }, h('label', { for: speed.id }, benchText.transport.speed), speed, speedShown);

  const mode = h('select', { id: 'trees-mode', 'aria-describedby': 'trees-mode-meaning' }, ...['once', 'exactly_once'].map((value) => h('option', { value }, benchText.transport.modes[/** @type {Mode} */ (value)])));
  const meaning = h('span', { class: 'meaning', id: 'trees-mode-meaning' });
  const ms = h('input', { type: 'text', inputmode: 'numeric', id: 'trees-ms', size: 6, autocomplete: 'off', 'aria-describedby': 'trees-ms-error' });
  const msError = h('span', { class: 'field-error', id: 'trees-ms-error', role: 'alert' });
  const pause = h('input', { type: 'checkbox', id: 'trees-complete' });
  const kind = h(
    'div',
    { class: 'tick-kind' },
    h('span', { class: 'pair' }, h('label', { for: mode.id }, benchText.transport.mode), mode, meaning),
    h('span', { class: 'pair' }, h('label', { for: ms.id }, benchText.transport.ms), ms, h('span', { class: 'unit' }, benchText.transport.msUnit), msError),
    h('label', { class: 'check' }, pause, benchText.transport.complete),
  );
  pane.append(buttons, time, speedGroup, kind);

  scrub.addEventListener('input', () => void run.seek(Number(scrub.value)).catch(() => {}));
  speed.addEventListener('input', () => setSpeed(fromStep(Number(speed.value))));
  mode.addEventListener('change', () => change({ mode: /** @type {Mode} */ (mode.value) }));
  ms.addEventListener('change', () => {
    const number = /^\s*\d+\s*$/.test(ms.value) ? Number(ms.value) : NaN;
    const allowed = number <= LONGEST_MS;
    if (allowed) ms.removeAttribute('aria-invalid');
    else ms.setAttribute('aria-invalid', 'true');
    write(msError, allowed ? '' : text.value.number(ms.value, true, 0, LONGEST_MS));
    if (allowed) change({ ms: number });
  });
  pause.addEventListener('change', () => complete(pause.checked));

  /** @param {number} ticksPerSecond */
  function setSpeed(ticksPerSecond) {
    pace.ticksPerSecond = Math.min(Math.max(ticksPerSecond, SLOWEST), FASTEST);
    speed.value = String(toStep(pace.ticksPerSecond));
    const shown = benchText.transport.ticksPerSecond(Number(pace.ticksPerSecond.toPrecision(2)));
    write(speedShown, shown);
    speed.setAttribute('aria-valuetext', shown);
  }

  function showButtons() {
    const running = state.name === 'running';
    write(play, running ? benchText.transport.pause : benchText.transport.play);
    play.disabled = !run.moment || (state.name !== 'running' && state.name !== 'paused');
    for (const control of [start, back, forward, scrub]) control.disabled = !run.moment || state.name === 'error';
  }

  state.on(showButtons);
  setSpeed(pace.ticksPerSecond);

  return {
    /** What a tick is; on phones it stands elsewhere. */
    kind,

    /** @param {{ mode: Mode, ms: number }} setup */
    show(setup) {
      const { moment } = run;
      scrub.max = String(run.length);
      scrub.value = String(run.tick);
      write(tick, run.tick);
      write(last, benchText.transport.of(run.length));
      const returned = moment?.root ?? null;
      if (returned) showStatus(root, letterOf(returned));
      else showStatus(root, '.', benchText.transport.noRoot);
      mode.value = setup.mode;
      write(meaning, benchText.transport.meaning[setup.mode]);
      if (document.activeElement !== ms) {
        ms.value = String(setup.ms);
        ms.removeAttribute('aria-invalid');
        write(msError, '');
      }
      showButtons();
    },
    faster: () => setSpeed(pace.ticksPerSecond * 1.5),
    slower: () => setSpeed(pace.ticksPerSecond / 1.5),
  };
}

/** @param {number} ticksPerSecond */
const toStep = (ticksPerSecond) => Math.round((SPEED_STEPS * Math.log(ticksPerSecond / SLOWEST)) / Math.log(FASTEST / SLOWEST));

/** @param {number} step */
const fromStep = (step) => Number((SLOWEST * (FASTEST / SLOWEST) ** (step / SPEED_STEPS)).toPrecision(2));
