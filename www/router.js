import { text } from './ui/strings.en.js';
import { button, h } from './ui/dom.js';
import { splitOnce } from './pack.js';
import { joined, parted } from './pagekeys.js';
import { embedded } from './ui/storage.js';

/** @import { State } from './state.js' */
/** @import { Keys } from './ui/keys.js' */
/** @import { Hiding } from './hiding.js' */

/**
 * @typedef {object} Tab what a tab gives once its script is there
 * @property {State} state
 * @property {Record<string, () => void>} actions by the names in the keys table; complete when `built` was called
 * @property {HTMLElement[]} regions where single keys act
 * @property {(hash: string) => Promise<void>} open shows what an address says; the first time it also starts the engine
 * @property {() => void} pause
 * @property {() => Promise<Shared>} [share] what can be given away of this moment
 *
 * @typedef {object} Shared a moment of a tab, to be given away
 * @property {string} hash the tab's own part of its address
 * @property {string} title
 * @property {string} version
 * @property {number | null} seed
 * @property {number | null} tick
 * @property {string} fingerprint empty where the tab has none
 * @property {{ name: string, text: string }} file the same as a file that the command line reads
 * @property {'geese' | 'sequencing' | 'trees' | 'studies' | 'soccer'} world whose papers it is after
 * @property {string | null} [plan] letters of the visitor's own plan
 *
 * @typedef {object} Beside another tab beside the open one
 * @property {(name: string, hash: string) => Promise<Tab | null>} open shows it, and in it what `hash` says; null when it could not be loaded
 * @property {(page: string) => Promise<void>} furnish shows other parts of it
 * @property {() => void} close gives it back as it was
 *
 * @typedef {object} Address a tab's own part of the address line
 * @property {(hash: string, push?: boolean) => void} write what the tab shows now; kept for later while another tab is open
 * @property {(hash: string) => boolean} knows whether the tab wrote this hash last
 * @property {(hash: string) => string} href the whole address to be given away: what is hidden here is hidden there
 *
 * @typedef {object} Place one tab of the page
 * @property {string} name as in the address
 * @property {string} label
 * @property {HTMLElement} element shown while the tab is open
 * @property {boolean} [aside] whether it is linked from elsewhere than the header
 * @property {boolean} [deep] whether its addresses go on after its name, as in `#/studies/success`
 * @property {(parts: { address: Address, beside: Beside, built: () => void }) => Promise<Tab>} load called once, when the tab is opened first
 *
 * @typedef {Place & { link: HTMLAnchorElement, loading: Promise<Tab> | null, tab: Tab | null, opened: boolean, kept: string, page: string, left: string,
 *   scroll: number, guest: Room | null, before: { kept: string, page: string } }} Room a place with its link in the header, its own part of the address
 *   as it wrote it last and the page's part of it, the hash it was left at, and the room shown beside it with what that stood at before
 */

/**
 * Tabs by hash route. A tab is loaded when it is opened first; one that is left is paused and finds its address again.
 *
 * @param {{ places: Place[], nav: HTMLElement, keys: Keys, tools: HTMLElement }} parts `tools` is where the way back to all controls stands
 */
