// The page #/bench: the numbers of `make bench` in the visitor's browser.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { violations } from './access.mjs';
import { FIXED, FIXED_STEPS, FORAGING, PUBLISHED, STEPS, TICKS, TREE } from '../../www/measure/measures.js';
import { eventually } from './browser.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
const SHORT = 1 / 20;

/** @param {string[]} words @returns {{ fingerprint: string }} */
const native = (...words) => JSON.parse(execFileSync('cargo', ['run', '--quiet', '--', ...words], { cwd: root, encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit'] }));

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'the_bench_page_computes_what_the_command_line_does_and_exports_every_round',
    async (open) => {
      const { page, inState, problems } = await open('#/forage', { acceptDownloads: true });
      await page.locator('#foot').getByRole('link', { name: 'How fast is it here?' }).click();
      await page.locator('#bench-short').check();
      await page.locator('#bench-run').click();
      await inState('busy');
      await inState('paused');
      await eventually(async () => assert.match((await page.locator('#bench-said').textContent()) ?? '', /^Measured, 1 round$/));
      const cells = await page.locator('.measure-table tbody tr').evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent ?? '')));
      assert.equal(cells.length, 9);
      const wanted = [
        native('bench', FORAGING, '--steps', String(STEPS * SHORT)),
        native('bench', PUBLISHED, '--steps', String(STEPS * SHORT)),
        native('bench', FIXED, '--steps', String(FIXED_STEPS * SHORT)),
        native('tree', 'bench', TREE, '--ticks', String(TICKS * SHORT)),
      ];
      wanted.forEach(({ fingerprint }, at) => assert.equal(cells[at][3], fingerprint, cells[at][0]));
      for (const row of cells.filter(([, here]) => here !== 'not in this version')) assert.match(row[1], /\d/, row.join(' | '));
      assert.match(cells[3][4], /38,000 to 45,000 root ticks\/s.*BehaviorTree\.CPP/);
      const waiting = page.waitForEvent('download');
      await page.getByRole('button', { name: 'CSV', exact: true }).click();
      const lines = readFileSync(await (await waiting).path(), 'utf8').trim().split('\n');
      assert.match(lines[0], /^# .*processors$/);
      assert.equal(lines[1], 'measure,unit,round,amount,seconds,fingerprint,integrations');
      assert.equal(lines.length - 2, cells.filter(([, here]) => here !== 'not in this version').length);
      assert.deepEqual(problems, []);
      return cells.map(([what, here]) => `${what.slice(0, 12)} ${here}`).join('; ');
    },
    'alone',
  ],
  ...['light', 'dark'].map((colorScheme) => /** @type {import('./browser.mjs').Case} */ ([
    `axe_finds_nothing_on_the_bench_page_and_in_the_film_dialog_in_${colorScheme}`,
    async (open) => {
      const { page, inState, at } = await open('#/bench', { colorScheme: /** @type {'light' | 'dark'} */ (colorScheme), viewport: { width: 390, height: 844 } });
      await page.locator('#bench-short').check();
      await page.locator('#bench-run').click();
      await inState('busy');
      await page.locator('.measure-table tbody td').filter({ hasText: 'robot-steps/s' }).first().waitFor();
      await page.locator('#bench-run').click();
      await inState('paused');
      assert.deepEqual(await violations(page), [], 'bench');
      await page.evaluate(() => void (location.hash = '#/forage'));
      await at(0);
      await page.locator('#foot').getByRole('button', { name: 'Video', exact: true }).click();
      await page.locator('.video-dialog').waitFor(); // it is loaded when it is asked for
      assert.deepEqual(await violations(page), [], 'film');
    },
  ])),
  [
    'neither_needs_sideways_scrolling_of_the_page_at_320_pixels',
    async (open) => {
      const { page, inState } = await open('#/bench', { viewport: { width: 320, height: 700 } });
      const width = () => page.evaluate(() => document.documentElement.scrollWidth);
      assert.equal(await width(), 320);
      await page.evaluate(() => void (location.hash = '#/forage'));
      await inState('paused');
      await page.locator('#foot').getByRole('button', { name: 'Video', exact: true }).click();
      const dialog = await page.locator('.video-dialog').boundingBox();
      assert.ok(dialog && dialog.x >= 0 && dialog.x + dialog.width <= 320, JSON.stringify(dialog));
      assert.equal(await width(), 320);
    },
  ],
  [
    'measuring_can_be_stopped_and_leaving_the_page_stops_it',
    async (open) => {
      const { page, inState, until } = await open('#/bench');
      await page.locator('#bench-run').click();
      await inState('busy');
      await page.locator('#bench-run').filter({ hasText: 'Stop' }).click();
      await inState('paused');
      await page.locator('#bench-said').filter({ hasText: 'Stopped' }).waitFor();
      await page.locator('#bench-run').click();
      await inState('busy');
      await page.getByRole('link', { name: 'Trees' }).click();
      await until(() => /** @type {HTMLElement} */ (document.querySelector('#bench')).dataset.state === 'paused');
    },
  ],
];
