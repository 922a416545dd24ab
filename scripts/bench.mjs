// `make bench`: how fast the engine is natively and in WebAssembly (under Node), measured in turns so that a busy
// machine slows both: agent-steps per second of three scenarios, and ticks per second of a tree. Prints the fastest rounds,
// their ratio and the project's targets; then the search for behaviour sequences, a match of ten minutes, what a crowd
// costs, and the memory of the engine in WebAssembly. Status 1 only when the two did not compute the same thing.
//
// The work is the same in every round, to the bit, so what else a machine has to do can only add to its time: the fastest
// round is the nearest to what the work takes. Medians of a shared machine tell of its other users.
//
// SCENARIO (a file), STEPS, TICKS and ROUNDS may be set as environment variables.

import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { Sequence, initSync as initSequence } from '../www/sequence/engine/swarm_playground.js';
import { World, initSync as initWorlds } from '../www/engine/swarm_playground.js';
import { Study, initSync as initStudies } from '../www/studies/engine/swarm_playground.js';
import { initSync as initTrees, tick_headless } from '../www/trees/engine/swarm_playground.js';
import { COVERAGE, FIXED, FIXED_STEPS, FLOCKS, FLOCK_STEPS, FORAGING, LAYOUTS, MATCH, MATCH_STEPS, NAVIGATION, PROOF, PUBLISHED, STEPS, TICKS, TREE, median, playMatch, runStudy, runWorld, searchLayouts, timed } from '../www/measure/measures.js';

const MATCHES = 250; // of the paper's study
const OPTIMUM = 'tests/cases/optimum.json'; // six decisions
const scenario = process.env.SCENARIO || FORAGING;
const steps = Number(process.env.STEPS || STEPS);
const ticks = Number(process.env.TICKS || TICKS);
const rounds = Number(process.env.ROUNDS || 5);
for (const [name, value] of Object.entries({ STEPS: steps, TICKS: ticks, ROUNDS: rounds })) {
  if (!Number.isInteger(value) || value < 1) {
    console.error(`${name} must be a whole number of at least 1.`);
    process.exit(1);
  }
}

