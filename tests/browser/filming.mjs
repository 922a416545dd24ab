// A film of a run, and a whole study in one file.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { unzipSync } from 'fflate';
import { ALL_FORMATS, BufferSource, EncodedPacketSink, Input } from 'mediabunny';
import { documentOf, openBench } from './bench.mjs';
import { SHORT, openSoccer } from './pitch.mjs';
import { openPlan } from './plan.mjs';
import { linkTo, openStudy } from './studies.mjs';

/** Opens the dialog of the open tab. @param {import('playwright-core').Page} page */
async function openFilm(page) {
  await page.locator('.page-tab:not([hidden]) .foot').getByRole('button', { name: 'Video', exact: true }).click();
  return page.locator('.video-dialog');
}

/** Fills the dialog and waits for the file. @param {import('./browser.mjs').Opened} opened @param {Record<string, string>} fields @param {string} [stretch] a button pressed before */
async function film({ page }, fields, stretch) {
  const dialog = await openFilm(page);
  if (stretch) await dialog.getByRole('button', { name: stretch }).click();
  for (const [label, value] of Object.entries({ Pixels: '480', ...fields })) {
    const field = dialog.getByLabel(label);
    if (await field.evaluate((element) => element.matches('select'))) await field.selectOption(value);
    else await field.fill(value);
  }
  const waiting = page.waitForEvent('download');
  await dialog.getByRole('button', { name: 'Film', exact: true }).click();
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

/** @param {number[]} times @param {number} [rate] pictures a second */
const assertEven = (times, rate = 30) => times.forEach((time, at) => assert.ok(Math.abs(time - at / rate) < 0.0006, `picture ${at} at ${time} s`)); // a container counts in milliseconds

/**
 * Shades of a picture as a browser shows it, of so many spots. The page holds the decoder.
 *
 * @param {import('playwright-core').Page} page
 * @param {Buffer} bytes
 * @param {number} time seconds
 */
const shades = (page, bytes, time, width = 24, height = 18) =>
  page.evaluate(
    async ([base64, at, across, down]) => {
      const { ALL_FORMATS, BufferSource, CanvasSink, Input } = /** @type {typeof import('mediabunny')} */ (/** @type {any} */ (globalThis).Mediabunny);
      const source = new BufferSource(Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)));
      const track = await new Input({ formats: ALL_FORMATS, source }).getPrimaryVideoTrack();
      if (!track) return [];
      const found = await new CanvasSink(track, { width: across, height: down, fit: 'fill' }).getCanvas(at);
      const context = /** @type {OffscreenCanvasRenderingContext2D} */ (found?.canvas.getContext('2d'));
      return [...context.getImageData(0, 0, across, down).data];
    },
    /** @type {[string, number, number, number]} */ ([bytes.toString('base64'), time, width, height]),
  );

/**
 * How many spots of a picture have about the colour of a status in the light theme. The page holds the decoder.
 *
 * @param {import('playwright-core').Page} page
 * @param {Buffer} bytes
 * @param {number} time seconds
 */
const statuses = (page, bytes, time) =>
  page.evaluate(
    async ([base64, at]) => {
      const { ALL_FORMATS, BufferSource, CanvasSink, Input } = /** @type {typeof import('mediabunny')} */ (/** @type {any} */ (globalThis).Mediabunny);
      const source = new BufferSource(Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)));
      const track = await new Input({ formats: ALL_FORMATS, source }).getPrimaryVideoTrack();
      const found = track && (await new CanvasSink(track).getCanvas(at));
      if (!found) return null;
      const context = /** @type {OffscreenCanvasRenderingContext2D} */ (found.canvas.getContext('2d'));
      const { data } = context.getImageData(0, 0, found.canvas.width, found.canvas.height);
      const counts = { success: 0, failure: 0, running: 0 };
      for (let spot = 0; spot < data.length; spot += 4) {
        const near = (/** @type {number[]} */ colour) => Math.hypot(...colour.map((part, index) => part - data[spot + index])) < 50;
        if (near([0, 158, 115])) counts.success += 1;
        else if (near([213, 94, 0])) counts.failure += 1;
        else if (near([230, 159, 0])) counts.running += 1;
      }
      return counts;
    },
    /** @type {[string, number]} */ ([bytes.toString('base64'), time]),
  );

