import './style/embed.css';
import { listed, parted } from './pagekeys.js';

/** @import { Room } from './router.js' */

const BASE = { width: 880, height: 495 }; // the layout that is enlarged: at 1080 lines its smallest text, 11 pixels, has 24

/**
 * The page inside somebody else's: no header, larger with the frame, no single keys before somebody is inside, still while
 * it is out of sight, and a few messages from the page around it. What it may store, www/ui/storage.js decides.
 *
 * @param {{ active: () => Room | null }} parts
 */
export function createEmbed({ active }) {
  const root = document.documentElement;
  root.dataset.embed = 'true';

  function fit() {
    const scale = Math.min(innerWidth / BASE.width, innerHeight / BASE.height);
    root.style.zoom = String(Math.max(1, scale));
  }
  addEventListener('resize', fit);
  fit();

  // Nothing is asked for later: what the frame may open is loaded now.
  const named = listed(parted(location.hash).page, 'ui');
  if (named.includes('charts')) void import('./views/charts.js');
  if (named.includes('compare')) void import('./ab/compare.js');

  let inside = false;
  addEventListener('pointerdown', () => (inside = true), { capture: true });
  addEventListener(
    'keydown',
    (event) => {
      // Who came by the Tab key is inside too; otherwise a page that is read would lose its own keys to the frame.
      if (!inside && (document.activeElement === null || document.activeElement === document.body)) event.stopImmediatePropagation();
    },
    { capture: true },
  );

  let rested = false; // whether it was paused because nobody could see it
  new IntersectionObserver(([entry]) => {
    const running = active()?.tab?.state.name === 'running';
    if (!entry.isIntersecting && running) {
      rested = true;
      active()?.tab?.pause();
    } else if (entry.isIntersecting && rested) {
      rested = false;
      play();
    }
  }).observe(root);

  function play() {
    const tab = active()?.tab;
    if (tab?.state.name === 'paused') tab.actions.toggle?.();
  }

  /** @type {Record<string, () => void>} */
  const does = {
    play,
    pause: () => active()?.tab?.pause(),
    step() {
      const tab = active()?.tab;
      tab?.pause();
      tab?.actions.forward?.();
    },
    state: () => {},
  };

  addEventListener('message', async (event) => {
    const type = readType(event.data);
    if (type === null || event.source !== parent || parent === window) return;
    try {
      does[type]();
      const tab = active()?.tab;
      const shared = await tab?.share?.();
      if (!tab || !shared) return;
      const answer = { type: 'state', state: tab.state.name, tick: shared.tick, fingerprint: shared.fingerprint };
      parent.postMessage(answer, event.origin === 'null' ? '*' : event.origin);
    } catch {
      // nothing is there yet, or the engine has broken, which the page says itself
    }
  });

  /**
   * What a message asks for; null when it is none of ours: an object with nothing but a known `type`.
   *
   * @param {unknown} message
   */
  function readType(message) {
    if (typeof message !== 'object' || message === null || Object.getPrototypeOf(message) !== Object.prototype) return null;
    const { type, ...rest } = /** @type {Record<string, unknown>} */ (message);
    return typeof type === 'string' && Object.hasOwn(does, type) && Object.keys(rest).length === 0 ? type : null;
  }
}
