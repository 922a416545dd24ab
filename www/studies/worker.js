// Makes the runs of one study.

import init, { Study } from './engine/swarm_playground.js';
import { makeRuns } from './making.js';

const SLICE_MS = 40;

/** @type {Study | null} */
let study = null;
let slice = 8; // steps

makeRuns({
  async open(module, spec) {
    await init({ module_or_path: module });
    study = new Study(spec, '{}', 'paper');
  },

  start(run) {
    if (!study) throw new Error('no study was given');
    const job = study.start(run);
    return {
      advance() {
        const start = performance.now();
        const over = job.advance(slice);
        const took = performance.now() - start;
        slice = Math.max(1, Math.min(4096, Math.round((slice * SLICE_MS) / Math.max(took, 1))));
        return over;
      },
      line: () => job.line(),
      free: () => job.free(),
    };
  },
});
