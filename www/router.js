import { text } from './ui/strings.en.js';
import { button, h } from './ui/dom.js';
import { splitOnce } from './pack.js';

/** @import { State } from './state.js' */
/** @import { Keys } from './ui/keys.js' */

/**
 * @typedef {object} Tab what a tab gives once its script is there
 * @property {State} state
 * @property {Record<string, () => void>} actions by the names in the keys table; complete when `built` was called
 * @property {HTMLElement[]} regions where single keys act
 * @property {(hash: string) => Promise<void>} open shows what an address says; the first time it also starts the engine
 * @property {() => void} pause
 *
 * @typedef {object} Address a tab's own part of the address line
 * @property {(hash: string, push?: boolean) => void} write what the tab shows now; kept for later while another tab is open
 * @property {(hash: string) => boolean} knows whether the tab wrote this hash last
 *
 * @typedef {object} Place one tab of the page
 * @property {string} name as in the address
 * @property {string} label
 * @property {HTMLElement} element shown while the tab is open
 * @property {boolean} [aside] whether it is linked from elsewhere than the header
 * @property {boolean} [deep] whether its addresses go on after its name, as in `#/studies/success`
 * @property {(parts: { address: Address, built: () => void }) => Promise<Tab>} load called once, when the tab is opened first
 *
 * @typedef {Place & { link: HTMLAnchorElement, loading: Promise<Tab> | null, tab: Tab | null, opened: boolean, kept: string, left: string, scroll: number }} Room
 *   a place with its link in the header, the hash it wrote last and the hash it was left at
 */

/**
 * Tabs by hash route. A tab is loaded when it is opened first; one that is left is paused and finds its address again.
 *
 * @param {{ places: Place[], nav: HTMLElement, keys: Keys }} parts
 */
export function createRouter({ places, nav, keys }) {
  /** @type {Room[]} */
  const rooms = places.map((place) => {
    const link = h('a', { href: `#/${place.name}`, 'data-action': `tab-${place.name}` }, place.label);
    return { ...place, link, loading: null, tab: null, opened: false, kept: '', left: '', scroll: 0 };
  });
  /** @type {Room | null} */
  let current = null;
  let standing = location.hash; // the address before the change that is being told
  let told = location.hash; // the address as it was arrived at or written last; another one is a step back or forward not told of yet

  nav.append(...rooms.filter(({ aside }) => !aside).map(({ link }) => link));
  nav.addEventListener('click', (event) => {
    if (event.target === current?.link) event.preventDefault(); // it is open already, and its address says more than the link's
  });
  window.addEventListener('hashchange', (event) => {
    standing = new URL(event.oldURL).hash;
    void arrive(location.hash);
  });

  /**
   * Goes where the address points.
   *
   * @param {string} hash
   * @returns {Promise<Tab | null>} null when the tab could not be loaded
   */
  async function arrive(hash) {
    told = location.hash;
    const room = roomOf(hash);
    const moved = room !== current;
    if (moved) change(room);
    const tab = await loaded(room);
    if (!tab || room !== current) return tab;
    const [path, query] = splitOnce(hash.replace(/^#?\/?/, ''), '?');
    const bare = !query && (path === room.name || path === '');
    if (room.opened && moved && (bare || hash === room.left || hash === room.kept)) {
      if (room.kept) history.replaceState(null, '', room.kept);
      told = location.hash;
    } else if (!room.opened || hash !== room.kept) {
      room.opened = true;
      await tab.open(hash);
    }
    return tab;
  }

  /** @param {string} hash */
  function roomOf(hash) {
    const [path] = splitOnce(hash.replace(/^#?\/?/, ''), '?');
    const [tab] = splitOnce(path, '/');
    return rooms.find(({ name, deep }) => name === (deep ? tab : path)) ?? rooms[0]; // the first tab names what it does not know
  }

  /** Shows another tab. @param {Room} room */
  function change(room) {
    if (current) {
      current.tab?.pause();
      current.left = standing;
      current.scroll = scrollY;
      current.link.removeAttribute('aria-current');
    }
    current = room;
    room.link.setAttribute('aria-current', 'page');
    for (const { element } of rooms) element.hidden = element !== room.element;
    scrollTo(0, room.scroll);
    document.title = text.documentTitle(room.label);
    mirror(room);
    keys.use(room.name, room.tab);
  }

  /** @param {Room} room */
  function mirror(room) {
    if (room === current) document.body.dataset.state = room.tab?.state.name ?? 'loading';
  }

  /** @param {Room} room @returns {Promise<Tab | null>} */
  async function loaded(room) {
    try {
      room.loading ??= room.load({ address: addressOf(room), built: () => room === current && keys.use(room.name, room.tab) });
      const tab = await room.loading;
      if (!room.tab) {
        room.tab = tab;
        tab.state.on(() => mirror(room));
        mirror(room);
        if (room === current) keys.use(room.name, tab);
      }
      return tab;
    } catch {
      room.loading = null; // a later visit tries again
      const notice = h('p', { class: 'tab-missing', role: 'alert' }, text.tabMissing(room.label), ' ', button(text.fault.retry, () => (notice.remove(), void arrive(location.hash))));
      room.element.append(notice);
      return null;
    }
  }

  /** @param {Room} room @returns {Address} */
  function addressOf(room) {
    return {
      write(hash, push = false) {
        if (room === current && location.hash !== told) return; // it would overwrite where the visitor has just gone
        room.kept = hash;
        if (room !== current || hash === location.hash) return;
        if (push) history.pushState(null, '', hash);
        else history.replaceState(null, '', hash);
        told = location.hash;
      },
      knows: (hash) => hash === room.kept,
    };
  }

  return {
    arrive,

    /** Opens a tab where it was left, as a new entry of the history. @param {string} name */
    visit(name) {
      const room = rooms.find((entry) => entry.name === name);
      if (!room || room === current) return arrive(location.hash);
      standing = location.hash;
      const hash = room.kept || `#/${name}`;
      history.pushState(null, '', hash);
      return arrive(hash);
    },

    pause: () => current?.tab?.pause(),
  };
}

/** @typedef {ReturnType<typeof createRouter>} Router */
