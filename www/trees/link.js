import { decode, pack, splitOnce, unpack } from '../pack.js';
import { text } from '../ui/strings.en.js';
import { benchText } from '../ui/strings.trees.en.js';
import { written } from './script.js';

/** @import { Entry } from './library.js' */
/** @import { ScriptEvent } from './types.js' */

/**
 * @typedef {object} TreeLink what a link says; everything that could be read, null what it does not mention
 * @property {string} version
 * @property {string | null} entry
 * @property {string | null} xml
 * @property {ScriptEvent[] | null} script
 * @property {'once' | 'exactly_once' | null} mode
 * @property {number | null} ms
 * @property {number | null} length
 * @property {Spot | null | undefined} compare where the sequence or fallback stands whose kinds are compared; null for none,
 *   undefined where the link does not say
 * @property {number | null} tick
 * @property {string} fingerprint
 * @property {string[]} problems one sentence for each thing that could not be read
 */

/** @typedef {{ line: number, column: number }} Spot a place in the text, both from 1 */
/** @typedef {{ xml: string, script: ScriptEvent[], mode: 'once' | 'exactly_once', ms: number, length: number }} Base what a link is compared with */

/** @type {Base} what a link without a library entry is compared with */
const NOTHING = { xml: '', script: [], mode: 'once', ms: 100, length: 0 };
const MODES = /** @type {const} */ (['once', 'exactly_once']);
const NONE = 'none';
const LARGEST = { ms: 3_600_000, ticks: 100_000 };

/**
 * A run of a tree as the hash of an address: what differs from the library entry, what is compared, and where it stands.
 *
 * @param {{ version: string, entry: (Base & { name: string }) | null, setup: Base, compare: Spot | null, usual: Spot | null, tick: number, fingerprint: string }} what
 *   `usual` is what is compared where a link does not say
 */
export async function writeTreeLink({ version, entry, setup, compare, usual, tick, fingerprint }) {
  const base = entry ?? NOTHING;
  const parts = [`v=${version}`];
  if (entry) parts.push(`preset=${encodeURIComponent(entry.name)}`);
  if (setup.xml !== base.xml) parts.push(`xml=${await pack(setup.xml)}`);
  const script = written(setup.script);
  if (script !== written(base.script)) parts.push(`script=${await pack(script)}`);
  if (setup.mode !== base.mode) parts.push(`mode=${setup.mode}`);
  if (setup.ms !== base.ms) parts.push(`ms=${setup.ms}`);
  if (setup.length !== base.length) parts.push(`length=${setup.length}`);
  if (compare?.line !== usual?.line || compare?.column !== usual?.column) parts.push(`compare=${compare ? `${compare.line}.${compare.column}` : NONE}`);
  if (fingerprint) parts.push(`t=${tick}`, `f=${fingerprint}`);
  return `#/trees?${parts.join('&')}`;
}

/**
 * Reads a hash. Never throws: what cannot be read is named in `problems`, the rest is there.
 *
 * @param {string} hash
 * @param {Entry[]} library
 * @returns {Promise<TreeLink>}
 */
export async function readTreeLink(hash, library) {
  /** @type {TreeLink} */
  const link = { version: '', entry: null, xml: null, script: null, mode: null, ms: null, length: null, compare: undefined, tick: null, fingerprint: '', problems: [] };
  const [, query = ''] = splitOnce(hash, '?');
  for (const pair of query.split('&')) {
    if (!pair) continue;
    const [key, raw = ''] = splitOnce(pair, '=');
    try {
      await readPair(link, decode(key), raw, library);
    } catch (error) {
      link.problems.push(text.link.bad(key, error instanceof Error ? error.message : String(error)));
    }
  }
  return link;
}

/**
 * @param {TreeLink} link
 * @param {string} key
 * @param {string} raw
 * @param {Entry[]} library
 */
async function readPair(link, key, raw, library) {
  if (key === 'xml') link.xml = await unpack(raw);
  else if (key === 'script') link.script = readScript(await unpack(raw));
  else if (key === 'v') link.version = decode(raw);
  else if (key === 'preset') link.entry = one(decode(raw), library.map(({ name }) => name));
  else if (key === 'mode') link.mode = one(decode(raw), MODES);
  else if (key === 'ms') link.ms = whole(raw, LARGEST.ms);
  else if (key === 'length') link.length = whole(raw, LARGEST.ticks);
  else if (key === 'compare') link.compare = spot(raw);
  else if (key === 't') link.tick = whole(raw, LARGEST.ticks);
  else if (key === 'f') {
    if (!/^[0-9a-f]{16}$/.test(raw)) throw new Error(text.link.fingerprint(raw));
    link.fingerprint = raw;
  } else link.problems.push(text.link.unknown(key));
}

/** @template {string} T @param {string} found @param {readonly T[]} allowed @returns {T} */
function one(found, allowed) {
  const known = allowed.find((name) => name === found);
  if (known === undefined) throw new Error(text.link.preset(found, [...allowed]));
  return known;
}

/** A place in the text. @param {string} raw @returns {Spot | null} */
function spot(raw) {
  if (raw === NONE) return null;
  const [, line, column] = /^(\d{1,6})\.(\d{1,6})$/.exec(raw) ?? [];
  if (!line) throw new Error(benchText.link.compare(raw));
  return { line: Number(line), column: Number(column) };
}

/** @param {string} raw @param {number} most */
function whole(raw, most) {
  if (!/^\d{1,9}$/.test(raw) || Number(raw) > most) throw new Error(text.value.number(raw, true, 0, most));
  return Number(raw);
}

/**
 * A setup saved as a file; throws a sentence when it is none.
 *
 * @param {string} json
 */
export function readSetup(json) {
  const { xml, script = [], mode = 'once', ms = 100, length = 0, at = 0 } = JSON.parse(json);
  if (typeof xml !== 'string') throw new Error(benchText.noSetup);
  return {
    xml: xml.replaceAll('\r\n', '\n'),
    script: readScript(JSON.stringify(script)),
    mode: one(String(mode), MODES),
    ms: whole(String(ms), LARGEST.ms),
    length: whole(String(length), LARGEST.ticks),
    at: whole(String(at), LARGEST.ticks),
  };
}

/**
 * A script as it stands in links and files. What is in the events is for the engine to judge.
 *
 * @param {string} json
 * @returns {ScriptEvent[]}
 */
export function readScript(json) {
  let events;
  try {
    events = JSON.parse(json);
  } catch {
    throw new Error(benchText.link.script);
  }
  if (!Array.isArray(events) || !events.every((event) => Number.isSafeInteger(event?.tick))) throw new Error(benchText.link.script);
  return events;
}
