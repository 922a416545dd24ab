import { button, h, write } from './dom.js';
import { text } from './strings.en.js';

const MOST = 5;

/** @typedef {(message: string, kind?: 'note' | 'problem', offers?: { label: string, press: () => void }[]) => void} Say */

/**
 * Lines that tell what happened, each until it is closed; also read out through the one polite live region.
 *
 * @param {HTMLElement} pane
 * @param {HTMLElement} live
 */
export function createNotices(pane, live) {
  const list = h('div', { class: 'notices' });
  pane.prepend(list);

  /**
   * @param {string} message
   * @param {'note' | 'problem'} [kind]
   * @param {{ label: string, press: () => void }[]} [offers]
   */
  function say(message, kind = 'note', offers = []) {
    announce(message);
    for (const old of list.children) if (old.firstChild?.textContent === message) old.remove();
    const notice = h('div', { class: `notice ${kind}` }, h('p', {}, message));
    for (const { label, press } of offers) notice.append(button(label, () => (notice.remove(), press())));
    notice.append(button(text.dismiss, () => notice.remove(), { glyph: '×', class: 'quiet' }));
    list.append(notice);
    if (list.children.length > MOST) list.firstElementChild?.remove();
  }

  /** @param {string} message */
  function announce(message) {
    write(live, message);
  }

  return { say, announce, clear: () => list.replaceChildren() };
}
