import assert from 'node:assert/strict';
import { violations } from './access.mjs';
import { SMALL, openPlan } from './plan.mjs';

const WIDTHS = [1440, 1024, 390];

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  ...['light', 'dark'].flatMap((colorScheme) =>
    WIDTHS.map((width) => /** @type {import('./browser.mjs').Case} */ ([
      `axe_finds_nothing_in_${colorScheme}_at_${width}_pixels_of_sequence`,
      async (open) => {
        const phone = width < 900;
        const options = { viewport: { width, height: phone ? 844 : 900 }, colorScheme: /** @type {'light' | 'dark'} */ (colorScheme), ...(phone ? { hasTouch: true, isMobile: true } : {}) };
        const { page, result, tab, problems } = await openPlan(open, SMALL, options);
        await result('optimal');
        const sheet = async () => phone && (await page.locator('#sequence .sheet-handle').click());
        assert.deepEqual(await violations(page), [], 'opening');
        await page.locator('#sequence-thing').selectOption('target-0');
        await page.locator('#sequence .plan-cell').nth(1).click();
        await page.locator('#sequence-behaviour').selectOption('W');
        await page.locator('#sequence-hand').filter({ hasText: 'Your plan' }).waitFor();
        assert.deepEqual(await violations(page), [], 'plan made by hand');
        await sheet();
        for (const name of /** @type {const} */ (['plan', 'search', 'robots', 'game'])) {
          await tab(name);
          assert.deepEqual(await violations(page), [], name);
        }
        await page.locator('#sequence-game-begin').click();
        assert.deepEqual(await violations(page), [], 'game');
        await page.getByRole('button', { name: 'Show the plan' }).click();
        await sheet();
        await page.getByRole('button', { name: 'A | B' }).click();
        await page.locator('#sequence-compare').filter({ hasText: /^A:/ }).waitFor();
        assert.deepEqual(await violations(page), [], 'A | B');
        assert.deepEqual(problems, []);
      },
    ])),
  ),
  ...[320, 390, 768, 1024].map((width) => /** @type {import('./browser.mjs').Case} */ ([
    `sequence_does_not_scroll_sideways_at_${width}_pixels`,
    async (open) => {
      const { page, result, tab } = await openPlan(open, SMALL, { viewport: { width, height: 640 }, hasTouch: true });
      await result('optimal');
      const check = async (/** @type {string} */ where) => {
        const [scroll, client] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
        assert.ok(scroll <= client, `${where}: ${scroll} pixels in a window of ${client}`);
      };
      await check('opening');
      await page.locator('#sequence-thing').selectOption('robot-1');
      await check('robot chosen');
      if (width < 900) await page.locator('#sequence .sheet-handle').click();
      for (const name of /** @type {const} */ (['plan', 'search', 'robots', 'game'])) {
        await tab(name);
        await check(name);
      }
      if (width < 900) await page.locator('#sequence .sheet-handle').click();
      await page.getByRole('button', { name: 'A | B' }).click();
      await page.locator('#sequence-compare').filter({ hasText: /^A:/ }).waitFor();
      await check('A | B');
    },
  ])),
  [
    'targets_of_sequence_are_large_enough_for_fingers',
    async (open) => {
      const { page, result } = await openPlan(open, SMALL, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
      await result('optimal');
      await page.locator('#sequence-thing').selectOption('robot-1');
      const small = await page.locator('#sequence button:visible, #sequence summary:visible, #sequence select:visible').evaluateAll((targets) =>
        targets.filter((target) => target.getBoundingClientRect().height < 43.5).map((target) => target.outerHTML.slice(0, 80)),
      );
      assert.deepEqual(small, []);
    },
  ],
  [
    'sequence_is_dragged_by_touch_and_the_page_scrolls_elsewhere',
    async (open) => {
      const { page, result, middle, until } = await openPlan(open, SMALL, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
      await result('optimal');
      const [x, y] = await middle('target-0');
      const touch = await page.context().newCDPSession(page);
      const send = (/** @type {'touchStart' | 'touchMove' | 'touchEnd'} */ type, /** @type {number[][]} */ points) =>
        touch.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([px, py]) => ({ x: px, y: py })) });
      await send('touchStart', [[x, y]]);
      for (let step = 1; step <= 6; step += 1) await send('touchMove', [[x, y + 5 * step]]);
      await send('touchEnd', []);
      await until(() => location.hash.includes('target-y'));
      assert.equal(await page.locator('#sequence-thing').inputValue(), 'target-0');
      const styles = await page.evaluate(() => [getComputedStyle(/** @type {Element} */ (document.querySelector('#sequence .thing.target'))).touchAction, getComputedStyle(/** @type {Element} */ (document.querySelector('#sequence .stage canvas'))).touchAction]);
      assert.deepEqual(styles, ['none', 'pan-y']);
    },
  ],
];
