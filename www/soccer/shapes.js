/** @import { Engine } from '../engine.js' */
/** @import { Trees } from './types.js' */

const MOST = 12; // texts whose trees are kept

/**
 * The trees of texts as they are drawn; each text is asked for once.
 *
 * @param {Pick<Engine, 'request'>} engine
 */
export function createShapes(engine) {
  /** @type {Map<string, Promise<Trees>>} */
  const known = new Map();

  /** Problems and trees of a text. @param {'coach' | 'roles'} what @param {string} xml @returns {Promise<Trees>} */
  function read(what, xml) {
    const key = `${what} ${xml}`;
    /** @type {Promise<Trees>} */
    const found = known.get(key) ?? engine.request('trees', { what, xml });
    known.delete(key);
    known.set(key, found);
    found.catch(() => known.delete(key));
    for (const oldest of known.keys()) {
      if (known.size <= MOST) break;
      known.delete(oldest);
    }
    return found;
  }

  return {
    read,
    /** The nodes of one tree; null when the text has a fault. @param {'coach' | 'roles'} what @param {string} xml @param {string} name */
    of: async (what, xml, name) => (await read(what, xml)).trees?.[name] ?? null,
  };
}

/** @typedef {ReturnType<typeof createShapes>} TreeShapes */
