import assert from 'node:assert/strict';

const SECONDS = 5;
const LEAST = 20; // machines are noisy: only a page that stutters fails

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  ...[false, true].map((max) => /** @type {import('./browser.mjs').Case} */ ([
    `frames_over_${SECONDS}_seconds_${max ? 'at_full_speed' : 'at_the_opening_speed'}`,
    async (open) => {
      const { page, inState, tick } = await open('', { reducedMotion: 'no-preference' });
      await inState('running');
      if (max) await page.locator('#max').check();
      const before = await tick();
      const frames = await page.evaluate(
        (seconds) =>
          new Promise((resolve) => {
            let count = 0;
            const start = performance.now();
            requestAnimationFrame(function beat(now) {
              count += 1;
              if (now - start < seconds * 1000) requestAnimationFrame(beat);
              else resolve((count * 1000) / (now - start));
            });
          }),
        SECONDS,
      );
      const ticks = ((await tick()) - before) / SECONDS;
      assert.ok(Number(frames) >= LEAST, `${Number(frames).toFixed(1)} frames per second`);
      return `${Number(frames).toFixed(1)} frames per second, ${ticks.toFixed(0)} ticks per second`;
    },
    'alone',
  ])),
];