export function createRouter({ places, nav, keys, tools }) {
  /** @type {Room[]} */
  const rooms = places.map((place) => {
    const link = h('a', { href: `#/${place.name}`, 'data-action': `tab-${place.name}` }, place.label);
    return { ...place, link, loading: null, tab: null, opened: false, kept: '', page: '', left: '', scroll: 0, guest: null, before: { kept: '', page: '' } };
  });
  /** @type {Room | null} */
  let current = null;
  let standing = location.hash; // the address before the change that is being told
  /** @type {Promise<Hiding> | null} loaded when an address first says what to show */
  let hiding = null;
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
    const { own, page } = parted(hash);
    const [path, query] = splitOnce(own.replace(/^#?\/?/, ''), '?');
    const bare = !query && !page && (path === room.name || path === '');
    if (room.opened && moved && (bare || hash === room.left || hash === whole(room))) {
      if (room.kept) history.replaceState(null, '', whole(room));
      told = location.hash;
    } else if (!room.opened || hash !== whole(room)) {
      room.opened = true;
      if (!bare) room.page = page;
      await furnish(room);
      await tab.open(bare && moved && room.kept ? room.kept : own);
      if (hiding) (await hiding).settle(room);
    }
    return tab;
  }

  /** The address of a room. @param {Room} room */
  const whole = (room) => joined(room.kept, room.page);

  /** The room that is open, or the one it shows beside itself. */
  const active = () => current?.guest ?? current;

  /** Shows the parts of a room that its address wants. @param {Room} room */
  async function furnish(room) {
    if (!room.page && !hiding) return;
    const showAll = () => {
      room.page = '';
      if (room === current) history.replaceState(null, '', room.kept || `#/${room.name}`);
      told = location.hash;
      void furnish(room);
    };
    hiding ??= import('./hiding.js').then(({ createHiding }) => createHiding({ tools, active: () => active() }));
    (await hiding).apply(room, showAll);
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
      active()?.tab?.pause();
      dismiss(current);
      current.left = standing;
      current.scroll = scrollY;
      current.link.removeAttribute('aria-current');
    }
    current = room;
    room.link.setAttribute('aria-current', 'page');
    show();
    scrollTo(0, room.scroll);
    document.title = text.documentTitle(room.label);
  }

  /** Shows what is open. */
  function show() {
    const room = active();
    if (!room) return;
    for (const entry of rooms) entry.element.hidden = entry !== current && entry !== room;
    document.body.dataset.tab = current?.name;
    document.body.toggleAttribute('data-beside', room !== current);
    mirror(room);
    keys.use(room.name, room.tab);
  }

  /** Gives the room beside back as it was. @param {Room} host */
  function dismiss(host) {
    const { guest } = host;
    if (!guest) return;
    guest.tab?.pause();
    Object.assign(guest, host.before, { opened: false });
    host.guest = null;
    host.opened = false; // a later visit shows it again
    void furnish(guest);
  }

  /** @param {Room} host @returns {Beside} */
  const besideOf = (host) => ({
    async open(name, hash) {
      const guest = rooms.find((room) => room.name === name);
      if (!guest || host !== current) return null;
      if (host.guest !== guest) {
        dismiss(host);
        host.opened = true;
        host.guest = guest;
        host.before = { kept: guest.kept, page: guest.page };
        show();
      }
      const { own, page } = parted(hash);
      guest.page = page;
      await furnish(guest);
      const tab = await loaded(guest);
      if (!tab || host.guest !== guest) return null;
      guest.opened = true;
      await tab.open(own);
      if (hiding) (await hiding).settle(guest);
      return tab;
    },
    async furnish(page) {
      if (!host.guest) return;
      host.guest.page = page;
      await furnish(host.guest);
    },
    close() {
      dismiss(host);
      host.opened = true;
      show();
    },
  });

  /** @param {Room} room */
  function mirror(room) {
    if (room === active()) document.body.dataset.state = room.tab?.state.name ?? 'loading';
  }

  /** @param {Room} room @returns {Promise<Tab | null>} */
  async function loaded(room) {
    try {
      room.loading ??= room.load({ address: addressOf(room), beside: besideOf(room), built: () => room === active() && keys.use(room.name, room.tab) });
      const tab = await room.loading;
      if (!room.tab) {
        room.tab = tab;
        tab.state.on(() => mirror(room));
        mirror(room);
        if (room === active()) keys.use(room.name, tab);
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
        const address = whole(room);
        if (room !== current || address === location.hash) return;
        if (push) history.pushState(null, '', address);
        else history.replaceState(null, '', address);
        told = location.hash;
      },
      knows: (hash) => hash === room.kept,
      href(hash) {
        // What a frame or a lesson shows of a tab is for that place alone.
        const pairs = room.page.split('&');
        const page = room === current && !embedded ? pairs : pairs.filter((pair) => pair.startsWith('hide='));
        return new URL(joined(hash, page.join('&')), location.href).href;
      },
    };
  }

  return {
    arrive,

    /** Opens a tab where it was left, as a new entry of the history. @param {string} name */
    visit(name) {
      const room = rooms.find((entry) => entry.name === name);
      if (!room || room === current) return arrive(location.hash);
      standing = location.hash;
      const hash = whole(room) || `#/${name}`;
      history.pushState(null, '', hash);
      return arrive(hash);
    },

    pause: () => active()?.tab?.pause(),

    /** The tab that acts now, and what of its address is the page's. */
    active: () => active(),
  };
}

/** @typedef {ReturnType<typeof createRouter>} Router */
