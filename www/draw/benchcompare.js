/** @import { BenchNode, Timeline } from '../trees/types.js' */

/** @typedef {{ type: string, nodes: BenchNode[] }} Form a form of a tree, with the type of the node that differs */

/**
 * @typedef {object} Difference where forms part, and what each does there
 * @property {number} tick
 * @property {string | null} leaf name of the first leaf that differs; null when only the roots do
 * @property {{ types: string[], letter: string, again: boolean }[]} groups forms that do the same; again: the leaf was
 *   ticked before, as far as is known
 */

/** Leaves of a tree, in order. @param {BenchNode[]} nodes */
export const leavesOf = (nodes) => nodes.filter(({ id, end }) => end === id + 1);

/**
 * The ticks of several forms beside each other. Leaves are matched by their order.
 *
 * @param {Form[]} forms
 * @param {Timeline[]} histories
 */
export function compareForms(forms, histories) {
  const leaves = forms.map(({ nodes }) => leavesOf(nodes).map(({ id }) => id));
  const rows = Math.min(...leaves.map((ids) => ids.length));
  const from = Math.max(1, ...histories.map((history) => history.from));
  const to = histories.length < forms.length || forms.length === 0 ? 0 : Math.min(...histories.map((history) => history.from + history.columns.length - 1));

  /** @param {number} form @param {number} row @param {number} tick */
  const letter = (form, row, tick) => histories[form]?.columns[tick - histories[form].from]?.[leaves[form][row]] ?? null;
  /** @param {number} form @param {number} tick */
  const root = (form, tick) => histories[form].roots[tick - histories[form].from] ?? '.';
  /** @param {(form: number) => string | null} of */
  const parts = (of) => forms.some((_, form) => of(form) !== of(0));

  /** Whether a leaf differs between the forms. @param {number} row @param {number} tick */
  const differs = (row, tick) => tick >= from && tick <= to && row < rows && parts((form) => letter(form, row, tick));

  /** @param {number} tick @param {number | null} row @returns {Difference} */
  function difference(tick, row) {
    /** @type {Map<string, string[]>} */
    const groups = new Map();
    forms.forEach(({ type }, form) => {
      const found = row === null ? root(form, tick) : (letter(form, row, tick) ?? '.');
      groups.set(found, [...(groups.get(found) ?? []), type]);
    });
    const before = Array.from({ length: tick - from }, (_, at) => from + at);
    const again = row !== null && before.some((earlier) => /[SFRK]/.test(letter(0, row, earlier) ?? ''));
    const leaf = row === null ? null : forms[0].nodes[leaves[0][row]].name;
    const order = [...groups].sort(([a], [b]) => rank(a) - rank(b));
    return { tick, leaf, groups: order.map(([found, types]) => ({ types, letter: found, again })) };
  }

  /** @returns {Difference | null} */
  function first() {
    for (let tick = from; tick <= to && forms.length > 1; tick += 1) {
      for (let row = 0; row < rows; row += 1) if (differs(row, tick)) return difference(tick, row);
      if (parts((form) => root(form, tick))) return difference(tick, null);
    }
    return null;
  }

  return { from, to, letter, differs, first: first() };
}

/** Those who tick a leaf come before those who do not. @param {string} letter */
const rank = (letter) => ('SFRKE'.includes(letter) ? 0 : letter === 'H' ? 1 : 2);
