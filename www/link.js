import { decode, pack, splitOnce, unpack } from './pack.js';
import { text } from './ui/strings.en.js';

/** @import { Parameter, Scenario, Value, LiveEvent } from './types.js' */

/**
 * @typedef {object} LinkParts what a link says; everything that could be read
 * @property {string} route
 * @property {string} version
 * @property {string} preset
 * @property {Map<string, Value>} values by full key
 * @property {LiveEvent[]} events
 * @property {number | null} tick
 * @property {string} fingerprint
 * @property {[key: string, raw: string][]} beside what the link says of B in A | B; empty when there is none
 * @property {string[]} problems one sentence for each thing that could not be read
 */

export const LARGEST_SEED = Number.MAX_SAFE_INTEGER;

/** Name of a parameter's field in a scenario. @param {string} key */
export const fieldOf = (key) => key.slice(key.indexOf('.') + 1);

/**
 * The whole scenario as the hash of an address: what differs from the preset, and where the run stands.
 *
 * @param {{ version: string, preset: string, base: Scenario, scenario: Scenario, schema: Parameter[], tick: number, fingerprint: string, beside: string[] }} what
 *   `beside` is what A | B adds
 */
export async function writeLink({ version, preset, base, scenario, schema, tick, fingerprint, beside }) {
  const parts = [`v=${version}`, `preset=${encodeURIComponent(preset)}`];
  for (const parameter of schema) {
    const value = scenario[fieldOf(parameter.key)];
    if (value === base[fieldOf(parameter.key)]) continue;
    parts.push(`${parameter.key}=${await writeValue(parameter, value)}`);
  }
  if (scenario.events?.length) parts.push(`events=${await pack(JSON.stringify(scenario.events))}`);
  parts.push(...beside);
  if (tick > 0) parts.push(`t=${tick}`, `f=${fingerprint}`);
  return `#/forage?${parts.join('&')}`;
}

/** The last long texts with what they became: a population is packed once and not with every address. @type {[string, string][]} */
const packed = [];

/** A value as it stands in links. @param {Parameter} parameter @param {Value} value */
export async function writeValue({ type }, value) {
  const string = String(value);
  if (type !== 'text') return encodeURIComponent(string);
  const known = packed.find(([original]) => original === string);
  if (known) return known[1];
  const written = await pack(string);
  packed.unshift([string, written]);
  packed.length = Math.min(packed.length, 4);
  return written;
}

/**
 * Reads a hash. Never throws: what cannot be read is named in `problems`, the rest is there.
 *
 * @param {string} hash
 * @param {Parameter[]} schema
 * @param {string[]} presets names that exist
 * @returns {Promise<LinkParts>}
 */
export async function readLink(hash, schema, presets) {
  /** @type {LinkParts} */
  const parts = { route: 'forage', version: '', preset: presets[0], values: new Map(), events: [], tick: null, fingerprint: '', beside: [], problems: [] };
  const [path, query = ''] = splitOnce(hash.replace(/^#?\/?/, ''), '?');
  if (path && path !== 'forage') parts.problems.push(text.link.route(path));
  for (const pair of query.split('&')) {
    if (!pair) continue;
    const [key, raw = ''] = splitOnce(pair, '=');
    try {
      await readPair(parts, decodeURIComponent(key), raw, schema, presets);
    } catch (error) {
      parts.problems.push(text.link.bad(key, error instanceof Error ? error.message : String(error)));
    }
  }
  return parts;
}

/**
 * @param {LinkParts} parts
 * @param {string} key
 * @param {string} raw
 * @param {Parameter[]} schema
 * @param {string[]} presets
 */
async function readPair(parts, key, raw, schema, presets) {
  if (key === 'b' || key.startsWith('b.')) {
    parts.beside.push([key, raw]);
    return;
  }
  if (key === 'events') {
    parts.events = readEvents(await unpack(raw), schema);
    return;
  }
  const parameter = schema.find((entry) => entry.key === key);
  if (parameter?.type === 'text') {
    parts.values.set(key, await unpack(raw));
    return;
  }
  const value = decode(raw);
  if (parameter) parts.values.set(key, readValue(parameter, value));
  else if (key === 'v') parts.version = value;
  else if (key === 'preset') {
    if (!presets.includes(value)) throw new Error(text.link.preset(value, presets));
    parts.preset = value;
  } else if (key === 't') {
    if (!/^\d{1,9}$/.test(value)) throw new Error(text.link.tick(value));
    parts.tick = Number(value);
  } else if (key === 'f') {
    if (!/^[0-9a-f]{16}$/.test(value)) throw new Error(text.link.fingerprint(value));
    parts.fingerprint = value;
  } else parts.problems.push(text.link.unknown(key));
}

/**
 * A value typed by hand or read from a link; throws an Error that says what was found and what is allowed.
 *
 * @param {Parameter} parameter
 * @param {string} written
 * @returns {Value}
 */
export function readValue(parameter, written) {
  const { type, choices } = parameter;
  if (type === 'bool') {
    if (written !== 'true' && written !== 'false') throw new Error(text.value.bool(written));
    return written === 'true';
  }
  if (type === 'choice') {
    if (!choices?.some((choice) => choice.value === written)) throw new Error(text.value.choice(written, choices ?? []));
    return written;
  }
  if (type === 'text') return written;
  return readNumber(parameter, written);
}

/** @param {Parameter} parameter @param {string} written */
function readNumber({ type, min, max, hard_max: hardMax }, written) {
  const whole = type === 'int' || type === 'seed';
  const low = type === 'seed' ? 0 : (min ?? -Infinity);
  const high = type === 'seed' ? LARGEST_SEED : (hardMax ?? max ?? Infinity);
  const trimmed = written.trim();
  const number = Number(trimmed);
  const shaped = whole ? /^[+-]?\d+$/.test(trimmed) : trimmed !== '' && Number.isFinite(number);
  if (!shaped || number < low || number > high) throw new Error(text.value.number(written, whole, low, high));
  return number;
}

/** @param {string} json @param {Parameter[]} schema @returns {LiveEvent[]} */
export function readEvents(json, schema) {
  const events = JSON.parse(json);
  if (!Array.isArray(events)) throw new Error(text.link.events);
  for (const event of events) {
    const parameter = schema.find((entry) => entry.key === event?.key);
    if (!parameter || !Number.isSafeInteger(event.tick)) throw new Error(text.link.events);
    readValue(parameter, String(event.value));
  }
  return events;
}
