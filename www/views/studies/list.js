import { button, h, write } from '../../ui/dom.js';
import { studiesText as text } from '../../ui/strings.studies.en.js';
import { keyOf } from '../../studies/store.js';
import { SIZES } from '../../studies/types.js';

/** @import { Listed, StudySession } from '../../studies/session.js' */
/** @import { Speed } from '../../studies/speed.js' */
/** @import { Store } from '../../studies/store.js' */
/** @import { Size } from '../../studies/types.js' */

const MEGABYTE = 1 << 20;

/**
 * Every study file with its sizes, and the way to a study of one's own.
 *
 * @param {{ pane: HTMLElement, element: HTMLElement, session: StudySession, store: Store, speed: Speed, workers: () => number,
 *   say: (message: string, kind?: 'note' | 'problem') => void }} parts `element` takes files that are dropped
 */
export function createStudyList({ pane, element, session, store, speed, workers, say }) {
  const times = h('p', { class: 'secondary' });
  const rows = h('ul', { class: 'study-rows' });
  const file = h('input', { type: 'file', accept: '.json,application/json', class: 'unseen', tabindex: -1, 'aria-hidden': 'true' });
  file.addEventListener('change', () => {
    if (file.files?.[0]) void take(file.files[0]);
    file.value = '';
  });
  pane.append(
    h('h2', {}, text.list.title),
    h('p', { class: 'studies-about' }, text.list.about),
    rows,
    times,
    h(
      'div',
      { class: 'row' },
      button(text.list.open, () => file.click(), { title: text.list.openLong }),
      button(text.list.paste, () => void paste(), { title: text.list.pasteLong }),
      file,
      h('span', { class: 'secondary' }, text.list.dropped),
    ),
  );

  element.addEventListener('dragover', (event) => event.preventDefault());
  element.addEventListener('drop', (event) => {
    event.preventDefault();
    const dropped = event.dataTransfer?.files[0];
    if (dropped) void take(dropped);
  });

  /** @param {File} taken */
  async function take(taken) {
    if (taken.size > MEGABYTE) say(text.list.tooLarge(taken.name, 1), 'problem');
    else await session.openText(await taken.text(), taken.name);
  }

  async function paste() {
    try {
      await session.openText(await navigator.clipboard.readText(), text.list.pastedTitle);
    } catch {
      say(text.list.notPasted, 'problem');
    }
  }

  /** @param {Listed} study @param {Map<string, number>} counts */
  function row({ name, outline }, counts) {
    const about = outline.about.split(/(?<=[a-z)]\.) /)[0];
    return h(
      'li',
      { class: 'study-row', 'data-study': name },
      h('div', {}, h('h3', {}, outline.title || name), h('p', { class: 'secondary' }, about)),
      h('ul', { class: 'study-sizes' }, ...SIZES.map((size) => cell(name, outline.world, size, outline.sizes.find((entry) => entry.size === size), counts))),
    );
  }

  /** @param {string} name @param {string} world @param {Size} size @param {import('../../studies/types.js').SizeOutline | undefined} outline @param {Map<string, number>} counts */
  function cell(name, world, size, outline, counts) {
    if (!outline) return h('li', {});
    const range = speed.estimate(world, outline.robot_steps, workers());
    const kept = counts.get(keyOf(session.version, outline.hash)) ?? 0;
    return h(
      'li',
      {},
      h('a', { href: `#/studies/${name}?size=${size}`, title: text.list.sizesLong[size] }, `${text.list.sizes[size]}`, h('span', { class: 'unseen' }, `, ${name}`)),
      h('span', {}, text.list.runs(outline.runs)),
      range && h('span', { class: 'secondary' }, text.list.time(range)),
      kept > 0 ? h('span', { class: 'kept' }, text.list.kept(kept, outline.runs)) : null,
    );
  }

  return {
    async show() {
      const [listed, counts] = await Promise.all([session.listed(), store.counts()]);
      rows.replaceChildren(...listed.map((study) => row(study, counts)));
      write(times, listed.some(({ outline }) => speed.knows(outline.world)) ? text.list.hasTime(workers()) : text.list.noTime);
    },
  };
}
