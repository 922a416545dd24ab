import { joined } from '../pagekeys.js';

/**
 * A whole address.
 *
 * @param {string} hash the tab's own part
 * @param {string} page which parts are shown; empty for all
 */
export const addressOf = (hash, page) => new URL(joined(hash, page), location.href.replace(/#.*$/, '')).href;

/** What the page's part of an address is when these parts are hidden. @param {string[]} names */
export const hiding = (names) => (names.length > 0 ? `hide=${names.join(',')}` : '');

/** What the page's part of an address is in a frame. @param {string[]} names of the parts that are shown */
export const embedding = (names) => `embed=1&ui=${names.length > 0 ? names.join(',') : 'none'}`;

/** A line of HTML for a page of one's own. @param {string} address @param {string} title */
export function frameCode(address, title) {
  const quoted = (/** @type {string} */ value) => value.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');
  return `<iframe src="${quoted(address)}" title="${quoted(title)}" width="960" height="540" loading="lazy" style="border: 0"></iframe>`;
}
