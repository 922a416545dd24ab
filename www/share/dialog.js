import '../style/share.css';
import { hidable } from '../hiding.js';
import { listed, pinned } from '../pagekeys.js';
import { LONGEST_LINK } from '../pack.js';
import { messageOf } from '../session.js';
import { button, h, write } from '../ui/dom.js';
import { copy, save } from '../ui/share.js';
import { shareText as text } from '../ui/strings.share.en.js';
import { text as page } from '../ui/strings.en.js';
import { addressOf, embedding, frameCode, hiding } from './links.js';
import { drawQr } from './qr.js';

/** @import { Room, Shared } from '../router.js' */

const IN_FRAME = ['words', 'play', 'scrub', 'speed', 'legend', 'ribbon', 'timeline']; // parts of tabs that a frame may show
const AT_FIRST = ['play', 'scrub'];

/** @type {HTMLDialogElement | null} */
let open = null;

/**
 * Shows what can be given away of a tab: links, with parts hidden for a class; a frame; a QR code; a file; a citation.
 *
 * @param {Room | null} room
 */
export async function openShare(room) {
  open?.remove();
  const said = h('p', { class: 'share-said', role: 'status' });
  const body = h('div', { class: 'share-body' });
  const close = h('button', { type: 'button', onclick: () => dialog.close() }, page.close);
  const dialog = h('dialog', { class: 'share-dialog', 'aria-labelledby': 'share-title' }, h('h2', { id: 'share-title' }, text.title), body, h('div', { class: 'row' }, said, close));
  dialog.addEventListener('close', () => dialog.remove());
  document.body.append(dialog);
  open = dialog;
  try {
    if (!room?.tab?.share) throw new Error(page.tabs.label);
    fill(body, room, await room.tab.share(), (message) => write(said, message));
  } catch (error) {
    write(said, text.failed(messageOf(error)));
  }
  dialog.showModal();
}

/**
 * @param {HTMLElement} body
 * @param {Room} room
 * @param {Shared} shared
 * @param {(message: string) => void} say
 */
function fill(body, room, shared, say) {
  const parts = hidable(room);
  const inside = parts.filter(({ name, within }) => IN_FRAME.includes(name) || within === 'inspector');
  const before = listed(room.page, 'hide');
  const boxes = new Map(parts.map((part) => [part, check(part.label, before.includes(part.name))]));
  const shown = new Map(inside.map((part) => [part, check(part.label, AT_FIRST.includes(part.name))]));
  const count = h('span', { class: 'count' });
  const link = field('share-link', text.link, say);
  const fixed = field('share-pinned', text.pinned, say, text.pinnedAbout);
  const frame = field('share-frame', text.frameCode, say);
  const cite = field('share-cite', text.cite, say);
  const qr = h('div', { class: 'share-qr' });
  const file = button(text.file, () => save(shared.file.name, new Blob([shared.file.text], { type: 'application/json' })));
  file.id = 'share-file';
  file.disabled = shared.file.text === '';
  const holds = (/** @type {string} */ name) => parts.some(({ within }) => within === name);
  /** @type {(within: string) => HTMLElement[]} */
  const group = (within) => [...boxes].filter(([part]) => part.within === within).map(([part, box]) => h('li', {}, box.label, holds(part.name) ? h('ul', {}, ...group(part.name)) : null));

  body.replaceChildren(
    h('p', {}, text.about),
    link.element,
    qr,
    h('details', { class: 'share-hide' }, h('summary', {}, text.hide, count), h('p', { class: 'help' }, text.hideAbout), h('ul', { class: 'share-parts' }, ...group(''))),
    fixed.element,
    h('details', { class: 'share-embed' }, h('summary', {}, text.frame), h('fieldset', {}, h('legend', {}, text.frameShows), ...[...shown.values()].map(({ label }) => label)), frame.element),
    cite.element,
    h('div', { class: 'row' }, file),
  );

  /** What follows from the boxes. */
  function show() {
    const chosen = (/** @type {Map<{ name: string }, { box: HTMLInputElement }>} */ of) => [...of].filter(([, { box }]) => box.checked).map(([{ name }]) => name);
    const names = chosen(boxes);
    const address = addressOf(shared.hash, hiding(names));
    write(count, text.hidden(names.length));
    link.set(address);
    fixed.set(pinned(address, shared.version));
    cite.set(text.citation(shared, address));
    frame.set(frameCode(addressOf(shared.hash, embedding(chosen(shown))), text.frameTitle(shared.title)));
    const code = drawQr(address, text.qr);
    qr.replaceChildren(code ?? h('p', { class: 'help' }, text.noQr));
    say(address.length > LONGEST_LINK ? text.tooLong(address.length) : '');
  }
  for (const { box } of [...boxes.values(), ...shown.values()]) box.addEventListener('change', show);
  show();
}

/** @param {string} label @param {boolean} checked */
function check(label, checked) {
  const box = h('input', { type: 'checkbox', checked });
  return { box, label: h('label', { class: 'check' }, box, label) };
}

/**
 * A text to be copied.
 *
 * @param {string} id
 * @param {string} label
 * @param {(message: string) => void} say
 * @param {string} [about]
 */
function field(id, label, say, about = '') {
  const area = h('textarea', { id, readonly: true, rows: 2, spellcheck: 'false' });
  const take = async () => {
    if (await copy(area.value)) say(text.copied);
    else {
      area.select();
      say(text.notCopied);
    }
  };
  const element = h('div', { class: 'share-field' }, h('label', { for: id }, label), h('div', { class: 'share-line' }, area, button(text.copy, () => void take())), about ? h('p', { class: 'help' }, about) : null);
  return { element, set: (/** @type {string} */ value) => void (area.value = value) };
}
