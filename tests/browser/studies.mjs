// The tab Studies in the words its tests speak.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { packed } from './bench.mjs';
import { eventually } from './browser.mjs';

/** @typedef {import('./browser.mjs').Open} Open */

/** Two cells of five runs, each of which takes a moment. */
export const SPEC = {
  study: 'small',
  title: 'A small study',
  about: 'Made for the tests.',
  scenario: { world: 'geese', agents: 20, steps: 120 },
  grid: { 'geese.children': [2, 8] },
  seeds: { first: 5, count: 5 },
  metrics: ['share', 'success', 'steps', 'mean_diversity'],
  tests: [{ kind: 'mann-whitney', metric: 'mean_diversity', compare: ['children 2', 'children 8'] }],
  figure: { kind: 'box', metric: 'mean_diversity', x: 'geese.children' },
  paper: { 'children 2': { share: 0.5 } },
};

/** A link to a study of one's own. @param {object} changes to `SPEC` */
export const linkTo = (changes = {}) => `#/studies?size=paper&spec=${packed(JSON.stringify({ ...SPEC, ...changes }, null, 2))}`;

/**
 * Opens a study, or the list.
 *
 * @param {Open} open
 * @param {string} hash
 * @param {import('playwright-core').BrowserContextOptions} [options]
 */
export async function openStudy(open, hash, options = {}) {
  const opened = await open(hash, options);
  const { page, until, inState } = opened;
  const study = {
    ...opened,
    run: page.locator('#studies-run'),
    stop: page.locator('#studies-stop'),
    text: page.locator('#studies-json'),

    /** Waits until there is something to run or to show. */
    ready: () => until(() => /^\d+ of \d+ run/.test(document.querySelector('#studies-done')?.textContent ?? '')),

    /** Runs made, and all of them. */
    async done() {
      const words = (await page.locator('#studies-done').textContent()) ?? '';
      return (words.match(/\d+/g) ?? []).slice(0, 2).map(Number);
    },

    /** Waits until so many runs are made. @param {number} count */
    made: (count) => until((wanted) => Number.parseInt(document.querySelector('#studies-done')?.textContent ?? '', 10) >= wanted, count),

    /** Runs to the end, and waits for the last report. */
    async finish() {
      await study.run.click();
      await study.finished();
    },

    async finished() {
      await inState('finished');
      const [, all] = await study.done();
      assert.ok(all > 0);
      await page.locator('.studies-extent').filter({ hasText: /^(\d+) of \1 seeds/ }).waitFor();
    },

    /** What a button of the footer saves. @param {string} label */
    async saved(label) {
      const waiting = page.waitForEvent('download');
      await page.locator('#studies .take').getByRole('button', { name: label, exact: true }).click();
      const download = await waiting;
      return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
    },

    csv: async () => (await study.saved('CSV')).bytes.toString(),

    /** Puts a text in place of the study's. @param {string} json */
    type: (json) => study.text.fill(json),

    /** The workers that make runs. */
    hands: () => page.workers().filter((worker) => /\/worker-/.test(worker.url())),

    /** Waits for workers that make runs; gives one. @param {(worker: import('playwright-core').Worker) => boolean} [other] which one will do */
    async hand(other = () => true) {
      return eventually(() => study.hands().find(other) ?? assert.fail('there is no worker'));
    },
  };
  if (!/^#\/studies$/.test(hash)) await study.ready();
  return study;
}
