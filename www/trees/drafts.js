import { recall, remember } from '../ui/storage.js';

/** @import { Rest } from './setup.js' */

/** @typedef {Rest & { id: string, xml: string, length: number, at: number }} Draft what was typed and can be had again */

const KEY = 'drafts.trees';
const MOST = 5;

/**
 * What was typed, kept in the browser: one draft for each tree that was opened and changed, the newest first.
 */
export function createDrafts() {
  let list = read();
  let id = newId();

  return {
    /** Drafts of other trees than the one on screen. */
    others: () => list.filter((draft) => draft.id !== id),

    /** Another tree is on screen: what is typed from now on is a draft of its own. @param {string} [known] a draft that is taken up again */
    begin(known = newId()) {
      id = known;
    },

    /** Keeps what is on screen, or forgets it when null: it says what a library entry says. @param {Omit<Draft, 'id'> | null} draft */
    keep(draft) {
      const others = list.filter((entry) => entry.id !== id);
      list = draft ? [{ id, ...draft }, ...others].slice(0, MOST) : others;
      remember(KEY, list.length > 0 ? JSON.stringify(list) : null);
    },
  };
}

/** @returns {string} */
const newId = () => crypto.randomUUID();

/** @returns {Draft[]} */
function read() {
  try {
    const list = JSON.parse(recall(KEY) ?? '[]');
    return Array.isArray(list) ? list.filter((draft) => typeof draft?.xml === 'string' && Array.isArray(draft.script)) : [];
  } catch {
    return [];
  }
}

/** @typedef {ReturnType<typeof createDrafts>} Drafts */
