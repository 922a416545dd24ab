import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';

/** What a button of the footer saves. @param {import('playwright-core').Page} page @param {string} label */
async function saved(page, label) {
  const waiting = page.waitForEvent('download');
  await page.locator('.take').getByRole('button', { name: label, exact: true }).click();
  const download = await waiting;
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'everything_can_be_taken_away_as_a_file',
    async (open) => {
      const { page, seek, problems } = await open('#/forage?preset=foraging&seed=9', { acceptDownloads: true });
      await seek(100);
      await page.locator('[role=treeitem]').first().waitFor();
      const png = await saved(page, 'PNG');
      assert.equal(png.name, 'swarm-foraging-seed9-tick100.png');
      assert.equal(png.bytes.subarray(1, 4).toString(), 'PNG');
      for (const label of ['SVG', 'Tree']) {
        const { bytes } = await saved(page, label);
        const drawing = bytes.toString();
        assert.match(drawing, /^<svg [^>]*xmlns="http:\/\/www\.w3\.org\/2000\/svg"/);
        assert.doesNotMatch(drawing, /NaN|undefined|var\(/);
        const shapes = await page.evaluate((source) => {
          const parsed = new DOMParser().parseFromString(source, 'image/svg+xml');
          return parsed.querySelector('parsererror') ? 0 : parsed.querySelectorAll('path, rect, text').length;
        }, drawing);
        assert.ok(shapes > 20, `${label}: ${shapes} shapes`);
      }
      const csv = (await saved(page, 'CSV')).bytes.toString().split('\n');
      assert.equal(csv[0], 'tick,delivered,carrying,programs,swaps');
      assert.equal(csv[1].split(',').length, 5);
      assert.ok(csv.length >= 6);
      const scenario = JSON.parse((await saved(page, 'JSON')).bytes.toString());
      assert.equal(scenario.seed, 9);
      assert.deepEqual(problems, []);
    },
  ],
  [
    'citation_holds_version_link_seed_fingerprint_and_paper',
    async (open) => {
      const { page, seek, notice } = await open('', { permissions: ['clipboard-read', 'clipboard-write'] });
      const fingerprint = await seek(30);
      await page.getByRole('button', { name: 'Cite', exact: true }).click();
      await notice(/citation is on the clipboard/);
      const cited = await page.evaluate(() => navigator.clipboard.readText());
      for (const part of ['Swarm playground', 'tick 30', fingerprint, '#/forage?v=', 'BeTr-GEESE']) assert.ok(cited.includes(part), part);
    },
  ],
];
