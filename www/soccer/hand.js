// Plays the games of a tournament. To www/studies/pool.js its study is the list of scenarios, its runs are games, and the
// line of a run is the outcome.

import { makeRuns } from '../studies/making.js';
import init, { Match } from './engine/swarm_playground.js';

const SLICE_TICKS = 1200; // about 20 milliseconds

/** @type {object[]} */
let scenarios = [];

makeRuns({
  async open(module, spec) {
    await init({ module_or_path: module });
    scenarios = JSON.parse(spec);
  },

  start(run) {
    const match = new Match(JSON.stringify(scenarios[run]));
    return {
      advance: () => !match.skip(SLICE_TICKS),
      line: () => match.outcome(),
      free: () => match.free(),
    };
  },
});
