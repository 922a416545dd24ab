// What the tests of the tab Sequence have in common.

/** @param {import('./browser.mjs').Open} open @param {string} [hash] @param {import('playwright-core').BrowserContextOptions} [options] */
export async function openPlan(open, hash = '#/sequence', options = {}) {
  const opened = await open(hash, options);
  const { page } = opened;

  /** The middle of a thing on the map, in the window. @param {string} thing such as `obstacle-1` */
  const middle = async (thing) => {
    const shape = page.locator(`#sequence [data-thing=${thing}]`);
    await shape.waitFor({ state: 'attached' });
    return shape.evaluate((element) => {
      const { left, top, width, height } = element.getBoundingClientRect();
      return /** @type {[number, number]} */ ([left + width / 2, top + height / 2]);
    });
  };
  const plan = {
    ...opened,
    middle,
    verdict: async () => (await page.locator('#sequence-verdict').textContent()) ?? '',

    /** Waits until a result of one of these kinds is there. @param {...string} kinds */
    result: (...kinds) => opened.until((wanted) => wanted.includes(document.querySelector('#sequence')?.getAttribute('data-result')), kinds),

    /** Waits for a plan that is of the present placement. */
    planned: () => opened.until(() => document.querySelectorAll('#sequence .ribbon-pane:not(.stale) .plan-cell').length > 0),

    letters: async () => (await page.locator('#sequence .cell-letter').allTextContents()).map((letter) => (letter === '·' ? '.' : letter.charAt(0))).join(''),

    /** Drags a thing by so many pixels. @param {string} thing @param {number} dx @param {number} dy @param {number} [steps] */
    async drag(thing, dx, dy, steps = 5) {
      const [x, y] = await middle(thing);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + dx, y + dy, { steps });
      return () => page.mouse.up();
    },

    /** What stands in a field of the chosen thing. @param {string} name */
    field: async (name) => Number(await page.locator(`#sequence-${name}`).inputValue()),

    /** @param {'plan' | 'search' | 'robots' | 'game'} name */
    tab: (name) => page.locator(`#tab-sequence-${name}`).click(),

    /** @param {string} name */
    fact: async (name) => (await page.locator(`#panel-sequence-search [data-fact=${name}]`).textContent()) ?? '',
  };
  return plan;
}

/** A link to three robots in the open, whose optimum is proved at once. */
export const SMALL = '#/sequence?preset=plan-live&sequencing.robots=3&sequencing.decisions=5&sequencing.obstacles=0&sequencing.target-x=-10&sequencing.target-y=-10';
