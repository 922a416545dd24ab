import assert from 'node:assert/strict';

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'opens_and_plays_without_error_or_foreign_request',
    async (open) => {
      const { page, until, inState, problems } = await open('', { reducedMotion: 'no-preference' });
      await inState('running');
      await until(() => Number(document.querySelector('#tick')?.textContent) >= 5);
      assert.equal(await page.locator('#preset').inputValue(), 'foraging');
      assert.match((await page.locator('.lede').textContent()) ?? '', /Nobody wrote these behaviours/);
      await page.locator('#tab-charts').click(); // loads the charts
      await page.locator('.uplot').first().waitFor();
      assert.deepEqual(problems, []);
    },
  ],
  [
    'reduced_motion_waits_at_tick_0_with_play',
    async (open) => {
      const { page, inState, tick } = await open();
      await inState('paused');
      assert.equal(await tick(), 0);
      assert.equal(await page.locator('#play').textContent(), 'Play');
      assert.equal(await page.locator('#tag').textContent(), 'Paused');
      assert.ok(await page.locator('#tag').isVisible());
    },
  ],
  [
    'first_load_stays_small',
    async (open, url) => {
      const { page } = await open();
      await page.locator('.programs li').first().waitFor();
      const loaded = await page.evaluate(() => performance.getEntriesByType('resource').map((entry) => entry.name));
      const addresses = new Set([url, ...loaded, ...page.workers().map((worker) => worker.url())]);
      const sizes = { js: 0, css: 0, html: 0 };
      const { gzipSync } = await import('node:zlib');
      for (const address of addresses) {
        const kind = address === url ? 'html' : /\.(js|css)$/.exec(address)?.[1];
        if (!kind) continue;
        const body = Buffer.from(await (await fetch(address)).arrayBuffer());
        sizes[/** @type {keyof typeof sizes} */ (kind)] += gzipSync(body, { level: 9 }).length;
      }
      assert.ok(sizes.js <= 45_000, `${sizes.js} bytes of script, 45000 allowed`);
      assert.ok(sizes.css <= 8_000, `${sizes.css} bytes of style, 8000 allowed`);
      return `script ${sizes.js} bytes gzipped, style ${sizes.css}, page ${sizes.html}`;
    },
  ],
];
