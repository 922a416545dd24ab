/** @import { Engine } from '../engine.js' */
/** @import { Compare } from '../views/trees/compare.js' */
/** @import { TreeRun } from './run.js' */
/** @import { BenchNode, Moment, Opened, Setup, Timeline, Variant } from './types.js' */

const MOST = 3; // benches 1 to 3; bench 0 is the run on screen
const CELLS = 60_000; // of all timelines together, so that a large tree does not slow the ticks
const COLUMNS = 512;

/**
 * The kinds of one sequence or fallback side by side: one bench each, taken along to every tick of the run.
 *
 * @param {{ engine: Engine, run: TreeRun, view: Compare }} parts
 */
export function createComparison({ engine, run, view }) {
  let count = 0; // benches in use
  let asked = 0; // comparisons begun or ended so far: one that is overtaken is given up
  let cells = 1;
  /** @type {Promise<void> | null} */
  let moving = null;
  let again = false;

  const comparison = {
    /** The node that is compared; null when nothing is. @type {BenchNode | null} */
    node: null,

    /**
     * Compares the kinds of a node.
     *
     * @param {BenchNode[]} candidates the first that has other kinds is taken
     * @param {Omit<Setup, 'length' | 'at'>} setup
     * @param {(node: BenchNode) => string} note what the comparison says about itself
     * @returns {Promise<boolean>} false when none of them has
     */
    async start(candidates, setup, note) {
      const mine = ++asked;
      for (const node of candidates) {
        /** @type {Variant[]} */
        const variants = (await engine.request('variants', { xml: setup.xml, line: node.line, column: node.column })).variants;
        if (mine !== asked) return true;
        if (variants.length === 0) continue;
        const trees = await open(variants.slice(0, MOST), setup);
        if (mine !== asked) return true;
        comparison.node = node;
        count = trees.length;
        view.show(trees, note(node));
        await move();
        return true;
      }
      comparison.stop();
      return false;
    },

    stop() {
      asked += 1;
      comparison.node = null;
      count = 0;
    },

    /** Follows the run to its tick; of several moves only the last is made. */
    follow() {
      if (count === 0) return;
      again = moving !== null;
      moving ??= move().finally(() => (moving = null));
    },
  };

  /** @param {Variant[]} variants @param {Omit<Setup, 'length' | 'at'>} setup */
  async function open(variants, setup) {
    const answers = await Promise.all(variants.map(({ xml }, index) => engine.request('open', { bench: index + 1, setup: { ...setup, xml, length: run.length, at: run.tick } })));
    const trees = answers.map(({ opened }, index) => ({ type: variants[index].type, nodes: /** @type {Opened} */ (opened).tree?.nodes ?? [] }));
    cells = Math.max(1, ...trees.map(({ nodes }) => nodes.length)) * trees.length;
    return trees;
  }

  async function move() {
    do {
      again = false;
      const benches = Array.from({ length: count }, (_, index) => index + 1);
      const { tick } = run;
      const from = Math.max(1, tick - Math.min(COLUMNS, Math.max(16, Math.floor(CELLS / cells))) + 1);
      /** @type {(Moment | null)[]} */
      const moments = (await Promise.all(benches.map((bench) => engine.request('seek', { bench, tick })))).map(({ moment }) => moment);
      /** @type {Timeline[]} */
      const timelines = (await Promise.all(benches.map((bench) => engine.request('timeline', { bench, from, to: tick })))).map(({ timeline }) => timeline);
      if (count !== benches.length) return;
      view.paint(moments.filter((moment) => moment !== null));
      view.history(timelines);
    } while (again && count > 0);
  }

  return comparison;
}

/** @typedef {ReturnType<typeof createComparison>} Comparison */
