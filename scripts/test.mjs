// `make test`: runs every part, even after one has failed, and ends with one line `N passed, N failed`.
//
// A part with tests is counted from what its runner prints; any other part counts as one. A part that ends badly
// without saying how many failed is one failure, and so is a part with tests that ran none.
// Run it through make, which puts the pinned tools on PATH.

import { execFileSync, spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, readFileSync } from 'node:fs';
import { createInterface } from 'node:readline';

const MINUTES = 60_000;
const LIMIT = 60 * MINUTES; // for one command, on a slow machine with empty caches

// Shown as a passing line on a terminal and not at all elsewhere: a first build has hundreds of them.
const PROGRESS = /^\s*(Adding|Blocking|Checking|Compiling|Downloaded|Downloading|Locking|Updating) /;
const CARGO_RESULT = /^test result: \S+ (\d+) passed; (\d+) failed/;
const CARGO_FAILED_TARGETS = /^error: (\d+) targets? failed:/;
const PLAIN_RESULT = /^(\d+) passed, (\d+) failed$/;

/** @typedef {{ passed: number, failed: number, note: string }} Outcome */

/**
 * Runs a command and shows what it prints, or with `quiet` only when it failed. Returns its lines and whether it
 * succeeded.
 * @param {string[]} command
 * @param {{ env?: Record<string, string>, quiet?: boolean }} [options]
 */
async function run(command, { env, quiet = false } = {}) {
  console.log(`$ ${command.join(' ')}`);
  // Through sh, so that both streams come in the order they were written.
  const child = spawn('sh', ['-c', 'exec "$@" 2>&1', 'sh', ...command], {
    stdio: ['ignore', 'pipe', 'inherit'],
    env: { ...process.env, ...env },
    timeout: LIMIT,
  });
  // A process left behind by the command would keep the pipe open for ever.
  child.once('exit', () => setTimeout(() => child.stdout.destroy(), 2000).unref());
  const closed = once(child, 'close');
  const lines = [];
  createInterface({ input: child.stdout }).on('line', (line) => {
    lines.push(line);
    if (!quiet) show(line);
  });
  const [status, signal] = await closed;
  if (quiet && status !== 0) lines.forEach(show);
  if (signal) show(`ended by ${signal}`);
  return { lines, ok: status === 0 };
}

/** @param {string} line */
function show(line) {
  const fleeting = process.stdout.isTTY ? '\r\x1b[K' : '';
  if (PROGRESS.test(line)) {
    if (fleeting) process.stdout.write(fleeting + line.slice(0, process.stdout.columns - 1));
  } else if (!PLAIN_RESULT.test(line)) {
    console.log(fleeting + line); // the only plain result to be seen is the last line of all
  }
}

/**
 * A part that counts as one: it passes when all its commands succeed.
 * @param {...string[]} commands
 * @returns {Promise<Outcome>}
 */
async function check(...commands) {
  let ok = true;
  for (const command of commands) ok = (await run(command)).ok && ok;
  return { passed: ok ? 1 : 0, failed: ok ? 0 : 1, note: '' };
}

/**
 * A part that counts its own tests.
 * @param {string[]} command
 * @param {Record<string, string>} [env]
 * @returns {Promise<Outcome>}
 */
async function tests(command, env) {
  const { lines, ok } = await run(command, { env });
  const outcome = count(lines, ok);
  const unsteady = lines.filter((line) => line.startsWith('unsteady ')).length; // counted as passed, see tests/browser/run.mjs
  if (unsteady === 0) return outcome;
  return { ...outcome, note: [outcome.note, `${unsteady} unsteady: passed at the second try only`].filter(Boolean).join('; ') };
}

/**
 * How many tests passed and failed, from what a runner printed and whether it succeeded.
 * @param {string[]} lines
 * @param {boolean} ok
 * @returns {Outcome}
 */
function count(lines, ok) {
  let passed = 0;
  let failed = 0;
  let died = 0;
  for (const line of lines) {
    const result = CARGO_RESULT.exec(line) ?? PLAIN_RESULT.exec(line);
    passed += Number(result?.[1] ?? 0);
    failed += Number(result?.[2] ?? 0);
    if (result && line.startsWith('test result: FAILED')) died -= 1;
    died += Number(CARGO_FAILED_TARGETS.exec(line)?.[1] ?? 0);
  }
  if (died > 0) return { passed, failed: failed + died, note: 'a test program died' };
  if (!ok && failed === 0) return { passed, failed: 1, note: 'it ended badly without a count' };
  if (passed + failed === 0) return { passed, failed: 1, note: 'it ran no test' };
  return { passed, failed, note: '' };
}

/** @param {string} note @returns {Outcome} */
function failure(note) {
  return { passed: 0, failed: 1, note };
}

/**
 * Our trees in another implementation. A machine on which that cannot be installed skips the part and says so.
 * @returns {Promise<Outcome>}
 */
async function peer() {
  const suits = 'import sys; sys.exit(sys.version_info < (3, 8))';
  if (!(await run(['python3', '-c', suits], { quiet: true })).ok) {
    const note = 'skipped: no python3 of version 3.8 or later was found';
    console.log(note);
    return { passed: 0, failed: 0, note };
  }
  return optional(['python3', 'scripts/peer.py']);
}

/**
 * A part of which a machine may lack the means: then it says `skipped: REASON` in place of some or all of its tests.
 * @param {string[]} command
 * @returns {Promise<Outcome>}
 */
