// Measures the engines, one thing at a time; each is loaded when it is first measured.
// The handler is set at once, or the first request would be lost.

import { COVERAGE, FIXED, FIXED_STEPS, FLOCKS, FLOCK_STEPS, FORAGING, LAYOUTS, MATCH, MATCH_STEPS, NAVIGATION, PUBLISHED, STEPS, TICKS, TREE, median, playMatch, runWorld, searchLayouts, timed } from './measures.js';

/** @import { Measured, ToWorker } from './types.js' */

const FILES = /** @type {Record<string, () => Promise<string>>} */ (
  import.meta.glob(['/scenarios/{foraging,published,hand-tree,navigation,coverage,match}.json', '/tests/cases/{reactive_tree,flocks}.json'], { query: '?raw', import: 'default' })
);
const text = (/** @type {string} */ file) => FILES[`/${file}`]();

const port = /** @type {{ postMessage(message: object): void, onmessage: ((event: MessageEvent<ToWorker>) => void) | null }} */ (/** @type {unknown} */ (self));

port.onmessage = async ({ data: { id, name, share } }) => {
  try {
    port.postMessage({ id, measured: await MEASURES[name](share) });
  } catch (error) {
    port.postMessage({ id, type: 'error', message: error instanceof Error ? error.message : String(error) });
  }
};

/** An engine, once. @template T @param {() => Promise<T & { default: () => Promise<any> }>} load */
function engine(load) {
  /** @type {Promise<{ module: T, memory: WebAssembly.Memory }> | undefined} */
  let loaded;
  return () => (loaded ??= load().then(async (module) => ({ module, memory: (await module.default()).memory })));
}

const worlds = engine(() => import('../engine/swarm_playground.js'));
const trees = engine(() => import('../trees/engine/swarm_playground.js'));
const sequences = engine(() => import('../sequence/engine/swarm_playground.js'));
const studies = engine(() => import('../studies/engine/swarm_playground.js'));

/** @type {Record<string, (share: number) => Promise<Measured>>} */
const MEASURES = {
  foraging: swarm(FORAGING, STEPS),
  published: swarm(PUBLISHED, STEPS),
  fixed: swarm(FIXED, FIXED_STEPS),

  async tree(share) {
    const { module } = await trees();
    const setup = await text(TREE);
    const ticks = part(TICKS, share);
    module.tick_headless(setup, part(ticks, 0.01)); // the first run is slower: the code is still compiled
    return { amount: ticks, ...timed(() => module.tick_headless(setup, ticks)) };
  },

  navigation: search(NAVIGATION),
  coverage: search(COVERAGE),

  async flocks() {
    const { module } = await sequences();
    const [{ seconds, integrated }] = searchLayouts(module.Sequence, await text(FLOCKS), 1);
    return { amount: FLOCK_STEPS, seconds, integrated };
  },

  async match(share) {
    const { module } = await studies();
    const steps = part(MATCH_STEPS, share);
    return { amount: steps, ...playMatch(module.Study, await text(MATCH), steps) };
  },

  async memory() {
    const { memory } = await worlds();
    return { amount: memory.buffer.byteLength, seconds: 0 };
  },
};

/** @param {number} amount @param {number} share */
const part = (amount, share) => Math.max(1, Math.round(amount * share));

/** Steps of all robots of a scenario. @param {string} file @param {number} steps */
function swarm(file, steps) {
  return async (/** @type {number} */ share) => {
    const { module } = await worlds();
    const json = await text(file);
    const { agents } = JSON.parse(module.complete(json));
    const made = part(steps, share);
    runWorld(module.World, json, part(made, 0.02)); // the first run is slower: the code is still compiled
    return { amount: made * agents, ...runWorld(module.World, json, made) };
  };
}

/** Layouts that are searched. @param {string} file */
function search(file) {
  return async (/** @type {number} */ share) => {
    const { module } = await sequences();
    const json = await text(file);
    searchLayouts(module.Sequence, json, 1); // the first run is slower: the code is still compiled
    const found = searchLayouts(module.Sequence, json, part(LAYOUTS, share));
    const total = (/** @type {(layout: typeof found[number]) => number} */ of) => found.reduce((sum, layout) => sum + of(layout), 0);
    return { amount: total(({ integrated }) => integrated), seconds: total(({ seconds }) => seconds), each: median(found.map(({ seconds }) => seconds)), integrated: total(({ integrated }) => integrated) };
  };
}
