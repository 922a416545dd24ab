// The workbench in the words the tests of the tab Trees speak.
import { deflateRawSync } from 'node:zlib';

/** @typedef {import('./browser.mjs').Open} Open */

const MODIFIER = 'Control';

/** A text as it stands in links. @param {string} text */
export const packed = (text) => `~${deflateRawSync(Buffer.from(text)).toString('base64url')}`;

/** A document around a tree. @param {string} tree @param {string} [models] */
export const documentOf = (tree, models = '') =>
  `<root BTCPP_format="4">\n  <BehaviorTree ID="Main">\n    ${tree}\n  </BehaviorTree>\n  <TreeNodesModel>${models}</TreeNodesModel>\n</root>\n`;

/** Two scripted leaves under a sequence. */
export const SMALL = documentOf('<Sequence name="Both"><Near/><Grasp name="grasp"/></Sequence>', '<Condition ID="Near"/><Action ID="Grasp"/>');

/**
 * Opens the tab Trees.
 *
 * @param {Open} open
 * @param {string} [hash]
 * @param {import('playwright-core').BrowserContextOptions} [options]
 */
export async function openBench(open, hash = '#/trees', options = {}) {
  const opened = await open(hash, options);
  const { page, until } = opened;
  const editor = page.locator('.trees-code .cm-content');
  const bench = {
    ...opened,
    editor,

    /** What the console said and should not have. */
    said: () => opened.problems,

    /** The text of the tree, as far as it is in sight. */
    text: async () => (await editor.locator('.cm-line').allTextContents()).join('\n'),

    /** Puts a text in place of the present one, as a person who pastes it. @param {string} xml */
    async type(xml) {
      await editor.focus();
      await page.keyboard.press(`${MODIFIER}+a`);
      await page.keyboard.insertText(xml);
    },

    /** Waits until the page says how many problems the text has. @param {RegExp | string} words */
    problems: (words) => page.locator('.problems-head').filter({ hasText: words }).waitFor(),

    /** Every problem as its line says it. */
    problemTexts: () => page.locator('.problem-text').allTextContents(),

    /** Waits until the run stands at a tick; gives the fingerprint. @param {number} tick */
    async at(tick) {
      await until(
        (wanted) =>
          document.querySelector('#trees-tick')?.textContent === String(wanted) &&
          /** @type {HTMLElement} */ (document.querySelector('#trees-fingerprint')).dataset.tick === String(wanted) &&
          ['paused', 'finished'].includes(document.body.dataset.state ?? ''),
        tick,
      );
      return /** @type {string} */ (await page.locator('#trees-fingerprint').textContent());
    },

    /** Moves the scrubber. @param {number} tick */
    async seek(tick) {
      await page.locator('#trees-scrub').evaluate((scrub, wanted) => {
        /** @type {HTMLInputElement} */ (scrub).value = String(wanted);
        scrub.dispatchEvent(new Event('input'));
      }, tick);
      return bench.at(tick);
    },

    /** Presses +1. @param {number} [times] */
    async step(times = 1) {
      for (let count = 0; count < times; count += 1) await page.locator('#trees [data-action=forward]').click();
    },

    /** Ticks the root returned in, as far as they are known. */
    root: () => page.locator('#trees-root').textContent(),

    /** A node of the drawing by its name, and by what it says of itself. @param {string} name @param {string} [words] */
    node: (name, words = '') => page.locator('.trees-stage > .bench').getByRole('treeitem', { name: new RegExp(`^${name}\\b.*${words}`, 's') }).first(),

    /** Waits until a node of the drawing has returned a status in this tick. @param {string} name @param {string} status */
    returned: (name, status) => bench.node(name, `${status} in this tick`).waitFor({ state: 'attached' }),

    /** Selects a node through its place in the drawing. @param {string} name */
    async select(name) {
      await bench.node(name).focus();
      await page.keyboard.press('Enter');
      await bench.selected(name);
    },

    /** Waits until a node is selected, in the drawing and in the inspector. @param {string} name */
    async selected(name) {
      await page.locator('.trees-stage > .bench').getByRole('treeitem', { name: new RegExp(`^${name}\\b`), selected: true }).waitFor({ state: 'attached' });
      await page.locator('#panel-node h2').filter({ hasText: name }).waitFor({ state: 'attached' });
    },

    /** Opens a tab of the inspector. @param {'node' | 'script' | 'board' | 'log'} name */
    tab: (name) => page.locator(`#tab-${name}`).click(),

    /** Waits until the address names the moment on screen, and gives its hash. @param {number} tick */
    async address(tick) {
      const part = `t=${tick}&f=${await bench.at(tick)}`;
      await until((wanted) => location.hash.includes(wanted), part);
      return opened.hash();
    },

    /** Chooses an entry of the library. @param {string} name */
    async entry(name) {
      await page.locator('#trees-entry').selectOption(`entry:${name}`);
      await until((wanted) => location.hash.includes(`preset=${wanted}`), name);
    },

    /** What a button of the footer saves. @param {string} label */
    async saved(label) {
      const waiting = page.waitForEvent('download');
      await page.locator('#trees .take').getByRole('button', { name: label, exact: true }).click();
      const download = await waiting;
      const { readFileSync } = await import('node:fs');
      return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
    },
  };
  return bench;
}

/** @typedef {Awaited<ReturnType<typeof openBench>>} OpenedBench */
