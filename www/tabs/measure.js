import '../style/measure.css';
import { createEngine } from '../engine.js';
import { messageOf } from '../session.js';
import { createState } from '../state.js';
import { write } from '../ui/dom.js';
import { save } from '../ui/share.js';
import { measureText as text } from '../ui/strings.measure.en.js';
import { createMeasurePage } from '../views/measurepage.js';

/** @import { Address, Tab } from '../router.js' */
/** @import { Measured, Row } from '../measure/types.js' */

const ADDRESS = '#/bench';
const SHORT = 1 / 20;

/**
 * The page #/bench: how fast the engines are in this browser.
 *
 * @param {{ element: HTMLElement, address: Address, built: () => void, live: HTMLElement }} parts
 * @returns {Tab}
 */
export function createMeasure({ element, address, built, live }) {
  const state = createState(element);
  /** @type {Row[]} */
  const rows = Object.keys(text.measures).map((name) => ({ name, rounds: [] }));
  const engine = createEngine(broke, () => new Worker(new URL('../measure/worker.js', import.meta.url), { type: 'module' }));
  let share = 1;
  let rounds = 0;
  let stopped = false;
  const page = createMeasurePage({ element, toggle: () => void toggle(), csv });

  const toggle = () => (state.name === 'busy' ? stop() : round());

  /** Measures everything once, beside what was measured already. */
  async function round() {
    if (!state.to('busy')) return;
    const wanted = page.short() ? SHORT : 1;
    if (wanted !== share) for (const row of rows) row.rounds = []; // rates of short and long runs are not the same
    if (wanted !== share) rounds = 0;
    share = wanted;
    stopped = false;
    engine.start();
    for (const row of rows) {
      const { title } = text.measures[row.name];
      tell(text.running(title));
      try {
        /** @type {{ measured: Measured }} */
        const { measured } = await engine.request('measure', { name: row.name, share });
        row.rounds.push(measured);
      } catch (error) {
        if (stopped) break;
        tell(text.failed(title, messageOf(error)));
        break;
      }
      page.show(rows, state.name);
    }
    engine.end();
    if (state.name !== 'busy') return;
    state.to('paused');
    if (rows.every(({ rounds: made }) => made.length > rounds)) tell(text.finished((rounds += 1)));
    else if (stopped) tell(text.stopped);
    page.show(rows, state.name);
  }

  /** Ends the worker: what it was at is lost. */
  function stop() {
    stopped = true;
    engine.end();
  }

  /** @param {string} message */
  function broke(message) {
    tell(text.failed(text.title, message));
  }

  /** @param {string} message */
  function tell(message) {
    page.say(message);
    page.show(rows, state.name);
    write(live, message);
  }

  /** Every round as a table of its own kind: one line each. */
  function csv() {
    const lines = rows.flatMap(({ name, rounds: made }) =>
      made.map(({ amount, seconds, fingerprint = '', integrated = '' }, number) => [name, text.measures[name].unit || 'bytes', number + 1, amount, seconds, fingerprint, integrated].join(',')),
    );
    const about = `# ${navigator.userAgent}, ${navigator.hardwareConcurrency} processors`;
    save('swarm-bench.csv', new Blob([[about, 'measure,unit,round,amount,seconds,fingerprint,integrations', ...lines, ''].join('\n')], { type: 'text/csv' }));
  }

  state.to('paused');
  page.show(rows, state.name);
  page.say(text.none);
  return {
    state,
    actions: { toggle: () => void toggle() },
    regions: [],
    pause: stop,
    async open() {
      built();
      address.write(ADDRESS);
    },
  };
}
