// A film of a run, and a whole study in one file.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { unzipSync } from 'fflate';
import { ALL_FORMATS, BufferSource, EncodedPacketSink, Input } from 'mediabunny';
import { linkTo, openStudy } from './studies.mjs';

/** Fills the dialog and waits for the file. @param {import('./browser.mjs').Opened} opened @param {Record<string, string>} fields */
async function film({ page }, fields) {
  await page.locator('#foot').getByRole('button', { name: 'Video', exact: true }).click();
  for (const [label, value] of Object.entries(fields)) await page.locator('.video-dialog').getByLabel(label).fill(value);
  await page.locator('.video-dialog select').selectOption('480');
  const waiting = page.waitForEvent('download');
  await page.locator('.video-dialog').getByRole('button', { name: 'Film', exact: true }).click();
  const download = await waiting;
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

/** What a player sees: the picture's size and when each begins. @param {Buffer} bytes */
async function watch(bytes) {
  const input = new Input({ formats: ALL_FORMATS, source: new BufferSource(bytes) });
  const track = await input.getPrimaryVideoTrack();
  assert.ok(track, 'there is no picture in it');
  const times = [];
  for await (const { timestamp } of new EncodedPacketSink(track).packets()) times.push(timestamp);
  return { width: track.displayWidth, height: track.displayHeight, times };
}

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'a_film_has_a_picture_for_every_tick_asked_for_with_even_timing',
    async (open) => {
      const opened = await open('#/forage?preset=foraging&seed=9', { acceptDownloads: true });
      const before = await opened.seek(25);
      const { name, bytes } = await film(opened, { 'From tick': '20', 'To tick': '80', 'Ticks per picture': '2' });
      assert.match(name, /^swarm-foraging-seed9-20-to-80\.(mp4|webm)$/);
      const { width, height, times } = await watch(bytes);
      assert.deepEqual([width, height, times.length], [480, 480, 31]);
      times.forEach((time, at) => assert.ok(Math.abs(time - at / 30) < 0.0006, `picture ${at} at ${time} s`)); // a container counts in milliseconds
      await opened.notice(/Saved swarm-foraging-seed9-20-to-80.*31 pictures/);
      assert.equal(await opened.at(25), before, 'the run on screen stays as it was');
      assert.deepEqual(opened.problems, []);
      return name;
    },
  ],
  [
    'a_film_that_makes_no_sense_is_refused_and_one_under_way_can_be_stopped',
    async (open) => {
      const { page } = await open('#/forage?preset=foraging&seed=9');
      await page.locator('#foot').getByRole('button', { name: 'Video', exact: true }).click();
      const dialog = page.locator('.video-dialog');
      const start = dialog.getByRole('button', { name: 'Film', exact: true });
      for (const [label, value] of [['To tick', '12001'], ['To tick', '-1'], ['From tick', '1.5'], ['Ticks per picture', '0'], ['To tick', '']]) {
        const field = dialog.getByLabel(label);
        const good = await field.inputValue();
        await field.fill(value);
        await page.locator('#video-extent').filter({ hasText: 'Expected whole ticks from 0 to 12000' }).waitFor();
        assert.ok(await start.isDisabled(), `${label} ${value}`);
        await field.fill(good);
        await page.locator('#video-extent').filter({ hasText: '601 pictures, 20.0 s at 30' }).waitFor();
      }
      await start.click();
      await dialog.getByRole('button', { name: 'Stop' }).click();
      await page.locator('#video-extent').filter({ hasText: 'Nothing was saved' }).waitFor();
      await dialog.getByRole('button', { name: 'Close' }).click();
      await dialog.waitFor({ state: 'detached' }); // the browser closes it a moment later
    },
  ],
  [
    'a_browser_without_an_encoder_is_told_so',
    async (open) => {
      const { page } = await open('#/trees');
      await page.addInitScript(() => Reflect.deleteProperty(globalThis, 'VideoEncoder'));
      await page.goto(page.url().replace(/#.*/, '#/forage'));
      await page.reload();
      await page.waitForFunction(() => document.body.dataset.state !== 'loading');
      await page.locator('#foot').getByRole('button', { name: 'Video', exact: true }).click();
      await page.locator('.video-dialog').getByRole('button', { name: 'Film', exact: true }).click();
      await page.locator('#video-extent').filter({ hasText: 'cannot encode video' }).waitFor();
    },
  ],
  [
    'a_study_leaves_as_one_file_with_spec_rows_report_figure_and_citation',
    async (open) => {
      const study = await openStudy(open, linkTo(), { acceptDownloads: true });
      await study.finish();
      const { name, bytes } = await study.saved('ZIP');
      assert.equal(name, 'small.zip');
      const files = unzipSync(bytes);
      const text = (/** @type {string} */ path) => new TextDecoder().decode(files[path]);
      assert.deepEqual(Object.keys(files).sort(), ['CITATION.txt', 'small.csv', 'small.md', 'small.study.json', 'small.svg']);
      assert.equal(text('small.csv'), await study.csv());
      assert.equal(text('small.study.json'), (await study.saved('Spec')).bytes.toString());
      assert.equal(text('small.svg'), (await study.saved('SVG')).bytes.toString());
      assert.equal(text('small.md'), (await study.saved('Report')).bytes.toString());
      const [, hash] = /study ([0-9a-f]{16})\./.exec(text('CITATION.txt')) ?? [];
      assert.ok(hash && text('small.csv').includes(hash), 'the citation names the study of the rows');
      assert.deepEqual((await study.saved('ZIP')).bytes, bytes, 'the same bytes again');
      assert.deepEqual(study.problems, []);
    },
  ],
];
