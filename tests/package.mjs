// The npm package as somebody else has it: installed from its tarball into an empty folder, used by a small program in Node, by
// TypeScript, and in a browser through a bundler. Ends with the line `N passed, N failed`; run `make package` first.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { findChromium, launch } from './browser/browser.mjs';
import { serve } from './browser/serve.mjs';

const root = fileURLToPath(new URL('..', import.meta.url));
const packed = join(root, 'target/npm');
const folder = mkdtempSync(join(tmpdir(), 'swarm-package-'));
const { cases: golden } = JSON.parse(readFileSync(join(root, 'tests/cases/golden.json'), 'utf8'));
const few = golden.slice(0, 4).concat(golden.at(-1));

/** @param {string} program @param {...string} args */
const run = (program, ...args) => execFileSync(program, args, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
const bin = (/** @type {string} */ name) => join(root, 'node_modules/.bin', name);

/** What one golden case gives; the same text runs in Node and in the browser. */
const REACHED = `
export function reached(World, preset, { seed, tick }) {
  const world = new World(JSON.stringify({ ...JSON.parse(preset), seed }));
  world.advance(tick);
  const fingerprint = world.fingerprint();
  world.free();
  return fingerprint;
}
`;

/** @type {[string, () => void | Promise<void | string>][]} */
const cases = [
  [
    'the_tarball_installs_into_an_empty_folder_and_brings_nothing_else',
    () => {
      const [tarball, ...others] = readdirSync(packed).filter((name) => name.endsWith('.tgz'));
      assert.ok(tarball && others.length === 0, 'target/npm holds one tarball: run make package');
      writeFileSync(join(folder, 'package.json'), '{ "private": true, "type": "module" }');
      run('npm', 'install', '--offline', '--no-audit', '--no-fund', '--loglevel', 'error', resolve(packed, tarball));
      assert.deepEqual(readdirSync(join(folder, 'node_modules')).filter((name) => !name.startsWith('.')), ['swarm-playground']);
      const files = readdirSync(join(folder, 'node_modules/swarm-playground'));
      for (const file of ['README.md', 'LICENSE-MIT', 'LICENSE-APACHE', 'swarm_playground.d.ts', 'scenarios']) assert.ok(files.includes(file), file);
      const { version } = JSON.parse(readFileSync(join(folder, 'node_modules/swarm-playground/package.json'), 'utf8'));
      assert.equal(version, /^version = "(.*)"$/m.exec(readFileSync(join(root, 'Cargo.toml'), 'utf8'))?.[1]);
    },
  ],
  [
    'a_small_program_in_node_gets_the_golden_fingerprints',
    () => {
      writeFileSync(join(folder, 'reached.js'), REACHED);
      writeFileSync(
        join(folder, 'golden.js'),
        `import { readFileSync } from 'node:fs';
import init, { World } from 'swarm-playground';
import { reached } from './reached.js';
await init();
const preset = (name) => readFileSync(new URL(import.meta.resolve(\`swarm-playground/scenarios/\${name}.json\`)), 'utf8');
console.log(JSON.stringify(${JSON.stringify(golden)}.map((wanted) => reached(World, preset(wanted.scenario), wanted))));
`,
      );
      assert.deepEqual(JSON.parse(run('node', 'golden.js')), golden.map((/** @type {{ fingerprint: string }} */ { fingerprint }) => fingerprint));
      return `${golden.length} cases`;
    },
  ],
  [
    'a_whole_match_in_node_is_that_of_the_committed_results',
    () => {
      const [names, first] = readFileSync(join(root, 'results/coaches.csv'), 'utf8').split('\n', 2).map((line) => line.split(','));
      const fingerprint = first.at(names.indexOf('fingerprint') - names.length); // counted from the end: the cell's name holds a comma
      writeFileSync(
        join(folder, 'match.js'),
        `import { readFileSync } from 'node:fs';
import { Match } from 'swarm-playground';
const scenario = JSON.parse(readFileSync(new URL(import.meta.resolve('swarm-playground/scenarios/match.json')), 'utf8'));
const match = new Match(JSON.stringify({ ...scenario, seed: 1 }));
while (match.skip(6000));
console.log(match.fingerprint(match.front()));
`,
      );
      assert.equal(run('node', 'match.js').trim(), fingerprint);
    },
  ],
  [
    'the_example_of_the_readme_runs',
    () => {
      const readme = readFileSync(join(folder, 'node_modules/swarm-playground/README.md'), 'utf8');
      const example = /```js\n([^]*?)```/.exec(readme);
      assert.ok(example);
      writeFileSync(join(folder, 'example.js'), example[1]);
      assert.match(run('node', 'example.js'), /^500 [0-9a-f]{16}\n$/);
      const names = [...readme.matchAll(/^\| (`.*`) \| /gm)].flatMap(([, cells]) => cells.replaceAll('`', '').split(', '));
      writeFileSync(join(folder, 'names.js'), `import * as all from 'swarm-playground';\nconsole.log(JSON.stringify(Object.keys(all)));\n`);
      const there = JSON.parse(run('node', 'names.js'));
      assert.deepEqual(names.filter((name) => !there.includes(name)), [], 'named in the README but not there');
    },
  ],
  [
    'mistakes_come_as_errors_that_say_what_is_allowed',
    () => {
      writeFileSync(join(folder, 'mistake.js'), `import { World } from 'swarm-playground';\ntry { new World('{"world": "geese", "agents": 0}'); } catch (error) { console.log(error instanceof Error, error.message); }\n`);
      assert.match(run('node', 'mistake.js'), /^true .*agents.*expected/);
    },
  ],
  [
    'its_types_hold_under_both_ways_of_finding_modules',
    () => {
      writeFileSync(join(folder, 'typed.ts'), `import init, { World, Study } from 'swarm-playground';\nawait init();\nconst world: World = new World('{}', undefined);\nexport const made: number = world.advance(1);\nexport const plan = (study: Study): string => study.plan();\n`);
      for (const way of [['nodenext', 'nodenext'], ['esnext', 'bundler']]) {
        run(bin('tsc'), '--noEmit', '--strict', '--target', 'es2023', '--lib', 'es2023,dom', '--types', '', '--module', way[0], '--moduleResolution', way[1], 'typed.ts');
      }
    },
  ],
  [
    'a_bundler_needs_no_plugin_and_the_browser_gets_the_same_fingerprints',
    async () => {
      const executable = findChromium();
      assert.ok(executable, 'no Chromium was found: install it or set CHROMIUM to its path');
      mkdirSync(join(folder, 'page'));
      const presets = few.map((/** @type {{ scenario: string }} */ { scenario }, /** @type {number} */ at) => `import p${at} from 'swarm-playground/scenarios/${scenario}.json?raw';`);
      writeFileSync(
        join(folder, 'page/main.js'),
        `import init, { World } from 'swarm-playground';
import { reached } from '../reached.js';
${presets.join('\n')}
await init();
const found = ${JSON.stringify(few)}.map((wanted, at) => reached(World, [${few.map((/** @type {unknown} */ _, /** @type {number} */ at) => `p${at}`)}][at], wanted));
document.title = JSON.stringify(found);
`,
      );
      writeFileSync(join(folder, 'page/index.html'), '<!doctype html><title></title><script type="module" src="./main.js"></script>');
      run(bin('vite'), 'build', 'page', '--base', './', '--logLevel', 'warn', '--configLoader', 'native', '--target', 'esnext');
      const server = await serve(join(folder, 'page/dist'), '/');
      const browser = await launch(executable);
      try {
        const page = await browser.newPage();
        await page.goto(server.url);
        await page.waitForFunction(() => document.title !== '', undefined, { timeout: 60_000 });
        assert.deepEqual(JSON.parse(await page.title()), few.map((/** @type {{ fingerprint: string }} */ { fingerprint }) => fingerprint));
      } finally {
        await browser.close();
        server.close();
      }
      return `${few.length} cases`;
    },
  ],
];

let passed = 0;
for (const [name, test] of cases) {
  try {
    const note = await test();
    passed += 1;
    console.log(`ok ${name}${note ? `: ${note}` : ''}`);
  } catch (error) {
    const { stdout, stderr, message } = /** @type {Error & { stdout?: string, stderr?: string }} */ (error);
    console.log(`FAIL ${name}: ${[message, stdout, stderr].filter(Boolean).join('\n')}`);
  }
}
rmSync(folder, { recursive: true });
console.log(`${passed} passed, ${cases.length - passed} failed`);
process.exit(passed === cases.length ? 0 : 1);
