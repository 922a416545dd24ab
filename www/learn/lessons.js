import { learnText } from '../ui/strings.learn.en.js';

/** @import { Value } from '../types.js' */

/**
 * @typedef {Record<string, Value | unknown[]>} Values fields of a scenario that differ from its preset
 *
 * @typedef {object} World what stands beside the words
 * @property {'forage' | 'sequence' | 'trees' | 'studies' | 'soccer'} tab
 * @property {string} preset a scenario file, of the workbench a teaching tree, of the studies a study
 * @property {number} [seed]
 * @property {number} [tick]
 * @property {Values} [values]
 * @property {string} [xml] a tree of the lesson's own
 * @property {unknown[]} [script]
 * @property {number} [length]
 *
 * @typedef {object} Fact a number in the words; `tests/lessons.rs` says how each is checked
 * @property {number} value
 *
 * @typedef {{ from: number, to: number }} Range both ends included
 * @typedef {{ kind: 'runs', preset: string, seed: number, tick: number, measure: Measure, values?: Values, options: Record<string, { values?: Values, tick?: number }> }} RunsCheck
 *   right is the option that measures most
 * @typedef {{ kind: 'number', preset: string, seed: number, tick: number, measure: Measure, values?: Values, options: Record<string, Range> }} NumberCheck
 *   right is the option whose range holds what is measured
 * @typedef {{ kind: 'twins', preset: string, tick: number, options: Record<string, { seed: number, values?: Values }[]> }} TwinsCheck
 *   right is the option whose two runs have one fingerprint
 * @typedef {{ kind: 'derive', preset: string, seed: number, values: Values, options: Record<string, { codon: number, value: number }> }} DeriveCheck
 *   right is the option that changes the first robot's program
 * @typedef {{ kind: 'tree', tick: number, options: Record<string, { leaf: string, letter: string }> }} TreeCheck
 *   right is the option whose leaf returned that letter in the tick
 * @typedef {{ kind: 'orders', preset: string, seed: number, letters: string, options: Record<string, Range> }} OrdersCheck
 *   right is the option whose range holds the number of orders of these behaviours that reach the goal without a collision
 * @typedef {{ kind: 'wins', preset: string, seeds: number, tick: number, measure: Measure, values: Values, options: Record<string, [Values, Values]> }} WinsCheck
 *   right is the pair whose first is ahead of its second in most seeds, from 1 on
 * @typedef {{ kind: 'goal', tick: number, measure: Measure, least: number }} GoalCheck right when the world on screen measures so much
 * @typedef {{ kind: 'plan' }} PlanCheck right when the visitor's own plan reaches the goal
 * @typedef {RunsCheck | NumberCheck | TwinsCheck | DeriveCheck | TreeCheck | OrdersCheck | WinsCheck | GoalCheck | PlanCheck} Check
 * @typedef {'delivered' | 'knowing'} Measure
 *
 * @typedef {object} Lesson
 * @property {number} number from 1
 * @property {string} name
 * @property {World} world
 * @property {string[]} show parts of the tab that are seen
 * @property {Record<string, Fact>} facts
 * @property {Check} check
 *
 * @typedef {object} Words of a lesson, its numbers put in
 * @property {string} title
 * @property {string[]} body paragraphs
 * @property {string} ask
 * @property {Record<string, string>} options
 */

/** The lessons in order: files, read alike by the page and the tests. @returns {Lesson[]} */
export function readLessons() {
  const files = /** @type {Record<string, Omit<Lesson, 'number' | 'name'>>} */ (import.meta.glob('/lessons/*.json', { import: 'default', eager: true }));
  return Object.entries(files)
    .map(([path, lesson]) => {
      const [, number, name] = /(\d+)-([^/]+)\.json$/.exec(path) ?? ['', '0', ''];
      return { number: Number(number), name, ...lesson };
    })
    .sort((a, b) => a.number - b.number);
}

/** @param {Lesson} lesson @returns {Words} */
export function wordsOf({ name, facts }) {
  return learnText.lessons[name](Object.fromEntries(Object.entries(facts).map(([fact, { value }]) => [fact, value])));
}

const PREFIX = { forage: 'geese.', sequence: 'sequencing.', soccer: 'soccer.', trees: '', studies: '' };

/**
 * The world of a lesson as the hash of its tab.
 *
 * @param {Lesson} lesson
 */
export function worldHash({ world, show }) {
  const { tab, preset, seed, tick, values = {}, xml, script, length } = world;
  const written = (/** @type {unknown} */ value) => encodeURIComponent(typeof value === 'object' ? JSON.stringify(value) : String(value));
  const path = tab === 'studies' ? `#/studies/${preset}` : `#/${tab}`;
  const parts = tab === 'studies' ? [`size=${written(values.size ?? 'paper')}`] : xml ? [] : [`preset=${written(preset)}`];
  if (xml) parts.push(`xml=${written(xml)}`, `script=${written(script ?? [])}`, 'mode=exactly_once', `length=${length ?? 0}`);
  if (seed !== undefined) parts.push(`seed=${seed}`);
  if (tab !== 'studies') for (const [field, value] of Object.entries(values)) parts.push(`${PREFIX[tab]}${field}=${written(value)}`);
  if (tick) parts.push(`t=${tick}`);
  return `${path}?${parts.join('&')}&ui=${show.join(',') || 'none'}`;
}
