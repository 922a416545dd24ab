import assert from 'node:assert/strict';
import { OPENING } from '../../www/opening.js';
import { eventually, findChromium, launch, patient } from './browser.mjs';

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'opens_and_plays_from_the_still_without_error_or_foreign_request',
    async (open) => {
      const { page, until, inState, problems } = await open('#/', { reducedMotion: 'no-preference' });
      await inState('running');
      await until((tick) => Number(document.querySelector('#tick')?.textContent) >= tick + 5, OPENING.tick);
      await eventually(async () => assert.equal(await page.locator('#preset').inputValue(), OPENING.preset));
      await eventually(async () => assert.equal(await page.locator('#seed').inputValue(), String(OPENING.seed)));
      await eventually(async () => assert.match((await page.locator('.lede').textContent()) ?? '', /Nobody wrote these behaviours/));
      assert.equal(await page.locator('#still').count(), 0);
      await page.locator('#tab-charts').click(); // loads the charts
      await page.locator('.uplot').first().waitFor();
      assert.equal(await page.locator('.notice').count(), 0);
      assert.deepEqual(problems, []);
    },
  ],
  [
    'reduced_motion_waits_at_the_still_with_play',
    async (open) => {
      const { page, at } = await open('#/');
      await at(OPENING.tick);
      await eventually(async () => assert.equal(await page.locator('#play').textContent(), 'Play'));
      await eventually(async () => assert.equal(await page.locator('#tag').textContent(), 'Paused'));
      await eventually(async () => assert.ok(await page.locator('#tag').isVisible()));
      await page.waitForTimeout(300);
      assert.equal(await page.locator('#tick').textContent(), String(OPENING.tick));
    },
  ],
  [
    'the_still_is_the_engines_state_at_its_tick',
    async (open, url) => {
      const html = await (await fetch(url)).text();
      const still = /<svg id="still"[^>]*>/.exec(html)?.[0] ?? '';
      const said = (/** @type {string} */ name) => new RegExp(`data-${name}="([^"]+)"`).exec(still)?.[1];
      assert.equal(said('preset'), OPENING.preset);
      const { seek, page } = await open(`#/forage?preset=${said('preset')}&seed=${said('seed')}`);
      assert.equal(await seek(Number(said('tick'))), said('fingerprint'));
      const drawing = html.slice(html.indexOf(still), html.indexOf('</svg>') + 6);
      assert.ok(drawing.length <= 12_000, `${drawing.length} bytes`);
      const summary = page.locator('#summary').filter({ hasText: `Tick ${said('tick')}.` });
      const [, carrying] = /** @type {RegExpExecArray} */ (/\. (\d+) of 100 robots carry/.exec((await summary.textContent()) ?? ''));
      assert.equal((drawing.match(/href="#still-c"/g) ?? []).length, Number(carrying));
      assert.equal((drawing.match(/href="#still-[rc]"/g) ?? []).length, 100);
      return `${drawing.length} bytes`;
    },
  ],
  ...['light', 'dark'].map((colorScheme) => /** @type {import('./browser.mjs').Case} */ ([
    `without_script_the_still_the_sentence_and_a_way_out_are_seen_in_${colorScheme}`,
    async (_, url) => {
      const browser = await launch(/** @type {string} */ (findChromium()));
      const page = await patient(await browser.newContext({ javaScriptEnabled: false, colorScheme: /** @type {'light' | 'dark'} */ (colorScheme), viewport: { width: 1440, height: 900 } })).newPage();
      await page.goto(url);
      assert.ok(await page.locator('.lede').isVisible());
      assert.ok(await page.locator('noscript p').isVisible());
      const box = await page.locator('#still').boundingBox();
      assert.ok(box && box.width > 400, JSON.stringify(box));
      assert.equal(await page.locator('#still use').count(), 100);
      await browser.close();
    },
  ])),
  [
    'the_live_world_takes_the_place_of_the_still_without_a_jump',
    async (_, url) => {
      const browser = await launch(/** @type {string} */ (findChromium()));
      const jumps = [];
      for (const [width, height] of [[1440, 900], [1024, 768], [390, 844]]) {
        const plain = await patient(await browser.newContext({ viewport: { width, height } })).newPage();
        await plain.route('**/*.js', (route) => route.abort());
        await plain.goto(url);
        const before = await plain.locator('#still').boundingBox();
        const page = await patient(await browser.newContext({ reducedMotion: 'reduce', viewport: { width, height } })).newPage();
        await page.goto(url);
        await page.waitForFunction((tick) => document.querySelector('#tick')?.textContent === String(tick) && !document.querySelector('#still'), OPENING.tick);
        const after = await page.locator('#canvas').boundingBox();
        for (const side of /** @type {const} */ (['x', 'y', 'width'])) {
          if (Math.abs((before?.[side] ?? 0) - (after?.[side] ?? 0)) > 2) jumps.push(`${width} pixels wide: ${JSON.stringify(before)} became ${JSON.stringify(after)}`);
        }
      }
      await browser.close();
      assert.deepEqual(jumps, []);
    },
  ],
  [
    'start_from_random_begins_at_tick_0_at_full_speed_and_draws_the_curves',
    async (open) => {
      const { page, at, inState, until } = await open('#/');
      await at(OPENING.tick);
      await page.locator('#from-random').click();
      await inState('running');
      await page.locator('.uplot').first().waitFor();
      assert.ok(await page.locator('#max').isChecked());
      await until(() => Number(document.querySelector('#tick')?.textContent) > 0);
      await page.locator('#play').click();
      await inState('paused');
      await eventually(async () => assert.match(await page.evaluate(() => location.hash), new RegExp(`seed=${OPENING.seed}`)));
    },
  ],
  [
    'a_press_before_the_engine_is_there_is_not_lost',
    async (open) => {
      const { page, inState, until } = await open('#/trees');
      await page.route('**/*.wasm', async (route) => (await new Promise((resolve) => setTimeout(resolve, 1500)), route.continue()));
      await page.goto(page.url().replace(/#.*/, '#/'));
      await page.reload();
      await page.locator('#from-random').click();
      await inState('running');
      await eventually(async () => assert.ok(await page.locator('#max').isChecked()));
      await until(() => location.hash.startsWith('#/forage'));
    },
  ],
  [
    'a_link_shows_neither_still_nor_landing',
    async (open) => {
      const { page } = await open('#/forage?preset=nest');
      assert.equal(await page.locator('#still, #landing').count(), 0);
    },
  ],
  [
    'first_paint_and_first_interaction_with_the_processor_slowed_four_times',
    async (_, url) => {
      const browser = await launch(/** @type {string} */ (findChromium()));
      /** @type {{ paint: number, ready: number, runs: number }[]} */
      const times = [];
      for (let round = 0; round < 5; round += 1) {
        const page = await patient(await browser.newContext({ viewport: { width: 1440, height: 900 } })).newPage();
        await (await page.context().newCDPSession(page)).send('Emulation.setCPUThrottlingRate', { rate: 4 });
        await page.addInitScript(() => {
          const watch = new MutationObserver(() => {
            const button = document.querySelector('#from-random');
            if (button instanceof HTMLButtonElement && !button.disabled) {
              performance.mark('can be pressed');
              watch.disconnect();
            }
          });
          watch.observe(document, { subtree: true, childList: true, attributes: true });
        });
        await page.goto(url);
        await page.waitForFunction(() => document.body.dataset.state === 'running');
        await page.evaluate(() => performance.mark('runs'));
        times.push(
          await page.evaluate(() => ({
            paint: performance.getEntriesByName('first-contentful-paint')[0].startTime,
            ready: performance.getEntriesByName('can be pressed')[0].startTime,
            runs: performance.getEntriesByName('runs')[0].startTime,
          })),
        );
        await page.context().close();
      }
      await browser.close();
      const least = (/** @type {'paint' | 'ready'} */ what) => Math.min(...times.map((time) => time[what])); // other work on the machine only adds; the aims are 1000 and 1500
      const note = times.map(({ paint, ready, runs }) => `${paint.toFixed(0)}/${ready.toFixed(0)}/${runs.toFixed(0)}`).join(', ');
      assert.ok(least('paint') <= 2 * 1000 && least('ready') <= 2 * 1500, `first paint / first interaction / live world in ms: ${note}`);
      return `first paint / first interaction / live world in ms: ${note}`;
    },
    'alone',
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
