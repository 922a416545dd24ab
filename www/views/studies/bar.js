import { button, h, write } from '../../ui/dom.js';
import { studiesText as text } from '../../ui/strings.studies.en.js';
import { SIZES } from '../../studies/types.js';

/** @import { State } from '../../state.js' */
/** @import { StudyRun } from '../../studies/run.js' */
/** @import { StudySession } from '../../studies/session.js' */
/** @import { Speed } from '../../studies/speed.js' */
/** @import { Size } from '../../studies/types.js' */

const MOST_WORKERS = 64;

/**
 * The bar below a study: run, pause and stop, size and workers, and how far it is.
 *
 * @param {{ pane: HTMLElement, run: StudyRun, session: StudySession, state: State, speed: Speed, cores: number }} parts
 */
export function createStudyBar({ pane, run, session, state, speed, cores }) {
  const main = button(text.bar.run, run.toggle, { action: 'toggle', class: 'primary' });
  const stop = button(text.bar.stop, run.stop, { title: text.bar.stopLong });
  const size = h('select', { id: 'studies-size' }, ...SIZES.map((name) => h('option', { value: name, title: text.list.sizesLong[name] }, text.list.sizes[name])));
  const workers = h('input', { type: 'number', id: 'studies-workers', min: 1, max: Math.max(cores, MOST_WORKERS), value: run.workers, title: text.bar.workersLong(cores) });
  const progress = h('progress', { max: 1, value: 0, 'aria-label': text.bar.progress });
  const done = h('output', { id: 'studies-done' });
  const left = h('span', { class: 'secondary', id: 'studies-left' });
  const slow = h('span', { class: 'secondary studies-slow' });
  main.id = 'studies-run';
  stop.id = 'studies-stop';
  size.addEventListener('change', () => void session.resize(/** @type {Size} */ (size.value)));
  workers.addEventListener('change', () => {
    const count = Math.round(Number(workers.value));
    run.resize(Math.max(1, Math.min(Number(workers.max), count || 1)));
    workers.value = String(run.workers);
  });
  pane.append(
    h('div', { class: 'buttons' }, main, stop),
    h('div', { class: 'studies-how' }, h('label', { for: size.id }, text.bar.size), size, h('label', { for: workers.id }, text.bar.workers), workers),
    h('div', { class: 'studies-far' }, progress, h('p', {}, done, left, slow)),
  );

  /** What the main button does. */
  function label() {
    if (state.name === 'busy') return text.bar.pause;
    if (run.underWay() > 0) return text.bar.resume;
    return run.done() > 0 && run.missing().length > 0 ? text.bar.carryOn : text.bar.run;
  }

  function time() {
    const { plan } = run;
    const missing = run.missing();
    if (!plan || missing.length === 0) return '';
    const exact = run.timeLeft();
    if (exact) return text.bar.left(exact);
    const robotSteps = missing.reduce((all, number) => all + plan.robot_steps[number % plan.cells.length], 0);
    const range = speed.estimate(plan.world, robotSteps, Math.min(run.workers, missing.length));
    if (range) return text.bar.about(range);
    return state.name === 'busy' ? text.bar.unknown : '';
  }

  function show() {
    const all = run.plan?.runs ?? 0;
    write(main, label());
    main.disabled = !run.plan || (state.name !== 'busy' && run.missing().length === 0) || state.name === 'error';
    stop.disabled = state.name !== 'busy' && run.underWay() === 0;
    const sizes = session.outline?.sizes.map((entry) => /** @type {string} */ (entry.size)) ?? [];
    for (const option of size.options) option.disabled = !sizes.includes(option.value);
    size.value = session.size;
    size.disabled = sizes.length === 0;
    progress.max = Math.max(all, 1);
    progress.value = run.done();
    const standing = state.name !== 'busy' && run.underWay() > 0 ? `, ${text.bar.underWay(run.underWay())}` : '';
    write(done, run.plan ? text.bar.done(run.done(), all) + standing : '');
    write(left, time());
    const cell = run.slowest();
    write(slow, cell ? text.bar.slowest(cell.name, cell.seconds) : '');
    slow.title = slow.textContent ?? '';
  }

  run.on('plan', show);
  run.on('progress', show);
  session.on(show);
  state.on(show);
  show();
}
