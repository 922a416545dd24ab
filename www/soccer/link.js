import { fieldOf, readValue } from '../link.js';
import { decode, pack, splitOnce, unpack } from '../pack.js';
import { soccerText } from '../ui/strings.soccer.en.js';
import { text } from '../ui/strings.en.js';

/** @import { LiveEvent, Parameter, Value } from '../types.js' */
/** @import { Scenario } from './types.js' */

const BESIDE = 'soccer.blue'; // what B has a value of its own of

/**
 * @typedef {object} SoccerLink what a link says; everything that could be read
 * @property {string} version
 * @property {string} preset
 * @property {Map<string, Value>} values by full key
 * @property {LiveEvent[]} events what was done to the match
 * @property {number} tick
 * @property {string} fingerprint of the whole match
 * @property {string | null} beside in A | B, who coaches blue in B; null when A stands alone
 * @property {string[]} problems one sentence for each thing that could not be read
 */

/**
 * The whole scenario as the hash of an address: what differs from the preset, what was done to the match, what B has instead,
 * the moment.
 *
 * @param {{ version: string, preset: string, base: Scenario, scenario: Scenario, schema: Parameter[], beside: string | null, tick: number, fingerprint: string }} what
 */
export async function writeSoccerLink({ version, preset, base, scenario, schema, beside, tick, fingerprint }) {
  const parts = [`v=${version}`, `preset=${encodeURIComponent(preset)}`];
  for (const { key, type } of schema) {
    const value = scenario[fieldOf(key)];
    if (value === base[fieldOf(key)]) continue;
    parts.push(`${key}=${type === 'text' ? await pack(value) : encodeURIComponent(String(value))}`);
  }
  const events = scenario.events ?? [];
  if (events.length > 0) parts.push(`events=${await pack(JSON.stringify(events))}`);
  if (beside !== null) parts.push(`b.${BESIDE}=${encodeURIComponent(beside)}`);
  if (tick > 0) parts.push(`t=${tick}`);
  if (fingerprint) parts.push(`f=${fingerprint}`);
  return `#/soccer?${parts.join('&')}`;
}

/**
 * Reads a hash. Never throws: what cannot be read is named in `problems`, the rest is there.
 *
 * @param {string} hash
 * @param {Parameter[]} schema
 * @param {string[]} presets names that exist
 * @returns {Promise<SoccerLink>}
 */
export async function readSoccerLink(hash, schema, presets) {
  /** @type {SoccerLink} */
  const link = { version: '', preset: presets[0], values: new Map(), events: [], tick: 0, fingerprint: '', beside: null, problems: [] };
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
 * @param {SoccerLink} link
 * @param {string} key
 * @param {string} raw
 * @param {Parameter[]} schema
 * @param {string[]} presets
 */
async function readPair(link, key, raw, schema, presets) {
  const parameter = schema.find((entry) => entry.key === key);
  if (parameter) link.values.set(key, parameter.type === 'text' ? await unpack(raw) : readValue(parameter, decode(raw)));
  else if (key === `b.${BESIDE}`) link.beside = String(readValue(/** @type {Parameter} */ (schema.find((entry) => entry.key === BESIDE)), decode(raw)));
  else if (key === 'v') link.version = decode(raw);
  else if (key === 'events') link.events = readEvents(await unpack(raw));
  else if (key === 'preset') {
    const value = decode(raw);
    if (!presets.includes(value)) throw new Error(text.link.preset(value, presets));
    link.preset = value;
  } else if (key === 't') {
    if (!/^\d{1,9}$/.test(raw)) throw new Error(text.link.tick(raw));
    link.tick = Number(raw);
  } else if (key === 'f') {
    if (!/^[0-9a-f]{16}$/.test(raw)) throw new Error(text.link.fingerprint(raw));
    link.fingerprint = raw;
  } else link.problems.push(text.link.unknown(key));
}

/** The form of events; what they say is the engine's to judge. @param {string} json @returns {LiveEvent[]} */
function readEvents(json) {
  let events;
  try {
    events = JSON.parse(json);
  } catch {
    throw new Error(soccerText.link.events);
  }
  if (!Array.isArray(events)) throw new Error(soccerText.link.events);
  return events;
}
