// The dialogs that film, as axe sees them.
import assert from 'node:assert/strict';
import { violations } from './access.mjs';
import { SHORT } from './pitch.mjs';
import { SMALL } from './plan.mjs';

const PHONE = 900;

/** @typedef {{ name: string, hash: string, ready: string, field: string }} Filmed `ready` is there when the tab can be filmed, `field` is one of the dialog */

/** @type {Filmed[]} */
const TABS = [
  { name: 'forage', hash: '#/forage?preset=foraging', ready: '#fingerprint[data-tick]', field: 'From tick' },
  { name: 'sequence', hash: SMALL, ready: '#sequence .ribbon-pane:not(.stale) .plan-cell', field: 'From second' },
  { name: 'soccer', hash: SHORT, ready: '#soccer-fingerprint[data-whole=true]', field: 'From second' },
  { name: 'soccer_beside', hash: `${SHORT}&b.soccer.blue=machine`, ready: '#soccer .soccer-side[data-side=b] .side-said:not(:empty)', field: 'From second' },
  { name: 'trees', hash: '#/trees?preset=retry', ready: '#trees-fingerprint:not(:empty)', field: 'From tick' },
];

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  ...TABS.flatMap(({ name, hash, ready, field }) =>
    [1440, 390].map((width) => /** @type {import('./browser.mjs').Case} */ ([
      `axe_finds_nothing_in_the_film_dialog_of_${name}_at_${width}_pixels`,
      async (open) => {
        const phone = width < PHONE;
        const { page, problems } = await open(hash, { viewport: { width, height: phone ? 844 : 900 }, ...(phone ? { hasTouch: true, isMobile: true } : {}) });
        await page.locator(ready).first().waitFor({ state: 'attached' });
        await page.locator('.page-tab:not([hidden]) .foot').getByRole('button', { name: 'Video', exact: true }).click();
        const dialog = page.locator('.video-dialog');
        await dialog.waitFor();
        const box = await dialog.boundingBox();
        assert.ok(box && box.x >= 0 && box.x + box.width <= width, `the dialog is in sight: ${JSON.stringify(box)}`);
        for (const colorScheme of /** @type {const} */ (['light', 'dark'])) {
          await page.emulateMedia({ colorScheme });
          assert.deepEqual(await violations(page), [], colorScheme);
        }
        await dialog.getByLabel(field).fill('');
        await page.locator('#video-extent').filter({ hasText: 'Expected' }).waitFor();
        assert.deepEqual(await violations(page), [], 'refused');
        const small = await dialog.locator('button, input, select').evaluateAll((targets, least) => targets.filter((target) => target.getBoundingClientRect().height < least).map((target) => target.outerHTML.slice(0, 80)), phone ? 43.5 : 24);
        assert.deepEqual(small, [], 'large enough');
        assert.deepEqual(problems, []);
      },
    ])),
  ),
  [
    'axe_finds_nothing_while_a_film_is_made',
    async (open) => {
      const { page, problems } = await open('#/forage?preset=foraging&seed=9');
      await page.locator('#foot').getByRole('button', { name: 'Video', exact: true }).click();
      const dialog = page.locator('.video-dialog');
      await dialog.getByLabel('To tick').fill('12000');
      await dialog.getByRole('button', { name: 'Film', exact: true }).click();
      await dialog.getByRole('progressbar').waitFor();
      assert.deepEqual(await violations(page), []);
      await dialog.getByRole('button', { name: 'Stop' }).click();
      await page.locator('#video-extent').filter({ hasText: 'Nothing was saved' }).waitFor();
      assert.deepEqual(await violations(page), [], 'stopped');
      assert.deepEqual(problems, []);
    },
  ],
];
