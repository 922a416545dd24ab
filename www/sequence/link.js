import { fieldOf, readValue } from '../link.js';
import { decode, pack, splitOnce, unpack } from '../pack.js';
import { sequenceText } from '../ui/strings.sequence.en.js';
import { text } from '../ui/strings.en.js';

/** @import { Parameter, Value } from '../types.js' */
/** @import { Scenario } from './types.js' */

/**
 * @typedef {object} SequenceLink what a link says; everything that could be read
 * @property {string} version
 * @property {string} preset
 * @property {Map<string, Value | unknown[]>} values by full key
 * @property {string | null} plan letters of a plan made by hand
 * @property {string | null} beside in A | B, in what the two differ; null when the map stands alone
 * @property {number} step the moment, in steps of 0.1 s
 * @property {string[]} problems one sentence for each thing that could not be read
 */

const MOST_STEPS = 72_000;
const PLAIN = /^[\w.-]*$/; // letters that stand in an address as they are

/**
 * The whole scenario as the hash of an address: what differs from the preset, the plan made by hand, what A | B compares, the
 * moment.
 *
 * @param {{ version: string, preset: string, base: Scenario, scenario: Scenario, schema: Parameter[], plan: string | null, beside: string | null, step: number }} what
 */
export async function writeSequenceLink({ version, preset, base, scenario, schema, plan, beside, step }) {
  const parts = [`v=${version}`, `preset=${encodeURIComponent(preset)}`];
  for (const { key, type } of schema) {
    const value = scenario[fieldOf(key)];
    const written = JSON.stringify(value);
    if (written === JSON.stringify(base[fieldOf(key)])) continue;
    parts.push(`${key}=${type === 'list' ? await pack(written) : encodeURIComponent(String(value))}`);
  }
  if (plan !== null) parts.push(`plan=${encodeURIComponent(plan)}`);
  if (beside !== null) parts.push(`b=${beside}`);
  if (step > 0) parts.push(`t=${step}`);
  return `#/sequence?${parts.join('&')}`;
}

/**
 * Reads a hash. Never throws: what cannot be read is named in `problems`, the rest is there.
 *
 * @param {string} hash
 * @param {Parameter[]} schema
 * @param {string[]} presets names that exist
 * @returns {Promise<SequenceLink>}
 */
export async function readSequenceLink(hash, schema, presets) {
  /** @type {SequenceLink} */
  const link = { version: '', preset: presets[0], values: new Map(), plan: null, beside: null, step: 0, problems: [] };
  const [, query = ''] = splitOnce(hash, '?');
  for (const pair of query.split('&')) {
    if (!pair) continue;
    const [key, raw = ''] = splitOnce(pair, '=');
    try {
      await readPair(link, decode(key), raw, schema, presets);
    } catch (error) {
      link.problems.push(text.link.bad(key, error instanceof Error ? error.message : String(error)));
    }
  }
  return link;
}

/**
 * @param {SequenceLink} link
 * @param {string} key
 * @param {string} raw
 * @param {Parameter[]} schema
 * @param {string[]} presets
 */
async function readPair(link, key, raw, schema, presets) {
  const parameter = schema.find((entry) => entry.key === key);
  if (parameter) link.values.set(key, await readAny(parameter, raw));
  else if (key === 'v') link.version = decode(raw);
  else if (key === 'plan') link.plan = PLAIN.test(raw) ? raw : decode(raw);
  else if (key === 'preset') {
    const value = decode(raw);
    if (!presets.includes(value)) throw new Error(text.link.preset(value, presets));
    link.preset = value;
  } else if (key === 'b') {
    const pairs = sequenceText.compare.pairs.map(([name]) => name);
    const value = decode(raw);
    if (!pairs.includes(value)) throw new Error(text.link.preset(value, pairs));
    link.beside = value;
  } else if (key === 't') {
    if (!/^\d{1,5}$/.test(raw) || Number(raw) > MOST_STEPS) throw new Error(text.value.number(raw, true, 0, MOST_STEPS));
    link.step = Number(raw);
  } else link.problems.push(text.link.unknown(key));
}

/** @param {Parameter} parameter @param {string} raw */
async function readAny(parameter, raw) {
  return parameter.type === 'list' ? readList(await unpack(raw)) : readValue(parameter, decode(raw));
}

/** A list as it is written in links and fields; throws a sentence. @param {string} json @returns {unknown[]} */
export function readList(json) {
  let list;
  try {
    list = JSON.parse(json);
  } catch {
    throw new Error(sequenceText.list(json));
  }
  if (!Array.isArray(list)) throw new Error(sequenceText.list(json));
  return list;
}