/** @param {...string} args of the command line */
function native(...args) {
  return JSON.parse(execFileSync('cargo', ['run', '--release', '--quiet', '--', ...args], { encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit'] }));
}

/**
 * @typedef {object} Measure
 * @property {string} title
 * @property {string} unit
 * @property {number} amount of units in one run
 * @property {() => { seconds: number, fingerprint: string }} native
 * @property {() => { seconds: number, fingerprint: string }} wasm
 * @property {number} least units per second wanted natively
 * @property {number} [ratio] wanted of WebAssembly over native
 * @property {number} [leastWasm] units per second wanted in WebAssembly
 */

/** @returns {Measure[]} */
function measures() {
  const json = readFileSync(scenario, 'utf8');
  const setup = readFileSync(TREE, 'utf8');
  const agentSteps = native('bench', scenario, '--steps', String(steps)).agent_steps;
  const fixed = readFileSync(FIXED, 'utf8');
  const published = readFileSync(PUBLISHED, 'utf8');
  return [
    {
      title: `${scenario}, ${steps} steps`,
      unit: 'agent-steps',
      amount: agentSteps,
      native: () => native('bench', scenario, '--steps', String(steps)),
      wasm: () => runWorld(World, json, steps),
      least: 12_000 * 100 / 4, // a full run in 4 seconds
    },
    {
      // The page makes its full runs in the engine of the studies, which is built for speed; that of the worlds, above, is in
      // the first load and built for size.
      title: `${scenario}, ${steps} steps, by the engine of the studies`,
      unit: 'agent-steps',
      amount: agentSteps,
      native: () => native('bench', scenario, '--steps', String(steps)),
      wasm: () => runStudy(Study, json, steps),
      least: 12_000 * 100 / 4,
      ratio: 0.7,
    },
    {
      title: `${PUBLISHED}, ${steps} steps`,
      unit: 'agent-steps',
      amount: native('bench', PUBLISHED, '--steps', String(steps)).agent_steps,
      native: () => native('bench', PUBLISHED, '--steps', String(steps)),
      wasm: () => runWorld(World, published, steps),
      least: 12_000 * 100 / 7, // a full run in 7 seconds
    },
    {
      title: `${FIXED}, ${FIXED_STEPS} steps`,
      unit: 'agent-steps',
      amount: native('bench', FIXED, '--steps', String(FIXED_STEPS)).agent_steps,
      native: () => native('bench', FIXED, '--steps', String(FIXED_STEPS)),
      wasm: () => runWorld(World, fixed, FIXED_STEPS),
      least: 1_000_000,
      leastWasm: 1_000_000, // "and worker": those of a page run this
    },
    {
      title: `${TREE}, ${ticks} ticks`,
      unit: 'root ticks',
      amount: ticks,
      native: () => native('tree', 'bench', TREE, '--ticks', String(ticks)),
      wasm: () => timed(() => tick_headless(setup, ticks)),
      least: 20 * 45_000, // BehaviorTree.CPP makes 38,000 to 45,000 on such a machine
      ratio: 0.6,
    },
  ];
}

const rate = (/** @type {number} */ value) => Math.round(value).toLocaleString('en').padStart(12);
const fastest = (/** @type {number[]} */ seconds) => Math.min(...seconds);
const verdict = (/** @type {boolean} */ reached) => (reached ? 'reached' : 'missed');

/** @param {Measure} measure */
function run({ title, unit, amount, native: runNative, wasm: runWasm, least, ratio: leastRatio, leastWasm }) {
  runWasm(); // the first run is slower: V8 is still compiling
  console.log(`\n${title}`);
  console.log(`${unit}/s`.padEnd(14) + '     native         wasm');
  /** @type {number[]} */
  const ours = [];
  /** @type {number[]} */
  const theirs = [];
  const fingerprints = new Set();
  for (let round = 1; round <= rounds; round++) {
    for (const [list, done] of /** @type {const} */ ([[ours, runNative()], [theirs, runWasm()]])) {
      list.push(amount / done.seconds);
      fingerprints.add(done.fingerprint);
    }
    console.log(`round ${String(round).padEnd(6)} ${rate(ours[round - 1])} ${rate(theirs[round - 1])}`);
  }
  const [fast, slow] = [Math.max(...ours), Math.max(...theirs)];
  const ratio = slow / fast;
  console.log(`fastest      ${rate(fast)} ${rate(slow)}`);
  console.log(`native       ${verdict(fast >= least)}: at least ${rate(least).trim()} ${unit}/s`);
  if (leastWasm) console.log(`wasm         ${verdict(slow >= leastWasm)}: at least ${rate(leastWasm).trim()} ${unit}/s`);
  console.log(`wasm/native  ${leastRatio ? `${verdict(ratio >= leastRatio)}: ${ratio.toFixed(2)}, at least ${leastRatio}` : ratio.toFixed(2)}`);
  if (fingerprints.size === 1) {
    console.log(`fingerprint  ${[...fingerprints][0]} in every run, native and wasm`);
  } else {
    console.error(`fingerprints differ: ${[...fingerprints].join(', ')}`);
    process.exitCode = 1;
  }
}

/** @import { Searched } from '../www/measure/measures.js' */

/** What a search came to, without the time. @param {Searched} found */
const cameTo = ({ outcome, plan, cost, lower_bound: bound, integrated, expanded }) => JSON.stringify([outcome, plan, cost, bound, integrated, expanded]);

/**
 * Searches layouts natively and in WebAssembly in turns, and checks that both come to the same.
 * @param {string} file @param {number} layouts @param {number} times
 */
function searches(file, layouts, times) {
  const json = readFileSync(file, 'utf8');
  searchLayouts(Sequence, json, 1); // the first run is slower: V8 is still compiling
  /** @type {{ native: number[][], wasm: number[][] }} seconds, by layout */
  const seconds = { native: [], wasm: [] };
  /** @type {Searched[]} */
  let found = [];
  for (let round = 0; round < times; round++) {
    found = native('sequence', 'measure', file, '--layouts', String(layouts)).layouts;
    const theirs = searchLayouts(Sequence, json, layouts);
    found.forEach((ours, at) => {
      (seconds.native[at] ??= []).push(ours.seconds);
      (seconds.wasm[at] ??= []).push(theirs[at].seconds);
      if (cameTo(ours) === cameTo(theirs[at])) return;
      console.error(`layout ${at + 1} differs: ${cameTo(ours)} natively, ${cameTo(theirs[at])} in WebAssembly`);
      process.exitCode = 1;
    });
  }
  return { found, native: seconds.native.map(fastest), wasm: seconds.wasm.map(fastest) };
}

/** How fast plans are found, and flocks simulated. */
function plans() {
  const times = Math.min(rounds, 3); // one layout takes seconds
  const per = (/** @type {number[]} */ seconds) => 1000 * median(seconds);
  const mean = (/** @type {number[]} */ values) => values.reduce((all, value) => all + value, 0) / values.length;
  const ms = (/** @type {string} */ name, /** @type {number} */ value, /** @type {number} */ most) => console.log(`${name.padEnd(12)} ${verdict(value <= most)}: ${value.toFixed(1)} ms at the median, at most ${most}`);

  const navigation = searches(NAVIGATION, LAYOUTS, times);
  const counts = navigation.found.map(({ integrated }) => integrated);
  const solved = navigation.found.filter(({ outcome }) => outcome === 'solved').length;
  console.log(`\n${NAVIGATION}, ${LAYOUTS} layouts, medians over them of the fastest of ${times} rounds`);
  console.log(`integrations ${verdict(median(counts) <= 40)}: ${median(counts)} at the median, at most 40`);
  console.log(`solved       ${verdict(solved === LAYOUTS)}: ${solved} of ${LAYOUTS}`);
  ms('native', per(navigation.native), 15);
  ms('wasm', per(navigation.wasm), 30);

  const coverage = searches(COVERAGE, LAYOUTS, times);
  const integrations = mean(coverage.found.map(({ integrated }) => integrated));
  console.log(`\n${COVERAGE}, ${LAYOUTS} layouts`);
  console.log(`integrations ${verdict(integrations <= 130)}: ${integrations.toFixed(1)} in the mean, at most 130`);
  console.log(`native       ${per(coverage.native).toFixed(1)} ms at the median`);
  console.log(`wasm         ${per(coverage.wasm).toFixed(1)} ms at the median`);

  const proof = searches(PROOF, LAYOUTS, 1);
  const proven = (/** @type {number[]} */ seconds) => proof.found.filter(({ outcome }, at) => outcome === 'solved' && seconds[at] <= 2).length;
  console.log(`\n${PROOF}, ${LAYOUTS} layouts, a ratio of 1.25 proven within 2 s`);
  for (const [name, count] of /** @type {[string, number][]} */ ([['native', proven(proof.native)], ['wasm', proven(proof.wasm)]])) {
    console.log(`${name.padEnd(12)} ${verdict(count >= 8)}: ${count} of ${LAYOUTS}, at least 8`);
  }

  const optimum = searches(OPTIMUM, LAYOUTS, 1);
  const ended = optimum.found.filter(({ outcome }) => outcome === 'solved' || outcome === 'proved infeasible').length;
  console.log(`\n${OPTIMUM}, ${LAYOUTS} layouts: the cheapest plan, or that there is none`);
  console.log(`proven       ${verdict(ended === LAYOUTS)}: ${ended} of ${LAYOUTS}`);
  ms('native', per(optimum.native), 1000);
  console.log(`wasm         ${per(optimum.wasm).toFixed(1)} ms at the median`);

  const flocks = searches(FLOCKS, 1, rounds);
  const [fast, slow] = [FLOCK_STEPS / flocks.native[0], FLOCK_STEPS / flocks.wasm[0]];
  console.log(`\n${FLOCKS}, ${FLOCK_STEPS.toLocaleString('en')} robot-steps of flocking within a search`);
  console.log(`native       ${verdict(fast >= 4e6)}: ${rate(fast).trim()} robot-steps/s, at least ${rate(4e6).trim()}`);
  console.log(`wasm/native  ${verdict(slow / fast >= 0.65)}: ${(slow / fast).toFixed(2)}, at least 0.65`);
}

/** How long a match takes, which the two play in turns. */
function matches() {
  const json = readFileSync(MATCH, 'utf8');
  const { steps: made } = native('bench', MATCH, '--steps', String(MATCH_STEPS));
  playMatch(Study, json, MATCH_STEPS); // the first run is slower: V8 is still compiling
  /** @type {number[]} */
  const ours = [];
  /** @type {number[]} */
  const theirs = [];
  const fingerprints = new Set();
  for (let round = 0; round < rounds; round++) {
    for (const [list, done] of /** @type {const} */ ([[ours, native('bench', MATCH, '--steps', String(MATCH_STEPS))], [theirs, playMatch(Study, json, MATCH_STEPS)]])) {
      list.push(done.seconds);
      fingerprints.add(done.fingerprint);
    }
  }
  const line = (/** @type {string} */ name, /** @type {number[]} */ seconds, /** @type {number} */ most) => {
    const each = fastest(seconds);
    console.log(`${name.padEnd(12)} ${verdict(each <= most)}: ${each.toFixed(3)} s, at most ${most}; ${(60 / each).toFixed(0)} matches a minute, ${MATCHES} in ${(MATCHES * each).toFixed(0)} s, on one thread`);
  };
  console.log(`\n${MATCH}, ${made.toLocaleString('en')} steps, the fastest of ${rounds} rounds`);
  line('native', ours, 0.35);
  line('wasm', theirs, 0.5);
  if (fingerprints.size === 1) {
    console.log(`fingerprint  ${[...fingerprints][0]} in every run, native and wasm`);
  } else {
    console.error(`fingerprints differ: ${[...fingerprints].join(', ')}`);
    process.exitCode = 1;
  }
}

/**
 * What an agent-step costs in a crowd of 10,000, as densely placed as 100, natively: a run of the one beside runs of a
 * hundred seeds of the others, so that both measure as many agent-steps of the same age.
 */
function crowds() {
  const cost = (/** @type {number} */ agents) => {
    const seeds = String(10_000 / agents);
    const { seconds, agent_steps: amount } =
      native('bench', `tests/cases/crowd_${agents}.json`, '--steps', '300', '--seeds', seeds);
    return seconds / amount;
  };
  console.log('\nCost of an agent-step with 10,000 robots over that with 100, of equal density');
  /** @type {[number, number][]} */
  const costs = Array.from({ length: rounds }, () => [cost(10_000), cost(100)]);
  const ratio = fastest(costs.map(([crowd]) => crowd)) / fastest(costs.map(([, few]) => few));
  console.log(`ratio        ${verdict(ratio <= 1.5)}: ${ratio.toFixed(2)} (by round ${costs.map(([crowd, few]) => (crowd / few).toFixed(2)).join(', ')}), at most 1.5`);
}

/** How much memory the engine of the worlds took for all of its runs. @param {WebAssembly.Memory} memory */
function ceiling(memory) {
  const megabytes = memory.buffer.byteLength / 1e6;
  console.log(`\nMemory of the engine of the worlds\nwasm         ${verdict(megabytes <= 64)}: ${megabytes.toFixed(1)} MB, at most 64`);
}

console.log('Building the command line (release)');
execFileSync('cargo', ['build', '--release', '--quiet'], { stdio: 'inherit' });
const { memory } = initWorlds({ module: readFileSync('www/engine/swarm_playground_bg.wasm') });
initSequence({ module: readFileSync('www/sequence/engine/swarm_playground_bg.wasm') });
initStudies({ module: readFileSync('www/studies/engine/swarm_playground_bg.wasm') });
initTrees({ module: readFileSync('www/trees/engine/swarm_playground_bg.wasm') });
console.log(`${cpus()[0].model}, Node ${process.versions.node}, ${rounds} rounds`);
for (const measure of measures()) run(measure);
plans();
matches();
crowds();
ceiling(memory);
