import assert from 'node:assert/strict';
import { eventually } from './browser.mjs';

/** Where each tab is shared from: a moment with a fingerprint where the tab has one. @type {[tab: string, hash: string, stands: string][]} */
const MOMENTS = [
  ['forage', '#/forage?preset=nest&seed=5&geese.agents=40&t=64', '#fingerprint[data-tick="64"]'],
  ['trees', '#/trees?preset=two-running&t=4', '#trees-fingerprint[data-tick="4"]'],
  ['sequence', '#/sequence?preset=plan-small&seed=3&plan=EEN&t=120', '.ribbon > *'],
  ['studies', '#/studies/depth?size=glance', '.facts .hash'],
];

/** @param {import('playwright-core').Page} page */
const openDialog = async (page) => {
  await page.locator('[data-action=share]').click();
  await page.locator('#share-link').waitFor();
  return page.locator('#share-link').inputValue();
};

/** What of a tab says that it is the same again. @param {import('playwright-core').Page} page */
const sign = (page) => page.evaluate(() => document.querySelector('.page-tab:not([hidden]) :is(#fingerprint, #trees-fingerprint, .facts .hash, .ribbon)')?.textContent ?? '');

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  ...MOMENTS.map(([tab, hash, stands]) => /** @type {import('./browser.mjs').Case} */ ([
    `a_shared_link_of_${tab}_opens_again_to_the_same`,
    async (open, url) => {
      const first = await open(hash);
      await first.page.locator(stands).first().waitFor();
      await first.until(() => document.body.dataset.state === 'paused' || document.body.dataset.state === 'finished' || document.body.dataset.state === 'busy');
      const link = await openDialog(first.page);
      assert.ok(link.startsWith(url), link);
      const before = await sign(first.page);
      assert.notEqual(before, '');
      const second = await open(link.slice(url.length));
      await second.until(
        (wanted) => document.querySelector('.page-tab:not([hidden]) :is(#fingerprint, #trees-fingerprint, .facts .hash, .ribbon)')?.textContent === wanted,
        before,
      );
      if (tab === 'forage' || tab === 'trees') await second.notice(/fingerprint matches/);
      assert.equal(await second.page.locator('.notice.problem').count(), 0);
      assert.deepEqual(first.problems.concat(second.problems), []);
    },
  ])),
  [
    'hidden_parts_go_into_the_link_still_apply_and_come_back',
    async (open, url) => {
      const first = await open('#/forage?preset=foraging&geese.agents=30');
      const { page } = first;
      await first.at(0);
      await openDialog(page);
      await page.locator('.share-hide summary').click();
      for (const label of ['Seed', 'Robots', 'Tab Tree', 'Footer']) await page.locator('.share-parts').getByLabel(label, { exact: true }).check();
      const link = await page.locator('#share-link').inputValue();
      assert.match(link, /&hide=[^&]*\bseed\b/);
      const names = /** @type {RegExpExecArray} */ (/hide=([^&]+)/.exec(link))[1].split(',').sort();
      assert.deepEqual(names, ['foot', 'geese.agents', 'seed', 'tree']);
      const second = await open(link.slice(url.length));
      await second.at(0);
      await second.openGroups();
      for (const hidden of ['#seed', '[data-key="geese.agents"]', '#tab-tree', '#panel-tree', '#foot']) await eventually(async () => assert.equal(await second.page.locator(hidden).isVisible(), false, hidden));
      await eventually(async () => assert.ok(await second.page.locator('[data-key="geese.items"]').isVisible()));
      await eventually(async () => assert.equal(await second.page.locator('[role=tab][aria-selected=true]').textContent(), 'Robot'));
      await eventually(async () => assert.equal(await second.page.locator('[data-layer=robots] output').textContent(), '30'));
      await eventually(async () => assert.match(await second.hash(), /hide=/));
      await second.page.locator('[data-action=show-all]').click();
      await eventually(async () => assert.ok(await second.page.locator('#seed').isVisible()));
      await eventually(async () => assert.ok(await second.page.locator('[data-key="geese.agents"]').isVisible()));
      await eventually(async () => assert.doesNotMatch(await second.hash(), /hide=/));
      assert.deepEqual(second.problems, []);
    },
  ],
  ...['#/forage?preset=foraging&seed=9', '#/trees?preset=two-running', '#/sequence?preset=plan-small&seed=3', '#/soccer?preset=match&seed=3&soccer.half-seconds=20', '#/studies/depth?size=glance'].map((hash) => /** @type {import('./browser.mjs').Case} */ ([
    `what_is_hidden_stays_hidden_in_links_copied_from_the_footer_of_${(/\w+/.exec(hash) ?? [])[0]}`,
    async (open) => {
      const { page, notice, problems } = await open(`${hash}${hash.includes('?') ? '&' : '?'}hide=seed,words`, { permissions: ['clipboard-read', 'clipboard-write'] });
      const foot = page.locator('.page-tab:not([hidden]) .foot');
      const given = async (/** @type {string} */ name) => {
        await page.evaluate(() => navigator.clipboard.writeText(''));
        await foot.getByRole('button', { name, exact: true }).click();
        return eventually(async () => {
          const written = await page.evaluate(() => navigator.clipboard.readText());
          assert.notEqual(written, '');
          return written;
        });
      };
      const names = ['Copy link', 'Cite'].slice(0, await foot.getByRole('button', { name: /^(Copy link|Cite)$/ }).count());
      for (const name of names) assert.match(await given(name), /#\/\S+[?&]hide=seed,words(\s|$)/, name);
      await page.locator('[data-action=show-all]').click();
      for (const name of names) assert.doesNotMatch(await given(name), /hide=/, `${name}, after all is shown`);
      await notice(/clipboard/);
      assert.deepEqual(problems, []);
    },
  ])),
  [
    'a_link_copied_in_a_frame_opens_the_whole_page',
    async (open) => {
      const { page } = await open('#/forage?preset=foraging&seed=9&embed=1&ui=play,foot&hide=seed', { permissions: ['clipboard-read', 'clipboard-write'] });
      await page.locator('[data-action=copy-link]').click();
      const link = await eventually(async () => {
        const written = await page.evaluate(() => navigator.clipboard.readText());
        assert.match(written, /preset=foraging/);
        return written;
      });
      assert.match(link, /&hide=seed$/);
      assert.doesNotMatch(link, /embed=|ui=/);
    },
  ],
  [
    'the_dialog_gives_versioned_link_frame_code_citation_and_file',
    async (open) => {
      const { page, at, problems } = await open('#/forage?preset=foraging&seed=9&t=30');
      const fingerprint = await at(30);
      const link = await openDialog(page);
      const pinned = await page.locator('#share-pinned').inputValue();
      assert.match(pinned, /\/some\/sub\/path\/v\d+\.\d+\.\d+\/#\/forage\?/);
      assert.equal(pinned.replace(/v\d+\.\d+\.\d+\/#/, '#'), link);
      const qr = await page.locator('.qr path').getAttribute('d');
      assert.ok((qr ?? '').length > 500);
      await page.locator('.share-embed summary').click();
      await eventually(async () => assert.match(await page.locator('#share-frame').inputValue(), /^<iframe src="[^"]*&amp;embed=1&amp;ui=play,scrub" title="Swarm playground: Foraging" width="960" height="540"/));
      const cite = await page.locator('#share-cite').inputValue();
      for (const part of ['Foraging', 'Seed 9.', 'Tick 30.', fingerprint, link, 'BeTr-GEESE']) assert.ok(cite.includes(part), `${part} in ${cite}`);
      const download = page.waitForEvent('download');
      await page.locator('#share-file').click();
      const { readFileSync } = await import('node:fs');
      assert.equal(JSON.parse(readFileSync(await (await download).path(), 'utf8')).seed, 9);
      assert.deepEqual(problems, []);
    },
  ],
  [
    'what_a_link_calls_hidden_is_never_markup_nor_a_rule',
    async (open) => {
      const { page, at, problems } = await open('#/forage?preset=foraging&hide=nothing.here,%22%5D%7Bcolor:red%7D,<img src=x onerror=alert(1)>,seed');
      await at(0);
      assert.equal(await page.locator('#seed').isVisible(), false);
      assert.equal(await page.locator('.hiding img').count(), 0);
      assert.match((await page.locator('.hiding-note').textContent()) ?? '', /does not have: .*nothing\.here/);
      assert.doesNotMatch((await page.locator('.hiding-note').textContent()) ?? '', /seed/);
      assert.deepEqual(problems, []);
    },
  ],
];
