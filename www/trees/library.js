/** @import { ScriptEvent } from './types.js' */

/**
 * @typedef {object} Entry a teaching tree
 * @property {string} name as in links
 * @property {string} title
 * @property {string} watch one line on what to watch
 * @property {'once' | 'exactly_once'} mode
 * @property {number} ms
 * @property {ScriptEvent[]} script
 * @property {number} length ticks that are run at once
 * @property {number} at the tick that is shown
 * @property {{ line: number, column: number } | null} compare the sequence or fallback to compare
 * @property {number | null} select
 * @property {() => Promise<string>} xml
 */

/** The teaching trees in order, the opening one first. @returns {Entry[]} */
export function readLibrary() {
  const texts = /** @type {Record<string, () => Promise<string>>} */ (import.meta.glob('/trees/*.xml', { query: '?raw', import: 'default' }));
  const lists = /** @type {Record<string, any[]>} */ (import.meta.glob('/trees/library.json', { import: 'default', eager: true }));
  return Object.values(lists)
    .flat()
    .map(({ file, title, watch, mode = 'once', ms = 100, script = [], length = 0, at = 0, compare = null, select = null }) => {
      return { name: file.replace(/\.xml$/, ''), title, watch, mode, ms, script, length, at, compare, select, xml: texts[`/trees/${file}`] };
    });
}
