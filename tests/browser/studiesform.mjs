import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { packed } from './bench.mjs';
import { eventually } from './browser.mjs';
import { SPEC, linkTo, openStudy } from './studies.mjs';

const file = (/** @type {string} */ name) => fileURLToPath(new URL(`../../studies/${name}.json`, import.meta.url));

/** The study that the text holds. @param {Awaited<ReturnType<typeof openStudy>>} study */
const held = async ({ text }) => JSON.parse(await text.inputValue());

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'list_names_every_study_with_its_runs_and_then_their_time',
    async (open) => {
      const study = await openStudy(open, '#/studies');
      const { page } = study;
      await page.locator('.study-row').first().waitFor();
      const files = readdirSync('studies').filter((name) => name.endsWith('.json'));
      assert.equal(await page.locator('.study-row').count(), files.length);
      const agents = page.locator('.study-row[data-study=agents]');
      assert.deepEqual(await agents.locator('.study-sizes li').allTextContents(), ['Glance, agents10 runs', 'Class, agents20 runs', 'Paper, agents160 runs']);
      await agents.getByRole('link', { name: 'Glance' }).click();
      await study.ready();
      await study.until(() => /^#\/studies\/agents\?v=\d+\.\d+\.\d+&size=glance$/.test(location.hash));
      await study.finish();
      await page.getByRole('link', { name: 'All studies' }).click();
      const glance = agents.locator('.study-sizes li').first();
      await glance.filter({ hasText: 'all made here' }).waitFor();
      assert.match((await agents.locator('.study-sizes li').nth(2).textContent()) ?? '', /\d (s|min|h)$/);
      await page.goBack();
      await study.finished();
      assert.deepEqual(study.problems, []);
    },
  ],
  [
    'a_fault_is_told_at_its_field_and_the_last_valid_study_is_kept',
    async (open) => {
      const study = await openStudy(open, linkTo());
      const { page } = study;
      await study.finish();
      const faults = /** @type {[object, string, RegExp][]} */ ([
        [{ grid: { 'geese.childern': [2] } }, 'grid.geese.childern', /unknown name "geese\.childern", did you mean "geese\.children"\?/],
        [{ grid: { 'geese.children': [2, -1] } }, 'grid.geese.children', /grid\.geese\.children\[1\]: .*-1/],
        [{ seeds: { first: 5, count: 0 } }, 'seeds.count', /expected a whole number from 1 to 10000, found 0/],
        [{ metrics: ['share', 'shares'] }, 'metrics', /metrics\[1\]: unknown name "shares", did you mean "share"\?/],
        [{ figure: { kind: 'bars', metric: 'share' } }, 'figure.kind', /unknown name "bars"/],
        [{ scenario: { world: 'geese', agents: 20, steps: 'many' } }, 'scenario.steps', /"many"/],
        [{ cells: [{ name: 'one', set: { 'geese.agents': 0 } }], tests: undefined, paper: undefined }, 'cells[0].set.geese.agents', /found 0/],
      ]);
      for (const [changes, path, message] of faults) {
        await study.type(JSON.stringify({ ...SPEC, ...changes }, null, 2));
        const place = page.locator(`[data-path="${path}"] > .field-error`);
        await place.filter({ hasText: message }).waitFor();
        await eventually(async () => assert.match((await page.locator('#studies-fault').textContent()) ?? '', message));
        await eventually(async () => assert.equal(await page.locator('.studies-results .stale').textContent(), 'The text has a fault. What runs and is reported is the last valid study.'));
        assert.deepEqual(await study.done(), [10, 10]);
        await page.getByRole('button', { name: 'Show the place' }).click();
        const chosen = await study.text.evaluate((area) => {
          const { value, selectionStart, selectionEnd } = /** @type {HTMLTextAreaElement} */ (area);
          return value.slice(selectionStart, selectionEnd);
        });
        const last = path.split(/\.(?!childern|children|agents)/).at(-1) ?? '';
        assert.ok(chosen.includes(last) || /shares|-1/.test(chosen), `${path}: ${chosen}`);
      }
      await study.type('{"study": "small",\n  oops');
      await page.locator('#studies-fault').filter({ hasText: /^expected a study as JSON: .*line 2 column/ }).waitFor();
      await page.locator('.form-missing').waitFor();
      await study.type(JSON.stringify(SPEC, null, 2));
      await page.locator('.studies-results .stale').waitFor({ state: 'hidden' });
      assert.deepEqual(await study.done(), [10, 10], 'the rows are still there');
      assert.deepEqual(study.problems, []);
    },
  ],
  [
    'form_and_text_follow_each_other',
    async (open) => {
      const study = await openStudy(open, linkTo());
      const { page, until } = study;
      const grid = page.locator('[id="study-grid.geese.children"]');
      await grid.fill('2, 4, 8');
      await grid.press('Tab');
      await until(() => /^0 of 15 runs/.test(document.querySelector('#studies-done')?.textContent ?? ''));
      assert.deepEqual((await held(study)).grid, { 'geese.children': [2, 4, 8] });
      await page.locator('[id="study-grid-add"]').selectOption({ label: 'Mutation' });
      await page.locator('[data-path=grid]').getByRole('button', { name: 'Add' }).click();
      const boxes = page.locator('[data-path="grid.geese.mutation-mode"] input');
      await eventually(async () => assert.equal(await boxes.first().isChecked(), true, 'it begins with its default'));
      await boxes.nth(1).check();
      // The test and the paper's value still name cells of before.
      await page.locator('#studies-fault').filter({ hasText: /cell's name such as/ }).waitFor();
      const { tests, paper, ...others } = await held(study);
      await study.type(JSON.stringify(others));
      await until(() => /^0 of 30 runs/.test(document.querySelector('#studies-done')?.textContent ?? ''));
      await page.locator('[id="study-seeds.count"]').fill('2');
      await page.locator('[id="study-seeds.count"]').press('Enter');
      await until(() => /^0 of 12 runs/.test(document.querySelector('#studies-done')?.textContent ?? ''));
      await page.getByRole('button', { name: 'Remove Children' }).click();
      await page.locator('#studies-fault').filter({ hasText: /^figure\.x/ }).waitFor();
      await page.locator('[id="study-figure.x"]').selectOption({ label: 'Mutation' });
      await until(() => /^0 of 4 runs/.test(document.querySelector('#studies-done')?.textContent ?? ''));
      await study.type(JSON.stringify({ ...(await held(study)), title: 'Another title' }));
      await page.locator('#studies-title').filter({ hasText: 'Another title' }).waitFor();
      await page.locator('#studies-part-words summary').click();
      await eventually(async () => assert.equal(await page.locator('#study-title').inputValue(), 'Another title'));
      await page.locator('#studies-part-cells summary').click();
      await page.getByRole('button', { name: 'Add a cell' }).click();
      await page.locator('[id="study-cells[0]"] summary').click();
      await page.locator('[id="study-cells[0].set-add"]').selectOption({ label: 'Robots' });
      await page.locator('[data-path="cells[0].set"]').getByRole('button', { name: 'Add' }).click();
      await page.locator('[id="study-cells[0].set.geese.agents"]').fill('7');
      await page.locator('[id="study-cells[0].set.geese.agents"]').press('Tab');
      await page.waitForFunction(() => /"geese\.agents": 7/.test(/** @type {HTMLTextAreaElement} */ (document.querySelector('#studies-json')).value));
      assert.deepEqual((await held(study)).cells, [{ name: 'cell 1', set: { 'geese.agents': 7 } }]);
      assert.deepEqual(study.problems, []);
    },
  ],
  [
    'words_of_a_study_change_while_it_runs_and_its_cells_start_anew',
    async (open) => {
      const study = await openStudy(open, linkTo({ scenario: { ...SPEC.scenario, steps: 4000 } }));
      const { page } = study;
      await study.run.click();
      await study.made(1);
      await study.type(JSON.stringify({ ...(await held(study)), title: 'Renamed while it ran' }));
      await page.locator('#studies-title').filter({ hasText: 'Renamed' }).waitFor();
      assert.equal(await page.evaluate(() => document.body.dataset.state), 'busy', 'only words differ');
      const [before] = await study.done();
      assert.ok(before >= 1);
      await study.type(JSON.stringify({ ...(await held(study)), scenario: { ...SPEC.scenario, steps: 4001 } }));
      await study.inState('paused');
      await eventually(async () => assert.deepEqual(await study.done(), [0, 10]));
      await study.type(JSON.stringify({ ...(await held(study)), scenario: { ...SPEC.scenario, steps: 4000 } }));
      await study.made(before);
    },
  ],
  [
    'a_link_holds_study_and_size_and_names_what_it_cannot_read',
    async (open) => {
      const permissions = { permissions: ['clipboard-read', 'clipboard-write'] };
      const study = await openStudy(open, linkTo({ title: 'Linked' }), permissions);
      await study.page.getByRole('button', { name: 'Copy link' }).click();
      await study.notice(/The link is on the clipboard\. It holds the study, not the results\./);
      const link = await study.page.evaluate(() => navigator.clipboard.readText());
      const other = await openStudy(open, link.slice(link.indexOf('#')));
      assert.deepEqual(await held(other), { ...SPEC, title: 'Linked' });
      assert.equal(await other.page.locator('#studies-size').inputValue(), 'paper');
      const named = await openStudy(open, '#/studies/turning?v=0.0.9&size=class&nonsense=1');
      await named.notice(/Made with 0\.0\.9, this is/);
      await named.notice(/holds 'nonsense'/);
      assert.equal(await named.page.locator('#studies-size').inputValue(), 'class');
      const broken = await openStudy(open, '#/studies');
      await broken.page.goto(broken.page.url().replace(/#.*/, '#/studies/succes'));
      await broken.notice(/The link's 'study' was left out: found 'succes', expected one of .*\bsuccess\b/);
      const long = await openStudy(open, `#/studies?size=paper&spec=${packed(JSON.stringify({ ...SPEC, title: Array.from({ length: 2000 }, (_, index) => String.fromCharCode(97 + ((index * index * 31) % 26))).join('') }))}`);
      assert.deepEqual(await long.done(), [0, 10]);
    },
  ],
  [
    'a_file_of_ones_own_opens_and_a_wrong_one_says_where',
    async (open) => {
      const study = await openStudy(open, '#/studies', { permissions: ['clipboard-read', 'clipboard-write'], acceptDownloads: true });
      const { page } = study;
      await page.locator('.study-row').first().waitFor();
      await page.locator('input[type=file]').setInputFiles(file('turning'));
      await study.notice(/^Opened: turning\.json\.$/);
      const saving = page.waitForEvent('download');
      await page.getByRole('button', { name: 'Save as a file' }).click();
      const saved = readFileSync(await (await saving).path(), 'utf8');
      assert.equal(saved, readFileSync(file('turning'), 'utf8'), 'what was not edited is saved as it was');
      await page.getByRole('link', { name: 'All studies' }).click();
      await page.locator('input[type=file]').setInputFiles({ name: 'cut.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(SPEC).slice(0, 100)) });
      await page.locator('#studies-fault').filter({ hasText: /EOF while parsing/ }).waitFor();
      await eventually(async () => assert.equal(await page.locator('.studies-results .stale').textContent(), 'The text is no valid study yet; its fault stands beside it.'));
      await eventually(async () => assert.ok(await study.run.isDisabled(), 'the study that was open before is not what runs'));
      await page.getByRole('link', { name: 'All studies' }).click();
      await page.evaluate((text) => navigator.clipboard.writeText(text), JSON.stringify({ ...SPEC, title: 'Pasted' }));
      await page.getByRole('button', { name: 'Paste' }).click();
      await page.locator('#studies-title').filter({ hasText: 'Pasted' }).waitFor();
      assert.deepEqual(study.problems, []);
    },
  ],
  [
    'a_size_too_large_shows_the_command_and_the_committed_results',
    async (open) => {
      const study = await openStudy(open, '#/studies/success?size=paper', { acceptDownloads: true });
      const { page } = study;
      await page.locator('.studies-large').filter({ hasText: 'too large for a page: 768 runs' }).waitFor();
      await eventually(async () => assert.equal(await page.locator('.command').textContent(), 'cargo run --release -- study studies/success.json --out success.csv'));
      await page.locator('.studies-source').filter({ hasText: 'made by the command line and are part of the project: results/success.csv' }).waitFor();
      await page.locator('.studies-extent').filter({ hasText: '64 of 64 seeds from 1 in each cell.' }).waitFor();
      assert.doesNotMatch((await page.locator('.studies-source').textContent()) ?? '', /another state/);
      await eventually(async () => assert.match((await page.locator('[data-section=paper]').textContent()) ?? '', /BeTr-GEESE, foraging, robust.*not reproduced/));
      assert.equal(await study.csv(), readFileSync(fileURLToPath(new URL('../../results/success.csv', import.meta.url)), 'utf8'));
      await page.getByRole('button', { name: 'Made here: 0 of 768' }).click();
      await page.locator('.studies-extent').filter({ hasText: 'No run has been made yet' }).waitFor();
      await eventually(async () => assert.ok(await page.locator('.studies-source').isHidden()));
      assert.deepEqual(study.problems, []);
    },
  ],
];
