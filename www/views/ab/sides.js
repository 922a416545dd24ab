import { locate } from '../../draw/frame.js';
import { h, write } from '../../ui/dom.js';
import { abText } from '../../ui/strings.ab.en.js';

/** @import { Seen } from '../../lens.js' */

/** @typedef {Seen & { finished: string | null, fingerprint: string, fingerprintTick: number }} SideRun */

/**
 * One arena of A | B with its letter, name and counts above it.
 *
 * @param {'a' | 'b'} side
 */
export function createSide(side) {
  const name = h('span', { class: 'ab-name' });
  const counts = h('p', { class: 'ab-counts', id: `ab-counts-${side}` });
  const fingerprint = h('output', { class: 'ab-fingerprint', id: `ab-fingerprint-${side}`, 'aria-label': abText.fingerprint(side.toUpperCase()) });
  const title = h('h2', {}, h('span', { class: 'ab-letter' }, side.toUpperCase()), name);
  const element = h('section', { class: 'ab-side', 'data-side': side, 'aria-label': side.toUpperCase() }, h('header', { class: 'ab-caption' }, title, counts, fingerprint));
  /** @type {unknown} */
  let layout = null;
  /** @type {ReturnType<typeof locate> | null} */
  let at = null;

  return {
    element,

    /** @param {string} written */
    name: (written) => {
      write(name, written);
      name.title = written;
    },

    /** @param {SideRun} run @param {{ tick: number, finished: string | null }} stands */
    show(run, stands) {
      if (!run.layout || run.frame.length !== run.layout.length) return;
      if (layout !== run.layout) at = locate(run.layout);
      layout = run.layout;
      if (!at) return;
      const { frame } = run;
      const counted = abText.counts(frame[at.delivered], frame[at.total], frame[at.carried], frame[at.programs]);
      write(counts, stands.finished === null ? counted : `${counted}; ${abText.ended(stands.tick, stands.finished)}`);
      write(fingerprint, run.fingerprint);
      fingerprint.dataset.tick = String(run.fingerprintTick);
      fingerprint.classList.toggle('past', run.fingerprintTick !== run.tick);
    },
  };
}
