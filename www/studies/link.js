import { decode, pack, splitOnce, unpack } from '../pack.js';
import { text } from '../ui/strings.en.js';
import { SIZES } from './types.js';

/** @import { Size } from './types.js' */

/**
 * @typedef {object} StudyLink what a link says; everything that could be read
 * @property {string} version
 * @property {string | null} name of a study file
 * @property {string | null} spec of a study of one's own
 * @property {Size | null} size
 * @property {string[]} problems one sentence for each thing that could not be read
 */

/** The list of studies. */
export const LIST = '#/studies';

/**
 * A study as the hash of an address: a study file by its name, any other as its text.
 *
 * @param {{ version: string, name: string | null, spec: string, size: Size }} what
 */
export async function writeStudyLink({ version, name, spec, size }) {
  const own = name === null ? `&spec=${await pack(spec)}` : '';
  return `${LIST}${name === null ? '' : `/${encodeURIComponent(name)}`}?v=${version}&size=${size}${own}`;
}

/**
 * Reads a hash. Never throws: what cannot be read is named in `problems`, the rest is there.
 *
 * @param {string} hash
 * @param {string[]} names of the study files
 * @returns {Promise<StudyLink>}
 */
export async function readStudyLink(hash, names) {
  /** @type {StudyLink} */
  const link = { version: '', name: null, spec: null, size: null, problems: [] };
  const [path, query = ''] = splitOnce(hash.replace(/^#?\/?/, ''), '?');
  const [, name = ''] = splitOnce(path, '/');
  const tries = query.split('&').filter((pair) => pair !== '').map((pair) => splitOnce(pair, '='));
  if (name !== '') tries.unshift(['study', name]);
  for (const [key, raw = ''] of tries) {
    try {
      if (key === 'study') link.name = one(decode(raw), names);
      else if (key === 'size') link.size = one(decode(raw), SIZES);
      else if (key === 'spec') link.spec = await unpack(raw);
      else if (key === 'v') link.version = decode(raw);
      else link.problems.push(text.link.unknown(key));
    } catch (error) {
      link.problems.push(text.link.bad(key, error instanceof Error ? error.message : String(error)));
    }
  }
  return link;
}

/** @template {string} T @param {string} found @param {readonly T[]} allowed @returns {T} */
function one(found, allowed) {
  const known = allowed.find((name) => name === found);
  if (known === undefined) throw new Error(text.link.preset(found, [...allowed]));
  return known;
}
