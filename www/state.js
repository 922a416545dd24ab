/**
 * @typedef {'loading' | 'paused' | 'running' | 'finished' | 'busy' | 'error'} StateName
 */

/** @type {Record<StateName, StateName[]>} which states may follow which */
const NEXT = {
  loading: ['paused', 'running', 'finished', 'busy', 'error'],
  paused: ['loading', 'running', 'finished', 'busy', 'error'],
  running: ['loading', 'paused', 'finished', 'busy', 'error'],
  finished: ['loading', 'paused', 'busy', 'error'],
  busy: ['loading', 'paused', 'finished', 'error'],
  error: ['loading'],
};

/**
 * The one state of a tab, mirrored as `data-state` on its element; the body carries the open tab's.
 *
 * @param {HTMLElement} element
 */
export function createState(element) {
  /** @type {((name: StateName, reason: string) => void)[]} */
  const listeners = [];
  const state = {
    /** @type {StateName} */
    name: 'loading',
    /** Why: how a run finished, what failed. Empty for the other states. */
    reason: '',

    /**
     * Moves on, if `name` may follow the present state, and says whether it did.
     *
     * @param {StateName} name
     * @param {string} [reason]
     */
    to(name, reason = '') {
      if (name !== state.name && !NEXT[state.name].includes(name)) return false;
      if (name === state.name && reason === state.reason) return true;
      state.name = name;
      state.reason = reason;
      element.dataset.state = name;
      for (const listener of listeners) listener(name, reason);
      return true;
    },

    /** @param {(name: StateName, reason: string) => void} listener */
    on(listener) {
      listeners.push(listener);
    },
  };
  return state;
}

/** @typedef {ReturnType<typeof createState>} State */
