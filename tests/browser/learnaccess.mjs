import assert from 'node:assert/strict';
import { violations } from './access.mjs';
import { lessons } from './learn.mjs';

const WIDTHS = [[1440, 900], [1024, 768], [390, 844]];

/** Waits until a lesson and the world beside it stand. @param {import('./browser.mjs').Opened} opened */
const stands = ({ until }) => until(() => document.body.hasAttribute('data-beside') && !['loading', 'error'].includes(document.body.dataset.state ?? 'loading'));

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  ...['light', 'dark'].flatMap((colorScheme) =>
    WIDTHS.map(([width, height]) => /** @type {import('./browser.mjs').Case} */ ([
      `axe_finds_nothing_on_lessons_landing_and_share_in_${colorScheme}_at_${width}`,
      async (open) => {
        const opened = await open('#/', { colorScheme: /** @type {'light' | 'dark'} */ (colorScheme), viewport: { width, height } });
        const { page, until } = opened;
        await until(() => !document.querySelector('#still') && document.body.dataset.state === 'paused');
        assert.deepEqual(await violations(page), [], 'landing');
        await page.locator('[data-action=share]').click();
        await page.locator('.qr').waitFor();
        for (const part of ['.share-hide summary', '.share-embed summary']) await page.locator(part).click();
        assert.deepEqual(await violations(page), [], 'share');
        await page.keyboard.press('Escape');
        await page.evaluate(() => void (location.hash = '#/learn'));
        await page.locator('.learn-list').waitFor();
        assert.deepEqual(await violations(page), [], 'list');
        await page.evaluate(() => void (location.hash = '#/learn/2'));
        await stands(opened);
        await page.locator('#learn-option-walk').check();
        await page.locator('#learn-ask').click();
        await page.locator('.learn-table').waitFor();
        assert.deepEqual(await violations(page), [], 'lesson');
        await page.evaluate(() => void (location.hash = '#/learn/worksheet'));
        await page.locator('.sheet-page').first().waitFor();
        assert.deepEqual(await violations(page), [], 'worksheet');
      },
    ])),
  ),
  [
    'axe_finds_nothing_on_any_lesson',
    async (open) => {
      const opened = await open('#/learn/1');
      for (const { number } of lessons) {
        await opened.page.evaluate((wanted) => void (location.hash = `#/learn/${wanted}`), number);
        await opened.until((wanted) => document.querySelector('.learn-place')?.textContent?.startsWith(`${wanted} `), number);
        await stands(opened);
        assert.deepEqual(await violations(opened.page), [], `lesson ${number}`);
      }
    },
  ],
  ...['#/', '#/learn', '#/learn/1', '#/learn/2', '#/learn/4', '#/learn/7', '#/learn/worksheet', '#/forage?preset=foraging&hide=controls,inspector'].map((hash) => /** @type {import('./browser.mjs').Case} */ ([
    `nothing_scrolls_sideways_at_320_pixels_in_${hash}`,
    async (open) => {
      const { page, until } = await open(hash, { viewport: { width: 320, height: 640 }, hasTouch: true });
      await until(() => !['loading', 'error'].includes(document.body.dataset.state ?? 'loading'));
      await page.waitForLoadState('networkidle');
      const { scroll, client } = await page.evaluate(() => ({ scroll: document.documentElement.scrollWidth, client: document.documentElement.clientWidth }));
      assert.ok(scroll <= client, `${scroll} pixels in a window of ${client}`);
    },
  ])),
];
