import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { eventually } from './browser.mjs';

/** @typedef {import('./browser.mjs').Opened} Opened */

const root = fileURLToPath(new URL('../../', import.meta.url));

/** What the command line prints for a scenario. @param {...string} options */
const native = async (...options) => JSON.parse((await promisify(execFile)('cargo', ['run', '--locked', '--quiet', '--', 'run', ...options], { cwd: root })).stdout);

/** Runs a case with a folder of its own. @param {(folder: string) => Promise<void>} run */
async function inFolder(run) {
  const folder = mkdtempSync(join(tmpdir(), 'population-'));
  try {
    await run(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** What a button saves. @param {Opened} opened @param {string} label */
async function saved({ page }, label) {
  const waiting = page.waitForEvent('download');
  await page.getByRole('button', { name: label, exact: true }).click();
  const download = await waiting;
  return { name: download.suggestedFilename(), text: readFileSync(await download.path(), 'utf8') };
}

/** Opens a text as a file. @param {Opened} opened @param {string} name @param {string} text */
const choose = ({ page }, name, text) => page.locator('#open-file').setInputFiles({ name, mimeType: 'application/json', buffer: Buffer.from(text) });

/** Drops a text as a file on the world. @param {Opened} opened @param {string} name @param {string} text */
async function drop({ page }, name, text) {
  const data = await page.evaluateHandle(
    ([file, written]) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([written], file, { type: 'application/json' }));
      return transfer;
    },
    /** @type {const} */ ([name, text]),
  );
  await page.dispatchEvent('#canvas', 'dragover', { dataTransfer: data });
  await page.locator('.drop-veil').waitFor();
  await page.dispatchEvent('#canvas', 'drop', { dataTransfer: data });
  await page.locator('.drop-veil').waitFor({ state: 'hidden' });
}

const said = (/** @type {Opened} */ { page }) => page.locator('.population-said');

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'a_population_saved_by_the_page_is_the_command_lines_and_runs_there_to_the_same_fingerprint',
    async (open) => {
      await inFolder(async (folder) => {
        const opened = await open('#/forage?preset=foraging&seed=9', { acceptDownloads: true });
        await opened.openGroups();
        await opened.seek(60);
        const { name, text } = await saved(opened, 'Save population');
        assert.equal(name, 'population-foraging-seed9-tick60.json');
        const [ours, theirs] = [join(folder, 'page.json'), join(folder, 'native.json')];
        writeFileSync(ours, text);
        await native('scenarios/foraging.json', '--seed', '9', '--steps', '60', '--save-population', theirs);
        assert.equal(text, readFileSync(theirs, 'utf8'), 'both write the same file');

        await choose(opened, 'native.json', readFileSync(theirs, 'utf8'));
        await opened.notice(/native\.json is opened: 100 programs from “Foraging”, seed 9, tick 60/);
        await opened.at(0);
        const { fingerprint } = await native('scenarios/foraging.json', '--seed', '9', '--population', ours, '--steps', '40');
        assert.equal(await opened.seek(40), fingerprint, 'programs as they were saved');

        await opened.page.locator('[data-key="geese.population-form"] select').selectOption('blended');
        await opened.page.locator('[data-key="geese.evolution"] input').uncheck();
        const share = opened.page.locator('[data-key="geese.population-share"] .number input');
        await share.fill('0.2');
        await share.press('Enter');
        await opened.page.locator('#apply').click();
        await opened.at(0);
        const set = ['geese.population-form=blended', 'geese.population-share=0.2', 'geese.evolution=false'].flatMap((change) => ['--set', change]);
        // In the page the robots stop to evolve by a change at tick 40, which the restart makes part of the start.
        const blended = await native('scenarios/foraging.json', '--seed', '9', '--population', ours, '--steps', '30', ...set);
        assert.equal(await opened.seek(30), blended.fingerprint, 'the fittest fifth, all in each robot');
        assert.deepEqual(opened.problems, []);
      });
    },
  ],
  [
    'a_population_is_opened_by_dropping_and_pasting_and_is_removed',
    async (open) => {
      const opened = await open('#/forage?preset=foraging&seed=3', { acceptDownloads: true });
      await opened.openGroups();
      const start = await opened.at(0);
      await eventually(async () => assert.match((await said(opened).textContent()) ?? '', /^None/));
      await opened.seek(50);
      const { text } = await saved(opened, 'Save population');
      await drop(opened, 'dropped.json', text);
      await said(opened).filter({ hasText: '100 programs from “Foraging”, seed 3, tick 50.' }).waitFor();
      const dealt = await opened.at(0);
      assert.notEqual(dealt, start);
      await opened.page.getByRole('button', { name: 'Remove', exact: true }).click();
      await said(opened).filter({ hasText: /^None/ }).waitFor();
      assert.equal(await opened.at(0), start);
      await opened.page.locator('.paste textarea').fill(text.replace(/ {2}"(title|seed|tick)".*\n/g, ''));
      await opened.page.getByRole('button', { name: 'Open what is pasted' }).click();
      await said(opened).filter({ hasText: '100 programs; the file does not say where they come from.' }).waitFor();
      assert.equal(await opened.at(0), dealt);
      assert.deepEqual(opened.problems, []);
    },
  ],
  [
    'a_bad_population_is_refused_with_its_place_and_nothing_is_lost',
    async (open) => {
      const opened = await open('#/forage?preset=foraging&seed=3', { acceptDownloads: true });
      await opened.openGroups();
      const before = await opened.seek(50);
      const { text } = await saved(opened, 'Save population');
      const lines = text.split('\n');
      for (const [name, bad, pattern] of /** @type {[string, string, RegExp][]} */ ([
        ['cut.json', text.slice(0, 900), /cut\.json was not opened, and nothing changed: population: expected JSON, found EOF while parsing .* at line \d+ column \d+/],
        ['later.json', text.replace('geese-population/1', 'geese-population/2'), /format: expected "geese-population\/1", found "geese-population\/2"/],
        ['codon.json', text.replace(/"genome":\[\d+/, '"genome":[70000'), /members\[0\]\.genome: expected a list of whole numbers from 0 to 65535/],
        ['empty.json', '{"format": "geese-population/1", "members": []}', /members: expected a list of 1 to 10000 members/],
        ['broken.json', lines.with(6, '    nonsense,').join('\n'), /expected JSON, found .* at line 7 column \d+/],
        ['other.json', '{"name": "something else"}', /other\.json was not opened, and nothing changed: world: expected one of "geese", found no such field/],
        ['picture.json', '\u0000\u0001', /picture\.json was not opened, and nothing changed: expected a scenario as JSON/],
      ])) {
        await choose(opened, name, bad);
        await opened.notice(pattern);
        assert.equal(await opened.at(50), before, name);
      }
      assert.match((await said(opened).textContent()) ?? '', /^None/);
      assert.deepEqual(opened.problems, []);
    },
  ],
  [
    'a_population_survives_its_link_and_a_long_link_offers_the_file',
    async (open) => {
      const opened = await open('#/forage?preset=foraging&seed=3&geese.agents=400', { acceptDownloads: true, permissions: ['clipboard-read', 'clipboard-write'] });
      await opened.openGroups();
      await opened.seek(50);
      const { text } = await saved(opened, 'Save population');
      await choose(opened, 'population.json', text);
      await opened.at(0);
      const fingerprint = await opened.seek(20);
      const hash = await opened.address(20);
      assert.match(hash, /geese\.population=~/);
      const again = await open(hash);
      assert.equal(await again.at(20), fingerprint);
      await again.notice(/fingerprint matches/);
      await opened.page.locator('[data-action=copy-link]').click();
      await opened.notice(/too many for some programs/);
      const scenario = JSON.parse((await saved(opened, 'Save JSON')).text);
      assert.equal(scenario.population, text);
    },
  ],
  [
    'a_scenario_is_saved_and_opened_and_runs_on_the_command_line',
    async (open) => {
      await inFolder(async (folder) => {
        const first = await open('#/forage?preset=nest&seed=21&geese.agents=60', { acceptDownloads: true });
        await first.openGroups();
        await first.seek(30);
        const mutation = first.page.locator('[data-key="geese.mutation-probability"] .number input');
        await mutation.fill('0.3');
        await mutation.press('Enter');
        await first.until(() => location.hash.includes('events=~'));
        const fingerprint = await first.seek(80);
        const { text } = await saved(first, 'JSON');
        const second = await open('#/forage?preset=foraging&seed=4');
        const before = await second.seek(10);
        await choose(second, 'bad.json', text.replace('"agents": 60', '"agents": 0'));
        await second.notice(/bad\.json was not opened, and nothing changed: agents: expected a whole number from 1 to 10000 robots, found 0/);
        assert.equal(await second.at(10), before);
        await drop(second, 'nest.json', text);
        await second.notice(/nest\.json is opened: Nest maintenance\./);
        await eventually(async () => assert.equal(await second.page.locator('#preset').inputValue(), 'nest'));
        assert.equal(await second.seek(80), fingerprint);
        await eventually(async () => assert.match(await second.address(80), /preset=nest&seed=21&geese\.agents=60&events=~/));
        const path = join(folder, 'nest.json');
        writeFileSync(path, text);
        assert.equal((await native(path, '--steps', '80')).fingerprint, fingerprint);
        await second.page.goBack();
        await second.at(10);
        assert.deepEqual(second.problems, []);
      });
    },
  ],
  [
    'in_a_pair_the_side_looked_at_is_saved',
    async (open) => {
      const opened = await open('#/forage?preset=foraging-paper&seed=3&b.preset=foraging', { acceptDownloads: true });
      await opened.openGroups();
      await opened.seek(40);
      const a = await saved(opened, 'Save population');
      assert.equal(a.name, 'population-foraging-paper-a-seed3-tick40.json');
      await opened.page.locator('.ab-looking').getByRole('button', { name: 'B', exact: true }).click();
      const b = await saved(opened, 'Save population');
      assert.equal(b.name, 'population-foraging-paper-b-seed3-tick40.json');
      assert.equal(JSON.parse(b.text).title, 'Foraging');
      assert.notEqual(a.text, b.text);
      assert.equal(JSON.parse((await saved(opened, 'JSON')).text)['swap-rule'], 'always');
    },
  ],
  [
    'presets_stand_in_groups_and_the_chosen_one_says_what_it_is',
    async (open) => {
      const { page } = await open('#/forage?preset=geese-bt');
      const groups = await page.locator('#preset optgroup').evaluateAll((found) => found.map((group) => [group.getAttribute('label'), group.children.length]));
      assert.ok(groups.length >= 3 && groups.every(([, count]) => Number(count) > 0), JSON.stringify(groups));
      assert.equal(await page.locator('#preset').inputValue(), 'geese-bt');
      await eventually(async () => assert.match((await page.locator('.preset-about').textContent()) ?? '', /The algorithm before BeTr-GEESE/));
    },
  ],
  [
    'the_fitness_of_a_robot_is_shown_as_the_sum_it_is',
    async (open) => {
      for (const preset of ['foraging', 'geese-bt']) {
        const { page, seek, until } = await open(`#/forage?preset=${preset}&geese.fitness-memory=0.8`);
        await seek(120);
        await page.locator('#canvas').focus();
        await page.keyboard.press('Home');
        await page.locator('#tab-agent').click();
        const list = page.locator('.fitness-list');
        await list.waitFor();
        for (let robot = 0; robot < 12; robot += 1) {
          await until((wanted) => document.querySelector('.agent-head h2')?.textContent === `Robot ${wanted}`, robot);
          await eventually(async () => {
            const [before, ...rest] = await list.locator('dd').allTextContents();
            const sum = Number(rest.pop());
            const parts = rest.filter((part) => !part.includes('does not count')).map(Number);
            const kept = Number(before.split(' = ').pop());
            if ((await page.locator('.fitness-list').locator('xpath=preceding-sibling::p[1]').textContent())?.includes('starts at 0')) return;
            assert.ok(Math.abs(kept + parts.reduce((all, part) => all + part, 0) - sum) < 0.02, `robot ${robot}: ${before}; ${rest.join('; ')}; ${sum}`);
          });
          await page.getByRole('button', { name: 'Next robot' }).click();
        }
      }
    },
  ],
];
