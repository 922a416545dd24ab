// What the tests of the tab Soccer have in common.

/** A match of two halves of 20 seconds, which is computed at once. */
export const SHORT = '#/soccer?preset=match&seed=3&soccer.half-seconds=20';

/** @param {import('./browser.mjs').Open} open @param {string} [hash] @param {import('playwright-core').BrowserContextOptions} [options] */
export async function openSoccer(open, hash = SHORT, options = {}) {
  const opened = await open(hash, options);
  const { page } = opened;
  const soccer = {
    ...opened,

    /** Waits until the match was computed to its end, and gives its fingerprint. */
    async whole() {
      await opened.until(() => document.querySelector('#soccer-fingerprint')?.getAttribute('data-whole') === 'true');
      return (await page.locator('#soccer-fingerprint').textContent()) ?? '';
    },

    /** Goes to a tick. @param {number} tick */
    async seek(tick) {
      await page.locator('#soccer-scrub').fill(String(tick));
      await opened.until((wanted) => /** @type {HTMLInputElement} */ (document.querySelector('#soccer-scrub')).value === wanted, String(tick));
      await soccer.drawn();
    },

    /** Waits until what is on screen was drawn. */
    drawn: () => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))),

    /** A place on the pitch, in the window. @param {number} x metres @param {number} y */
    spot: (x, y) =>
      page.locator('#soccer .pitch-stage.own canvas').evaluate((canvas, [px, py]) => {
        const { left, top, width, height } = canvas.getBoundingClientRect();
        return /** @type {[number, number]} */ ([left + width / 2 + (px * width) / 1.8, top + height / 2 - (py * width) / 1.8]);
      }, [x, y]),

    tick: async () => Number(await page.locator('#soccer-scrub').inputValue()),

    /** @param {'coach' | 'roles' | 'organisation' | 'log' | 'charts'} name */
    async tab(name) {
      const sheet = page.locator('#soccer .sheet-handle');
      if ((await sheet.isVisible()) && (await sheet.getAttribute('aria-expanded')) === 'false') await sheet.click();
      await page.locator(`#tab-soccer-${name}`).click();
    },

    /** @param {'Blue' | 'Yellow'} name */
    team: (name) => page.locator('#soccer .panel:visible .scopes').first().getByRole('button', { name }).click(),

    /** The middle of a robot (0 to 5) or the ball (6), in the window. @param {number} thing */
    middle: (thing) =>
      page.locator(`#soccer [data-thing="${thing}"]`).evaluate((shape) => {
        const { left, top, width, height } = shape.getBoundingClientRect();
        return /** @type {[number, number]} */ ([left + width / 2, top + height / 2]);
      }),

    /** Drags a thing to a place on the pitch. @param {number} thing @param {number} x metres @param {number} y */
    async drag(thing, x, y) {
      await page.mouse.move(...(await soccer.middle(thing)));
      await page.mouse.down();
      await page.mouse.move(...(await soccer.spot(x, y)), { steps: 6 });
      await page.mouse.up();
    },

    /** The events of the scenario in the address. */
    events: () =>
      page.evaluate(async () => {
        const packed = new URLSearchParams(location.hash.slice(location.hash.indexOf('?'))).get('events');
        if (!packed) return [];
        const bytes = Uint8Array.from(atob(packed.slice(1).replaceAll('-', '+').replaceAll('_', '/')), (letter) => letter.charCodeAt(0));
        return JSON.parse(await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'))).text());
      }),
  };
  return soccer;
}
