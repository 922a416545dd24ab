import assert from 'node:assert/strict';

/** @type {[tab: string, stands: string][]} */
const TABS = [
  ['forage', '#fingerprint[data-tick]'],
  ['trees', '#trees-fingerprint[data-tick]'],
  ['sequence', '.ribbon > *'],
  ['studies', '.studies-page'],
];

/** 100 kB that look like packed text and are none. */
function rubbish() {
  let seed = 1;
  const letters = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_';
  return Array.from({ length: 100_000 }, () => letters[(seed = (seed * 48_271) % 2_147_483_647) % 64]).join('');
}

/** @param {import('./browser.mjs').Opened} opened @param {string} stands */
async function works({ page, problems, until }, stands) {
  await page.locator(stands).first().waitFor({ state: 'attached' });
  await until(() => !['loading', 'error'].includes(document.body.dataset.state ?? ''));
  assert.deepEqual(problems, []);
}

const KEYS = /** @type {Record<string, string>} */ ({ forage: 'geese.grammar', trees: 'xml', sequence: 'sequencing.obstacle-list', studies: 'spec' });
const said = (/** @type {import('playwright-core').Page} */ page) => page.locator('.notice p, .problems, .fault').allTextContents();

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  ...TABS.map(([tab, stands]) => /** @type {import('./browser.mjs').Case} */ ([
    `rubbish_of_100_kB_in_a_link_of_${tab}_is_named_and_the_tab_works`,
    async (open) => {
      const noise = rubbish();
      for (const part of [`${KEYS[tab]}=~${noise}`, `nonsense=${noise}`, noise, `hide=${noise}`]) {
        const opened = await open(`#/${tab}?${part}`);
        await works(opened, stands);
        if (!part.startsWith('hide=')) {
          await opened.page.locator('.notice.problem').first().waitFor();
          const [message] = await said(opened.page);
          assert.match(message, /left out|does not know/);
          assert.ok(message.length < 500, `a line of ${message.length} characters`);
        }
        await opened.close();
      }
    },
  ])),
  [
    'a_link_cut_short_anywhere_opens_as_far_as_it_can_be_read',
    async (open) => {
      const first = await open(`#/forage?preset=nest&seed=77&geese.agents=20&geese.grammar=${encodeURIComponent('<S> ::= Explore\n')}`);
      await first.seek(8);
      const whole = await first.address(8);
      for (const length of [12, 22, 34, 45, 60, 80, whole.length - 20, whole.length - 9, whole.length - 1]) {
        const opened = await open(whole.slice(0, length));
        await works(opened, '#fingerprint[data-tick]');
        await opened.close();
      }
    },
  ],
  ...TABS.map(([tab, stands]) => /** @type {import('./browser.mjs').Case} */ ([
    `a_link_of_${tab}_from_another_version_with_unknown_keys_is_told_and_applied`,
    async (open) => {
      const opened = await open(`#/${tab}${tab === 'studies' ? '/depth' : ''}?v=9.8.7&<b>x=1&nonsense=2`);
      await works(opened, stands);
      await opened.notice(/Made with 9\.8\.7, this is \d/);
      assert.ok(await opened.page.getByRole('button', { name: 'Open with 9.8.7' }).isVisible());
      await opened.notice(/holds 'nonsense', which this version does not know/);
      assert.equal(await opened.page.locator('.notice b').count(), 0, 'text from links is never markup');
    },
  ])),
  ...TABS.map(([tab, stands]) => /** @type {import('./browser.mjs').Case} */ ([
    `${tab}_works_where_the_browser_keeps_nothing`,
    async (open) => {
      const opened = await open('#/learn/99'); // no world yet
      await opened.page.addInitScript(() => {
        for (const name of ['localStorage', 'sessionStorage', 'indexedDB']) {
          Object.defineProperty(window, name, {
            get() {
              throw new DOMException('blocked', 'SecurityError');
            },
          });
        }
      });
      await opened.page.goto(opened.page.url().replace(/#.*/, `#/${tab}`));
      await opened.page.reload();
      await works(opened, stands);
      await opened.page.locator('#theme').click();
      if (tab === 'forage') await opened.notice(/Not saved/);
    },
  ])),
  [
    'a_lesson_is_done_where_the_browser_keeps_nothing',
    async (open) => {
      const opened = await open('#/learn');
      await opened.page.addInitScript(() => {
        Storage.prototype.setItem = () => {
          throw new DOMException('full', 'QuotaExceededError');
        };
      });
      await opened.page.reload();
      await opened.page.getByRole('link', { name: 'Sequence, fallback, running' }).click();
      await opened.page.locator('#learn-option-explore').check();
      await opened.page.locator('#learn-ask').click();
      await opened.page.locator('.learn-findings[data-right=true]').waitFor();
      assert.deepEqual(opened.problems, []);
    },
  ],
];