/** Whether the pitches in the left and the right half of a picture look alike. @param {import('playwright-core').Page} page @param {Buffer} bytes @param {number} time */
async function halvesEqual(page, bytes, time) {
  const spots = await shades(page, bytes, time, 90, 40); // half of it is 45 wide, of which the gap takes one
  const shade = (/** @type {number} */ x, /** @type {number} */ y) => spots[4 * (90 * y + x)];
  let apart = 0;
  for (let y = 0; y < 32; y += 1) for (let x = 0; x < 44; x += 1) if (Math.abs(shade(x, y) - shade(x + 46, y)) > 40) apart += 1;
  return apart < 3;
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
      assertEven(times);
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
      const dialog = await openFilm(page);
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
      const dialog = await openFilm(page);
      await dialog.getByRole('button', { name: 'Film', exact: true }).click();
      await page.locator('#video-extent').filter({ hasText: 'cannot encode video' }).waitFor();
    },
  ],
  [
    'a_film_of_a_match_shows_the_stretch_asked_for_with_even_timing',
    async (open) => {
      const soccer = await openSoccer(open, SHORT, { acceptDownloads: true, bypassCSP: true }); // so that the test may decode in the page
      const { page } = soccer;
      const fingerprint = await soccer.whole();
      await soccer.seek(600);
      const dialog = await openFilm(page);
      assert.deepEqual([await dialog.getByLabel('From second').inputValue(), await dialog.getByLabel('To second').inputValue()], ['10', '40'], 'the next 30 seconds');
      await page.locator('#video-extent').filter({ hasText: '901 pictures, 30.0 s at 30' }).waitFor(); // 30 s at real time, and the last
      for (const [label, value] of [['To second', '40.1'], ['From second', '-1'], ['From second', ''], ['To second', '9']]) {
        const field = dialog.getByLabel(label);
        const good = await field.inputValue();
        await field.fill(value);
        await page.locator('#video-extent').filter({ hasText: 'Expected seconds from 0 to 40' }).waitFor();
        assert.ok(await dialog.getByRole('button', { name: 'Film', exact: true }).isDisabled(), `${label} ${value}`);
        await field.fill(good);
      }
      await dialog.getByRole('button', { name: 'Close' }).click();
      const { name, bytes } = await film(soccer, { Speed: '8' }, 'Whole match');
      assert.match(name, /^match-seed3-0-to-40s\.(mp4|webm)$/);
      const { width, height, times } = await watch(bytes);
      assert.deepEqual([width, height, times.length], [480, 388, 301]); // 2400 ticks, 8 per picture, and the last
      assertEven(times);
      await page.addScriptTag({ path: 'node_modules/mediabunny/dist/bundles/mediabunny.min.cjs' });
      const [kickOff, again, later] = [await shades(page, bytes, 0), await shades(page, bytes, 0), await shades(page, bytes, 6)];
      assert.equal(kickOff.length, 24 * 18 * 4);
      assert.deepEqual(kickOff, again);
      assert.ok(kickOff.some((shade, at) => Math.abs(shade - later[at]) > 20), 'robots and ball have moved');
      assert.equal(await soccer.whole(), fingerprint, 'the match stays as it was');
      assert.equal(await soccer.tick(), 600);
      assert.deepEqual(soccer.problems, []);
      return name;
    },
  ],
  [
    'a_film_of_a_match_waits_for_what_is_not_computed_yet',
    async (open) => {
      const soccer = await openSoccer(open, '#/soccer?preset=match&seed=5&soccer.half-seconds=300', { acceptDownloads: true });
      const { bytes } = await film(soccer, { 'From second': '590', 'To second': '600', Speed: '32' });
      const { times } = await watch(bytes);
      assert.equal(times.length, 20); // 600 ticks, 32 per picture: 19, and the last
      assertEven(times);
      await soccer.whole();
      assert.deepEqual(soccer.problems, []);
    },
  ],
  [
    'a_film_beside_shows_both_pitches_with_coaches_and_scores_at_the_same_moments',
    async (open) => {
      const soccer = await openSoccer(open, SHORT.replace('seconds=20', 'seconds=60'), { acceptDownloads: true, bypassCSP: true });
      const { page } = soccer;
      await page.addScriptTag({ path: 'node_modules/mediabunny/dist/bundles/mediabunny.min.cjs' });
      const said = page.locator('#soccer-compare').filter({ hasText: 'At full time' });
      /** @type {() => Promise<string[]>} */
      const written = () => page.evaluate(() => (/** @type {any} */ (globalThis).written ??= []).splice(0));
      await page.evaluate(() => {
        const { fillText } = CanvasRenderingContext2D.prototype;
        CanvasRenderingContext2D.prototype.fillText = function (words, ...place) {
          /** @type {any} */ ((globalThis).written ??= []).push(words);
          fillText.call(this, words, ...place);
        };
      });
      await page.getByRole('button', { name: 'A | B' }).click();
      await said.waitFor();
      const [same, differs] = [[], []];
      for (const [other, found] of /** @type {[string, boolean[]][]} */ ([['tree', same], ['chase', differs]])) {
        await page.locator('#soccer-other').selectOption(other);
        await page.locator('#soccer .soccer-side .side-name').nth(1).filter({ hasText: other === 'tree' ? 'tree against machine' : 'two chasers against machine' }).waitFor();
        await said.waitFor();
        await written();
        const { name, bytes } = await film(soccer, { Speed: '32', Pixels: '720' }, 'Whole match');
        assert.match(name, /^match-seed3-a-b-0-to-120s\.(mp4|webm)$/);
        const { width, height, times } = await watch(bytes);
        assert.deepEqual([width, height, times.length], [720, 318, 226]); // 7200 ticks, 32 per picture, and the last
        assertEven(times);
        for (const time of [0, 2, 5]) found.push(await halvesEqual(page, bytes, time));
        const words = await written();
        const [, ...goals] = /A ends (\d+) : (\d+) and B (\d+) : (\d+)/.exec((await said.textContent()) ?? '') ?? [];
        const [a, b] = ['A', 'B'].map((letter) => words.filter((each) => each.startsWith(`${letter}: `)));
        assert.deepEqual([a.length, b.length], [226, 226], 'both in every picture');
        assert.equal(a.at(-1), `A: tree (blue) ${goals[0]} : ${goals[1]} machine (yellow)`);
        assert.equal(b.at(-1), `B: ${other === 'tree' ? 'tree' : 'two chasers'} (blue) ${goals[2]} : ${goals[3]} machine (yellow)`);
        assert.match(a[0], / 0 : 0 /, 'at the kick-off');
      }
      assert.deepEqual(same, [true, true, true], 'one coach: the same picture twice');
      assert.deepEqual(differs, [true, false, false], 'another coach: the same kick-off only');
      assert.deepEqual(soccer.problems, []);
    },
  ],
  [
    'a_film_of_a_plan_shows_it_from_start_to_end_and_none_is_made_of_no_plan',
    async (open) => {
      const plan = await openPlan(open, '#/sequence?preset=plan-small&seed=3&plan=EEN&t=120', { acceptDownloads: true });
      await plan.planned();
      const last = Number(await plan.page.locator('#sequence-scrub').getAttribute('max'));
      const { name, bytes } = await film(plan, {});
      assert.match(name, new RegExp(`^sequence-plan-small-seed3-0-to-${last / 10}s\\.(mp4|webm)$`));
      const { width, height, times } = await watch(bytes);
      assert.deepEqual([width, height, times.length], [480, 480, Math.ceil(last / 3) + 1]);
      assertEven(times);
      await plan.notice(/Saved sequence-plan-small/);
      assert.equal(await plan.page.locator('#sequence-scrub').inputValue(), '120', 'the moment on screen stays');
      const none = await openPlan(open, '#/sequence?preset=plan-walled');
      await none.result('infeasible');
      await none.page.locator('#sequence .foot').getByRole('button', { name: 'Video', exact: true }).click();
      await none.notice(/There is no plan/);
      assert.deepEqual(plan.problems.concat(none.problems), []);
      return name;
    },
  ],
  [
    'a_film_of_a_tree_has_a_picture_for_every_tick_in_the_colours_of_the_statuses',
    async (open) => {
      const bench = await openBench(open, '#/trees?preset=retry', { acceptDownloads: true, bypassCSP: true });
      const { page } = bench;
      const before = await bench.seek(3);
      const dialog = await openFilm(page);
      assert.deepEqual([await dialog.getByLabel('From tick').inputValue(), await dialog.getByLabel('To tick').inputValue()], ['0', '8'], 'the ticks that are known');
      await page.locator('#video-extent').filter({ hasText: '9 pictures, 4.5 s at 2 pictures a second' }).waitFor();
      await dialog.getByLabel('To tick').fill('100001');
      await page.locator('#video-extent').filter({ hasText: /^Expected whole ticks from 0 to 100000, the first not after the last\.$/ }).waitFor();
      assert.ok(await dialog.getByRole('button', { name: 'Film', exact: true }).isDisabled());
      await dialog.getByRole('button', { name: 'Close' }).click();
      const { name, bytes } = await film(bench, { 'To tick': '10', Speed: '4' });
      assert.match(name, /^retry-0-to-10\.(mp4|webm)$/);
      const { width, height, times } = await watch(bytes);
      assert.deepEqual([width, height % 2, times.length], [480, 0, 11]);
      assertEven(times, 4);
      await bench.notice(/Saved retry-0-to-10.*11 pictures/);
      await page.addScriptTag({ path: 'node_modules/mediabunny/dist/bundles/mediabunny.min.cjs' });
      const [none, first, fourth] = [await statuses(page, bytes, 0), await statuses(page, bytes, 0.25), await statuses(page, bytes, 1)];
      assert.ok(none && first && fourth);
      assert.deepEqual(none, { success: 0, failure: 0, running: 0 }, 'before the first tick nothing has returned');
      assert.ok(first.failure > 20 && first.running > 20, `PushDoor fails, Enter and help run: ${JSON.stringify(first)}`);
      assert.ok(fourth.failure > 20 && fourth.running < first.running, `Enter fails: ${JSON.stringify(fourth)}`);
      const again = await film(bench, { 'To tick': '10', Speed: '4' });
      assert.deepEqual(await statuses(page, again.bytes, 1), fourth, 'the same picture again');
      assert.equal(await bench.at(3), before, 'the run on screen stays as it was');
      assert.deepEqual(bench.said(), []);
      return name;
    },
  ],
  [
    'no_film_is_made_of_a_comparison_or_of_a_tree_that_cannot_run',
    async (open) => {
      const compared = await openBench(open, '#/trees');
      await compared.page.locator('.compare:not([hidden])').waitFor();
      await compared.page.locator('#trees .foot').getByRole('button', { name: 'Video', exact: true }).click();
      await compared.notice(/Leave the comparison first/);
      const bench = await openBench(open, '#/trees?preset=retry');
      await bench.type(documentOf('<Own><Near/></Own>', '<Control ID="Own"/><Condition ID="Near"/>'));
      await bench.page.locator('#trees .watch').filter({ hasText: 'can be shown but not run' }).waitFor();
      await bench.page.locator('#trees .foot').getByRole('button', { name: 'Video', exact: true }).click();
      await bench.notice(/cannot be run, so there is nothing to film/);
      assert.equal(await bench.page.locator('.video-dialog').count(), 0);
      assert.deepEqual(compared.said().concat(bench.said()), []);
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
