import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { eventually } from './browser.mjs';
import { SPEC, linkTo, openStudy } from './studies.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));

const cargo = async (/** @type {string[]} */ ...words) => (await promisify(execFile)('cargo', ['run', '--locked', '--quiet', '--', ...words], { cwd: root })).stdout;

/** The files that the command line writes for a study. @param {string[]} words */
async function native(...words) {
  const folder = mkdtempSync(join(tmpdir(), 'swarm-studies-'));
  try {
    const out = join(folder, 'out.csv');
    await cargo('study', ...words, '--jobs', '2', '--out', out);
    const report = await cargo('report', out, '--svg', join(folder, 'out.svg'));
    return { csv: readFileSync(out, 'utf8'), spec: readFileSync(join(folder, 'out.study.json'), 'utf8'), svg: readFileSync(join(folder, 'out.svg'), 'utf8'), report };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'a_glance_study_gives_the_bytes_of_the_command_line',
    async (open) => {
      const study = await openStudy(open, '#/studies/agents?size=glance', { acceptDownloads: true });
      assert.deepEqual(await study.done(), [0, 10]);
      await study.page.locator('#studies-workers').fill('2');
      await study.finish();
      const wanted = await native('studies/agents.json', '--size', 'glance');
      assert.equal(await study.csv(), wanted.csv);
      const spec = await study.saved('Spec');
      assert.deepEqual([spec.name, spec.bytes.toString()], ['agents-glance.study.json', wanted.spec]);
      assert.equal((await study.saved('Report')).bytes.toString(), wanted.report);
      assert.equal((await study.saved('SVG')).bytes.toString(), wanted.svg);
      const png = (await study.saved('PNG')).bytes;
      assert.deepEqual([png.subarray(1, 4).toString(), png.readUInt32BE(16), png.readUInt32BE(20)], ['PNG', 1520, 1000]);
      assert.deepEqual(study.problems, []);
    },
  ],
  [
    'a_study_of_plans_gives_the_bytes_of_the_command_line_and_offers_its_own_metrics',
    async (open) => {
      const study = await openStudy(open, '#/studies/search-variants?size=glance', { acceptDownloads: true });
      await study.finish();
      const wanted = await native('studies/search-variants.json', '--size', 'glance');
      assert.equal(await study.csv(), wanted.csv);
      assert.equal((await study.saved('Report')).bytes.toString(), wanted.report);
      const { page } = study;
      await page.locator('#studies-part-metrics summary').click();
      await eventually(async () => assert.deepEqual([await page.locator('#study-metric-integrations').isChecked(), await page.locator('#study-metric-share').count()], [true, 0]));
      const offered = await page.locator('#studies-part-scenario option').evaluateAll((options) => options.map((option) => /** @type {HTMLOptionElement} */ (option).value));
      assert.ok(offered.includes('sequencing.robots') && !offered.some((key) => key.startsWith('geese.')), offered.join(' '));
      assert.deepEqual(study.problems, []);
    },
  ],
  [
    'a_study_of_matches_gives_the_bytes_of_the_command_line_and_shows_the_tables_first',
    async (open) => {
      const study = await openStudy(open, '#/studies/coaches?size=glance', { acceptDownloads: true });
      await study.finish();
      const wanted = await native('studies/coaches.json', '--size', 'glance');
      assert.equal(await study.csv(), wanted.csv);
      assert.equal((await study.saved('Report')).bytes.toString(), wanted.report);
      assert.equal((await study.saved('SVG')).bytes.toString(), wanted.svg);
      const titles = await study.page.locator('.studies-results h3').allTextContents();
      assert.ok(titles.indexOf('Wins, ties and losses') >= 0 && titles.indexOf('Wins, ties and losses') < titles.indexOf('Tests'), titles.join(', '));
      assert.deepEqual(study.problems, []);
    },
  ],
  [
    'any_number_of_workers_gives_the_same_rows',
    async (open) => {
      /** @type {string[]} */
      const files = [];
      for (const workers of ['1', '3']) {
        const study = await openStudy(open, linkTo(), { acceptDownloads: true });
        await study.page.locator('#studies-workers').fill(workers);
        await study.finish();
        files.push(await study.csv());
      }
      assert.equal(files[0].split('\n').length, 12);
      assert.equal(files[1], files[0]);
    },
  ],
  [
    'paused_reloaded_and_resumed_a_study_ends_with_the_same_bytes',
    async (open) => {
      const long = linkTo({ scenario: { ...SPEC.scenario, steps: 2500 } });
      const whole = await openStudy(open, long, { acceptDownloads: true });
      await whole.finish();
      const wanted = await whole.csv();

      const study = await openStudy(open, long, { acceptDownloads: true });
      const { page, run, inState } = study;
      await run.click();
      await study.made(2);
      await run.click();
      await inState('paused');
      assert.match((await run.textContent()) ?? '', /^(Resume|Continue)$/);
      // A row that was under way to the page as it was paused still arrives.
      const before = await eventually(async () => {
        const [made] = await study.done();
        await page.waitForTimeout(300);
        assert.equal((await study.done())[0], made);
        return made;
      });
      assert.ok(before < 10, 'some are left to make');
      await page.waitForTimeout(700);
      assert.equal((await study.done())[0], before, 'nothing goes on while it is paused');
      await run.click();
      await study.made(before + 2);
      await page.reload();
      await study.ready();
      await study.notice(/of 10 runs were made here before\. Continue makes the rest\./);
      const [kept] = await study.done();
      assert.ok(kept >= before + 2, `${kept} rows are there after the reload`);
      assert.equal(await run.textContent(), 'Continue');
      await study.finish();
      assert.equal(await study.csv(), wanted);
      await page.reload();
      await study.finished();
      assert.equal(await study.csv(), wanted, 'a finished study is finished after a reload');
      assert.deepEqual(study.problems, []);
    },
  ],
  [
    'a_run_whose_worker_dies_is_made_again',
    async (open) => {
      const long = linkTo({ scenario: { ...SPEC.scenario, steps: 2500 } });
      const whole = await openStudy(open, long, { acceptDownloads: true });
      await whole.finish();
      const study = await openStudy(open, long, { acceptDownloads: true });
      await study.run.click();
      await study.made(1);
      const first = await study.hand();
      await first.evaluate(() => void setTimeout(() => { throw new Error('thrown by the test'); })); // it says so
      const second = await study.hand((worker) => worker !== first);
      await study.made(3);
      await second.evaluate(() => self.close()); // it dies without a word
      await study.finished();
      assert.equal(await study.csv(), await whole.csv());
    },
  ],
  [
    'a_run_that_breaks_its_worker_three_times_is_a_row_with_a_reason',
    async (open) => {
      const study = await openStudy(open, linkTo({ scenario: { ...SPEC.scenario, steps: 12_000, agents: 100 }, seeds: { first: 5, count: 1 } }), { acceptDownloads: true });
      await study.run.click();
      /** @type {import('playwright-core').Worker[]} */
      const known = [];
      // A worker that has no run yet has none to lose: then one more has to break.
      for (let breaks = 0; breaks < 12 && (await study.done())[0] === 0; breaks += 1) {
        const hand = await Promise.race([study.hand((worker) => !known.includes(worker)), study.made(1).then(() => null)]);
        if (!hand) break;
        known.push(hand);
        await hand.evaluate(() => new Promise((resolve) => setTimeout(resolve, 500)));
        await hand.evaluate(() => void setTimeout(() => { throw new Error('broken by the test'); }));
      }
      await study.made(1);
      await study.stop.click();
      await study.page.locator('.studies-results .field-error').filter({ hasText: '1 run failed, and no number below counts them' }).waitFor();
      const [, row] = (await study.csv()).split('\n');
      assert.match(row, /^0,children 2,2,5,,,,,0\.\d+\.\d+,[0-9a-f]{16},,"?its worker died 3 times, last: Uncaught Error: broken by the test"?$/);
    },
  ],
  [
    'results_live_with_partial_extent_verdict_and_tests',
    async (open) => {
      const study = await openStudy(open, linkTo({ scenario: { ...SPEC.scenario, steps: 12_000 } }));
      const { page, run } = study;
      await run.click();
      // A first report comes after a second, and a locator would look but twice a second.
      await study.until(() => {
        const partial = /^\d (to \d )?of 5 seeds from 5 in each cell, not complete\.$/.test(document.querySelector('.studies-extent')?.textContent ?? '');
        return partial && document.querySelector('.studies-figure')?.checkVisibility(); // the figure is there before the end
      });
      await study.finished();
      const section = (/** @type {string} */ name) => page.locator(`[data-section=${name}]`);
      await eventually(async () => assert.match((await section('paper').locator('tbody').textContent()) ?? '', /not reproduced/));
      await eventually(async () => assert.equal(await page.locator('.studies-verdicts').textContent(), 'The paper’s values: 1 not reproduced.'));
      await eventually(async () => assert.match((await section('tests').locator('tbody').textContent()) ?? '', /Mann-Whitney U.*A12/));
      await eventually(async () => assert.deepEqual(await section('mean_diversity').locator('thead th').allTextContents(), ['cell', 'runs', 'mean', 'sd', 'median', 'quartiles', 'range']));
      await page.locator('.studies-more summary').click();
      await eventually(async () => assert.match((await section('success').locator('thead').textContent()) ?? '', /Wilson/));
      await eventually(async () => assert.ok(await page.locator('.studies-figure').evaluate((image) => /** @type {HTMLImageElement} */ (image).naturalWidth > 0)));
      assert.deepEqual(study.problems, []);
    },
  ],
  [
    'rows_of_another_version_are_kept_apart',
    async (open) => {
      const study = await openStudy(open, linkTo(), { acceptDownloads: true });
      const hash = await study.page.locator('#studies .hash').textContent();
      await study.page.evaluate(
        (key) =>
          new Promise((resolve, reject) => {
            const request = indexedDB.open('swarm-playground.studies', 1);
            request.onsuccess = () => {
              const transaction = request.result.transaction('rows', 'readwrite');
              transaction.objectStore('rows').put({ study: key, run: 0, line: 'rows of another version\n' });
              transaction.oncomplete = () => resolve(null);
              transaction.onerror = reject;
            };
          }),
        `0.0.9/${hash}`,
      );
      await study.page.reload();
      await study.ready();
      assert.deepEqual(await study.done(), [0, 10]);
      await study.notice(/1 row of this study made with version 0\.0\.9 are kept too\. Versions never mix/);
      await study.finish();
      assert.doesNotMatch(await study.csv(), /another version/);
    },
  ],
  [
    'rows_that_cannot_be_read_are_told_and_can_be_cleared',
    async (open) => {
      const study = await openStudy(open, linkTo());
      await study.finish();
      await study.page.evaluate(
        () =>
          new Promise((resolve, reject) => {
            const request = indexedDB.open('swarm-playground.studies', 1);
            request.onsuccess = () => {
              const rows = request.result.transaction('rows', 'readwrite').objectStore('rows');
              rows.getAll().onsuccess = (event) => {
                const [first] = /** @type {IDBRequest} */ (event.target).result;
                rows.put({ ...first, line: '0,cut sho\n' }).onsuccess = resolve;
              };
              rows.transaction.onerror = reject;
            };
          }),
      );
      await study.page.reload();
      await study.notice(/^The rows kept here could not be read: line 2, column 1: expected \d+ fields, found 2\.$/);
      await study.page.locator('.notice').getByRole('button', { name: 'Clear results' }).click();
      await study.notice(/^10 rows cleared\.$/);
      await study.finish();
      assert.deepEqual(study.problems, []);
    },
  ],
  [
    'results_are_cleared_and_brought_back',
    async (open) => {
      const study = await openStudy(open, linkTo(), { acceptDownloads: true });
      await study.finish();
      const wanted = await study.csv();
      await study.page.getByRole('button', { name: 'Clear results' }).click();
      await study.notice(/^10 rows cleared\.$/);
      assert.deepEqual(await study.done(), [0, 10]);
      await study.page.getByRole('button', { name: 'Bring them back' }).click();
      await study.finished();
      assert.equal(await study.csv(), wanted);
      await study.page.getByRole('button', { name: 'Clear results' }).click();
      await study.notice(/^10 rows cleared\.$/);
      await study.page.reload();
      await study.ready();
      assert.deepEqual(await study.done(), [0, 10]);
    },
  ],
  [
    'without_storage_a_study_runs_in_memory_and_says_so',
    async (open) => {
      const { page } = await open('#/studies');
      await page.addInitScript(() => Object.defineProperty(window, 'indexedDB', { value: undefined }));
      await page.goto(page.url().replace(/#.*/, linkTo()));
      await page.reload();
      await page.locator('.notice p').filter({ hasText: /^This browser keeps nothing for the page, so results last/ }).waitFor();
      await page.locator('#studies-run').click();
      await page.waitForFunction(() => document.body.dataset.state === 'finished');
      await page.locator('.studies-extent').filter({ hasText: '5 of 5 seeds' }).waitFor();
      await page.locator('[id="study-seeds.count"]').fill('6');
      await page.locator('[id="study-seeds.count"]').press('Tab');
      await page.waitForFunction(() => document.querySelector('#studies-done')?.textContent === '10 of 12 runs');
      assert.equal(await page.locator('.notice p').filter({ hasText: 'keeps nothing' }).count(), 1, 'it is said once');
    },
  ],
  [
    'a_full_storage_is_told_once_and_the_study_goes_on',
    async (open) => {
      const study = await openStudy(open, linkTo());
      await study.page.evaluate(() => {
        IDBObjectStore.prototype.put = () => {
          throw new DOMException('no room', 'QuotaExceededError');
        };
      });
      await study.finish();
      assert.equal(await study.page.locator('.notice p').filter({ hasText: 'storage is full' }).count(), 1);
    },
  ],
  [
    'an_engine_that_breaks_is_started_again_with_study_and_rows',
    async (open) => {
      const study = await openStudy(open, linkTo({ scenario: { ...SPEC.scenario, steps: 2500 } }));
      const { page, inState } = study;
      await study.run.click();
      await study.made(2);
      const desk = page.workers().find((worker) => /\/desk-/.test(worker.url()));
      await desk?.evaluate(() => void setTimeout(() => { throw new Error('broken by the test'); }));
      await inState('error');
      await page.locator('.fault .message').filter({ hasText: /^The engine stopped: .*broken by the test/ }).waitFor();
      await page.getByRole('button', { name: 'Start it again' }).click();
      await inState('paused');
      await study.ready();
      await eventually(async () => assert.ok((await study.done())[0] >= 2));
      await study.finish();
    },
  ],
  [
    'more_runs_than_a_page_can_hold_are_left_to_the_command_line',
    async (open) => {
      const { page } = await open(linkTo({ grid: { 'geese.children': Array.from({ length: 50 }, (_, index) => index + 2) }, seeds: { first: 1, count: 10_000 } }));
      await page.locator('.studies-large').filter({ hasText: /^500,000 runs are more than a page can hold\. The command line makes them:/ }).waitFor();
      assert.ok(await page.locator('#studies-run').isDisabled());
      await page.locator('[id="study-seeds.count"]').fill('1');
      await page.locator('[id="study-seeds.count"]').press('Tab');
      await page.waitForFunction(() => document.querySelector('#studies-done')?.textContent === '0 of 50 runs');
    },
  ],
  [
    'leaving_the_tab_pauses_and_stop_gives_the_processor_back',
    async (open) => {
      const study = await openStudy(open, linkTo({ scenario: { ...SPEC.scenario, steps: 20_000 } }));
      const { page, inState } = study;
      await study.run.click();
      const hand = await study.hand();
      await page.getByRole('link', { name: 'Trees' }).click();
      await page.locator('#trees-fingerprint').filter({ hasText: /^[0-9a-f]{16}$/ }).waitFor();
      await page.getByRole('link', { name: 'Studies' }).click();
      await inState('paused');
      await eventually(async () => assert.equal(await study.run.textContent(), 'Resume'));
      await eventually(async () => assert.match((await page.locator('#studies-done').textContent()) ?? '', /1 run under way/));
      await study.stop.click();
      await eventually(() => assert.equal(study.hands().filter((worker) => worker.url() === hand.url()).length, 0)); // the tab Trees has a worker too
      await eventually(async () => assert.ok(await study.stop.isDisabled()));
    },
  ],
];
