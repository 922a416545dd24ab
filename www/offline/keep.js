import '../style/offline.css';
import { button, h } from '../ui/dom.js';
import { offlineText as text } from '../ui/strings.offline.en.js';

/** @typedef {'ready' | 'elsewhere'} News a newer version waits; or another window has put it in force */

/**
 * Keeps the page in the browser, so that it opens without the network from the second visit on, and tells when a newer
 * version is there. Everything kept is of one build: the newer one takes over as a whole, when the visitor says so.
 *
 * Does nothing where the browser has no service workers or does not let us, or is to save data: the page works as it is.
 *
 * @param {{ head: HTMLElement, announce: (message: string) => void }} parts the notice stands at the end of `head`
 */
export async function keepOffline({ head, announce }) {
  const { serviceWorker } = navigator;
  const { connection } = /** @type {{ connection?: { saveData?: boolean } }} */ (navigator);
  if (!serviceWorker || connection?.saveData) return;
  let asked = false; // whether this window asked for the newer version
  let controlled = serviceWorker.controller !== null;
  /** @type {HTMLElement | null} */
  let notice = null;

  serviceWorker.addEventListener('controllerchange', () => {
    if (asked) location.reload();
    else if (controlled) tell('elsewhere', () => location.reload());
    controlled = true;
  });

  /** @param {News} news @param {() => void} reload */
  function tell(news, reload) {
    notice?.remove();
    notice = h('div', { class: 'notice update', role: 'group', 'aria-label': text.label }, h('p', {}, text[news]));
    notice.append(button(text.reload, reload, { class: 'primary' }), button(text.later, () => notice?.remove(), { glyph: '×', class: 'quiet' }));
    head.append(notice);
    announce(text[news]);
  }

  /** @param {ServiceWorkerRegistration} registration */
  function watch(registration) {
    const offer = () => {
      if (!registration.waiting || !serviceWorker.controller) return; // the first build of all has nothing to take over from
      tell('ready', () => {
        asked = true;
        registration.waiting?.postMessage({ type: 'SKIP_WAITING' });
      });
    };
    offer();
    registration.addEventListener('updatefound', () => registration.installing?.addEventListener('statechange', offer));
    document.addEventListener('visibilitychange', () => {
      if (!document.hidden) registration.update().catch(() => {}); // without the network there is nothing new
    });
  }

  try {
    watch(await serviceWorker.register(new URL('sw.js', document.baseURI)));
  } catch {
    // Storage is blocked, or the host serves no sw.js: nothing is kept.
  }
}
