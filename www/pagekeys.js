import { splitOnce } from './pack.js';

const KEYS = /^(hide|ui|embed)=/;

/**
 * A hash in two: what the tab reads, and what tells the page which parts of it to show (`hide`, `ui`, `embed`).
 *
 * @param {string} hash
 * @returns {{ own: string, page: string }} `page` as it stood in the hash, empty when nothing did
 */
export function parted(hash) {
  const [path, query = ''] = splitOnce(hash, '?');
  const pairs = query.split('&');
  const page = pairs.filter((pair) => KEYS.test(pair));
  if (page.length === 0) return { own: hash, page: '' };
  const own = pairs.filter((pair) => !KEYS.test(pair));
  return { own: own.length > 0 ? `${path}?${own.join('&')}` : path, page: page.join('&') };
}

/** The whole hash again; a tab's own part is always written first. @param {string} own @param {string} page */
export const joined = (own, page) => (page && own ? `${own}${own.includes('?') ? '&' : '?'}${page}` : own);

/**
 * The same address in the folder in which a site keeps a version, `vX.Y.Z` beside the page.
 *
 * @param {string} address
 * @param {string} version
 */
export function pinned(address, version) {
  const url = new URL(address);
  url.pathname = `${url.pathname.replace(/[^/]*$/, '').replace(/\/v\d+\.\d+\.\d+\/$/, '/')}v${version}/`;
  return url.href;
}

/** What a notice offers about a link that another version made; nothing when it names none. @param {string} version @param {string} label */
export const olderVersion = (version, label) => (/^\d{1,4}\.\d{1,4}\.\d{1,4}$/.test(version) ? [{ label, press: () => location.assign(pinned(location.href, version)) }] : []);

/**
 * The names a key of `page` lists; empty when it is not there.
 *
 * @param {string} page
 * @param {'hide' | 'ui'} key
 * @returns {string[]}
 */
export function listed(page, key) {
  const pair = page.split('&').find((part) => part.startsWith(`${key}=`));
  return pair ? pair.slice(key.length + 1).replaceAll('%2C', ',').split(',').filter(Boolean) : [];
}
