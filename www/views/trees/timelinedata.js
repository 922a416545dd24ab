/** @import { Timeline } from '../../trees/types.js' */

const BLOCK = 128; // ticks asked for at once
const KEPT = 96; // blocks in memory

/**
 * The columns of a run, fetched when they come into view and kept in blocks.
 *
 * @param {(from: number, to: number) => Promise<Timeline>} fetch
 * @param {() => void} arrived
 * @param {(failed: boolean) => void} told
 */
export function createColumns(fetch, arrived, told) {
  /** @type {Map<number, { columns: string[], roots: string[] }>} */
  const blocks = new Map();
  let wanted = { from: 1, to: 0, length: 0 };
  let asking = false;
  let generation = 0;

  /** The first stretch of wanted ticks that is missing, within one block. */
  function missing() {
    for (let index = Math.floor((wanted.from - 1) / BLOCK); index * BLOCK < wanted.to; index += 1) {
      const known = index * BLOCK + (blocks.get(index)?.columns.length ?? 0);
      if (known < Math.min((index + 1) * BLOCK, wanted.to)) return { index, from: known + 1, to: Math.min((index + 1) * BLOCK, wanted.length) };
    }
    return null;
  }

  async function ask() {
    const gap = asking ? null : missing();
    if (!gap) return;
    asking = true;
    const mine = generation;
    let failed = false;
    try {
      const { columns, roots } = await fetch(gap.from, gap.to);
      if (mine === generation && columns.length > 0) keep(gap.index, columns, roots);
      else failed = mine === generation;
    } catch {
      failed = mine === generation;
    }
    asking = false;
    told(failed);
    if (failed) return; // asked again when the view or the tick changes
    arrived();
    void ask();
  }

  /** @param {number} index @param {string[]} columns @param {string[]} roots */
  function keep(index, columns, roots) {
    const block = blocks.get(index) ?? { columns: [], roots: [] };
    block.columns.push(...columns);
    block.roots.push(...roots);
    blocks.delete(index); // the last one used stands last
    blocks.set(index, block);
    if (blocks.size > KEPT) blocks.delete(/** @type {number} */ (blocks.keys().next().value));
  }

  return {
    /** Asks for ticks, and for those beside them that exist. @param {number} from @param {number} to @param {number} length */
    want(from, to, length) {
      wanted = { from, to, length };
      void ask();
    },

    /** Letter of a node in a tick; of the root also `E`. Null while it is not known. @param {number} id @param {number} tick */
    letter(id, tick) {
      const block = blocks.get(Math.floor((tick - 1) / BLOCK));
      const at = (tick - 1) % BLOCK;
      if (!block || at >= block.columns.length) return null;
      return id === 0 && block.roots[at] === 'E' ? 'E' : (block.columns[at][id] ?? '.');
    },

    /** Whether the first `length` ticks might still be what is known here. @param {number} length */
    fits: (length) => [...blocks].every(([index, { columns }]) => index * BLOCK + columns.length <= length),

    forget() {
      blocks.clear();
      generation += 1;
    },
  };
}
