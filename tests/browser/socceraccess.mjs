import assert from 'node:assert/strict';
import { violations } from './access.mjs';
import { eventually } from './browser.mjs';
import { openSoccer } from './pitch.mjs';

const WIDTHS = [1440, 1024, 390];
const TABS = /** @type {const} */ (['coach', 'roles', 'organisation', 'log', 'charts']);
const FIXED = '#/soccer?preset=match&seed=3&soccer.half-seconds=20&t=400';

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  ...['light', 'dark'].flatMap((colorScheme) =>
    WIDTHS.map((width) => /** @type {import('./browser.mjs').Case} */ ([
      `axe_finds_nothing_in_${colorScheme}_at_${width}_pixels_of_soccer`,
      async (open) => {
        const phone = width < 900;
        const options = { viewport: { width, height: phone ? 844 : 900 }, colorScheme: /** @type {'light' | 'dark'} */ (colorScheme), ...(phone ? { hasTouch: true, isMobile: true } : {}) };
        const { page, whole, tab, team, problems } = await openSoccer(open, FIXED, options);
        await whole();
        if (phone) await page.locator('#soccer .tools-fold > summary').click();
        await page.locator('#soccer-thing').selectOption('1');
        assert.deepEqual(await violations(page), [], 'opening');
        for (const name of TABS) {
          await tab(name);
          assert.deepEqual(await violations(page), [], name);
        }
        await tab('coach');
        await team('Yellow');
        await page.locator('#soccer .statechart').waitFor();
        assert.deepEqual(await violations(page), [], 'state chart');
        await team('Blue');
        await page.getByRole('button', { name: 'Edit the text' }).click();
        await page.locator('#soccer .soccer-code .cm-content').waitFor();
        assert.deepEqual(await violations(page), [], 'text');
        if (phone) await page.locator('#soccer .sheet-handle').click();
        await page.getByRole('button', { name: 'A | B' }).click();
        await page.locator('#soccer-compare').filter({ hasText: 'At full time' }).waitFor();
        assert.deepEqual(await violations(page), [], 'A | B');
        await page.getByRole('button', { name: 'Tournament' }).click();
        assert.deepEqual(await violations(page), [], 'tournament');
        assert.deepEqual(problems, []);
      },
    ])),
  ),
  ...[320, 390, 768, 1024].map((width) => /** @type {import('./browser.mjs').Case} */ ([
    `soccer_does_not_scroll_sideways_at_${width}_pixels`,
    async (open) => {
      const { page, whole, tab } = await openSoccer(open, FIXED, { viewport: { width, height: 640 }, hasTouch: true });
      await whole();
      const check = async (/** @type {string} */ where) => {
        const [scroll, client] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
        assert.ok(scroll <= client, `${where}: ${scroll} pixels in a window of ${client}`);
      };
      if (width < 900) await page.locator('#soccer .tools-fold > summary').click();
      await page.locator('#soccer-thing').selectOption('1');
      await check('opening');
      for (const name of TABS) {
        await tab(name);
        await check(name);
      }
      if (width < 900) await page.locator('#soccer .sheet-handle').click();
      await page.getByRole('button', { name: 'A | B' }).click();
      await check('A | B');
      await page.getByRole('button', { name: 'Tournament' }).click();
      await check('tournament');
    },
  ])),
  [
    'targets_of_soccer_are_large_enough_for_fingers',
    async (open) => {
      const { page, whole } = await openSoccer(open, FIXED, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
      await whole();
      await page.locator('#soccer .tools-fold > summary').click();
      const small = await page.locator('#soccer button:visible, #soccer summary:visible, #soccer select:visible').evaluateAll((targets) =>
        targets.filter((target) => target.getBoundingClientRect().height < 43.5).map((target) => target.outerHTML.slice(0, 80)),
      );
      assert.deepEqual(small, []);
    },
  ],
  [
    'soccer_is_worked_by_keyboard_alone',
    async (open) => {
      const { page, whole, until, tick } = await openSoccer(open, '#/soccer?preset=match&seed=3&soccer.half-seconds=20');
      await whole();
      await page.keyboard.press('?');
      const keys = (await page.locator('.keys-dialog').textContent()) ?? '';
      assert.match(keys, /on the pitch: move what is chosen/);
      await page.keyboard.press('Escape');
      await page.locator('#soccer-scrub').focus();
      for (let press = 0; press < 30; press += 1) await page.keyboard.press('ArrowRight');
      await eventually(async () => assert.equal(await tick(), 30));
      await page.locator('#tab-soccer-coach').focus();
      await page.keyboard.press('ArrowRight');
      await eventually(async () => assert.equal(await page.locator('#tab-soccer-roles').getAttribute('aria-selected'), 'true'));
      await page.locator('#soccer .pitch-stage.own canvas').focus();
      await page.keyboard.press('End');
      await eventually(async () => assert.equal(await page.locator('#soccer-thing').inputValue(), '6'));
      await page.keyboard.press('Shift+ArrowUp');
      await until(() => location.hash.includes('events='));
      await page.keyboard.press('3');
      assert.equal(await page.evaluate(() => location.hash.startsWith('#/soccer')), true);
      await page.keyboard.press('1');
      await until(() => location.hash.startsWith('#/forage'));
      await page.keyboard.press('3');
      await until(() => location.hash.startsWith('#/soccer'));
      assert.equal(await tick(), 30, 'the tab is found as it was left');
    },
  ],
];
