// Runs the opening world at full speed for a long time, a new seed after each end, and prints what memory the page takes.
//
//     node tests/browser/soak.mjs [MINUTES]      20 unless said; needs Linux, Chromium and the built page
//
// Status 1 when the median of the last quarter is more than a tenth above that of the same length after the first tenth:
// by then everything is loaded, and a run's keyframes have filled their share.

import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { findChromium, launch, openPage } from './browser.mjs';
import { serve } from './serve.mjs';

const EVERY_MS = 15_000;
const MOST_GROWTH = 0.1;
const minutes = Number(process.argv[2] ?? 20);
if (!(minutes >= 1)) {
  console.error('MINUTES must be a number of at least 1.');
  process.exit(1);
}
const executable = findChromium();
if (!executable) {
  console.error('no Chromium was found: install it or set CHROMIUM to its path');
  process.exit(1);
}

const server = await serve(fileURLToPath(new URL('../../dist', import.meta.url)), '/');
const browser = await launch(executable);
const { page, problems } = await openPage(browser, server.url, '#/forage?preset=foraging&seed=1', { reducedMotion: 'no-preference' });
const { processInfo } = await (await browser.newBrowserCDPSession()).send('SystemInfo.getProcessInfo');
const renderers = processInfo.filter(({ type }) => type === 'renderer').map(({ id }) => id);
const session = await page.context().newCDPSession(page);
await session.send('Performance.enable');

// In the page, so that no message is waited for: the next seed as soon as a run has ended.
await page.evaluate(() => {
  const click = (/** @type {string} */ selector) => /** @type {HTMLElement | null} */ (document.querySelector(selector))?.click();
  const counts = ((/** @type {any} */ (window).soak) = { runs: 0 });
  click('#max');
  setInterval(() => {
    const { state } = document.body.dataset;
    if (state === 'finished') {
      counts.runs += 1;
      click('[data-action=new-seed]');
    } else if (state === 'paused') click('#play');
  }, 100);
});

/** Megabytes that the page's processes hold. */
function resident() {
  const pages = renderers.map((id) => {
    try {
      return Number(readFileSync(`/proc/${id}/statm`, 'utf8').split(' ')[1]);
    } catch {
      return 0; // it has ended
    }
  });
  return pages.reduce((sum, count) => sum + count, 0) * 4096 / 1e6;
}

/** @param {number[]} values */
const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

/** @type {number[]} */
const samples = [];
const start = Date.now();
console.log('minute   runs   tick  script, MB  process, MB');
while (Date.now() - start < minutes * 60_000) {
  await new Promise((resolve) => setTimeout(resolve, EVERY_MS));
  await session.send('HeapProfiler.collectGarbage');
  const { metrics } = await session.send('Performance.getMetrics');
  const heap = (metrics.find(({ name }) => name === 'JSHeapUsedSize')?.value ?? 0) / 1e6;
  const [runs, tick] = await page.evaluate(() => [(/** @type {any} */ (window).soak).runs, Number(document.querySelector('#tick')?.textContent)]);
  samples.push(resident());
  console.log([((Date.now() - start) / 60_000).toFixed(1).padStart(6), String(runs).padStart(6), String(tick).padStart(6), heap.toFixed(1).padStart(11), samples[samples.length - 1].toFixed(0).padStart(12)].join(' '));
}
const quarter = Math.max(1, Math.floor(samples.length / 4));
const first = Math.ceil(samples.length / 10);
const [before, after] = [median(samples.slice(first, first + quarter)), median(samples.slice(-quarter))];
const growth = after / before - 1;
console.log(`${before.toFixed(0)} MB early, ${after.toFixed(0)} MB late: ${(100 * growth).toFixed(1)} % more, at most ${100 * MOST_GROWTH} %`);
for (const problem of problems) console.log(`the page said: ${problem}`);
await browser.close();
server.close();
process.exit(growth <= MOST_GROWTH && problems.length === 0 ? 0 : 1);
