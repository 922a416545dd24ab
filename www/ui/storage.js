const PREFIX = 'swarm-playground.';
/** Whether the page stands inside another one, where it keeps nothing. */
export const embedded = /[?&]embed=1(&|$)/.test(location.hash);
let warned = false;
/** @type {() => void} */
let warn = () => {};

/** What to do, once, when the browser keeps nothing. @param {() => void} tell */
export function onStorageBlocked(tell) {
  warn = tell;
}

/** @param {string} name @returns {string | null} null when there is nothing, or nothing may be read */
export function recall(name) {
  if (embedded) return null;
  try {
    return localStorage.getItem(PREFIX + name);
  } catch {
    return null;
  }
}

/** Keeps a text, or forgets it when null; everything works without. @param {string} name @param {string | null} value */
export function remember(name, value) {
  if (embedded) return;
  try {
    if (value === null) localStorage.removeItem(PREFIX + name);
    else localStorage.setItem(PREFIX + name, value);
  } catch {
    if (!warned) warn();
    warned = true;
  }
}
