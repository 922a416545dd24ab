import { recall, remember } from '../ui/storage.js';

const KEPT = 'learn';

/** Names of the lessons whose question was answered rightly, kept in this browser only. @returns {Set<string>} */
export function done() {
  return new Set((recall(KEPT) ?? '').split(' ').filter(Boolean));
}

/** @param {string} name */
export function finish(name) {
  remember(KEPT, [...done().add(name)].join(' '));
}

export const forget = () => remember(KEPT, null);
