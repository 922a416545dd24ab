import { embedded } from '../ui/storage.js';

const NAME = 'swarm-playground.studies';
const ROWS = 'rows';

/** @typedef {{ study: string, run: number, line: string }} Kept one row; `study` is version and hash */

/** By what rows are kept: results of different versions never mix. @param {string} version @param {string} hash */
export const keyOf = (version, hash) => `${version}/${hash}`;

/**
 * Rows of results, kept by the browser as they come; in memory where it keeps nothing, so that everything works.
 *
 * @param {(full: boolean) => void} tell called once when nothing can be kept, because there is no storage or it is full
 */
export function createStore(tell) {
  /** @type {Promise<IDBDatabase | null> | null} */
  let opening = null;
  let told = false;
  /** @type {Map<string, Map<number, string>>} lines that could not be kept, by study */
  const memory = new Map();

  /** @param {unknown} [error] */
  function lost(error) {
    if (!told) tell(error instanceof DOMException && error.name === 'QuotaExceededError');
    told = true;
  }

  /** @returns {Promise<IDBDatabase | null>} */
  function database() {
    if (embedded) return Promise.resolve(null); // rows stay in memory
    opening ??= open().catch((error) => {
      lost(error);
      return null;
    });
    return opening;
  }

  /** @returns {Promise<IDBDatabase>} */
  function open() {
    return new Promise((resolve, reject) => {
      const request = indexedDB.open(NAME, 1);
      request.onupgradeneeded = () => void request.result.createObjectStore(ROWS, { keyPath: ['study', 'run'] });
      request.onerror = () => reject(request.error);
      request.onblocked = () => reject(new Error('blocked'));
      request.onsuccess = () => {
        request.result.onversionchange = () => request.result.close();
        resolve(request.result);
      };
    });
  }

  /**
   * @template T
   * @param {IDBTransactionMode} mode
   * @param {(rows: IDBObjectStore) => IDBRequest<T>} ask
   * @returns {Promise<T | null>} null when nothing can be kept
   */
  async function within(mode, ask) {
    const open = await database();
    if (!open) return null;
    try {
      return await new Promise((resolve, reject) => {
        const transaction = open.transaction(ROWS, mode);
        const request = ask(transaction.objectStore(ROWS));
        transaction.oncomplete = () => resolve(request.result);
        transaction.onabort = () => reject(transaction.error);
        transaction.onerror = () => reject(transaction.error);
      });
    } catch (error) {
      lost(error);
      return null;
    }
  }

  /** All rows of a study. @param {string} study */
  const all = (study) => IDBKeyRange.bound([study, 0], [study, Number.MAX_SAFE_INTEGER]);

  return {
    /** The lines that are kept, by run. @param {string} study @returns {Promise<Map<number, string>>} */
    async load(study) {
      const rows = /** @type {Kept[] | null} */ (await within('readonly', (store) => store.getAll(all(study))));
      return new Map([...(memory.get(study) ?? []), ...(rows ?? []).map(({ run, line }) => /** @type {[number, string]} */ ([run, line]))]);
    },

    /** @param {string} study @param {number} run @param {string} line */
    async keep(study, run, line) {
      if ((await within('readwrite', (store) => store.put({ study, run, line }))) !== null) return;
      const lines = memory.get(study) ?? new Map();
      memory.set(study, lines.set(run, line));
    },

    /** @param {string} study */
    async clear(study) {
      memory.delete(study);
      await within('readwrite', (store) => store.delete(all(study)));
    },

    /** How many rows are kept, by study. @returns {Promise<Map<string, number>>} */
    async counts() {
      const keys = await within('readonly', (store) => store.getAllKeys());
      /** @type {Map<string, number>} */
      const counts = new Map([...memory].map(([study, lines]) => [study, lines.size]));
      for (const key of keys ?? []) {
        const [study] = /** @type {[string, number]} */ (key);
        counts.set(study, (counts.get(study) ?? 0) + 1);
      }
      return counts;
    },
  };
}

/** @typedef {ReturnType<typeof createStore>} Store */
