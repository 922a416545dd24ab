import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { SMALL, documentOf, openBench, packed } from './bench.mjs';
import { eventually } from './browser.mjs';

const library = JSON.parse(readFileSync(new URL('../../trees/library.json', import.meta.url), 'utf8'));

/** Drops a file on the text. @param {import('playwright-core').Page} page @param {string} name @param {string} content */
async function drop(page, name, content) {
  const transfer = await page.evaluateHandle(
    ([title, body]) => {
      const data = new DataTransfer();
      data.items.add(new File([body], title));
      return data;
    },
    [name, content],
  );
  await page.dispatchEvent('.trees-code', 'drop', { dataTransfer: transfer });
}

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'every_library_tree_opens_without_a_problem_at_its_tick',
    async (open) => {
      const { page, entry, at, problems } = await openBench(open);
      for (const { file, title, watch, at: tick = 0 } of library) {
        await entry(file.replace('.xml', ''));
        await at(tick);
        await problems('No problems');
        await eventually(async () => assert.equal(await page.locator('.watch').textContent(), watch, title));
      }
      assert.equal(await page.locator('.notice.problem').count(), 0);
      return `${library.length} trees`;
    },
  ],
  [
    'tree_link_reopened_in_a_second_page_gives_the_same_fingerprint',
    async (open) => {
      const first = await openBench(open, '#/trees?preset=retry');
      await first.type(SMALL);
      await first.problems('No problems');
      await first.tab('script');
      await first.page.getByLabel('grasp returns').selectOption('RUNNING');
      await first.page.locator('#trees-mode').selectOption('exactly_once');
      await first.page.locator('#trees-ms').fill('30');
      await first.page.locator('#trees-ms').press('Enter');
      const fingerprint = await first.seek(6);
      const hash = await first.address(6);
      assert.match(hash, /^#\/trees\?v=[\d.]+&preset=retry&xml=~[\w-]+&script=~[\w-]+&mode=exactly_once&ms=30&t=6&f=[0-9a-f]{16}$/);
      const second = await openBench(open, hash);
      assert.equal(await second.at(6), fingerprint);
      await second.notice(/fingerprint matches/);
      await eventually(async () => assert.ok((await second.text()).includes('grasp')));
      await eventually(async () => assert.equal(await second.page.locator('#trees-ms').inputValue(), '30'));
      assert.deepEqual(second.said(), []);
    },
  ],
  [
    'unchanged_library_tree_has_a_short_link',
    async (open) => {
      const { address } = await openBench(open, '#/trees?preset=parallel');
      assert.match(await address(3), /^#\/trees\?v=[\d.]+&preset=parallel&t=3&f=[0-9a-f]{16}$/);
    },
  ],
  [
    'bad_parts_of_a_tree_link_are_named_and_the_rest_is_applied',
    async (open) => {
      const { page, at, notice } = await openBench(open, '#/trees?v=0.0.1&length=many&xx=1&t=2&f=12');
      await at(2);
      await notice(/Made with 0\.0\.1/);
      const said = (await page.locator('.notice p').allTextContents()).join('\n');
      for (const part of [/'length' was left out: found 'many', expected a whole number from 0 to 100000/, /holds 'xx'/, /'f' was left out/]) assert.match(said, part);
      const more = await openBench(open, '#/trees?preset=nowhere&mode=twice&ms=-3&script=~!!');
      await more.notice(/'preset' was left out: found 'nowhere', expected one of three-sequences/);
      await more.notice(/'mode' was left out: found 'twice', expected one of once, exactly_once/);
      await more.notice(/'ms' was left out: found '-3'/);
      await more.notice(/'script' was left out: the packed text/);
      const refused = await openBench(open, `#/trees?xml=${packed(SMALL)}&script=${packed('[{"tick":0,"leaf":"Near","then":"PERHAPS"}]')}`);
      await refused.notice(/script\[0\]\.then: expected one of/);
      await refused.at(0);
    },
  ],
  [
    'wrong_fingerprint_of_a_tree_is_told_with_both_values',
    async (open) => {
      const { at, notice } = await openBench(open, '#/trees?preset=retry&t=2&f=0123456789abcdef');
      const found = await at(2);
      const said = (await notice(/does not match/)) ?? '';
      assert.ok(said.includes('0123456789abcdef') && said.includes(found), said);
    },
  ],
  [
    'tree_is_taken_away_as_xml_svg_png_and_json',
    async (open) => {
      const { page, saved, at, node, said: seen } = await openBench(open, `#/trees?xml=${packed(SMALL.replace('<Near/>', '<Near />'))}&t=1`, { acceptDownloads: true });
      await at(1);
      const xml = (await saved('XML')).bytes.toString();
      assert.match(xml, /<Near\/>/);
      assert.match(xml, /<Condition ID="Near"/);
      const svg = (await saved('SVG')).bytes.toString();
      assert.match(svg, /^<svg [^>]*xmlns="http:\/\/www\.w3\.org\/2000\/svg"/);
      assert.doesNotMatch(svg, /NaN|undefined|var\(/);
      assert.match(svg, /grasp/);
      const png = await saved('PNG');
      assert.equal(png.bytes.subarray(1, 4).toString(), 'PNG');
      const width = Number(/ width="(\d+)"/.exec(svg)?.[1]);
      assert.equal(png.bytes.readUInt32BE(16), 2 * width);
      const json = await saved('JSON');
      const setup = JSON.parse(json.bytes.toString());
      assert.equal(setup.at, 1);
      await page.locator('#trees-entry').selectOption('entry:retry');
      await node('grasp').waitFor({ state: 'detached' });
      await drop(page, json.name, json.bytes.toString());
      await at(1);
      await node('grasp').waitFor();
      assert.deepEqual(seen(), []);
    },
  ],
  [
    'xml_with_a_fault_is_not_saved_but_told',
    async (open) => {
      const { page, type, problems, notice } = await openBench(open);
      await type(SMALL.replace('<Near/>', '<Nowhere/>'));
      await problems('1 fault');
      await page.locator('#trees .take').getByRole('button', { name: 'XML', exact: true }).click();
      await notice(/No XML was saved: .*Nowhere/);
    },
  ],
  [
    'dropped_file_opens_and_undo_brings_back_what_was_here',
    async (open) => {
      const { page, text, type, notice, problems, node } = await openBench(open, '#/trees?preset=retry');
      await type(documentOf('<AlwaysSuccess name="typed"/>'));
      await node('typed').waitFor();
      const before = await text();
      await drop(page, 'mine.xml', SMALL);
      await notice(/Opened: mine\.xml/);
      await problems('No problems');
      await eventually(async () => assert.equal(await page.locator('#trees-entry').inputValue(), 'own'));
      await page.getByRole('button', { name: 'Restore what I typed' }).waitFor();
      await eventually(async () => assert.ok((await text()).includes('grasp')));
      await page.locator('.trees-bar').getByRole('button', { name: 'Undo' }).click();
      await page.waitForFunction((wanted) => [...(document.querySelector('.trees-code')?.shadowRoot?.querySelectorAll('.cm-line') ?? [])].map((line) => line.textContent).join('\n') === wanted, before);
      await eventually(async () => assert.equal(await page.locator('#trees-entry').inputValue(), 'entry:retry'));
      await drop(page, 'bad.json', '{"xml": 3}');
      await notice(/bad\.json was not opened/);
    },
  ],
  [
    'what_was_typed_is_kept_and_offered_again',
    async (open) => {
      const { page, type, problems, until, text, inState, at, tab } = await openBench(open, '#/trees?preset=retry');
      await type(SMALL);
      await problems('No problems');
      await tab('script');
      await page.getByLabel('Near returns').selectOption('SKIPPED');
      await until(() => localStorage.getItem('swarm-playground.drafts.trees')?.includes('SKIPPED'));
      await page.evaluate(() => void (location.hash = '#/trees?preset=guards'));
      await at(3);
      await page.evaluate(() => history.replaceState(null, '', '#/trees?preset=parallel'));
      await page.reload();
      await inState('paused');
      await at(3);
      await page.getByRole('button', { name: 'Restore what I typed' }).click();
      await page.waitForFunction(() => document.querySelector('.trees-code')?.shadowRoot?.textContent?.includes('grasp'));
      await page.locator('#tab-script').click();
      await page.getByText('Near → SKIPPED').waitFor();
      await eventually(async () => assert.ok((await text()).includes('grasp')));
    },
  ],
  [
    'link_that_is_too_long_offers_the_file',
    async (open) => {
      const names = Array.from({ length: 900 }, (_, index) => `Leaf${Math.floor(((index * 2654435761) % 4294967296) / 7).toString(36)}${index}`);
      const xml = documentOf(`<Sequence>${names.map((name) => `<${name}/>`).join('')}</Sequence>`, names.map((name) => `<Action ID="${name}"/>`).join(''));
      const { page, notice, at } = await openBench(open);
      await at(2);
      await drop(page, 'large.xml', xml);
      await at(0);
      await page.locator('#trees .take').getByRole('button', { name: 'Copy link' }).click();
      await notice(/too many for some programs/);
      const waiting = page.waitForEvent('download');
      await page.getByRole('button', { name: 'Save JSON' }).click();
      assert.match((await waiting).suggestedFilename(), /\.json$/);
    },
  ],
  [
    'evolved_tree_opens_from_forage_in_the_workbench',
    async (open) => {
      const { page, until, said: seen } = await openBench(open, '#/forage?preset=foraging&seed=5', { acceptDownloads: true });
      await page.locator('#scrub').evaluate((scrub) => {
        /** @type {HTMLInputElement} */ (scrub).value = '60';
        scrub.dispatchEvent(new Event('input'));
      });
      await until(() => document.querySelector('#tick')?.textContent === '60' && document.body.dataset.state === 'paused');
      await page.locator('#canvas').focus();
      await page.keyboard.press('Home');
      const waiting = page.waitForEvent('download');
      await page.locator('#panel-tree').getByRole('button', { name: 'XML', exact: true }).click();
      const xml = readFileSync(await (await waiting).path(), 'utf8');
      assert.match(xml, /<root BTCPP_format="4"/);
      await page.getByRole('button', { name: 'Open in workbench' }).click();
      await page.locator('#trees .notice').filter({ hasText: 'Opened: Robot 0' }).waitFor();
      await page.locator('.problems-head').filter({ hasText: 'No problems' }).waitFor();
      await until(() => location.hash.startsWith('#/trees?') && location.hash.includes('xml=~'));
      await page.locator('.trees-stage > .bench [role=treeitem]').nth(1).waitFor();
      await eventually(async () => assert.equal(await page.locator('.trees-bar').getByRole('button', { name: 'Undo' }).isDisabled(), false));
      await page.getByRole('link', { name: 'Forage' }).click();
      await until(() => location.hash.includes('t=60'));
      assert.deepEqual(seen(), []);
    },
  ],
];
