// `make bench`: agent-steps per second of the command line and of the same engine in WebAssembly (under Node), measured
// in turns so that a busy machine slows both. Prints the medians, their ratio and the project's targets; status 1 only
// when the two did not compute the same thing.
//
// SCENARIO (a file), STEPS and ROUNDS may be set as environment variables.

import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { World, initSync } from '../www/engine/swarm_playground.js';

const TARGET_NATIVE = 250_000; // agent-steps per second
const TARGET_RATIO = 0.7; // WebAssembly over native

const scenario = process.env.SCENARIO || 'scenarios/foraging.json';
const steps = Number(process.env.STEPS || 6000);
const rounds = Number(process.env.ROUNDS || 5);
for (const [name, value] of Object.entries({ STEPS: steps, ROUNDS: rounds })) {
  if (!Number.isInteger(value) || value < 1) {
    console.error(`${name} must be a whole number of at least 1.`);
    process.exit(1);
  }
}

/** One native run, as the command line reports it. */
function runNative() {
  const args = ['run', '--release', '--quiet', '--', 'bench', scenario, '--steps', String(steps)];
  return JSON.parse(execFileSync('cargo', args, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit'] }));
}

/** The same run in WebAssembly. */
function runWasm() {
  const world = new World(json);
  const start = performance.now();
  // In slices, as the page does: V8 replaces slow code by fast code only where a function is entered again.
  for (let done = 0; done < steps; done += 20) world.advance(Math.min(20, steps - done));
  const seconds = (performance.now() - start) / 1000;
  const fingerprint = world.fingerprint();
  world.free();
  return { seconds, fingerprint };
}

/** @param {number[]} values */
function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

const rate = (value) => Math.round(value).toLocaleString('en').padStart(12);
const verdict = (reached) => (reached ? 'reached' : 'missed');

console.log('Building the command line (release)');
execFileSync('cargo', ['build', '--release', '--quiet'], { stdio: 'inherit' });
const json = readFileSync(scenario, 'utf8');
initSync({ module: readFileSync('www/engine/swarm_playground_bg.wasm') });
runWasm(); // the first run is slower: V8 is still compiling

console.log(`${cpus()[0].model}, Node ${process.versions.node}; ${scenario}, ${steps} steps, ${rounds} rounds`);
console.log('agent-steps/s     native         wasm');
const native = [];
const wasm = [];
const fingerprints = new Set();
for (let round = 1; round <= rounds; round++) {
  const ours = runNative();
  const theirs = runWasm();
  native.push(ours.agent_steps / ours.seconds);
  wasm.push(ours.agent_steps / theirs.seconds);
  fingerprints.add(ours.fingerprint).add(theirs.fingerprint);
  console.log(`round ${String(round).padEnd(4)} ${rate(native.at(-1))} ${rate(wasm.at(-1))}`);
}

const fast = median(native);
const ratio = median(wasm) / fast;
console.log(`median     ${rate(fast)} ${rate(median(wasm))}`);
console.log(`native       ${verdict(fast >= TARGET_NATIVE)}: at least ${rate(TARGET_NATIVE).trim()} agent-steps/s`);
console.log(`wasm/native  ${verdict(ratio >= TARGET_RATIO)}: ${ratio.toFixed(2)}, at least ${TARGET_RATIO}`);
if (fingerprints.size === 1) {
  console.log(`fingerprint  ${[...fingerprints][0]} in every run, native and wasm`);
} else {
  console.error(`fingerprints differ: ${[...fingerprints].join(', ')}`);
  process.exitCode = 1;
}
