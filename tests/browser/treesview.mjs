import assert from 'node:assert/strict';
import { documentOf, openBench, packed } from './bench.mjs';
import { eventually } from './browser.mjs';

const KINDS = ['Sequence', 'Fallback', 'ReactiveSequence', 'Parallel'];

/** A tree of so many nodes, five children each. @param {number} count */
function large(count) {
  let made = 1;
  /** @param {number} depth @returns {string} */
  const grow = (depth) => {
    const children = [];
    for (let child = 0; child < 5 && made < count; child += 1) {
      made += 1;
      children.push(depth < 3 ? grow(depth + 1) : `<Leaf${made % 7} name="leaf${made}"/>`);
    }
    return children.length === 0 ? `<AlwaysSuccess name="leaf${made}"/>` : `<${KINDS[depth]} name="node${made}">\n${children.join('\n')}\n</${KINDS[depth]}>`;
  };
  return documentOf(grow(0), Array.from({ length: 7 }, (_, index) => `<Action ID="Leaf${index}"/>`).join('')); // at most 1 + 5 + 25 + 125 + 625
}

/** Where the drawing stands. @param {import('playwright-core').Page} page */
const sight = (page) => page.locator('.trees-stage > .bench .bench-stage > g').getAttribute('transform');

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'tree_of_1000_nodes_is_read_laid_out_edited_and_played',
    async (open) => {
      const xml = large(781).replace(/<Leaf(\d) name="leaf(\d+)"\/>/g, (all, _, id) => (Number(id) % 3 === 0 ? `<Inverter name="not${id}">${all}</Inverter>` : all));
      const nodes = (xml.match(/ name="/g) ?? []).length;
      const { page, type, problems, until, said, step, at, inState } = await openBench(open);
      await at(2);
      const paste = Date.now();
      await type(xml);
      await until(() => document.querySelector('.problems-head')?.textContent === 'No problems' && document.querySelector('.trees-stage > .bench .bench-node, .trees-stage > .bench .bench-mass *') && !document.querySelector('.compare:not([hidden])'));
      const opened = Date.now() - paste;
      await problems('No problems');
      // An edit that changes every node's name: read, computed, laid out and drawn anew.
      for (let round = 0; round < 4; round += 1) {
        await page.evaluate(() => performance.clearMeasures());
        await type(xml.replaceAll(' name="', ` name="r${round}`));
        await until(() => performance.getEntriesByName('tree shown').length > 0);
      }
      const shown = await page.evaluate(() => performance.getEntriesByName('tree shown').at(-1)?.duration ?? 0);
      const stepping = Date.now();
      await step();
      await at(3);
      const stepped = Date.now() - stepping;
      await page.locator('#trees-speed').fill('100');
      await page.locator('#trees .play').click();
      await inState('running');
      const frames = await page.evaluate(
        () =>
          new Promise((resolve) => {
            let count = 0;
            const start = performance.now();
            requestAnimationFrame(function beat(now) {
              count += 1;
              if (now - start < 2000) requestAnimationFrame(beat);
              else resolve((count * 1000) / (now - start));
            });
          }),
      );
      await page.locator('#trees .play').click();
      await inState('paused');
      assert.ok(nodes >= 950, `${nodes} nodes`);
      assert.deepEqual(said(), []);
      return `${nodes} nodes: ${shown.toFixed(0)} ms from the request to everything drawn; the first paste ${opened} ms (120 ms of it waiting for more typing), ${stepped} ms a step, ${Number(frames).toFixed(0)} frames per second playing`;
    },
    'alone',
  ],
  [
    'branches_fold_and_unfold',
    async (open) => {
      const { page, at } = await openBench(open, '#/trees?preset=subtrees');
      await at(1);
      const items = page.locator('.trees-stage > .bench [role=treeitem]');
      await page.getByRole('button', { name: 'Fold all', exact: true }).click();
      await items.and(page.locator('[aria-expanded=false]')).first().waitFor();
      const folded = await items.count();
      await page.getByRole('button', { name: 'Unfold all' }).click();
      await page.locator('.trees-stage > .bench [aria-expanded=false]').first().waitFor({ state: 'detached' });
      await eventually(async () => assert.ok((await items.count()) > folded));
      await items.first().focus();
      await page.keyboard.press('ArrowUp');
      await page.keyboard.press('Home');
    },
  ],
  [
    'search_counts_hits_and_goes_through_them',
    async (open) => {
      const { page, at } = await openBench(open, '#/trees?preset=subtrees');
      await at(1);
      await page.keyboard.press('/');
      await page.keyboard.type('ToDoor');
      const count = page.locator('.trees-bar .found-count');
      await count.filter({ hasText: /^\d+ hits$/ }).waitFor();
      const hits = Number.parseInt((await count.textContent()) ?? '', 10);
      assert.ok(hits >= 2);
      await page.keyboard.press('Enter');
      await count.filter({ hasText: `1 of ${hits}` }).waitFor();
      await eventually(async () => assert.equal(await page.locator('#panel-node h2').textContent(), 'ToDoor'));
      await page.getByRole('button', { name: 'Next hit' }).click();
      await count.filter({ hasText: `2 of ${hits}` }).waitFor();
      await page.locator('.bench-node[aria-selected=true]').waitFor();
    },
  ],
  [
    'drawing_is_zoomed_panned_turned_and_fitted',
    async (open) => {
      const { page, at } = await openBench(open, '#/trees?preset=subtrees');
      await at(1);
      const views = new Set([await sight(page)]);
      const changed = async () => {
        await page.waitForFunction((seen) => !seen.includes(document.querySelector('.trees-stage > .bench .bench-stage > g')?.getAttribute('transform') ?? ''), [...views].slice(-1));
        views.add(await sight(page));
      };
      await page.getByRole('button', { name: 'Zoom in' }).click();
      await changed();
      await page.getByRole('button', { name: 'Zoom out' }).click();
      await page.getByRole('button', { name: 'Zoom out' }).click();
      await changed();
      const box = await page.locator('.trees-stage').boundingBox();
      assert.ok(box);
      await page.mouse.move(box.x + 60, box.y + box.height - 30);
      await page.mouse.down();
      await page.mouse.move(box.x + 160, box.y + box.height - 60, { steps: 4 });
      await page.mouse.up();
      await changed();
      await page.mouse.wheel(0, 80);
      await changed();
      await page.getByRole('button', { name: /Grows down/ }).click();
      await changed();
      await page.getByRole('button', { name: 'Whole tree' }).click();
      await changed();
      await eventually(async () => assert.ok(await page.getByRole('button', { name: /Grows to the right/ }).isVisible()));
    },
  ],
  [
    'timeline_goes_to_a_tick',
    async (open) => {
      const { page, at } = await openBench(open, '#/trees?preset=parallel');
      await at(3);
      await page.locator('.trees-timeline [tabindex="0"]').last().focus();
      await page.keyboard.press('ArrowLeft');
      await page.keyboard.press('ArrowLeft');
      await page.keyboard.press('Enter');
      await page.waitForFunction(() => document.querySelector('#trees-tick')?.textContent !== '3');
    },
  ],
  [
    'width_of_the_text_is_changed_by_keys_and_by_dragging',
    async (open) => {
      const { page, at, inState } = await openBench(open);
      await at(2);
      const width = async () => (await page.locator('#trees-text').boundingBox())?.width ?? 0;
      const before = await width();
      await page.getByRole('separator').focus();
      for (let count = 0; count < 3; count += 1) await page.keyboard.press('ArrowRight');
      await eventually(async () => assert.equal(await width(), before + 48));
      const box = await page.getByRole('separator').boundingBox();
      assert.ok(box);
      await page.mouse.move(box.x + 12, box.y + box.height / 2);
      await page.mouse.down();
      await page.mouse.move(box.x + 62, box.y + box.height / 2, { steps: 3 });
      await page.mouse.up();
      await eventually(async () => assert.equal(await width(), before + 98));
      await page.reload();
      await inState('paused');
      await at(2);
      assert.equal(await width(), before + 98);
    },
  ],
  [
    'tree_that_only_a_model_declares_is_shown_and_not_run',
    async (open) => {
      const xml = documentOf('<Dance><Grasp/></Dance>', '<Control ID="Dance"/><Action ID="Grasp"/>');
      const { page, node, inState } = await openBench(open, `#/trees?xml=${packed(xml)}`);
      await inState('paused');
      await node('Dance').waitFor();
      await page.locator('.watch').filter({ hasText: /can be shown but not run/ }).waitFor();
      await eventually(async () => assert.ok(await page.locator('#trees .play').isDisabled()));
    },
  ],
];
