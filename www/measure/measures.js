// What is measured, in `make bench` and on the page #/bench alike: the same files, the same amounts, the same calls.

/** @import { Sequence } from '../sequence/engine/swarm_playground.js' */
/** @import { Study } from '../studies/engine/swarm_playground.js' */
/** @import { World } from '../engine/swarm_playground.js' */

export const FORAGING = 'scenarios/foraging.json';
export const PUBLISHED = 'scenarios/published.json';
export const FIXED = 'scenarios/hand-tree.json'; // every robot runs one tree of 16 nodes, nobody evolves
export const TREE = 'tests/cases/reactive_tree.json'; // 18 nodes
export const NAVIGATION = 'scenarios/navigation.json';
export const COVERAGE = 'scenarios/coverage.json';
export const PROOF = 'tests/cases/proof.json'; // ends when a ratio of 1.25 is proven
export const FLOCKS = 'tests/cases/flocks.json'; // 1000 flocks of 20 robots for one interval of 100 steps
export const MATCH = 'scenarios/match.json'; // ten minutes, both coaches

export const STEPS = 12_000; // of a swarm that evolves
export const FIXED_STEPS = 20_000;
export const TICKS = 2_000_000; // of a tree's root
export const LAYOUTS = 10; // that are searched
export const FLOCK_STEPS = 1000 * 20 * 100;
export const MATCH_STEPS = 36_000;

/** @param {() => string} work returns a fingerprint */
export function timed(work) {
  const start = performance.now();
  const fingerprint = work();
  return { seconds: (performance.now() - start) / 1000, fingerprint };
}

/**
 * A scenario in WebAssembly for a number of steps; a run that ends is followed by the next seed.
 *
 * @param {typeof World} Engine
 * @param {string} json
 * @param {number} steps
 */
export function runWorld(Engine, json, steps) {
  const scenario = JSON.parse(json);
  let done = { seconds: 0, fingerprint: '' };
  for (let left = steps, seed = scenario.seed ?? 1; left > 0; seed += 1) {
    const world = new Engine(JSON.stringify({ ...scenario, seed, steps }));
    const { seconds, fingerprint } = timed(() => {
      // In slices, as the page does: V8 replaces slow code by fast code only where a function is entered again.
      while (left > 0) {
        const made = world.advance(Math.min(20, left));
        if (made === 0) break;
        left -= made;
      }
      return world.fingerprint();
    });
    done = { seconds: done.seconds + seconds, fingerprint };
    world.free();
  }
  return done;
}

/** @typedef {{ seconds: number, outcome: string, plan: string | null, cost: number | null, lower_bound: number | null, integrated: number, expanded: number }} Searched */

/**
 * The search on layouts in WebAssembly, with the seeds from the scenario's on.
 *
 * @param {typeof Sequence} Engine
 * @param {string} json
 * @param {number} layouts
 * @returns {Searched[]}
 */
export function searchLayouts(Engine, json, layouts) {
  const scenario = JSON.parse(json);
  return Array.from({ length: layouts }, (_, number) => {
    const sequence = new Engine(JSON.stringify({ ...scenario, seed: (scenario.seed ?? 1) + number }));
    // In slices, as the page does.
    const { seconds } = timed(() => {
      while (sequence.advance(16));
      return '';
    });
    const found = JSON.parse(sequence.progress());
    sequence.free();
    return { ...found, seconds };
  });
}

/**
 * A match in WebAssembly, by the engine of the studies.
 *
 * @param {typeof Study} Engine
 * @param {string} json
 * @param {number} steps of play, rounded to whole seconds of a half
 */
export function playMatch(Engine, json, steps) {
  const { seed = 1, title, about, ...scenario } = JSON.parse(json);
  const { seconds, fingerprint } = makeRun(Engine, { ...scenario, 'half-seconds': Math.max(1, Math.round(steps / 120)) }, seed, 'goals', 600);
  return { seconds, fingerprint };
}

/**
 * A swarm in WebAssembly for a number of steps, by the engine of the studies; a run that ends is followed by the next seed.
 *
 * @param {typeof Study} Engine
 * @param {string} json
 * @param {number} steps
 */
export function runStudy(Engine, json, steps) {
  const { seed: first = 1, title, about, ...scenario } = JSON.parse(json);
  let done = { seconds: 0, fingerprint: '' };
  for (let left = steps, seed = first; left > 0; seed += 1) {
    const { seconds, fingerprint, value: made } = makeRun(Engine, { ...scenario, steps: left }, seed, 'steps', 20);
    done = { seconds: done.seconds + seconds, fingerprint };
    if (made === 0) break;
    left -= made;
  }
  return done;
}

/**
 * One run of a study: how long it took, its fingerprint, and the metric.
 *
 * @param {typeof Study} Engine @param {object} scenario @param {number} seed @param {string} metric @param {number} slice
 */
function makeRun(Engine, scenario, seed, metric, slice) {
  const study = new Engine(JSON.stringify({ study: 'bench', scenario, seeds: { first: seed, count: 1 }, metrics: [metric] }), '{}', 'paper');
  const job = study.start(0);
  /** @type {string[]} */
  let columns = [];
  const done = timed(() => {
    while (!job.advance(slice));
    columns = job.line().trimEnd().split(',').slice(-5); // the metric, version, study, fingerprint and reason
    return columns[3] ?? '';
  });
  job.free();
  study.free();
  return { ...done, value: Number(columns[0]) };
}

/** The middle of some numbers. @param {number[]} values at least one */
export function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}
