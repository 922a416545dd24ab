import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { eventually } from './browser.mjs';

const preset = readFileSync(new URL('../../scenarios/foraging.json', import.meta.url), 'utf8');
const fieldOf = (/** @type {string} */ key) => key.slice(key.indexOf('.') + 1);

/** Another value the schema allows. @param {any} parameter @param {any} value */
function another({ type, min, max, step, choices, key }, value) {
  if (type === 'seed') return 123_456;
  if (type === 'bool') return !value;
  if (type === 'choice') return choices.find((/** @type {{ value: string }} */ choice) => choice.value !== value)?.value;
  if (key === 'geese.grammar') return '<S> ::= Explore\n'; // names of built-in rules are shown in full
  if (type === 'text') return `${value}\n`;
  const by = step ?? (type === 'int' ? 1 : (max - min) / 100);
  const next = value + by <= max ? value + by : value - by;
  assert.ok(next >= min, `${key} has room for one value only`);
  return Number(next.toPrecision(12));
}

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'link_reopened_in_a_second_page_gives_the_same_fingerprint',
    async (open) => {
      const first = await open('#/forage?preset=foraging&seed=7');
      const fingerprint = await first.seek(150);
      const hash = await first.address(150);
      assert.match(hash, /^#\/forage\?v=[\d.]+&preset=foraging&seed=7&t=150&f=[0-9a-f]{16}$/);
      const second = await open(hash);
      assert.equal(await second.at(150), fingerprint);
      await second.notice(/fingerprint matches/);
      assert.deepEqual(second.problems, []);
    },
  ],
  [
    'every_key_of_the_schema_survives_the_link',
    async (open) => {
      const { page, engine, until, at, hash } = await open();
      await at(0);
      const { schema } = /** @type {{ schema: any[] }} */ (await engine('hello'));
      const { scenario } = /** @type {{ scenario: Record<string, any> }} */ (await engine('complete', { scenario: preset }));
      const lost = [];
      for (const parameter of schema) {
        const { key, type } = parameter;
        const value = another(parameter, scenario[fieldOf(key)]);
        if (value === undefined) continue; // a choice of one
        await page.evaluate((wanted) => void (location.hash = wanted), `#/forage?preset=foraging&${key}=${encodeURIComponent(value)}`);
        await until(() => location.hash.startsWith('#/forage?v=') || document.querySelector('.notice.problem'));
        const written = await hash();
        const problems = await page.locator('.notice.problem p').allTextContents();
        if (problems.length > 0) lost.push(`${key}=${value}: ${problems.join(' ')}`);
        else if (type === 'text' ? !written.includes(`${key}=~`) : !written.includes(`&${key}=${encodeURIComponent(value)}`)) lost.push(`${key}=${value} became ${written}`);
        if (problems.length > 0 || type !== 'text' || key === 'geese.population') continue; // a population is told in one line
        await page.evaluate((wanted) => void (location.hash = `${wanted}&t=0`), written);
        await until((wanted) => location.hash === wanted, written);
        await eventually(async () => assert.equal(await page.locator(`[data-key="${key}"] textarea`).inputValue(), value));
      }
      assert.deepEqual(lost, []);
      return `${schema.length} keys`;
    },
  ],
  [
    'back_leaves_a_preset_but_never_walks_through_sliders',
    async (open) => {
      const { page, at, until } = await open();
      await at(0);
      await page.locator('#preset').selectOption('foraging-paper');
      await until(() => location.hash.includes('preset=foraging-paper'));
      await page.locator('[data-action=new-seed]').click();
      await until(() => location.hash.includes('seed='));
      await page.goBack();
      await until(() => /** @type {HTMLSelectElement} */ (document.querySelector('#preset')).value === 'foraging');
      await until(() => location.hash.includes('preset=foraging&') || location.hash.endsWith('preset=foraging'));
    },
  ],
  [
    'copied_link_holds_scenario_tick_and_fingerprint',
    async (open, url) => {
      const { page, seek, notice } = await open('', { permissions: ['clipboard-read', 'clipboard-write'] });
      const fingerprint = await seek(90);
      await page.locator('[data-action=copy-link]').click();
      await notice(/on the clipboard/);
      const link = await page.evaluate(() => navigator.clipboard.readText());
      assert.ok(link.startsWith(`${url}#/forage?v=`), link);
      assert.ok(link.endsWith(`t=90&f=${fingerprint}`), link);
    },
  ],
];
