// Drives the built page in headless Chromium. Ends with the line `N passed, N failed`.
// Words on the command line choose the cases whose name holds one of them.
import { existsSync } from 'node:fs';
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
import { cases as learn } from './learn.mjs';
import { cases as learnAccess } from './learnaccess.mjs';
import { cases as sharing } from './sharing.mjs';
import { cases as embedding } from './embedding.mjs';
import { cases as badLinks } from './badlinks.mjs';

const dist = fileURLToPath(new URL('../../dist', import.meta.url));
const executable = findChromium();
if (!existsSync(`${dist}/index.html`)) fail('the page is not built: run make build first');
if (!executable) fail('no Chromium was found: install it or set CHROMIUM to its path');

const words = process.argv.slice(2);
const chosen = [opening, steps, tasks, inspecting, links, fingerprints, controls, mistakes, access, exports, frames, comparing, files, tabs, treesText, treesRun, treesFiles, treesView, treesAccess, studiesRun, studiesForm, studiesAccess, sequenceRun, sequenceEdit, sequenceAccess, soccerRun, soccerEdit, soccerBeside, soccerAccess, policy, offline, publishing, measuring, filming, learn, learnAccess, sharing, embedding, badLinks]
  .flat()
  .filter(([name]) => words.length === 0 || words.some((word) => name.includes(word)));
const server = await serve(dist, '/some/sub/path/');
const browser = await launch(/** @type {string} */ (executable));
let passed = 0;
let failed = 0;
for (const [name, run] of chosen) {
  /** @type {import('./browser.mjs').Opened[]} */
  const opened = [];
  try {
    const note = await run(async (hash, options) => {
      const page = await openPage(browser, server.url, hash, options);
      opened.push(page);
      return page;
    }, server.url);
    passed += 1;
    console.log(`ok ${name}${note ? `: ${note}` : ''}`);
  } catch (error) {
    failed += 1;
    console.log(`FAIL ${name}: ${error instanceof Error ? error.message : error}`);
    for (const { problems } of opened) if (problems.length > 0) console.log(`  the page said: ${problems.join(' | ')}`);
  }
  for (const { close } of opened) await close();
}
await browser.close();
server.close();
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed > 0 ? 1 : 0);

/** @param {string} message @returns {never} */
function fail(message) {
  console.error(message);
  console.log('0 passed, 1 failed');
  process.exit(1);
}