async function optional(command) {
  const { lines, ok } = await run(command);
  const note = lines.filter((line) => line.startsWith('skipped: ')).join('; ');
  const outcome = count(lines, ok);
  if (!note) return outcome;
  return ok && outcome.passed === 0 ? { passed: 0, failed: 0, note } : { ...outcome, note: outcome.note || note };
}

/**
 * The path of a Chromium. Root on Debian gets one installed; elsewhere the error says what to install.
 * @returns {Promise<string>}
 */
async function chromium() {
  const names = ['chromium', 'chromium-browser', 'google-chrome'];
  const find = () => process.env.CHROMIUM || names.map(onPath).find(Boolean);
  const found = find();
  if (found) return found;
  const debian = existsSync('/etc/os-release') && /^ID=debian$/m.test(readFileSync('/etc/os-release', 'utf8'));
  if (!debian || process.getuid?.() !== 0) {
    throw new Error('no Chromium was found; install Chromium or Google Chrome, or set CHROMIUM to the path of one');
  }
  const apt = ['env', 'DEBIAN_FRONTEND=noninteractive', 'apt-get', '-qq', '-o', 'DPkg::Lock::Timeout=300'];
  const install = [...apt, 'install', '--no-install-recommends', '-y', 'chromium'];
  const installed = (await run([...apt, 'update'], { quiet: true })).ok && (await run(install, { quiet: true })).ok;
  const path = find();
  if (installed && path) return path;
  throw new Error('Chromium could not be installed with apt-get, see the messages above');
}

/** @param {string} name */
function onPath(name) {
  try {
    return execFileSync('sh', ['-c', 'command -v "$1"', 'sh', name], { encoding: 'utf8' }).trim();
  } catch {
    return '';
  }
}

const make = (...goals) => ['make', '--silent', '--no-print-directory', ...goals];
const WASM = ['--target', 'wasm32-unknown-unknown', '--no-default-features', '--features', 'worlds,trees,studies,sequence,soccer-page'];

// What a later part needs from an earlier one.
let built = false;

/** @type {[string, () => Promise<Outcome>][]} */
const PARTS = [
  ['tools and packages', () => check(make('tools', 'packages'))],
  [
    'formatting',
    () => check(['cargo', 'fmt', '--check'], ['cargo', 'fmt', '--check', '--manifest-path', 'tools/Cargo.toml']),
  ],
  [
    'lints',
    () =>
      check(
        ['cargo', 'clippy', '--locked', '--all-targets', '--', '-D', 'warnings'],
        ['cargo', 'clippy', '--locked', '--lib', ...WASM, '--', '-D', 'warnings'],
      ),
  ],
  ['native tests', () => tests(['cargo', 'test', '--locked', '--no-fail-fast', '--', '--quiet'])],
  ['documentation', () => check(['node', 'scripts/papers.mjs', '--check'], ['env', 'RUSTDOCFLAGS=-D warnings', 'cargo', 'doc', '--no-deps', '--locked', '--quiet'])],
  ['peer check', peer],
  ['studies past one machine', () => optional(['python3', 'scripts/workflow.py'])],
  [
    'tests in WebAssembly',
    // Doctests run natively; naming the targets leaves them out. Debug information would make every test program
    // several times larger, and preparing it for Node take eight times as long.
    () =>
      tests(
        ['wasm-pack', '--log-level', 'warn', 'test', '--mode', 'no-install', '--node']
          .concat(['--', '--no-default-features', '--features', 'sequencing,soccer,texts', '--lib', '--test', '*']),
        { CARGO_PROFILE_DEV_DEBUG: '0' },
      ),
  ],
  [
    'build of the page',
    async () => {
      const outcome = await check(make('build'));
      built = outcome.failed === 0;
      return outcome;
    },
  ],
  ['types', () => check(['tsc', '-p', 'tsconfig.json'])],
  ['sizes', async () => (built ? check(['node', 'scripts/size.mjs']) : failure('there is no page to weigh'))],
  [
    'browser tests',
    async () => {
      const path = await chromium();
      return built ? tests(['node', 'tests/browser/run.mjs'], { CHROMIUM: path }) : failure('there is no page to test');
    },
  ],
  ['other browsers', async () => (built ? optional(['node', 'tests/browser/others.mjs']) : failure('there is no page to test'))],
  [
    'npm package',
    async () => {
      const path = await chromium();
      const { failed } = await check(make('package'));
      return failed === 0 ? tests(['node', 'tests/package.mjs'], { CHROMIUM: path }) : failure('the package could not be built');
    },
  ],
];

const rows = [];
for (const [name, part] of PARTS) {
  console.log(`\n== ${name}`);
  const start = Date.now();
  const outcome = await part().catch((error) => failure(error.message));
  if (outcome.failed > 0 && outcome.note) console.log(`Failed: ${outcome.note}`);
  rows.push({ name, seconds: (Date.now() - start) / 1000, ...outcome });
}

console.log('\n== summary');
for (const { name, seconds, passed, failed, note } of rows) {
  const verdict = failed === 0 ? 'ok' : 'FAILED';
  const counts = `${passed} passed, ${failed} failed`;
  console.log(`${name.padEnd(22)} ${verdict.padEnd(7)} ${counts.padEnd(24)} ${seconds.toFixed(1).padStart(6)} s  ${note}`.trimEnd());
}
const failed = rows.reduce((sum, row) => sum + row.failed, 0);
console.log(`\n${rows.reduce((sum, row) => sum + row.passed, 0)} passed, ${failed} failed`);
process.exitCode = failed === 0 ? 0 : 1;
