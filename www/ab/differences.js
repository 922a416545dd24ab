import { fieldOf, readEvents, readValue, writeValue } from '../link.js';
import { decode, pack, unpack } from '../pack.js';
import { text } from '../ui/strings.en.js';

/** @import { Parameter, Scenario, Value } from '../types.js' */

/**
 * @typedef {{ key: string, value: Value, from: number }} Difference what B has in place of A's value, from a tick on; from
 *   tick 0 on it is part of the start
 * @typedef {{ name: string, base: Scenario }} Whole a preset with every field
 */

/**
 * The scenario of B: that of A with the differences. Changes that were made to A while it ran concern B too, except those
 * of a parameter that B has its own value of.
 *
 * @param {Scenario} scenario of A
 * @param {Difference[]} differences
 * @param {string} title
 * @returns {Scenario}
 */
export function besideOf(scenario, differences, title) {
  const shared = (scenario.events ?? []).filter((event) => !differences.some(({ key, from }) => key === event.key && event.tick >= from));
  const own = differences.filter(({ from }) => from > 0).map(({ key, value, from }) => ({ tick: from, key, value }));
  const start = Object.fromEntries(differences.filter(({ from }) => from === 0).map(({ key, value }) => [fieldOf(key), value]));
  return { ...scenario, ...start, title, events: [...shared, ...own].sort((a, b) => a.tick - b.tick) };
}

/**
 * The parameters in which two whole scenarios differ; never the seed, which both share.
 *
 * @param {Scenario} a
 * @param {(key: string) => Value} other
 * @param {Parameter[]} schema
 * @returns {Difference[]}
 */
export function differencesOf(a, other, schema) {
  const unlike = schema.filter(({ key, type }) => type !== 'seed' && other(key) !== a[fieldOf(key)]);
  return unlike.map(({ key }) => ({ key, value: other(key), from: 0 }));
}

/**
 * What the address says of B: a preset and what differs from it, or what differs from A.
 *
 * @param {Scenario} a
 * @param {Difference[]} differences
 * @param {Whole | null} preset
 * @param {Parameter[]} schema
 */
export async function writeDifferences(a, differences, preset, schema) {
  const parts = preset ? [`b.preset=${encodeURIComponent(preset.name)}`] : [];
  const start = differences.filter(({ from }) => from === 0);
  for (const parameter of schema) {
    const { key, type } = parameter;
    const value = start.find((difference) => difference.key === key)?.value ?? a[fieldOf(key)];
    if (type !== 'seed' && value !== (preset?.base ?? a)[fieldOf(key)]) parts.push(`b.${key}=${await writeValue(parameter, value)}`);
  }
  const later = differences.filter(({ from }) => from > 0).map(({ key, value, from }) => ({ tick: from, key, value }));
  if (later.length > 0) parts.push(`b.events=${await pack(JSON.stringify(later))}`);
  return parts.length > 0 ? parts : ['b=same'];
}

/**
 * Reads what a link says of B. Never throws: what cannot be read is named in `problems`, the rest is there.
 *
 * @param {[key: string, raw: string][]} pairs
 * @param {Parameter[]} schema
 * @param {string[]} presets
 * @param {string[]} problems
 */
export async function readDifferences(pairs, schema, presets, problems) {
  const read = { preset: '', values: /** @type {Map<string, Value>} */ (new Map()), later: /** @type {Difference[]} */ ([]), fingerprint: '' };
  for (const [full, raw] of pairs) {
    const key = full.slice(2);
    const parameter = schema.find((entry) => entry.key === key && entry.type !== 'seed');
    try {
      if (key === 'preset') {
        if (!presets.includes(decode(raw))) throw new Error(text.link.preset(decode(raw), presets));
        read.preset = decode(raw);
      } else if (key === 'events') read.later = readEvents(await unpack(raw), schema).map((event) => ({ key: event.key, value: event.value, from: event.tick }));
      else if (key === 'f') {
        if (!/^[0-9a-f]{16}$/.test(raw)) throw new Error(text.link.fingerprint(raw));
        read.fingerprint = raw;
      } else if (parameter) read.values.set(key, parameter.type === 'text' ? await unpack(raw) : readValue(parameter, decode(raw)));
      else if (full !== 'b') problems.push(text.link.unknown(full));
    } catch (error) {
      problems.push(text.link.bad(full, error instanceof Error ? error.message : String(error)));
    }
  }
  return read;
}
