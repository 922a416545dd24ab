import assert from 'node:assert/strict';
import { findChromium, launch, patient } from './browser.mjs';

const LINK = '#/forage?preset=foraging&seed=3&embed=1&ui=play,scrub,tree';

/**
 * A page of somebody else's with ours in a frame.
 *
 * @param {string} url
 * @param {(parts: { page: import('playwright-core').Page, frame: import('playwright-core').Frame, say: (message: unknown, patience?: number) => Promise<any>, problems: string[] }) => Promise<void>} look
 * @param {{ width: number, height: number }} [size]
 */
async function framed(url, look, size = { width: 1280, height: 720 }) {
  const browser = await launch(/** @type {string} */ (findChromium()));
  try {
    const page = await patient(await browser.newContext({ viewport: { width: size.width + 40, height: size.height + 40 }, reducedMotion: 'reduce' })).newPage();
    /** @type {string[]} */
    const problems = [];
    page.on('pageerror', (error) => problems.push(error.message));
    page.on('console', (message) => message.type() === 'error' && problems.push(message.text()));
    const host = `<!doctype html><div id="above"></div><iframe src="${(url + LINK).replaceAll('&', '&amp;')}" width="${size.width}" height="${size.height}" style="border: 0"></iframe>`;
    await page.route(`${url}host.html`, (route) => route.fulfill({ contentType: 'text/html', body: host }));
    await page.goto(`${url}host.html`);
    const frame = /** @type {import('playwright-core').Frame} */ (await (await page.$('iframe'))?.contentFrame());
    await frame.waitForFunction(() => document.body.dataset.state === 'paused' && document.querySelector('#fingerprint')?.textContent);
    // The answer to a message, or null when there is none in time.
    const say = (/** @type {unknown} */ message, patience = 30_000) =>
      page.evaluate(
        ([sent, ms]) =>
          new Promise((resolve) => {
            const hear = (/** @type {MessageEvent} */ event) => (removeEventListener('message', hear), resolve(event.data));
            addEventListener('message', hear);
            setTimeout(() => (removeEventListener('message', hear), resolve(null)), ms);
            /** @type {HTMLIFrameElement} */ (document.querySelector('iframe')).contentWindow?.postMessage(sent, '*');
          }),
        /** @type {[unknown, number]} */ ([message, patience]),
      );
    await look({ page, frame, say, problems });
    assert.deepEqual(problems, []);
  } finally {
    await browser.close();
  }
}

