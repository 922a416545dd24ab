/** @import { Value } from '../types.js' */
/** @import { Difference } from './differences.js' */

/**
 * @typedef {object} Comparison
 * @property {string} name as in the texts
 * @property {string} a preset
 * @property {string} [b] preset
 * @property {[key: string, value: Value][]} [differences] what B has in place of A's values
 */

/** @type {Comparison[]} comparisons worth a look, each offered while its presets exist */
export const COMPARISONS = [
  { name: 'paper-robust', a: 'foraging-paper', b: 'foraging' },
  { name: 'paper-published', a: 'foraging-paper', b: 'published' },
  { name: 'betr-geese-bt', a: 'foraging-paper', b: 'geese-bt' },
  {
    name: 'selection-none',
    a: 'foraging',
    differences: [
      ['geese.parent-share', 1],
      ['geese.genome-selection', 'random'],
    ],
  },
];

/**
 * The name of the comparison that is on screen; empty when it is none of these.
 *
 * @param {string} a A's preset
 * @param {string} b B's preset; empty when it is none as it is
 * @param {Difference[]} differences
 */
export function comparisonOf(a, b, differences) {
  const holds = (/** @type {[string, Value]} */ [key, value]) => differences.some((difference) => difference.key === key && difference.value === value && difference.from === 0);
  const found = COMPARISONS.find((offered) => {
    if (offered.a !== a) return false;
    if (offered.b) return offered.b === b;
    return offered.differences?.length === differences.length && offered.differences.every(holds);
  });
  return found?.name ?? '';
}
