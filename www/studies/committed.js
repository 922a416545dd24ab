import { committedResults } from './library.js';

/** @import { Engine } from '../engine.js' */
/** @import { Plan, Reported } from './types.js' */

const AS = 'committed';

/**
 * The committed results of a study, read when they are first asked for.
 *
 * @typedef {{ file: string, hash: string, spec: string, reported: Reported }} Shown `spec` is the study they were made from
 *
 * @param {Engine} desk
 */
export function createCommitted(desk) {
  /** @type {Map<string, Promise<Shown>>} */
  const known = new Map();

  return {
    /** @param {string} name of a study */
    has: (name) => committedResults(name) !== null,

    /**
     * The report on them; rejects with a sentence when they are of another version.
     *
     * @param {string} name
     * @returns {Promise<Shown>}
     */
    async read(name) {
      const found = committedResults(name);
      if (!found) throw new Error(name);
      const reading = known.get(name) ?? read(found);
      known.set(name, reading);
      reading.catch(() => known.delete(name)); // a later visit tries again
      return reading;
    },
  };

  /** @param {import('./library.js').Committed} found @returns {Promise<Shown>} */
  async function read({ file, csv, spec }) {
    const [rows, study] = await Promise.all([csv(), spec()]);
    /** @type {{ plan: Plan }} */
    const { plan } = await desk.request('open', { as: AS, spec: study, size: 'paper' });
    return { file, hash: plan.hash, spec: study, reported: await desk.request('report', { as: AS, results: rows }) };
  }
}

/** @typedef {ReturnType<typeof createCommitted>} Committed */
