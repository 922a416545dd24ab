// The golden fingerprints and every tab in Firefox and WebKit, where the system has them; a line says which one it has not.
// Ends with the line `N passed, N failed`. Names on the command line, such as `Firefox`, choose.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { startFirefox } from './firefox.mjs';
import { startWebKit } from './webkit.mjs';
import { serve } from './serve.mjs';

/**
 * @typedef {object} Driver one window of a browser
 * @property {string} name with its version
 * @property {(url: string) => Promise<void>} open leaves the page that is there, and opens another
 * @property {(expression: string) => Promise<string>} ask what an expression in the page gives, a text
 * @property {() => Promise<void>} close
 */

const PATIENCE_MS = 120_000;
const STARTERS = /** @type {const} */ ([['Firefox', startFirefox], ['WebKit', startWebKit]]).filter(([name]) => process.argv.length < 3 || process.argv.slice(2).includes(name));
const dist = fileURLToPath(new URL('../../dist', import.meta.url));
const { cases: golden } = JSON.parse(readFileSync(new URL('../cases/golden.json', import.meta.url), 'utf8'));

/** Waits until an expression in the page gives a text that is not empty. @param {Driver} driver @param {string} expression */
async function until(driver, expression) {
  const end = Date.now() + PATIENCE_MS;
  for (;;) {
    const told = await driver.ask(`String((${expression}) || '')`);
    if (told !== '') return told;
    if (Date.now() > end) throw new Error(`waited ${PATIENCE_MS / 1000} s for ${expression}; the page is ${await driver.ask('document.body.dataset.state + ": " + document.body.innerText.slice(0, 300)')}`);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

/** @type {[string, (driver: Driver, url: string) => Promise<string | void>][]} */
const cases = [
  [
    'fingerprints_are_those_of_the_command_line',
    async (driver, url) => {
      for (const [at, { scenario, seed, tick, fingerprint }] of golden.entries()) {
        // A query of its own makes each a new visit, not a step within the page.
        await driver.open(`${url}?case=${at}#/forage?preset=${scenario}&seed=${seed}&t=${tick}`);
        const standing = `['paused', 'finished'].includes(document.body.dataset.state) && document.querySelector('#tick')?.textContent === '${tick}'`;
        const found = await until(driver, `${standing} && document.querySelector('#fingerprint').dataset.tick === '${tick}' && document.querySelector('#fingerprint').textContent`);
        assert.equal(found, fingerprint, `${scenario}, seed ${seed}, tick ${tick}`);
      }
      return `${golden.length} cases`;
    },
  ],
  [
    'every_tab_opens',
    async (driver, url) => {
      await driver.open(url);
      await until(driver, `document.body.dataset.state !== 'loading' && document.querySelectorAll('#top nav a').length > 3`);
      const tabs = JSON.parse(await driver.ask(`JSON.stringify([...document.querySelectorAll('#top nav a')].map((link) => link.getAttribute('href')))`));
      for (const tab of tabs) {
        await driver.ask(`(location.hash = '${tab}', '')`);
        const state = await until(driver, `location.hash.startsWith('${tab}') && document.querySelector('#top nav [aria-current]')?.getAttribute('href') === '${tab}' && document.body.dataset.state !== 'loading' && document.body.dataset.state`);
        assert.notEqual(state, 'error', tab);
      }
      return tabs.join(' ');
    },
  ],
];

if (!existsSync(`${dist}/index.html`)) {
  console.error('the page is not built: run make build first');
  console.log('0 passed, 1 failed');
  process.exit(1);
}
const server = await serve(dist, '/some/sub/path/');
let passed = 0;
let failed = 0;
for (const [browser, start] of STARTERS) {
  /** @type {Driver | string} */
  let driver;
  try {
    driver = await start();
  } catch (error) {
    failed += 1;
    console.log(`FAIL ${browser} could not be started: ${error instanceof Error ? error.message : error}`);
    continue;
  }
  if (typeof driver === 'string') {
    console.log(`skipped: ${driver}`);
    continue;
  }
  console.log(driver.name);
  for (const [name, run] of cases) {
    try {
      const note = await run(driver, server.url);
      passed += 1;
      console.log(`ok ${browser} ${name}${note ? `: ${note}` : ''}`);
    } catch (error) {
      failed += 1;
      console.log(`FAIL ${browser} ${name}: ${error instanceof Error ? error.message : error}`);
    }
  }
  await driver.close();
}
server.close();
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed > 0 ? 1 : 0);