/** @type {import('./browser.mjs').Case[]} */
export const cases = [
  [
    'a_frame_shows_the_parts_it_names_and_no_header',
    async (_, url) => {
      await framed(url, async ({ frame }) => {
        for (const shown of ['#canvas', '#play', '#scrub', '#tab-tree']) assert.ok(await frame.locator(shown).isVisible(), shown);
        for (const hidden of ['.top', '#controls', '#foot', '#seed', '#speed', '#tab-genome', '.legend']) assert.equal(await frame.locator(hidden).isVisible(), false, hidden);
      });
    },
  ],
  [
    'text_in_a_frame_of_1080_lines_has_24_pixels_or_more_and_a_click_finds_its_robot',
    async (_, url) => {
      await framed(
        url,
        async ({ page, frame }) => {
          const sizes = await frame.evaluate(() =>
            [...document.querySelectorAll('body *')]
              .filter((element) => element.checkVisibility() && [...element.childNodes].some((node) => node.nodeType === 3 && node.textContent?.trim()))
              .filter((element) => element.getBoundingClientRect().width > 2) // not the texts for screen readers
              .map((element) => [parseFloat(getComputedStyle(element).fontSize) * /** @type {any} */ (element).currentCSSZoom, element.textContent?.slice(0, 30)]),
          );
          assert.ok(sizes.length > 10);
          assert.deepEqual(sizes.filter(([size]) => Number(size) < 23.9), []);
          const box = /** @type {{ x: number, y: number, width: number, height: number }} */ (await frame.locator('#canvas').boundingBox());
          await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2); // all robots stand at the hub
          await frame.locator('.selected-name').filter({ hasText: 'Robot' }).waitFor();
        },
        { width: 1920, height: 1080 },
      );
    },
  ],
  [
    'messages_play_pause_step_and_tell_tick_and_fingerprint',
    async (open, url) => {
      const alone = await open('#/forage?preset=foraging&seed=3');
      const wanted = await alone.seek(2);
      await framed(url, async ({ frame, say }) => {
        const first = await say({ type: 'state' });
        assert.deepEqual(Object.keys(first).sort(), ['fingerprint', 'state', 'tick', 'type']);
        assert.equal(first.tick, 0);
        assert.equal((await say({ type: 'step' })).tick, 1);
        const second = await say({ type: 'step' });
        assert.deepEqual([second.type, second.tick, second.fingerprint], ['state', 2, wanted]);
        await say({ type: 'play' });
        await frame.waitForFunction(() => document.body.dataset.state === 'running' && Number(document.querySelector('#tick')?.textContent) > 5);
        assert.equal((await say({ type: 'pause' })).state, 'paused');
      });
    },
  ],
  [
    'messages_of_another_shape_are_ignored',
    async (_, url) => {
      await framed(url, async ({ say }) => {
        for (const wrong of [null, 7, 'play', [], ['play'], {}, { type: 7 }, { type: 'stop' }, { type: 'constructor' }, { type: '__proto__' }, { type: 'play', more: 1 }, { Type: 'play' }, { type: { play: 1 } }, 'x'.repeat(100_000)]) {
          assert.equal(await say(wrong, 500), null, JSON.stringify(wrong)?.slice(0, 40));
        }
        assert.deepEqual(await say({ type: 'state' }).then(({ tick, state }) => [tick, state]), [0, 'paused']);
      });
    },
  ],
  [
    'a_frame_keeps_nothing_and_asks_for_nothing_after_it_has_loaded',
    async (_, url) => {
      await framed(url, async ({ page, frame, say }) => {
        await frame.locator('.programs li').first().waitFor();
        /** @type {string[]} */
        const asked = [];
        page.on('request', (request) => asked.push(request.url()));
        await frame.locator('#play').click();
        await frame.waitForFunction(() => Number(document.querySelector('#tick')?.textContent) > 30);
        await say({ type: 'pause' });
        assert.deepEqual(asked, []);
        assert.deepEqual(await frame.evaluate(async () => [localStorage.length, sessionStorage.length, document.cookie, (await indexedDB.databases()).length]), [0, 0, '', 0]);
      });
    },
  ],
  [
    'single_keys_act_in_a_frame_only_after_somebody_is_inside',
    async (_, url) => {
      await framed(url, async ({ page, frame }) => {
        const press = () => frame.evaluate(() => document.dispatchEvent(new KeyboardEvent('keydown', { key: '.', bubbles: true, cancelable: true })));
        await press();
        await page.waitForTimeout(200);
        assert.equal(await frame.locator('#tick').textContent(), '0');
        await frame.locator('.stage').click({ position: { x: 5, y: 5 } });
        await page.keyboard.press('.');
        await frame.waitForFunction(() => document.querySelector('#tick')?.textContent === '1');
      });
    },
  ],
  [
    'a_frame_out_of_sight_rests_and_goes_on_when_it_is_seen_again',
    async (_, url) => {
      await framed(url, async ({ page, frame }) => {
        await frame.locator('#play').click();
        await frame.waitForFunction(() => document.body.dataset.state === 'running');
        await page.evaluate(() => (/** @type {HTMLElement} */ (document.querySelector('#above')).style.height = '5000px'));
        await frame.waitForFunction(() => document.body.dataset.state === 'paused', null, { polling: 50 });
        await page.evaluate(() => (/** @type {HTMLElement} */ (document.querySelector('#above')).style.height = '0'));
        await frame.waitForFunction(() => document.body.dataset.state === 'running', null, { polling: 50 });
      });
    },
  ],
];
