const PREFIX = 'swarm-playground.';
let warned = false;
/** @type {() => void} */
let warn = () => {};

/** What to do, once, when the browser keeps nothing. @param {() => void} tell */
export function onStorageBlocked(tell) {
  warn = tell;
}

/** @param {string} name @returns {string | null} null when there is nothing, or nothing may be read */
export function recall(name) {
  try {
    return localStorage.getItem(PREFIX + name);
  } catch {
    return null;
  }
}

/** Keeps a text, or forgets it when null; everything works without. @param {string} name @param {string | null} value */
export function remember(name, value) {
  try {
    if (value === null) localStorage.removeItem(PREFIX + name);
    else localStorage.setItem(PREFIX + name, value);
  } catch {
    if (!warned) warn();
    warned = true;
  }
}
