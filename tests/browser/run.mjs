// Drives the built page in headless Chromium. Ends with the line `N passed, N failed`.
// Words on the command line choose the cases whose name holds one of them.
//
// Two cases run beside each other, each lane with a browser of its own, where the machine has two processors; what is
// printed keeps the order of the cases. Those that measure run at the end, with nothing beside them. A case that failed
// is run once more, alone in a fresh browser: one that passes then is counted as passed, and named as unsteady with what
// was wrong at first.
import { existsSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { fileURLToPath } from 'node:url';
import { findChromium, launch, openPage } from './browser.mjs';
import { serve } from './serve.mjs';
import { cases as opening } from './opening.mjs';
import { cases as steps } from './steps.mjs';
import { cases as inspecting } from './inspecting.mjs';
import { cases as links } from './links.mjs';
import { cases as fingerprints } from './fingerprints.mjs';
import { cases as controls } from './controls.mjs';
import { cases as mistakes } from './mistakes.mjs';
import { cases as access } from './access.mjs';
import { cases as exports } from './exports.mjs';
import { cases as frames } from './frames.mjs';
import { cases as tasks } from './tasks.mjs';
import { cases as comparing } from './comparing.mjs';
import { cases as files } from './files.mjs';
import { cases as tabs } from './tabs.mjs';
import { cases as treesText } from './treestext.mjs';
import { cases as treesRun } from './treesrun.mjs';
import { cases as treesFiles } from './treesfiles.mjs';
import { cases as treesView } from './treesview.mjs';
import { cases as treesAccess } from './treesaccess.mjs';
import { cases as studiesRun } from './studiesrun.mjs';
import { cases as studiesForm } from './studiesform.mjs';
import { cases as studiesAccess } from './studiesaccess.mjs';
import { cases as sequenceRun } from './sequencerun.mjs';
import { cases as sequenceEdit } from './sequenceedit.mjs';
import { cases as sequenceAccess } from './sequenceaccess.mjs';
import { cases as soccerRun } from './soccerrun.mjs';
import { cases as soccerEdit } from './socceredit.mjs';
import { cases as soccerBeside } from './soccerbeside.mjs';
import { cases as soccerAccess } from './socceraccess.mjs';
import { cases as policy } from './policy.mjs';
import { cases as offline } from './offline.mjs';
import { cases as publishing } from './publishing.mjs';
import { cases as measuring } from './measuring.mjs';
import { cases as filming } from './filming.mjs';
import { cases as filmAccess } from './filmaccess.mjs';
import { cases as learn } from './learn.mjs';
import { cases as learnAccess } from './learnaccess.mjs';
import { cases as sharing } from './sharing.mjs';
import { cases as embedding } from './embedding.mjs';
import { cases as badLinks } from './badlinks.mjs';

const LANES = Math.min(2, availableParallelism());
const LONGEST_MS = 5 * 60_000; // for one case; the longest takes half a minute
const MOST_AGAIN = 15; // more failures than that are no unsteadiness

/** @typedef {import('./browser.mjs').Case} Case */
/** @typedef {{ seconds: string, note: string, error: string, said: string[] }} Outcome without an error it has passed */

const dist = fileURLToPath(new URL('../../dist', import.meta.url));
const executable = findChromium() ?? '';
if (!existsSync(`${dist}/index.html`)) fail('the page is not built: run make build first');
if (!executable) fail('no Chromium was found: install it or set CHROMIUM to its path');

const words = process.argv.slice(2);
const chosen = [opening, steps, tasks, inspecting, links, fingerprints, controls, mistakes, access, exports, frames, comparing, files, tabs, treesText, treesRun, treesFiles, treesView, treesAccess, studiesRun, studiesForm, studiesAccess, sequenceRun, sequenceEdit, sequenceAccess, soccerRun, soccerEdit, soccerBeside, soccerAccess, policy, offline, publishing, measuring, filming, filmAccess, learn, learnAccess, sharing, embedding, badLinks]
  .flat()
  .filter(([name]) => words.length === 0 || words.some((word) => name.includes(word)));
const [together, alone] = [chosen.filter(([, , how]) => how !== 'alone'), chosen.filter(([, , how]) => how === 'alone')];
process.once('SIGTERM', () => process.exit(1)); // playwright would only close its browsers, and the lanes start new ones
const server = await serve(dist, '/some/sub/path/');
/** @type {Map<Case, Outcome>} */
const outcomes = new Map();
const order = [...together, ...alone];
let shown = 0;

const waiting = [...together];
await Promise.all(Array.from({ length: LANES }, () => lane(waiting)));
await lane([...alone]);

const failures = order.filter((entry) => outcomes.get(entry)?.error);
let failed = failures.length > MOST_AGAIN ? failures.length : 0;
for (const entry of failures.length > MOST_AGAIN ? [] : failures) {
  const browser = await launch(executable);
  const { error, said, seconds } = await attempt(browser, entry);
  await browser.close().catch(() => {});
  if (error) {
    failed += 1;
    console.log([`FAIL ${entry[0]} (${seconds}), at the second try too: ${error}`, ...said].join('\n  '));
  } else console.log(`unsteady ${entry[0]} (${seconds}): ${outcomes.get(entry)?.error}`);
}
server.close();
console.log(`${chosen.length - failed} passed, ${failed} failed`);
process.exit(failed > 0 ? 1 : 0);

/** Runs cases until there is none left, in a browser of its own. @param {Case[]} cases are taken from the front */
async function lane(cases) {
  if (cases.length === 0) return;
  let browser = await launch(executable);
  for (let entry = cases.shift(); entry; entry = cases.shift()) {
    if (!browser.isConnected()) browser = await launch(executable);
    outcomes.set(entry, await attempt(browser, entry));
    show();
  }
  await browser.close().catch(() => {});
}

/** Prints what is known, in the order of the cases. */
function show() {
  for (; shown < order.length && outcomes.has(order[shown]); shown += 1) {
    const [name] = order[shown];
    const { seconds, note, error, said } = /** @type {Outcome} */ (outcomes.get(order[shown]));
    if (error) console.log([`failed at first: ${name} (${seconds}): ${error}`, ...said].join('\n  '));
    else console.log(`ok ${name} (${seconds})${note ? `: ${note}` : ''}`);
  }
}

/** @param {import('playwright-core').Browser} browser @param {Case} entry @returns {Promise<Outcome>} */
async function attempt(browser, [, run]) {
  /** @type {import('./browser.mjs').Opened[]} */
  const opened = [];
  const start = performance.now();
  const seconds = () => `${((performance.now() - start) / 1000).toFixed(1)} s`;
  const work = run((hash, options) => openPage(browser, server.url, hash, options, (made) => opened.push(made)), server.url);
  /** @type {Outcome} */
  let outcome;
  try {
    const note = await within(LONGEST_MS, work);
    outcome = { seconds: seconds(), note: note ?? '', error: '', said: [] };
  } catch (error) {
    const said = await Promise.all(opened.map(({ page, problems }) => described(page, problems)));
    outcome = { seconds: seconds(), note: '', error: placed(error) || 'no reason was given', said: said.filter(Boolean) };
  }
  for (const { close } of opened) await within(10_000, close()).catch(() => {});
  return outcome;
}

/** What is wrong, and where in the case. @param {unknown} error */
function placed(error) {
  if (!(error instanceof Error)) return String(error);
  const [, place] = /[\\/]tests[\\/]browser[\\/](?!run\.mjs|browser\.mjs)(\w+\.mjs:\d+)/.exec(error.stack ?? '') ?? [];
  return place ? `${error.message} (${place})` : error.message;
}

/** What a page shows of its state when a case has failed. @param {import('playwright-core').Page} page @param {string[]} problems */
async function described(page, problems) {
  const look = () => `${location.hash.slice(0, 200)} is ${document.body.dataset.state}: ${[...document.querySelectorAll('.notice p, .fault:not([hidden]) .message')].map(({ textContent }) => textContent?.slice(0, 200)).join(' | ')}`;
  const shows = await within(5000, page.evaluate(look)).catch(() => '');
  return [shows && `the page ${shows}`, problems.length > 0 && `it said: ${problems.join(' | ')}`].filter(Boolean).join('; ');
}

/** @template T @param {number} ms @param {Promise<T>} work @returns {Promise<T>} */
function within(ms, work) {
  /** @type {NodeJS.Timeout} */
  let timer;
  const late = new Promise((_, reject) => (timer = setTimeout(() => reject(new Error(`nothing came of it in ${ms / 1000} s`)), ms)));
  return Promise.race([work, /** @type {Promise<never>} */ (late)]).finally(() => clearTimeout(timer));
}

/** @param {string} message @returns {never} */
function fail(message) {
  console.error(message);
  console.log('0 passed, 1 failed');
  process.exit(1);
}
