import assert from 'node:assert/strict';
import { eventually } from './browser.mjs';
import { SMALL, openPlan } from './plan.mjs';

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'sequence_things_are_dragged_and_the_plan_follows',
    async (open) => {
      const { page, result, drag, field, until, letters } = await openPlan(open, SMALL);
      await result('optimal');
      const before = await letters();
      const drop = await drag('target-0', 0, 60);
      await drop();
      await until(() => location.hash.includes('obstacle-list') || location.hash.includes('start-list'));
      await result('optimal', 'infeasible');
      await eventually(async () => assert.notEqual(await field('y'), -10));
      await eventually(async () => assert.notEqual(await letters(), before));
      await page.keyboard.press('Control+z');
      await until(() => !location.hash.includes('start-list'));
      await result('optimal');
      await eventually(async () => assert.equal(await letters(), before));
      await page.keyboard.press('Control+Shift+z');
      await until(() => location.hash.includes('start-list'));
      await (await drag('robot-1', 20, -20))();
      await eventually(async () => assert.match((await page.locator('#sequence-thing').inputValue()) ?? '', /robot-1/));
      const [x, y] = [await field('x'), await field('y')];
      await page.locator('#sequence-thing').selectOption('swarm-0');
      const middle = await field('x');
      await page.locator('#sequence-x').fill(String(middle + 4));
      await page.locator('#sequence-x').press('Enter');
      await page.locator('#sequence-thing').selectOption('robot-1');
      await until((wanted) => Math.abs(Number(/** @type {HTMLInputElement} */ (document.querySelector('#sequence-x')).value) - wanted) < 0.02, x + 4);
      assert.ok(Math.abs((await field('y')) - y) < 0.02);
    },
  ],
  [
    'sequence_placements_that_cannot_be_say_so_and_the_last_plan_stays',
    async (open) => {
      const { page, planned, middle, letters, until } = await openPlan(open);
      await planned();
      const [x, y] = await middle('obstacle-1');
      const [sx, sy] = await middle('swarm-0');
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(sx, sy, { steps: 6 });
      await page.locator('#sequence-refusal').filter({ hasText: /Not possible, and the last plan stays: robot \d+ would start inside obstacle 2\./ }).waitFor();
      assert.match(await letters(), /^.{15}$/);
      await page.mouse.up();
      await until(() => document.querySelector('#sequence-refusal')?.textContent === '');
      await page.locator('#sequence-thing').selectOption('robot-0');
      await page.locator('#sequence-x').fill('-51');
      await page.locator('#sequence-x').press('Enter');
      await page.locator('.notice p').filter({ hasText: 'robot 1 would start outside the map.' }).waitFor();
      assert.match(await letters(), /^.{15}$/);
    },
  ],
  [
    'sequence_obstacles_are_drawn_resized_and_deleted',
    async (open) => {
      const { page, result, middle, field, until } = await openPlan(open, SMALL);
      await result('optimal');
      const [x, y] = await middle('target-0');
      const draw = page.getByRole('group', { name: 'New obstacle' });
      await draw.getByRole('button', { name: 'Disc' }).click();
      await page.mouse.move(x + 120, y - 120);
      await page.mouse.down();
      await page.mouse.move(x + 150, y - 120, { steps: 3 });
      await page.mouse.up();
      await until(() => /** @type {HTMLSelectElement} */ (document.querySelector('#sequence-thing')).value === 'obstacle-0');
      const radius = await field('radius');
      const grip = (await page.locator('#sequence .grip').boundingBox()) ?? { x: 0, y: 0 };
      await page.mouse.move(grip.x + 6, grip.y + 6);
      await page.mouse.down();
      await page.mouse.move(grip.x + 26, grip.y + 6, { steps: 3 });
      await page.mouse.up();
      await until((before) => Number(/** @type {HTMLInputElement} */ (document.querySelector('#sequence-radius')).value) > before + 1, radius);
      await draw.getByRole('button', { name: 'Box' }).click();
      await page.mouse.move(x + 60, y + 60);
      await page.mouse.down();
      await page.mouse.move(x + 100, y + 90, { steps: 3 });
      await page.mouse.up();
      await until(() => /** @type {HTMLSelectElement} */ (document.querySelector('#sequence-thing')).value === 'obstacle-1');
      await draw.getByRole('button', { name: 'Polygon' }).click();
      for (const [dx, dy] of [[-120, -120], [-80, -120], [-90, -100], [-80, -80], [-120, -80]]) await page.mouse.click(x + dx, y + dy);
      await page.getByRole('button', { name: 'Close the polygon' }).click();
      await until(() => /** @type {HTMLSelectElement} */ (document.querySelector('#sequence-thing')).value === 'obstacle-2');
      await page.getByRole('button', { name: 'Delete' }).click();
      await until(() => document.querySelectorAll('#sequence .thing.obstacle').length === 2);
      await result('optimal');
    },
  ],
  [
    'sequence_link_holds_the_layout_drawn_by_hand',
    async (open) => {
      const { page, result, letters, hash, until } = await openPlan(open, SMALL);
      await result('optimal');
      await page.locator('#sequence-thing').selectOption('target-0');
      await page.locator('#sequence-y').fill('-14.25');
      await page.locator('#sequence-y').press('Enter');
      await until(() => location.hash.includes('start-list'));
      await result('optimal');
      const [link, plan] = [await hash(), await letters()];
      assert.ok(link.length < 2000, `${link.length} characters`);
      const again = await openPlan(open, link);
      await again.result('optimal');
      assert.equal(await again.letters(), plan);
      const twenty = await openPlan(open, '#/sequence');
      await twenty.planned();
      await twenty.page.locator('#sequence-thing').selectOption('target-0');
      await twenty.page.locator('#sequence-y').fill('20');
      await twenty.page.locator('#sequence-y').press('Enter');
      await twenty.until(() => location.hash.includes('start-list'));
      const long = await twenty.hash();
      assert.ok(long.length < 4000, `${long.length} characters`);
      const odd = await openPlan(open, '#/sequence?preset=plan-walled&sequencing.weight=0.5&sequencing.nonsense=1&sequencing.map=[1');
      await odd.notice(/'sequencing.weight' was left out: found '0.5', expected a number from 1 to 1000/);
      await odd.notice(/'sequencing.nonsense', which this version does not know/);
      await odd.notice(/'sequencing.map' was left out: found '\[1', expected a list/);
      return `${long.length} characters with twenty robots and six obstacles`;
    },
  ],
  [
    'sequence_controls_come_from_the_schema_and_plan_at_once',
    async (open) => {
      const { page, result, until, hash, planned } = await openPlan(open, SMALL);
      await result('optimal');
      const groups = await page.locator('#sequence .group summary').evaluateAll((all) => all.map((summary) => summary.firstChild?.textContent));
      assert.deepEqual(groups, ['Task', 'Map', 'Behaviours', 'Search', 'Costs', 'Robustness']);
      const weight = page.locator('[id="control-sequencing.weight"]');
      await weight.fill('2.5');
      await weight.press('Enter');
      await until(() => location.hash.includes('sequencing.weight=2.5'));
      await page.locator('#sequence details.group').nth(2).evaluate((group) => group.setAttribute('open', ''));
      const library = page.locator('[id="control-sequencing.library"]');
      await library.fill('ENQ');
      await library.press('Enter');
      await page.locator('.notice p').filter({ hasText: /Library was not changed: .*expected letters of/ }).waitFor();
      assert.ok(!(await hash()).includes('library'));
      await library.fill('NE.R');
      await library.press('Enter');
      await until(() => location.hash.includes('sequencing.library=NE.R'));
      await planned();
      await eventually(async () => assert.equal(await page.locator('#sequence-behaviour option').count(), 4));
    },
  ],
  [
    'keys_that_come_faster_than_placements_are_taken_lose_no_step',
    async (open) => {
      const { page, result, until } = await openPlan(open, SMALL);
      await result('optimal');
      await page.locator('#sequence-thing').selectOption('target-0');
      await page.locator('#sequence .stage canvas').evaluate((canvas) => {
        for (let press = 0; press < 6; press += 1) canvas.dispatchEvent(new KeyboardEvent('keydown', { key: press < 4 ? 'ArrowUp' : 'ArrowLeft', bubbles: true }));
      });
      await until(() => location.hash.includes('sequencing.target-x=-12') && location.hash.includes('sequencing.target-y=-6'));
      await result('optimal');
    },
  ],
  [
    'sequence_is_worked_by_keyboard_alone',
    async (open) => {
      const { page, result, until, letters } = await openPlan(open, SMALL);
      await result('optimal');
      /** Tabs until the focus is at a place. @param {string} selector @param {string} [key] */
      const reach = async (selector, key = 'Tab') => {
        for (let presses = 0; presses < 90; presses += 1) {
          await page.keyboard.press(key);
          if (await page.evaluate((wanted) => document.activeElement?.matches(wanted), selector)) return;
        }
        assert.fail(`${selector} is not reached by Tab`);
      };
      await reach('#sequence .stage canvas');
      await page.keyboard.press('PageDown');
      await page.keyboard.press('PageDown');
      await until(() => /** @type {HTMLSelectElement} */ (document.querySelector('#sequence-thing')).value === 'target-0');
      await page.keyboard.press('ArrowUp');
      await page.keyboard.press('Shift+ArrowRight');
      await until(() => /** @type {HTMLInputElement} */ (document.querySelector('#sequence-x')).value === '-9.9' && /** @type {HTMLInputElement} */ (document.querySelector('#sequence-y')).value === '-9');
      await result('optimal');
      await reach('#sequence .joined[role=group] button:nth-child(2)', 'Shift+Tab');
      await page.keyboard.press('Enter');
      await until(() => /** @type {HTMLSelectElement} */ (document.querySelector('#sequence-thing')).value === 'obstacle-0');
      await reach('#sequence .stage canvas');
      await page.keyboard.press('Delete');
      await until(() => document.querySelectorAll('#sequence .thing.obstacle').length === 0);
      await result('optimal');
      const before = await letters();
      await reach('#sequence .plan-cell');
      await page.keyboard.press('ArrowRight');
      await page.keyboard.press('ArrowDown');
      await page.locator('#sequence-hand').filter({ hasText: 'Your plan' }).waitFor();
      await eventually(async () => assert.notEqual((await letters()).charAt(1), before.charAt(1)));
      await page.keyboard.press('Control+z');
      await until((wanted) => [...document.querySelectorAll('#sequence .cell-letter')].map((cell) => (cell.textContent === '·' ? '.' : cell.textContent)).join('') === wanted, before);
      await reach('#sequence .stage canvas', 'Shift+Tab');
      await page.keyboard.press('Space');
      await until(() => document.body.dataset.state === 'running');
      await page.keyboard.press('Space');
      await until(() => document.body.dataset.state !== 'running');
    },
  ],
];
